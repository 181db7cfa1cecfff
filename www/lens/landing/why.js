/**
 * Why a shimmy begins and ends where it does, of what the branches of cycles over the speed say: whether it passes a boundary with
 * delay, or is held by a branch that folds.
 *
 * @typedef {import('../../pkg/shimmy.js').Bifurcation} Bifurcation
 * @typedef {import('./roll.js').Shimmy} Shimmy
 * @typedef {{ key: 'calm.stable' | 'calm.beside' | 'calm.short' | 'begins.once' | 'begins.late' | 'begins.pushed' | 'ends.fold' | 'ends.beside' | 'ends.late' | 'ends.with' | 'ends.never', values: Readonly<Record<string, number>> }} Reason
 *   `key`: its sentence; `values`: speeds in m/s by name
 */

/** Speeds nearer than this are told to be one, in m/s: half of what a roll of 3 m/s² loses in a third of a second. */
const near = 0.5;

/**
 * @param {Shimmy} shimmy
 * @param {Bifurcation} diagram over the speed
 * @param {number} threshold in rad
 * @returns {Reason[]} of its beginning and of its end; one where it is calm
 */
export function reasonsOf(shimmy, diagram, threshold) {
  const { touchdown, stop, begins, ends } = shimmy;
  const rest = restBetween(diagram, stop.velocity, touchdown.velocity);
  const cycles = cyclesBetween(diagram, threshold, stop.velocity, touchdown.velocity);
  if (!begins) {
    if (rest) return [{ key: 'calm.short', values: { from: rest.low, to: rest.high } }];
    return [cycles ? { key: 'calm.beside', values: { from: cycles.low, to: cycles.high } } : { key: 'calm.stable', values: {} }];
  }
  return [beginning(shimmy, begins, rest), ending(shimmy, ends, rest, cycles)];
}

/** @param {Shimmy} shimmy @param {{ velocity: number, time: number }} begins @param {Range | null} rest @returns {Reason} */
function beginning({ touchdown }, begins, rest) {
  if (rest && rest.high >= touchdown.velocity - 1e-9) return { key: 'begins.once', values: { at: begins.velocity } };
  // Where rest is stable something else has swung it out.
  if (!rest || begins.velocity > rest.high + near) return { key: 'begins.pushed', values: { at: begins.velocity } };
  return { key: 'begins.late', values: { at: begins.velocity, boundary: rest.high, late: rest.high - begins.velocity } };
}

/** @param {Shimmy} shimmy @param {{ velocity: number } | null} ends @param {Range | null} rest @param {Range | null} cycles @returns {Reason} */
function ending({ stop }, ends, rest, cycles) {
  if (!ends) return { key: 'ends.never', values: { at: stop.velocity } };
  const at = ends.velocity;
  if (cycles && !rest) return { key: 'ends.beside', values: { at, fold: cycles.low } };
  // A cycle that is left where rest is stable already: there the branch turns back.
  if (cycles && cycles.low < (rest?.low ?? Infinity) - near) return { key: 'ends.fold', values: { at, fold: cycles.low, boundary: rest?.low ?? at } };
  const boundary = cycles?.low ?? rest?.low ?? at;
  return boundary - at > near ? { key: 'ends.late', values: { at, boundary, late: boundary - at } } : { key: 'ends.with', values: { at, boundary } };
}

/** @typedef {{ low: number, high: number }} Range */

/** At which speeds of the roll rest is unstable. @param {Bifurcation} diagram @param {number} from @param {number} to @returns {Range | null} */
function restBetween({ equilibria, parameter, points }, from, to) {
  const speeds = equilibria[parameter];
  const unstable = Array.from(speeds.keys()).filter((i) => !equilibria.stable[i] && speeds[i] >= from && speeds[i] <= to);
  if (unstable.length === 0) return null;
  const [low, high] = [Math.min(...unstable.map((i) => speeds[i])), Math.max(...unstable.map((i) => speeds[i]))];
  // The very boundary, which lies between two points of rest.
  const turns = points.filter(({ kind }) => kind === 'hopf' || kind === 'divergence').map((point) => point[parameter]).filter((at) => at >= from && at <= to);
  const lower = turns.filter((at) => at <= low);
  const upper = turns.filter((at) => at >= high);
  return { low: lower.length > 0 ? Math.max(...lower) : from, high: upper.length > 0 ? Math.min(...upper) : to };
}

/** At which speeds of the roll there is a stable cycle that counts as shimmy. @param {Bifurcation} diagram @param {number} threshold @param {number} from @param {number} to @returns {Range | null} */
function cyclesBetween({ cycles, parameter }, threshold, from, to) {
  let [low, high] = [Infinity, -Infinity];
  for (const branch of cycles) {
    const [speeds, swings] = [branch[parameter], branch.amplitudes.torsionAngle];
    const add = (/** @type {number} */ speed) => {
      if (speed < from || speed > to) return;
      [low, high] = [Math.min(low, speed), Math.max(high, speed)];
    };
    for (let i = 0; i < speeds.length; i++) {
      const counts = (/** @type {number} */ at) => swings[at] >= threshold && branch.stable[at] === 1;
      if (counts(i)) add(speeds[i]);
      // The branch grows through what counts between two of its points.
      const isThrough = i > 0 && branch.stable[i] === 1 && branch.stable[i - 1] === 1 && (swings[i] >= threshold) !== (swings[i - 1] >= threshold);
      if (isThrough) add(speeds[i - 1] + ((threshold - swings[i - 1]) / (swings[i] - swings[i - 1])) * (speeds[i] - speeds[i - 1]));
    }
  }
  return low <= high ? { low, high } : null;
}
