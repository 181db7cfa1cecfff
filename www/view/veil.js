import { textFont } from './text.js';

/**
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('../style/theme.js').Theme} Theme
 */

/**
 * What is not to be seen before it has been guessed: a hatched box with a question mark.
 * @param {CanvasRenderingContext2D} context
 * @param {Box} box
 * @param {Theme} theme
 */
export function drawVeil(context, { left, right, top, bottom }, theme) {
  const [width, height] = [right - left, bottom - top];
  if (!(width > 0 && height > 0)) return;
  context.save();
  context.beginPath();
  context.rect(left, top, width, height);
  context.clip();
  context.fillStyle = theme.raised;
  context.fillRect(left, top, width, height);
  context.strokeStyle = theme.rule;
  context.lineWidth = 1.5;
  context.beginPath();
  for (let start = left - height; start < right; start += 7) {
    context.moveTo(start, bottom);
    context.lineTo(start + height, top);
  }
  context.stroke();
  context.restore();
  context.strokeStyle = theme.ghost;
  context.lineWidth = 1;
  context.strokeRect(Math.round(left) + 0.5, Math.round(top) + 0.5, Math.round(width) - 1, Math.round(height) - 1);
  context.font = textFont(theme, Math.min(1.6, (0.8 * height) / theme.size), 600);
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.lineJoin = 'round';
  context.lineWidth = 5;
  context.strokeStyle = theme.raised;
  context.strokeText('?', (left + right) / 2, (top + bottom) / 2 + 1);
  context.fillStyle = theme.ink;
  context.fillText('?', (left + right) / 2, (top + bottom) / 2 + 1);
}
