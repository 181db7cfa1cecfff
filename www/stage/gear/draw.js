/**
 * The torsional nose gear, drawn from data alone: the same scene gives the same picture.
 *
 * Top view, steering-head detail and side view, from back to front. One file a part; this one
 * holds their order.
 *
 * @module
 */

import { drawGround } from './ground.js';
import { sheetFor } from './sheet.js';

export { sheetFor, trackSpan } from './sheet.js';

/** @typedef {import('./scene.js').Scene} Scene */
/** @typedef {import('./scene.js').Size} Size */
/** @typedef {import('./scene.js').GearWords} GearWords */
/** @typedef {import('./theme.js').Theme} Theme */

/**
 * Draws the whole stage above the transport. The page lays its verdict over the top left, in the
 * first `sheetFor(size, scene).band.top` pixels, left of the steering head.
 *
 * @param {CanvasRenderingContext2D} ctx already scaled for device pixels
 * @param {Size} size in CSS pixels
 * @param {Scene} scene
 * @param {Theme} theme
 * @param {GearWords} words
 */
export function drawGear(ctx, size, scene, theme, words) {
  const sheet = sheetFor(size, scene);
  ctx.fillStyle = theme.page;
  ctx.fillRect(0, 0, size.width, size.height);
  drawGround(ctx, sheet, scene, theme);
}
