/**
 * Room for words on a plot: the corner that the curves leave free.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./curve.js').Curve} Curve
 * @typedef {'top-left' | 'top-right' | 'bottom-left' | 'bottom-right'} Corner
 */

/** How far words that find a corner taken may move along its side, in their own heights. */
const furthest = 1;

/**
 * The first of the wished corners that neither words nor curves pass; where all are passed, the one passed least.
 * @param {Box} frame
 * @param {{ width: number, height: number }} size
 * @param {Corner[]} wishes the corners, the best first
 * @param {Box[]} taken where other words stand
 * @param {Curve[]} curves
 * @returns {Box}
 */
export function freeCorner(frame, size, wishes, taken, curves) {
  const places = Array.from({ length: furthest + 1 }, (_, away) => wishes.map((corner) => boxIn(frame, size, corner, away))).flat();
  const open = places.filter((box) => !taken.some((other) => overlap(box, other)));
  let best = open[0] ?? places[0];
  let fewest = Infinity;
  for (const box of open) {
    const count = curves.reduce((sum, curve) => sum + pointsIn(curve, box), 0);
    if (count === 0) return box;
    if (count < fewest) [best, fewest] = [box, count];
  }
  return best;
}

/** @param {Box} frame @param {{ width: number, height: number }} size @param {Corner} corner @param {number} away @returns {Box} */
function boxIn(frame, { width, height }, corner, away) {
  const left = corner.endsWith('left') ? frame.left : frame.right - width;
  const top = corner.startsWith('top') ? frame.top + away * height : frame.bottom - (away + 1) * height;
  return { left, right: left + width, top, bottom: top + height };
}

/** Whether two boxes share a place. @param {Box} one @param {Box} other */
export function overlap(one, other) {
  return one.left < other.right && other.left < one.right && one.top < other.bottom && other.top < one.bottom;
}

/** How many points of a curve lie in a box; every other is asked, for curves are finer than words. @param {Curve} curve @param {Box} box */
function pointsIn({ count, x, y }, { left, right, top, bottom }) {
  let inside = 0;
  for (let i = 0; i < count; i += 2) {
    const [across, up] = [x(i), y(i)];
    if (across > left && across < right && up > top && up < bottom) inside++;
  }
  return inside;
}
