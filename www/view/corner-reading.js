import { textFont } from './text.js';

/**
 * What is read off a plot, in its one fixed corner: above the right end, and smaller where there is little room.
 *
 * @typedef {import('../style/theme.js').Theme} Theme
 */

/** @param {CanvasRenderingContext2D} context @param {string} reading @param {Theme} theme */
export function widthOfCornerReading(context, reading, theme) {
  context.font = textFont(theme, 1, 600);
  return context.measureText(reading).width;
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {string} reading
 * @param {import('./axes.js').Box} frame
 * @param {number} room to the left of the right end, in px
 * @param {Theme} theme
 */
export function writeCornerReading(context, reading, frame, room, theme) {
  context.font = textFont(theme, Math.min(1, room / Math.max(1, widthOfCornerReading(context, reading, theme))), 600);
  context.textAlign = 'right';
  context.textBaseline = 'alphabetic';
  context.fillStyle = theme.ink;
  context.fillText(reading, frame.right, frame.top - theme.size * 0.8);
}
