import { decimalsFor } from '../words/number.js';
import { linear, powers, tickDecimals, ticks } from './scale.js';
import { drawLabel, textFont, widthOfLabel } from './text.js';
import { nameOf } from './quantities.js';

/**
 * The axes of a plot: grid, numbers and names. No frame; the zero lines alone stand out.
 *
 * @typedef {import('./canvas.js').Size} Size
 * @typedef {import('./quantities.js').Quantity} Quantity
 * @typedef {import('./text.js').Run} Run
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{ left: number, right: number, top: number, bottom: number }} Box in pixels
 * @typedef {{ at: number, text: string, isZero: boolean }} Mark a line of the grid, where it stands, and its number
 * @typedef {{ at: (value: number) => number, marks: Mark[], name: (isShort: boolean) => Run[] }} Axis
 *   `at`: where a value in SI units stands
 */

/** Below this height a plot spares its edges, in heights of small type. */
const low = 16;

/**
 * Where the curves go, within an area that also holds numbers and names.
 * @param {Size} size
 * @param {Theme} theme
 * @param {'beside' | 'above'} upName where the name of the upward axis stands
 * @returns {Box}
 */
export function frameOf({ width, height }, theme, upName = 'beside') {
  const isBeside = upName === 'beside';
  const isLow = isBeside && height < low * theme.size;
  return {
    left: theme.size * (isBeside ? 5.2 : 3.6), right: width - theme.size * 1.6,
    top: theme.size * (isLow ? 0.8 : isBeside ? 1.2 : 2.2), bottom: height - theme.size * (isLow ? 3 : 3.3),
  };
}

/**
 * What the name of the axis to the right leaves free of its row.
 * @param {CanvasRenderingContext2D} context
 * @param {Box} frame
 * @param {Quantity} across
 * @param {Theme} theme
 * @param {Voice} voice
 * @returns {Box}
 */
export function footOf(context, { left, right, bottom }, across, theme, voice) {
  const name = widthOfLabel(context, nameOf(across, voice), theme, 600);
  return { left, right: right - name - theme.size, top: bottom + theme.size * 1.7, bottom: bottom + theme.size * 3.2 };
}

/**
 * An axis to the right, with as many marks as there is room for.
 * @param {Quantity} quantity
 * @param {[number, number]} domain its ends in SI units
 * @param {Box} frame
 * @param {Theme} theme
 * @param {Voice} voice
 * @returns {Axis}
 */
export function axisAcross(quantity, domain, frame, theme, voice) {
  const most = Math.min(10, (frame.right - frame.left) / (theme.size * 4.2));
  return axisOf(quantity, domain, [frame.left, frame.right], most, voice);
}

/**
 * An axis upward.
 * @param {Quantity} quantity
 * @param {[number, number]} domain
 * @param {Box} frame
 * @param {Theme} theme
 * @param {Voice} voice
 * @returns {Axis}
 */
export function axisUp(quantity, domain, frame, theme, voice) {
  const most = Math.min(6, (frame.bottom - frame.top) / (theme.size * 1.9));
  return axisOf(quantity, domain, [frame.bottom, frame.top], most, voice);
}

/**
 * A logarithmic axis upward, a mark at each power of ten; what lies below it stands at its foot.
 * @param {Quantity} quantity
 * @param {[number, number]} domain
 * @param {Box} frame
 * @param {Voice} voice
 * @returns {Axis}
 */
export function logAxisUp(quantity, [from, to], frame, voice) {
  const { perSI, unit } = quantity;
  const place = linear([Math.log10(from), Math.log10(to)], [frame.bottom, frame.top]);
  const at = (/** @type {number} */ value) => place(Math.log10(Math.max(value, from)));
  const marks = powers(from * perSI, to * perSI).map((power) => ({
    at: at(power / perSI), text: voice.number(power, decimalsFor(power, 1)) + (unit === '°' ? '°' : ''), isZero: false,
  }));
  return { at, marks, name: (isShort) => nameOf(quantity, voice, isShort) };
}

/**
 * An axis along any stretch: `range` are the places of its ends.
 * @param {Quantity} quantity
 * @param {[number, number]} domain
 * @param {[number, number]} range
 * @param {number} most marks
 * @param {Voice} voice
 * @returns {Axis}
 */
export function axisOf(quantity, [from, to], range, most, voice) {
  const { perSI, unit } = quantity;
  const at = linear([from, to], range);
  const sparse = ticks(from * perSI, to * perSI, most);
  // A lone number gives no scale.
  const shown = sparse.length < 3 ? ticks(from * perSI, to * perSI, 2 * most) : sparse;
  const decimals = tickDecimals(shown);
  const marks = shown.map((tick) => ({
    at: at(tick / perSI), text: voice.number(tick, decimals) + (unit === '°' ? '°' : ''), isZero: tick === 0,
  }));
  return { at, marks, name: (isShort) => nameOf(quantity, voice, isShort) };
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Box} frame
 * @param {Axis} x
 * @param {Axis} y
 * @param {Theme} theme
 * @param {{ up: 'beside' | 'above', nameAt?: number }} [name] where the name of the upward axis stands, above the frame
 *   or above another height
 */
export function drawAxes(context, frame, x, y, theme, { up, nameAt = frame.top } = { up: 'beside' }) {
  drawGrid(context, frame, x.marks, y.marks, theme);
  drawNumbers(context, frame, x.marks, y.marks, theme);
  context.fillStyle = theme.ink2;
  const nameWithin = (/** @type {Axis} */ { name }, /** @type {number} */ room) => name(widthOfLabel(context, name(false), theme, 600) > room);
  const width = frame.right - frame.left + theme.size;
  drawLabel(context, nameWithin(x, width), frame.right, frame.bottom + theme.size * 2.7, theme, { align: 'right', weight: 600 });
  if (up === 'above') {
    drawLabel(context, nameWithin(y, width), frame.left, nameAt - theme.size * 0.8, theme, { weight: 600 });
    return;
  }
  context.save();
  context.translate(theme.size * 1.25, (frame.top + frame.bottom) / 2);
  context.rotate(-Math.PI / 2);
  drawLabel(context, nameWithin(y, frame.bottom - frame.top), 0, 0, theme, { align: 'center', weight: 600 });
  context.restore();
}

/**
 * Lines through the marks, those through zero last.
 * @param {CanvasRenderingContext2D} context
 * @param {Box} frame
 * @param {Mark[]} across
 * @param {Mark[]} up
 * @param {Theme} theme
 */
export function drawGrid(context, { left, right, top, bottom }, across, up, theme) {
  context.lineWidth = 1;
  for (const zero of [false, true]) {
    context.strokeStyle = zero ? theme.ghost : theme.rule;
    context.beginPath();
    for (const { at, isZero } of across) if (isZero === zero) line(context, at, top, at, bottom);
    for (const { at, isZero } of up) if (isZero === zero) line(context, left, at, right, at);
    context.stroke();
  }
}

/**
 * Numbers below and to the left, none cut by the right edge.
 * @param {CanvasRenderingContext2D} context
 * @param {Box} frame
 * @param {Mark[]} across
 * @param {Mark[]} up
 * @param {Theme} theme
 */
export function drawNumbers(context, { left, right, bottom }, across, up, theme) {
  context.font = textFont(theme, 0.95);
  context.fillStyle = theme.ink2;
  context.textBaseline = 'middle';
  context.textAlign = 'right';
  for (const { at, text } of up) context.fillText(text, left - theme.size * 0.6, at);
  context.textAlign = 'center';
  for (const { at, text } of across) {
    const half = context.measureText(text).width / 2;
    context.fillText(text, Math.min(at, right + theme.size * 1.5 - half), bottom + theme.size);
  }
}

/** @param {CanvasRenderingContext2D} context @param {number} x1 @param {number} y1 @param {number} x2 @param {number} y2 */
function line(context, x1, y1, x2, y2) {
  context.moveTo(Math.round(x1) + 0.5, Math.round(y1) + 0.5);
  context.lineTo(Math.round(x2) + 0.5, Math.round(y2) + 0.5);
}
