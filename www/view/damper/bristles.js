import { drawRod } from './elements.js';

/**
 * The hysteresis element: bristles that the rod bends, by z, until they slip at z_max; and about it the coil, filled as far as
 * there is current.
 *
 * @typedef {import('../../style/theme.js').Theme} Theme
 */

const bristles = 5;
const windings = 9;
/** How far a bristle's tip leans at z_max, in heights of the gap. */
const lean = 0.55;

/**
 * @param {CanvasRenderingContext2D} context
 * @param {{ from: number, to: number, y: number, tall: number, share: number, command: number }} place `share`: z over z_max
 * @param {Theme} theme
 */
export function drawBristles(context, { from, to, y, tall, share, command }, theme) {
  const length = to - from;
  const [left, right] = [from + 0.2 * length, from + 0.8 * length];
  const wide = right - left;
  const [low, high] = [y + 0.2 * tall, y - 0.2 * tall];
  drawCoil(context, { left, right, top: y - tall / 2, bottom: y + tall / 2 }, command, theme);
  // The plate that the left end holds, and the one that the right end moves.
  drawRod(context, from, left, low, theme);
  drawRod(context, right, to, high, theme);
  context.strokeStyle = theme.ink;
  context.lineWidth = 2.4 * theme.line;
  context.beginPath();
  context.moveTo(left, low);
  context.lineTo(left + 0.82 * wide, low);
  context.moveTo(left + 0.18 * wide, high);
  context.lineTo(right, high);
  context.stroke();
  const tip = lean * (low - high) * Math.min(1, Math.max(-1, share));
  context.strokeStyle = theme.force;
  context.lineWidth = 2 * theme.line;
  context.beginPath();
  for (let i = 0; i < bristles; i++) {
    const foot = left + wide * (0.2 + (0.6 * i) / (bristles - 1));
    context.moveTo(foot, low);
    context.bezierCurveTo(foot, (2 * low + high) / 3, foot + tip / 3, (low + 2 * high) / 3, foot + tip, high + 2 * theme.line);
  }
  context.stroke();
}

/** @param {CanvasRenderingContext2D} context @param {import('../axes.js').Box} box @param {number} command 0 … 1 @param {Theme} theme */
function drawCoil(context, { left, right, top, bottom }, command, theme) {
  const pitch = (right - left) / windings;
  const radius = Math.min(0.34 * pitch, 0.13 * (bottom - top));
  for (let i = 0; i < windings; i++)
    for (const y of [top + radius, bottom - radius]) {
      const filled = Math.min(1, Math.max(0, command * windings - i));
      context.beginPath();
      context.arc(left + (i + 0.5) * pitch, y, radius, 0, 2 * Math.PI);
      context.fillStyle = theme.surface;
      context.fill();
      if (filled > 0) {
        context.globalAlpha *= filled;
        context.fillStyle = theme.force;
        context.fill();
        context.globalAlpha = 1;
      }
      context.strokeStyle = theme.ink2;
      context.lineWidth = theme.line;
      context.stroke();
    }
}
