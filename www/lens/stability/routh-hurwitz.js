/**
 * What one reads off Routh's array by eye.
 *
 * @typedef {{ terms: number[], than: number | null, value: number, bound: number, isMet: boolean, isEqual: boolean }} Condition the
 *   product of the coefficients a with these indices is greater than the one with index `than`, or than 0; `isEqual`: they are
 *   the same but for rounding
 */

/** What differs by less than this share came out of rounding. */
const rounding = 1e-12;
/** Digits with which numbers are written, and the most of them that are more than rounding. */
const [fewest, most] = [5, 12];

/**
 * Where in a first column the sign changes, row by row: from the row above to this one. A row of zero has no sign.
 * @param {readonly number[]} column
 */
export function signChanges(column) {
  return column.map((value, i) => {
    const above = column.slice(0, i).findLast((one) => one !== 0) ?? value;
    return value * above < 0;
  });
}

/**
 * The conditions as the textbooks write them for a third degree; for others none, the array says it all.
 * @param {readonly number[]} coefficients highest power (1) first
 * @returns {Condition[]}
 */
export function conditionsOf(coefficients) {
  if (coefficients.length !== 4) return [];
  const [, a2, a1, a0] = coefficients;
  const condition = (/** @type {number[]} */ terms, /** @type {number | null} */ than, /** @type {number} */ value, /** @type {number} */ bound) =>
    ({ terms, than, value, bound, isMet: value > bound, isEqual: apart(value, bound) < rounding });
  return [condition([2], null, a2, 0), condition([0], null, a0, 0), condition([2, 1], 0, a2 * a1, a0)];
}

/** With so many digits two numbers are told apart; with the fewest where they are the same. @param {number} value @param {number} bound */
export function digitsApart(value, bound) {
  const share = apart(value, bound);
  return share < rounding ? fewest : Math.min(most, Math.max(fewest, Math.ceil(-Math.log10(share)) + 1));
}

/** By which share of themselves they differ. @param {number} value @param {number} bound */
function apart(value, bound) {
  const size = Math.max(Math.abs(value), Math.abs(bound));
  return size > 0 ? Math.abs(value - bound) / size : 0;
}
