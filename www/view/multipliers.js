import { axisOf, drawAxes } from './axes.js';
import { drawHatch, hatchOf } from './hatch.js';
import { drawRing } from './points.js';
import { drawCross } from './roots.js';
import { roundLimit } from './scale.js';
import { textFont, writeEdged } from './text.js';
import { drawVeil } from './veil.js';

/**
 * The Floquet multipliers of a cycle in the unit circle: what becomes of a small aside within one period. Inside it shrinks;
 * outside, which is hatched, it grows. The trivial one, a step along the cycle itself, stays at 1.
 *
 * @typedef {import('./canvas.js').Size} Size
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{ re: number, im: number }} Complex
 */

/** A little more than the circle is always seen. */
const least = 1.25;
const widest = 1e6;
/** From this side on there is room for words, in widths of small type. */
const roomy = 9;

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Size} size
 * @param {{ along: Complex | null, others: readonly Complex[], veiled?: boolean }} shown `along`: the trivial one
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawMultipliers(context, size, { along, others, veiled = false }, theme, voice) {
  const area = { left: 2.4 * theme.size, right: size.width - 1.2 * theme.size, top: 2 * theme.size, bottom: size.height - 3.2 * theme.size };
  const side = Math.min(area.right - area.left, area.bottom - area.top);
  if (side < 20) return;
  const middle = (area.left + area.right) / 2;
  const frame = { left: middle - side / 2, right: middle + side / 2, top: area.top, bottom: area.top + side };
  const largest = veiled ? 1 : others.reduce((most, { re, im }) => Math.max(most, Math.abs(re), Math.abs(im)), 1);
  const limit = largest * 1.1 <= least ? least : roundLimit(Math.min(largest, widest));
  const plain = /** @type {const} */ ({ symbol: 'μ', word: 'cycle.multipliers', unit: '', perSI: 1, color: 'psi' });
  const most = Math.min(5, side / (theme.size * 3.2));
  const x = axisOf(plain, [-limit, limit], [frame.left, frame.right], most, voice);
  const y = axisOf(plain, [-limit, limit], [frame.bottom, frame.top], most, voice);
  const isOutside = (/** @type {number} */ across, /** @type {number} */ up) => Math.hypot(2 * across - 1, 2 * up - 1) * limit > 1;
  if (!veiled) drawHatch(context, hatchOf(frame, isOutside, theme), theme);
  drawAxes(context, frame, { ...x, name: () => [{ text: 'Re ' }, { symbol: 'μ' }] }, { ...y, name: () => [{ text: 'Im ' }, { symbol: 'μ' }] }, theme, { up: 'above' });
  if (veiled) {
    drawVeil(context, frame, theme);
    return;
  }
  context.beginPath();
  context.arc(x.at(0), y.at(0), x.at(1) - x.at(0), 0, 2 * Math.PI);
  context.strokeStyle = theme.ink2;
  context.lineWidth = 1.6 * theme.line;
  context.stroke();
  const within = (/** @type {number} */ value) => Math.min(Math.max(value, -limit), limit);
  if (along) drawRing(context, x.at(within(along.re)), y.at(within(along.im)), 5 * Math.sqrt(theme.line), theme.ghost, theme);
  for (const { re, im } of others) drawCross(context, x.at(within(re)), y.at(within(im)), Math.hypot(re, im) > 1 ? theme.unstable : theme.stable, theme);
  if (!along || side < roomy * theme.size) return;
  context.font = textFont(theme, 0.9);
  context.fillStyle = theme.ink2;
  context.textBaseline = 'middle';
  context.textAlign = 'right';
  writeEdged(context, voice.say('cycle.along'), frame.right, y.at(0) - 1.1 * theme.size, theme);
}
