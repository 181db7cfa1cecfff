import { drawRing } from './points.js';
import { decimalsUpTo, quantities, valueOf } from './quantities.js';
import { differenceOf, readingAt } from './reading.js';
import { textFont } from './text.js';

/**
 * Cursors on a time history, and what they read in one fixed corner.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./reading.js').Reading} Reading
 * @typedef {import('./time-history.js').History} History
 * @typedef {import('./time-history.js').StateName} StateName
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/**
 * What one cursor reads, or two differ by; '' where there is nothing to read.
 * @param {number[]} cursors times in s, relative to now
 * @param {History} history
 * @param {StateName} shown
 * @param {number} limit the end of the axis, which decides the decimals
 * @param {Voice} voice
 */
export function cursorWords(cursors, history, shown, limit, voice) {
  const quantity = quantities[shown];
  const readings = readingsOf(cursors, history, shown);
  const decimals = decimalsUpTo(quantity, limit);
  const value = (/** @type {number} */ si) => valueOf(quantity, si, decimals, voice);
  const hertz = (/** @type {number | null} */ frequency) => (frequency === null ? [] : [`${voice.number(frequency, 1)} Hz`]);
  if (readings.length === 1) {
    const [{ time, value: now, peakToPeak, frequency }] = readings;
    const peaks = peakToPeak === null ? [] : [voice.say('cursor.peaks', { value: value(peakToPeak) })];
    return [when(time, voice), value(now), ...peaks, ...hertz(frequency)].join(' · ');
  }
  if (readings.length < 2) return '';
  const difference = differenceOf(readings[0], readings[1]);
  const symbol = quantity.dotted ? `${quantity.symbol}\u0307` : quantity.symbol;
  return [`Δt ${voice.number(difference.time * 1000, 1)} ms`, ...hertz(difference.frequency).map((words) => `1/Δt ${words}`), `Δ${symbol} ${value(difference.value)}`].join(' · ');
}

/** @param {number} time in s @param {Voice} voice */
function when(time, voice) {
  const milliseconds = voice.number(Math.abs(time) * 1000, 0);
  if (milliseconds === '0') return voice.say('timeline.now');
  return time < 0 ? voice.say('cursor.ago', { time: milliseconds }) : voice.say('cursor.ahead', { time: milliseconds });
}

/**
 * @param {number[]} cursors @param {History} history @param {StateName} shown
 * @returns {Reading[]}
 */
function readingsOf(cursors, history, shown) {
  return cursors.map((at) => readingAt(history.time, history[shown] ?? [], at)).filter((reading) => reading !== null);
}

/**
 * A vertical line and a ring at each cursor.
 * @param {CanvasRenderingContext2D} context
 * @param {{ cursors: number[], history: History, shown: StateName }} reading
 * @param {Box} box
 * @param {(time: number) => number} x
 * @param {(value: number) => number} y
 * @param {Theme} theme
 */
export function drawCursors(context, { cursors, history, shown }, box, x, y, theme) {
  for (const { time, value } of readingsOf(cursors, history, shown)) {
    context.strokeStyle = theme.ink;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(Math.round(x(time)) + 0.5, box.top - 4);
    context.lineTo(Math.round(x(time)) + 0.5, box.bottom);
    context.stroke();
    drawRing(context, x(time), y(value), 4.5 * Math.sqrt(theme.line), theme[quantities[shown].color], theme);
  }
}

/** @param {CanvasRenderingContext2D} context @param {string} words @param {Theme} theme */
export function widthOfReading(context, words, theme) {
  context.font = textFont(theme, 1, 600);
  return context.measureText(words).width;
}

/**
 * The reading at the right end above the plot, or within a small one, on a plate and never wider than it.
 * @param {CanvasRenderingContext2D} context
 * @param {string} words
 * @param {Box} box
 * @param {Theme} theme
 * @param {{ isSmall: boolean }} options
 */
export function writeReading(context, words, box, theme, { isSmall }) {
  const width = widthOfReading(context, words, theme) + theme.size;
  const scale = Math.min(1, (box.right - box.left) / width);
  // Where another lane is above, its edge is covered rather than what is read.
  const top = box.top > 2 * theme.size ? box.top - theme.size * 1.7 : box.top;
  if (isSmall) {
    context.globalAlpha = 0.92;
    context.fillStyle = theme.surface;
    context.fillRect(box.right - scale * width, top, scale * width, theme.size * 1.6);
    context.globalAlpha = 1;
  }
  context.font = textFont(theme, scale, 600);
  context.textAlign = 'right';
  context.textBaseline = 'alphabetic';
  context.fillStyle = theme.ink;
  if (isSmall) context.fillText(words, box.right - theme.size / 2, top + theme.size * 1.1);
  else context.fillText(words, box.right, box.top - theme.size * 0.65);
}
