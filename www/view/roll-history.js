import { axisUp, drawGrid, drawNumbers } from './axes.js';
import { curveOf, strokeCurve } from './curve.js';
import { nameOf, quantities } from './quantities.js';
import { linear, tickDecimals, ticks } from './scale.js';
import { drawLabel, textFont, widthOfLabel } from './text.js';
import { drawVeil } from './veil.js';

/**
 * The torsion angle of a landing roll in full: the least and the largest of each stretch of time, so that no peak is lost, with
 * the speed along the top; and beside it, large, the cycles around now.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./canvas.js').Size} Size
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{ time: ArrayLike<number>, low: ArrayLike<number>, high: ArrayLike<number> }} Band
 * @typedef {{
 *   from: number, to: number, band: Band, limit: number, threshold: number, freeplay: number, now: number | null,
 *   speeds: readonly { time: number, text: string }[], window: { time: ArrayLike<number>, torsionAngle: ArrayLike<number> } | null, span: [number, number],
 *   isOld: boolean, veiled: boolean,
 * }} Shown times in s, angles in rad; `threshold`: what is called shimmy; `speeds`: marks along the top; `window`: ψ around now,
 *   seen over `span`
 */

/** The share of the window beside it. */
const windowShare = 0.3;
/** Where less is left for it than this, in heights of small type, there is none. */
const narrowest = 12;

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Size} size
 * @param {Shown} shown
 * @param {Theme} theme
 * @param {Voice} voice
 * @returns {{ frame: Box, from: (x: number) => number } | null} which time stands at a place
 */
export function drawRollHistory(context, size, shown, theme, voice) {
  const hasWindow = shown.window !== null && windowShare * size.width > narrowest * theme.size;
  const wide = hasWindow ? (1 - windowShare) * size.width : size.width;
  const frame = { left: theme.size * 4.4, right: wide - theme.size * 1.4, top: theme.size * 1.9, bottom: size.height - theme.size * 1.8 };
  if (frame.right - frame.left < 40 || frame.bottom - frame.top < 24) return null;
  drawFull(context, frame, shown, theme, voice);
  if (hasWindow) drawWindow(context, { ...frame, left: wide + theme.size * 0.6, right: size.width - theme.size * 1.2 }, shown, theme, voice);
  return { frame, from: linear([frame.left, frame.right], [shown.from, shown.to]) };
}

/** @param {CanvasRenderingContext2D} context @param {Box} frame @param {Shown} shown @param {Theme} theme @param {Voice} voice */
function drawFull(context, frame, { from, to, band, limit, threshold, now, speeds, span, isOld, veiled }, theme, voice) {
  const x = linear([from, to], [frame.left, frame.right]);
  const up = axisUp(quantities.torsionAngle, [-limit, limit], frame, theme, voice);
  const shownTimes = ticks(from, to, Math.min(10, (frame.right - frame.left) / (theme.size * 4)));
  const decimals = tickDecimals(shownTimes);
  const across = shownTimes.map((time, i) => ({ at: x(time), text: voice.number(time, decimals) + (i === shownTimes.length - 1 ? ' s' : ''), isZero: false }));
  drawGrid(context, frame, across, up.marks, theme);
  drawNumbers(context, frame, across, up.marks, theme);
  drawSpeeds(context, frame, speeds.map(({ time, text }) => ({ x: x(time), text })), theme);
  drawLabel(context, nameOf(quantities.torsionAngle, voice, true), theme.size * 0.5, (frame.top + frame.bottom) / 2 + theme.size * 0.4, theme);
  const edge = now === null ? frame.right : Math.min(Math.max(x(now), frame.left), frame.right);
  context.save();
  context.beginPath();
  context.rect(frame.left, frame.top - 2, frame.right - frame.left, frame.bottom - frame.top + 4);
  context.clip();
  context.globalAlpha = isOld ? 0.45 : 1;
  const strength = context.globalAlpha;
  context.fillStyle = theme.psi;
  fill(context, band, x, up.at, [frame.left, edge], frame, strength * 0.85);
  if (!veiled) fill(context, band, x, up.at, [edge, frame.right], frame, strength * (theme.scheme === 'dark' ? 0.45 : 0.35));
  context.globalAlpha = 1;
  context.strokeStyle = theme.unstable;
  context.lineWidth = theme.line;
  context.setLineDash([2 * theme.line, 3 * theme.line]);
  context.beginPath();
  for (const y of [up.at(threshold), up.at(-threshold)]) {
    context.moveTo(frame.left, y);
    context.lineTo(frame.right, y);
  }
  context.stroke();
  context.setLineDash([]);
  context.restore();
  if (veiled) drawVeil(context, { ...frame, left: edge }, theme);
  if (now === null) return;
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.5;
  const [left, right] = span.map((time) => x(now + time));
  context.strokeRect(Math.round(Math.max(left, frame.left)) + 0.5, frame.top - 2.5, Math.max(4, Math.round(Math.min(right, frame.right) - Math.max(left, frame.left))), frame.bottom - frame.top + 5);
}

/** The band between two places. @param {CanvasRenderingContext2D} context @param {Band} band @param {(time: number) => number} x @param {(angle: number) => number} y @param {[number, number]} ends in px @param {Box} frame @param {number} strength */
function fill(context, { time, low, high }, x, y, [from, to], { top, bottom }, strength) {
  if (to <= from || time.length < 2) return;
  context.save();
  context.globalAlpha = strength;
  context.beginPath();
  context.rect(from, top - 2, to - from, bottom - top + 4);
  context.clip();
  context.beginPath();
  for (let i = 0; i < time.length; i++) context[i ? 'lineTo' : 'moveTo'](x(time[i]), Math.min(y(high[i]), y(low[i]) - 1.5));
  for (let i = time.length - 1; i >= 0; i--) context.lineTo(x(time[i]), y(low[i]));
  context.closePath();
  context.fill();
  context.restore();
}

/** Speeds along the top, none over another. @param {CanvasRenderingContext2D} context @param {Box} frame @param {{ x: number, text: string }[]} marks @param {Theme} theme */
function drawSpeeds(context, { left, right, top }, marks, theme) {
  context.font = textFont(theme, 0.95);
  context.fillStyle = theme.ink2;
  context.strokeStyle = theme.ghost;
  context.lineWidth = 1;
  context.textAlign = 'left';
  context.textBaseline = 'alphabetic';
  let free = left - theme.size;
  for (const { x, text } of marks) {
    const width = context.measureText(text).width;
    const start = Math.min(Math.max(x - width / 2, left), right + theme.size - width);
    if (start < free) continue;
    free = start + width + theme.size * 0.8;
    context.fillText(text, start, top - theme.size * 0.55);
    context.beginPath();
    context.moveTo(Math.round(x) + 0.5, top - theme.size * 0.35);
    context.lineTo(Math.round(x) + 0.5, top);
    context.stroke();
  }
}

/** The cycles around now, as large as they are. @param {CanvasRenderingContext2D} context @param {Box} frame @param {Shown} shown @param {Theme} theme @param {Voice} voice */
function drawWindow(context, frame, { window, span, limit, now, veiled }, theme, voice) {
  if (!window || now === null) return;
  const x = linear(span, [frame.left, frame.right]);
  const up = axisUp(quantities.torsionAngle, [-limit, limit], frame, theme, voice);
  const marks = ticks(span[0] * 1000, span[1] * 1000, Math.max(2, (frame.right - frame.left) / (theme.size * 5)));
  const across = marks.map((mark, i) => ({ at: x(mark / 1000), text: mark === 0 ? voice.say('timeline.now') : voice.number(mark, 0) + (i === marks.length - 1 ? ' ms' : ''), isZero: mark === 0 }));
  drawGrid(context, frame, across, up.marks, theme);
  drawNumbers(context, frame, across, [], theme);
  const name = [{ text: voice.say('landing.window') }];
  if (widthOfLabel(context, name, theme, 600) < frame.right - frame.left) drawLabel(context, name, frame.left, frame.top - theme.size * 0.65, theme, { weight: 600 });
  context.save();
  context.beginPath();
  context.rect(frame.left, frame.top - 2, (veiled ? x(0) : frame.right) - frame.left, frame.bottom - frame.top + 4);
  context.clip();
  context.strokeStyle = theme.psi;
  context.lineJoin = 'round';
  context.lineWidth = 1.8 * theme.line;
  strokeCurve(context, curveOf(window.time, window.torsionAngle, (time) => x(time - now), up.at));
  context.restore();
  if (veiled) drawVeil(context, { ...frame, left: x(0) }, theme);
}
