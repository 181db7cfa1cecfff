/**
 * A curve on the canvas, point by point.
 *
 * @typedef {ArrayLike<number>} Series
 * @typedef {{ count: number, x: (i: number) => number, y: (i: number) => number }} Curve in pixels
 */

/**
 * Two columns of data as a curve.
 * @param {Series} across
 * @param {Series} up
 * @param {(value: number) => number} x where a value of `across` stands
 * @param {(value: number) => number} y
 * @returns {Curve}
 */
export function curveOf(across, up, x, y) {
  return { count: Math.min(across.length, up.length), x: (i) => x(across[i]), y: (i) => y(up[i]) };
}

/**
 * Adds the points `from` … `to` of a curve to the path.
 * @param {CanvasRenderingContext2D} context
 * @param {Curve} curve
 * @param {number} [from]
 * @param {number} [to]
 */
export function addCurve(context, { count, x, y }, from = 0, to = count - 1) {
  if (to <= from) return;
  context.moveTo(x(from), y(from));
  for (let i = from + 1; i <= to; i++) context.lineTo(x(i), y(i));
}

/**
 * Strokes a curve in the style in force.
 * @param {CanvasRenderingContext2D} context
 * @param {Curve} curve
 * @param {{ isClosed?: boolean }} [options]
 */
export function strokeCurve(context, curve, { isClosed = false } = {}) {
  if (curve.count < 2) return;
  context.beginPath();
  addCurve(context, curve);
  if (isClosed) context.closePath();
  context.stroke();
}
