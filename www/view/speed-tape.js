import { linear, roundStep } from './scale.js';
import { textFont } from './text.js';

/**
 * A speed on a tape that runs past a mark: on its left in m/s, on its right in knots.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/** A knot is a nautical mile of 1852 m in an hour, by definition. */
const knot = 1852 / 3600;
/** So much of the fastest speed is seen at once. */
const part = 0.5;

/** @param {Theme} theme */
export const widthOfTape = ({ size }) => 8.6 * size;

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Box} box
 * @param {{ velocity: number, fastest: number }} speed in m/s
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawSpeedTape(context, { left, right, top, bottom }, { velocity, fastest }, theme, voice) {
  const middle = (top + bottom) / 2;
  const across = (left + right) / 2;
  const span = Math.max(part * fastest, 1);
  const y = linear([velocity - span / 2, velocity + span / 2], [bottom, top]);
  context.fillStyle = theme.raised;
  context.fillRect(left, top, right - left, bottom - top);
  context.save();
  context.beginPath();
  context.rect(left, top, right - left, bottom - top);
  context.clip();
  context.font = textFont(theme, 0.9);
  context.textBaseline = 'middle';
  const most = (bottom - top) / (theme.size * 1.7);
  for (const [unit, side] of /** @type {[number, 1 | -1][]} */ ([[1, -1], [knot, 1]])) {
    const step = roundStep(span / unit / most);
    context.textAlign = side < 0 ? 'right' : 'left';
    context.fillStyle = theme.ink2;
    context.strokeStyle = theme.ghost;
    context.lineWidth = 1;
    context.beginPath();
    for (let mark = Math.max(0, Math.ceil((velocity - span / 2) / unit / step) * step); mark * unit <= velocity + span / 2; mark += step) {
      const at = y(mark * unit);
      context.moveTo(across + side * theme.size * 0.3, at);
      context.lineTo(across + side * theme.size * 0.8, at);
      context.fillText(voice.number(mark, 0), across + side * theme.size * 1.2, at);
    }
    context.stroke();
  }
  context.restore();
  drawMark(context, { left, right, middle }, velocity, theme, voice);
}

/** The speed of now, in both units. @param {CanvasRenderingContext2D} context @param {{ left: number, right: number, middle: number }} place @param {number} velocity @param {Theme} theme @param {Voice} voice */
function drawMark(context, { left, right, middle }, velocity, theme, voice) {
  const half = theme.size * 1.15;
  context.fillStyle = theme.ink;
  context.beginPath();
  context.moveTo(left - theme.size * 0.5, middle);
  context.lineTo(left, middle - half);
  context.lineTo(right, middle - half);
  context.lineTo(right, middle + half);
  context.lineTo(left, middle + half);
  context.closePath();
  context.fill();
  context.fillStyle = theme.surface;
  context.textBaseline = 'middle';
  const across = (left + right) / 2;
  for (const [unit, name, side] of /** @type {[number, string, 1 | -1][]} */ ([[1, 'm/s', -1], [knot, 'kn', 1]])) {
    const number = voice.number(velocity / unit, 0);
    context.font = textFont(theme, 1.1, 600);
    const width = context.measureText(number).width;
    context.font = textFont(theme, 0.8);
    const all = width + theme.size * 0.25 + context.measureText(name).width;
    const start = across + side * ((right - left) / 4) - all / 2;
    context.textAlign = 'left';
    context.fillText(name, start + width + theme.size * 0.25, middle + theme.size * 0.1);
    context.font = textFont(theme, 1.1, 600);
    context.fillText(number, start, middle);
  }
}
