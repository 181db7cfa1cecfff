import { strokeCurve } from './curve.js';

/** @typedef {import('../style/theme.js').Theme} Theme */

/**
 * Where the motion is now: a full dot, ringed so that it stands off its trail.
 * @param {CanvasRenderingContext2D} context
 * @param {number} x
 * @param {number} y
 * @param {string} color
 * @param {Theme} theme
 */
export function drawPresent(context, x, y, color, theme) {
  context.fillStyle = color;
  context.strokeStyle = theme.surface;
  context.lineWidth = 2;
  circle(context, x, y, 6 * Math.sqrt(theme.line));
  context.fill();
  context.stroke();
}

/**
 * The same on a plot that the motion may have left: then a triangle at the edge that it has passed, pointing on.
 * @param {CanvasRenderingContext2D} context
 * @param {import('./axes.js').Box} frame
 * @param {number} x
 * @param {number} y
 * @param {string} color
 * @param {Theme} theme
 */
export function drawPresentWithin(context, { left, right, top, bottom }, x, y, color, theme) {
  const [across, up] = [Math.min(Math.max(x, left), right), Math.min(Math.max(y, top), bottom)];
  if (across === x && up === y) {
    drawPresent(context, x, y, color, theme);
    return;
  }
  const size = 6 * Math.sqrt(theme.line);
  const angle = Math.atan2(y - up, x - across);
  context.fillStyle = color;
  context.strokeStyle = theme.surface;
  context.lineWidth = 2;
  context.beginPath();
  for (const [along, aside] of [[0, 0], [-1.8, 1], [-1.8, -1]])
    context.lineTo(across + size * (along * Math.cos(angle) - aside * Math.sin(angle)), up + size * (along * Math.sin(angle) + aside * Math.cos(angle)));
  context.closePath();
  context.stroke();
  context.fill();
}

/**
 * Where the motion was all along the exposure of a frame, where it is too fast for a dot: as wide as one, translucent, so
 * that no single state can be read from it.
 * @param {CanvasRenderingContext2D} context
 * @param {import('./curve.js').Curve} curve
 * @param {string} color
 * @param {Theme} theme
 * @param {number} [size] as a share of the dot's
 */
export function drawSmear(context, curve, color, theme, size = 1) {
  context.save();
  context.globalAlpha = 0.4;
  context.strokeStyle = color;
  context.lineWidth = 12 * size * Math.sqrt(theme.line);
  context.lineJoin = 'round';
  context.lineCap = 'round';
  strokeCurve(context, curve);
  context.restore();
}

/**
 * Where a ghost is now: hollow.
 * @param {CanvasRenderingContext2D} context
 * @param {number} x
 * @param {number} y
 * @param {Theme} theme
 */
export function drawHollow(context, x, y, theme) {
  drawRing(context, x, y, 4.5 * Math.sqrt(theme.line), theme.ghost, theme);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {number} x
 * @param {number} y
 * @param {number} radius
 * @param {string} color
 * @param {Theme} theme
 */
export function drawRing(context, x, y, radius, color, theme) {
  context.fillStyle = theme.surface;
  context.strokeStyle = color;
  context.lineWidth = 1.8 * theme.line;
  circle(context, x, y, radius);
  context.fill();
  context.stroke();
}

/** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} radius */
function circle(context, x, y, radius) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
}
