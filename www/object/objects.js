/**
 * The objects that the page is about, in groups: gears, oscillators of the primer, the gear as a machine. A new one is its
 * line here and its word. Those that are not `ready` are shown dimmed, with the reason.
 *
 * @typedef {{ name: string, ready?: boolean }} Listed
 */

export const objects = /** @type {const} @satisfies {readonly { group: string, of: readonly Listed[] }[]} */ ([
  {
    group: 'gears',
    of: [
      { name: 'torsional', ready: true },
      { name: 'torsional-linear', ready: true },
      { name: 'trailing-wheel' },
      { name: 'torsional-lateral' },
      { name: 'torsional-lateral-longitudinal' },
      { name: 'thota-5' },
      { name: 'thota-7' },
      { name: 'gear-walk' },
    ],
  },
  { group: 'oscillators', of: [{ name: 'lorenz' }, { name: 'chemical-oscillator' }, { name: 'van-der-pol' }] },
  { group: 'machine', of: [{ name: 'strut' }, { name: 'retraction' }, { name: 'tires' }] },
]);

/** @param {string | undefined} name */
export function isReady(name) {
  return objects.some(({ of }) => of.some((one) => one.name === name && 'ready' in one));
}
