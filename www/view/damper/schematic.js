import { drawArrow } from '../arrow.js';
import { drawLabel } from '../text.js';
import { drawBristles } from './bristles.js';
import { drawDashpot, drawRod, drawSpring } from './elements.js';

/**
 * What a damper's model is made of, moving as it moves: a Bouc–Wen element, a dashpot and a spring side by side (figure 7.6 of
 * the thesis); in series with another dashpot, and all of it beside a second spring (figure 7.7).
 *
 *     wall ─┬─ element ─┬─ x          wall ──dashpot c₁──┬─ element ─┬─ x
 *           ├─ dashpot ─┤                               w├─ dashpot ─┤
 *           └─ spring ──┘                                └─ spring ──┘
 *                                      └───────── spring k₁ ──────────┘
 *
 * @typedef {import('../../style/theme.js').Theme} Theme
 * @typedef {import('../canvas.js').Size} Size
 * @typedef {import('../text.js').Run} Run
 * @typedef {{ x: number, w: number, z: number, force: number, command: number }} Pose shares of what is the most of each, −1 … 1; the
 *   command 0 … 1: so much of the element's coil is filled
 * @typedef {{ element: string, dashpot: string, spring: string, seriesDashpot: string, outerSpring: string }} Words
 */

/** Shares of the picture's width: the wall, the two ends of rods at rest, and how far x and w take them. */
const wall = 0.05;
const middle = 0.4;
const end = 0.8;
const stroke = 0.085;

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Size} size
 * @param {{ isSeries: boolean, pose: Pose, words: Words }} shown
 * @param {Theme} theme
 */
export function drawSchematic(context, size, { isSeries, pose, words }, theme) {
  const { width, height } = size;
  if (width < 60 || height < 60) return;
  const at = (/** @type {number} */ share) => share * width;
  const [from, to] = [at(isSeries ? middle + stroke * pose.w : wall), at(end + stroke * pose.x)];
  const rows = rowsOf(size, isSeries, theme);
  const tall = Math.min(rows.step * 0.66, 0.17 * width);
  const captioned = rows.step > 3.4 * theme.size;
  const caption = (/** @type {Run[]} */ runs, /** @type {string} */ word, /** @type {number} */ left, /** @type {number} */ right, /** @type {number} */ y, color = theme.ink2) => {
    context.fillStyle = color;
    if (!captioned) {
      // Where a part begins there is nothing of it but its rod.
      drawLabel(context, runs, left + theme.size * 0.5, y - theme.size * 0.4, theme, { align: 'left', weight: 600, halo: theme.surface });
      return;
    }
    drawLabel(context, [...runs, { text: ` ${word}` }], (left + right) / 2, y - tall / 2 - theme.size * 0.5, theme, { align: 'center' });
  };

  drawWall(context, at(wall), rows.top, rows.bottom, theme);
  drawBristles(context, { from, to, y: rows.element, tall, share: pose.z, command: pose.command }, theme);
  caption([{ symbol: 'αz' }], words.element, from, to, rows.element);
  drawDashpot(context, { from, to, y: rows.dashpot, tall: 0.62 * tall, piston: at((isSeries ? (middle + end) / 2 : 0.5) + 0.5 * stroke * (pose.x + (isSeries ? pose.w : 0)) * 0.9) }, theme);
  caption([{ symbol: 'c', sub: '0' }], words.dashpot, from, to, rows.dashpot, theme.stable);
  drawSpring(context, { from, to, y: rows.spring, tall: 0.5 * tall }, theme);
  caption([{ symbol: 'k', sub: '0' }], words.spring, from, to, rows.spring, theme.psi);
  drawBar(context, to, rows.top, isSeries ? rows.outer : rows.bottom, theme);
  if (isSeries) {
    drawBar(context, from, rows.element - tall / 2, rows.spring, theme);
    drawDashpot(context, { from: at(wall), to: from, y: rows.dashpot, tall: 0.62 * tall, piston: at((wall + middle) / 2 + 0.5 * stroke * pose.w * 0.9) }, theme);
    caption([{ symbol: 'c', sub: '1' }], words.seriesDashpot, at(wall), from, rows.dashpot, theme.stable);
    drawSpring(context, { from: at(wall), to, y: rows.outer, tall: 0.5 * tall }, theme);
    caption([{ symbol: 'k', sub: '1' }], words.outerSpring, at(wall), to, rows.outer, theme.psi);
    drawPlace(context, { at: from, rest: at(middle), y: rows.top, symbol: 'w' }, theme);
  }
  drawPlace(context, { at: to, rest: at(end), y: rows.top, symbol: 'x' }, theme);
  drawForce(context, to, rows.dashpot, pose.force * at(0.1), theme);
}

/** Where the parts lie, upward down. @param {Size} size @param {boolean} isSeries @param {Theme} theme */
function rowsOf({ height }, isSeries, theme) {
  const [top, bottom] = [theme.size * 2.4, height - theme.size * 0.8];
  const step = (bottom - top) / (isSeries ? 4 : 3);
  const row = (/** @type {number} */ n) => top + step * (n + 0.62);
  return { top, bottom, step, element: row(0), dashpot: row(1), spring: row(2), outer: row(3) };
}

/** @param {CanvasRenderingContext2D} context @param {number} x @param {number} top @param {number} bottom @param {Theme} theme */
function drawWall(context, x, top, bottom, theme) {
  context.strokeStyle = theme.ink;
  context.lineWidth = 2 * theme.line;
  context.beginPath();
  context.moveTo(x, top);
  context.lineTo(x, bottom);
  context.stroke();
  context.strokeStyle = theme.ink2;
  context.lineWidth = theme.line;
  context.beginPath();
  for (let y = top + 8; y <= bottom; y += 9) {
    context.moveTo(x, y - 8);
    context.lineTo(x - 8, y);
  }
  context.stroke();
}

/** What ties the ends of parts together. @param {CanvasRenderingContext2D} context @param {number} x @param {number} top @param {number} bottom @param {Theme} theme */
function drawBar(context, x, top, bottom, theme) {
  context.strokeStyle = theme.ink;
  context.lineWidth = 2.6 * theme.line;
  context.lineCap = 'round';
  context.beginPath();
  context.moveTo(x, top + theme.size);
  context.lineTo(x, bottom);
  context.stroke();
  context.lineCap = 'butt';
}

/** How far an end is from where it rests. @param {CanvasRenderingContext2D} context @param {{ at: number, rest: number, y: number, symbol: string }} place @param {Theme} theme */
function drawPlace(context, { at, rest, y, symbol }, theme) {
  context.strokeStyle = theme.ghost;
  context.lineWidth = theme.line;
  context.setLineDash([2, 3]);
  context.beginPath();
  context.moveTo(rest, y - theme.size * 0.9);
  context.lineTo(rest, y + theme.size);
  context.stroke();
  context.setLineDash([]);
  context.strokeStyle = context.fillStyle = theme.ink;
  context.lineWidth = 1.8 * theme.line;
  drawArrow(context, { x: rest, y: y - theme.size * 0.1 }, { x: at, y: y - theme.size * 0.1 }, theme);
  drawLabel(context, [{ symbol }], rest, y - theme.size * 1.2, theme, { align: 'center', weight: 600 });
}

/** The force that the damper resists with, at its rod. @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} length @param {Theme} theme */
function drawForce(context, x, y, length, theme) {
  drawRod(context, x, x + theme.size * 1.1, y, theme);
  context.strokeStyle = context.fillStyle = theme.force;
  context.lineWidth = 3 * theme.line;
  const from = x + theme.size * 1.4;
  if (Math.abs(length) > 2) drawArrow(context, { x: length < 0 ? from - length : from, y }, { x: length < 0 ? from : from + length, y }, theme);
  drawLabel(context, [{ symbol: 'F' }], from, y - theme.size * 0.9, theme, { weight: 600 });
}
