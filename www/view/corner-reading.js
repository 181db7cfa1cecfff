import { textFont } from './text.js';

/**
 * What is read off a plot, in its one fixed corner: above the right end, in as many words as there is room for.
 *
 * @typedef {import('../style/theme.js').Theme} Theme
 */

/** Words smaller than this share of the usual size are not read by anyone. */
const smallest = 0.85;

/**
 * @param {CanvasRenderingContext2D} context
 * @param {readonly string[]} wishes the same in fewer and fewer words
 * @param {import('./axes.js').Box} frame
 * @param {number} room to the left of the right end, in px
 * @param {Theme} theme
 * @returns {number} how wide what is written is, 0 where nothing has room
 */
export function writeCornerReading(context, wishes, frame, room, theme) {
  context.font = textFont(theme, 1, 600);
  const widths = wishes.map((words) => context.measureText(words).width);
  const fitting = widths.findIndex((width) => width <= room);
  const chosen = fitting < 0 ? wishes.length - 1 : fitting;
  const scale = Math.min(1, room / Math.max(1, widths[chosen]));
  if (!wishes[chosen] || scale < smallest) return 0;
  context.font = textFont(theme, scale, 600);
  context.textAlign = 'right';
  context.textBaseline = 'alphabetic';
  context.fillStyle = theme.ink;
  context.fillText(wishes[chosen], frame.right, frame.top - theme.size * 0.8);
  return scale * widths[chosen];
}
