/**
 * Transforms of the plane, as canvas and SVG write them: (x, y) → (a x + c y + e, b x + d y + f).
 *
 * @typedef {[number, number, number, number, number, number]} Matrix
 * @typedef {[number, number]} Point
 */

/** @type {Matrix} */
export const identity = [1, 0, 0, 1, 0, 0];

/** First `n`, then `m`. @param {Matrix} m @param {Matrix} n @returns {Matrix} */
export function multiply([a, b, c, d, e, f], [g, h, i, j, k, l]) {
  return [a * g + c * h, b * g + d * h, a * i + c * j, b * i + d * j, a * k + c * l + e, b * k + d * l + f];
}

/** @param {Matrix} matrix @param {number} x @param {number} y @returns {Point} */
export function transform([a, b, c, d, e, f], x, y) {
  return [a * x + c * y + e, b * x + d * y + f];
}

/** @param {Matrix} matrix @returns {Matrix} */
export function inverse([a, b, c, d, e, f]) {
  const area = a * d - b * c;
  return [d / area, -b / area, -c / area, a / area, (c * f - d * e) / area, (b * e - a * f) / area];
}

/** Whether all lengths are drawn in one ratio, so that a stroke is as wide on every side. @param {Matrix} matrix */
export function isEven([a, b, c, d]) {
  const tolerance = 1e-9 * (a * a + b * b + c * c + d * d);
  return Math.abs(a * c + b * d) <= tolerance && Math.abs(a * a + b * b - c * c - d * d) <= tolerance;
}
