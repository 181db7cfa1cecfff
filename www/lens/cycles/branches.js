/**
 * Branches of cycles as one looks at them: what stands upward, the place nearest to a hand, the cycle at a place.
 *
 * @typedef {import('../../pkg/shimmy.js').Bifurcation} Bifurcation
 * @typedef {import('../../pkg/shimmy.js').CycleBranch} CycleBranch
 * @typedef {import('../../run/cycle-looks.js').Guess} Guess
 * @typedef {typeof heights[number]} Height what stands upward: the amplitude of a state, or the frequency
 * @typedef {{ branch: number, index: number }} Place on one of the branches
 */

export const heights = /** @type {const} */ (['torsionAngle', 'torsionRate', 'lateralDeformation', 'frequency']);

/** Swings wider than this tell nothing of a gear: axes end there, in rad. */
export const widest = 0.8;

/** What stands upward of a branch, point by point. @param {CycleBranch} branch @param {Height} height @returns {Float64Array} */
export const heightsOf = (branch, height) => (height === 'frequency' ? branch.frequency : branch.amplitudes[height] ?? new Float64Array());

/** The largest height of swings that are not too wide; 0 where there are none. @param {Bifurcation} diagram @param {Height} height */
export function highest({ cycles }, height) {
  return cycles.reduce((most, branch) => heightsOf(branch, height).reduce((high, value, i) => (branch.amplitude[i] <= widest ? Math.max(high, value) : high), most), 0);
}

/**
 * The place on a branch that is nearest to a point, among those that are seen.
 * @param {Bifurcation} diagram
 * @param {Height} height
 * @param {{ x: (value: number) => number, y: (value: number) => number }} places in px
 * @param {{ x: number, y: number }} point in px
 * @returns {(Place & { distance: number }) | null} null where there is no branch
 */
export function nearest({ parameter, cycles }, height, { x, y }, point) {
  /** @type {(Place & { distance: number }) | null} */
  let best = null;
  cycles.forEach((cycle, branch) => {
    const up = heightsOf(cycle, height);
    for (let index = 0; index < cycle.amplitude.length; index++) {
      // A branch begins where there is no cycle yet.
      if (cycle.amplitude[index] === 0) continue;
      const distance = Math.hypot(x(cycle[parameter][index]) - point.x, y(up[index]) - point.y);
      if (!best || distance < best.distance) best = { branch, index, distance };
    }
  });
  return best;
}

/** A cycle that has an amplitude, some points on; where the branch ends it stays. @param {CycleBranch} branch @param {number} index @param {number} by */
export function along({ amplitude }, index, by) {
  const next = Math.min(Math.max(index + by, 0), amplitude.length - 1);
  return amplitude[next] === 0 ? index : next;
}

/** What leads to the cycle at a place. @param {CycleBranch} branch @param {number} index @returns {Guess} */
export function cycleAt(branch, index) {
  return { period: branch.period[index], state: Object.fromEntries(Object.entries(branch.state).map(([name, series]) => [name, series[index]])) };
}

/** Digits of a value that a hand picks from a branch. */
const digits = 6;

/** A value as it is set from a branch: in the unit it is shown in it has few digits. @param {import('../../controls/quantity.js').Quantity | undefined} quantity @param {number} value in SI */
export const roundValue = (quantity, value) => (quantity ? quantity.toSI(Number(quantity.toShown(value).toPrecision(digits))) : value);

/**
 * How small cycles over the gap grow with it, as amplitude over half of the gap: the slope of a branch where it comes out of
 * nothing. Null for branches that do not.
 * @param {Bifurcation} diagram
 */
export function slopeOfSmall({ parameter, cycles }) {
  if (parameter !== 'freeplayAngle') return null;
  for (const branch of cycles) {
    const order = Array.from(branch.amplitude, (_, i) => i).filter((i) => branch.freeplayAngle[i] > 0 && branch.amplitude[i] > 0).sort((one, other) => branch.freeplayAngle[one] - branch.freeplayAngle[other]);
    const [first] = order;
    if (branch.ends.includes('rest') && first !== undefined) return branch.amplitude[first] / branch.freeplayAngle[first];
  }
  return null;
}

/** At which of its points the stability of a branch changes, or of rest. @param {Bifurcation} diagram @param {number | null} of the branch; null for rest @returns {number[]} */
export function turnsOf({ points }, of) {
  const isRest = (/** @type {{ kind: string }} */ { kind }) => kind === 'hopf' || kind === 'divergence';
  return points.filter((point) => (of === null ? isRest(point) : !isRest(point) && point.branch === of)).map(({ index }) => index);
}

/** The cycle of a branch that is nearest to a value of what varies. @param {CycleBranch} branch @param {string} parameter @param {number} value */
export function nearestTo(branch, parameter, value) {
  const off = (/** @type {number} */ i) => (branch.amplitude[i] > 0 ? Math.abs(branch[parameter][i] - value) : Infinity);
  return branch.amplitude.reduce((best, _, i) => (off(i) < off(best) ? i : best), 0);
}
