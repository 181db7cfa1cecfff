/**
 * A pen's strokes as an address carries them: the view, then the points as thousandths of its width and height, with the
 * pressure in hundredths where it is another than that of a hand that feels none.
 *
 *     pen=gear,412.305,440.290,501.263.80
 *
 * @typedef {import('../present/stroke.js').Point} Point
 * @typedef {{ view: string, points: readonly Point[] }} Drawn
 */

/** Strokes of an address; the latest where there are more. */
export const mostStrokes = 24;
/** Points of one stroke; a longer one is drawn by fewer. */
const mostPoints = 160;
/** A line is kept to this, in thousandths. */
const finest = 1.5;
const even = 0.5;
/** A pen's points lie close together, and its curve rounds the corner at each: read points are filled up to this, as a share of the view. */
const closest = 0.01;

/** @param {readonly Drawn[]} strokes @returns {string[]} */
export function penPairs(strokes) {
  return strokes.slice(-mostStrokes).map(({ view, points }) => `pen=${[view, ...outlined(points).map(textOf)].join(',')}`);
}

/**
 * @param {string} text
 * @returns {Drawn | null} null where it is no stroke
 */
export function strokeOf(text) {
  const [view, ...places] = text.split(',');
  const points = places.map(pointOf);
  const isWhole = /^[\w.-]{1,40}$/.test(view) && points.length > 0 && points.length <= mostPoints && points.every((point) => point !== null);
  return isWhole ? { view, points: filled(/** @type {Point[]} */ (points)) } : null;
}

/** @param {readonly Point[]} points @returns {Point[]} */
function filled(points) {
  return points.flatMap((to, i) => {
    const from = points[i - 1] ?? to;
    const count = Math.max(1, Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / closest));
    return Array.from({ length: count }, (_, j) => between(from, to, (j + 1) / count));
  });
}

/** @param {Point} from @param {Point} to @param {number} share @returns {Point} */
function between(from, to, share) {
  const mixed = (/** @type {keyof Point} */ of) => (share === 1 ? to[of] : from[of] + share * (to[of] - from[of]));
  return { x: mixed('x'), y: mixed('y'), pressure: mixed('pressure') };
}

/** @param {Point} point */
function textOf({ x, y, pressure }) {
  const place = [x, y].map((share) => Math.round(share * 1000));
  return [...place, ...(pressure === even ? [] : [Math.round(pressure * 100)])].join('.');
}

/** @param {string} text @returns {Point | null} */
function pointOf(text) {
  if (!/^-?\d{1,4}\.-?\d{1,4}(\.\d{1,3})?$/.test(text)) return null;
  const [x, y, pressure = even * 100] = text.split('.').map(Number);
  return pressure <= 100 ? { x: x / 1000, y: y / 1000, pressure: pressure / 100 } : null;
}

/** As few points as draw the same line, the coarser the more there are. @param {readonly Point[]} points */
function outlined(points) {
  let width = finest / 1000;
  let kept = thinned(points, width);
  while (kept.length > mostPoints) {
    width *= 1.5;
    kept = thinned(points, width);
  }
  return kept;
}

/**
 * The ends and whatever lies farther from the line between them (Ramer, Douglas and Peucker).
 * @param {readonly Point[]} points @param {number} width
 * @returns {readonly Point[]}
 */
function thinned(points, width) {
  const from = points[0];
  const to = points[points.length - 1];
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  let farthest = 0;
  let most = width;
  for (let i = 1; i < points.length - 1; i++) {
    const { x, y } = points[i];
    const off = length > 0 ? Math.abs((to.x - from.x) * (y - from.y) - (to.y - from.y) * (x - from.x)) / length : Math.hypot(x - from.x, y - from.y);
    if (off > most) [farthest, most] = [i, off];
  }
  if (farthest === 0) return points.length > 1 ? [from, to] : points;
  return [...thinned(points.slice(0, farthest + 1), width), ...thinned(points.slice(farthest), width).slice(1)];
}
