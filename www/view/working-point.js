/**
 * The gear as a point in a plane of two of its values: a ring, with dotted lines to both axes. Beyond the plane's range it
 * stands at the edge, with an arrow to where it is.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('../style/theme.js').Theme} Theme
 */

/** In px. */
const radius = 9;

/** What it covers. @param {number} x in px @param {number} y @param {Theme} theme @returns {Box} */
export function boxOfWorkingPoint(x, y, theme) {
  const reach = radius * Math.sqrt(theme.line) + 3 * theme.line;
  return { left: x - reach, right: x + reach, top: y - reach, bottom: y + reach };
}

/** Dotted lines from the point to both axes. @param {CanvasRenderingContext2D} context @param {Box} frame @param {{ x: number, y: number }} point in px @param {Theme} theme */
export function drawGuides(context, frame, point, theme) {
  const { x, y } = withinFrame(point, frame);
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.5 * theme.line;
  context.setLineDash([1.5 * theme.line, 4 * theme.line]);
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x, frame.bottom);
  context.moveTo(x, y);
  context.lineTo(frame.left, y);
  context.stroke();
  context.setLineDash([]);
}

/** The ring itself. @param {CanvasRenderingContext2D} context @param {Box} frame @param {{ x: number, y: number }} point in px @param {Theme} theme */
export function drawWorkingPoint(context, frame, point, theme) {
  const { x, y } = withinFrame(point, frame);
  const size = radius * Math.sqrt(theme.line);
  context.beginPath();
  context.arc(x, y, size, 0, 2 * Math.PI);
  context.fillStyle = theme.surface;
  context.fill();
  context.strokeStyle = theme.surface;
  context.lineWidth = 6 * theme.line;
  context.stroke();
  context.strokeStyle = theme.ink;
  context.lineWidth = 2.5 * theme.line;
  context.stroke();

  const [beyondX, beyondY] = [Math.sign(Math.round(point.x - x)), Math.sign(Math.round(point.y - y))];
  if (beyondX !== 0 || beyondY !== 0) drawArrow(context, x, y, Math.atan2(beyondY, beyondX), size, theme);
}

/** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} angle @param {number} size @param {Theme} theme */
function drawArrow(context, x, y, angle, size, theme) {
  const at = (/** @type {number} */ along, /** @type {number} */ aside) =>
    /** @type {const} */ ([x + along * Math.cos(angle) - aside * Math.sin(angle), y + along * Math.sin(angle) + aside * Math.cos(angle)]);
  context.fillStyle = theme.ink;
  context.beginPath();
  context.moveTo(...at(0.75 * size, 0));
  context.lineTo(...at(-0.4 * size, 0.55 * size));
  context.lineTo(...at(-0.4 * size, -0.55 * size));
  context.closePath();
  context.fill();
}

/** The point, or the nearest to it that is in the frame. @param {{ x: number, y: number }} point @param {Box} frame */
export function withinFrame(point, { left, right, top, bottom }) {
  return { x: Math.min(Math.max(point.x, left), right), y: Math.min(Math.max(point.y, top), bottom) };
}
