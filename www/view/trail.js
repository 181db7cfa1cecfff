import { addCurve } from './curve.js';

/**
 * @typedef {import('./curve.js').Curve} Curve
 * @typedef {import('../style/theme.js').Theme} Theme
 */

/** How many shades a trail fades through. */
export const shades = 32;

/**
 * How strong a trail is at a share of its length, 0 … 1 from the oldest to now.
 * @param {number} share
 */
export const strengthAt = (share) => 0.06 + 0.94 * share ** 1.6;

/**
 * The past, the older the fainter.
 * @param {CanvasRenderingContext2D} context
 * @param {Curve} curve
 * @param {string} color
 * @param {Theme} theme
 */
export function drawTrail(context, curve, color, theme) {
  const last = curve.count - 1;
  if (last < 1) return;
  context.strokeStyle = color;
  context.lineWidth = 2.2 * theme.line;
  context.lineJoin = 'round';
  context.lineCap = 'butt';
  for (let shade = 0; shade < shades; shade++) {
    const from = Math.floor((last * shade) / shades);
    const to = Math.floor((last * (shade + 1)) / shades);
    if (to === from) continue;
    context.globalAlpha = strengthAt((shade + 1) / shades);
    context.beginPath();
    addCurve(context, curve, from, to);
    context.stroke();
  }
  context.globalAlpha = 1;
}
