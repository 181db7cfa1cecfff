/**
 * The geometry of a pen's stroke: a curve through the middles between its points, as thick as the pen was pressed.
 *
 * @typedef {import('../view/canvas.js').Size} Size
 * @typedef {{ x: number, y: number, pressure: number }} Point place as a share of its view's width and height, so that a
 *   view that changes its size keeps it; pressure from 0 to 1, a half where the pen knows none
 * @typedef {{ x: number, y: number, radius: number }} Dot in CSS pixels
 */

/** Half the thickness of a line drawn with an even hand, in px. */
const radius = 1.9;
/** Dots are no farther apart than this, in px. */
const spacing = 2;

/**
 * A stroke as a row of dots so close that they are a line.
 * @param {readonly Point[]} points
 * @param {Size} size of the view
 * @param {number} line a factor for the thickness
 * @returns {Dot[]}
 */
export function dotsOf(points, { width, height }, line) {
  const places = points.map(({ x, y, pressure }) => ({ x: x * width, y: y * height, radius: radius * line * (0.4 + 1.2 * pressure) }));
  if (places.length < 2) return places;
  const middles = places.slice(1).map((place, i) => between(places[i], place, 0.5));
  const dots = [places[0]];
  addStraight(dots, middles[0]);
  for (let i = 1; i < middles.length; i++) addCurve(dots, middles[i - 1], places[i], middles[i]);
  addStraight(dots, places[places.length - 1]);
  return dots;
}

/** @param {Dot[]} dots @param {Dot} to */
function addStraight(dots, to) {
  const from = dots[dots.length - 1];
  const count = pieces(distance(from, to));
  for (let i = 1; i <= count; i++) dots.push(between(from, to, i / count));
}

/**
 * A quadratic curve from one middle to the next, bent toward the point between them.
 * @param {Dot[]} dots @param {Dot} from @param {Dot} bend @param {Dot} to
 */
function addCurve(dots, from, bend, to) {
  // It goes nowhere faster than at twice its longer side.
  const count = pieces(2 * Math.max(distance(from, bend), distance(bend, to)));
  for (let i = 1; i <= count; i++) dots.push(between(between(from, bend, i / count), between(bend, to, i / count), i / count));
}

/** @param {Dot} one @param {Dot} other @param {number} share of the way */
function between(one, other, share) {
  const mixed = (/** @type {number} */ a, /** @type {number} */ b) => a + share * (b - a);
  return { x: mixed(one.x, other.x), y: mixed(one.y, other.y), radius: mixed(one.radius, other.radius) };
}

/** @param {Dot} one @param {Dot} other */
function distance(one, other) {
  return Math.hypot(other.x - one.x, other.y - one.y);
}

/** @param {number} length in px */
function pieces(length) {
  return Math.max(1, Math.ceil(length / spacing));
}
