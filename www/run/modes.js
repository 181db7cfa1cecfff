/**
 * The modes of the gear as one chooses among them: a pair of eigenvalues is one motion.
 *
 * @typedef {import('./linear-looks.js').Mode} Mode
 * @typedef {{ name: string, mode: Mode }} Choice `name`: `pair-1`, `pair-2`, … and `real-1`, …, each by falling real part
 */

/**
 * @param {readonly Mode[]} modes in the order of their eigenvalues
 * @returns {Choice[]} pairs first: they are what swings
 */
export function modeChoices(modes) {
  const named = (/** @type {string} */ kind, /** @type {Mode[]} */ some) => some.map((mode, i) => ({ name: `${kind}-${i + 1}`, mode }));
  return [
    ...named('pair', modes.filter(({ eigenvalue }) => eigenvalue.im > 0)),
    ...named('real', modes.filter(({ eigenvalue }) => eigenvalue.im === 0)),
  ];
}

/** The one of that name; the first where there is none. @param {readonly Choice[]} choices @param {string} name @returns {Choice | undefined} */
export function chosenMode(choices, name) {
  return choices.find((one) => one.name === name) ?? choices[0];
}

/**
 * Which mode moves as a ghost on the gear; null where none is looked at.
 * @param {Pick<import('../store.js').State, 'lens' | 'views'>} state
 */
export function modeOnGear({ lens, views }) {
  return lens === 'stability' && views.stability === 'modes' ? views.mode ?? '' : null;
}
