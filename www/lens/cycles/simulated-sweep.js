/**
 * What a gear does as a value creeps up, and down again: at each value the motion goes on from where the last one settled, so
 * that what it does depends on where it comes from.
 *
 * @typedef {import('../../run/cycle-looks.js').CycleLooks} CycleLooks
 * @typedef {{ value: number, way: 'up' | 'down' }} Stop
 * @typedef {{ amplitude: Readonly<Record<string, number>>, frequency: number | null, state: Record<string, number> }} Settled
 */

import { stateAt } from '../../run/cycle-looks.js';

/** Nothing is ever wholly at rest, in rad. */
const touch = 1e-3;

/** The stops of a sweep, up and down. @param {{ from: number, to: number }} range @param {number} count each way @returns {Stop[]} */
export function stopsOf({ from, to }, count) {
  const up = Array.from({ length: count }, (_, i) => ({ value: from + ((to - from) * i) / (count - 1), way: /** @type {const} */ ('up') }));
  return [...up, ...up.toReversed().map(({ value }) => ({ value, way: /** @type {const} */ ('down') }))];
}

/** @param {CycleLooks} cycles @param {string} parameter @param {Stop} stop @param {Settled | null} before @returns {Settled} */
export function settledAt(cycles, parameter, { value }, before) {
  const { verdict, amplitude, frequency, orbit } = cycles.outlook(before?.state ?? { torsionAngle: touch }, { [parameter]: value });
  const swings = (verdict === 'shimmies' || verdict === 'rattles') && orbit.time.length > 0;
  if (!swings) return { amplitude: {}, frequency: null, state: { torsionAngle: touch } };
  return { amplitude, frequency, state: stateAt(orbit, 0) };
}
