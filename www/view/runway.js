import { drawAircraft } from './aircraft.js';
import { linear, tickDecimals, ticks } from './scale.js';
import { drawSpeedTape, widthOfTape } from './speed-tape.js';
import { textFont, writeEdged } from './text.js';
import { drawVeil } from './veil.js';

/**
 * A landing roll from above: the runway with its distances, what the nose wheel drew on it, where it touched down, where shimmy
 * began and ended and where the roll ends, the aircraft where it is now, and beside it its speed on a tape.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./canvas.js').Size} Size
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{ distance: number, text: string, kind: 'plain' | 'shimmy' }} Flag
 * @typedef {{
 *   length: number, distance: ArrayLike<number>, low: ArrayLike<number>, high: ArrayLike<number>, limit: number,
 *   shimmy: [number, number] | null, flags: readonly Flag[], now: { distance: number, velocity: number } | null, fastest: number,
 *   isOld: boolean, veiled: boolean,
 * }} Shown `length` of the roll, in m; `distance`, `low`, `high`: ψ in stretches of it; `limit`: the ψ that is drawn as wide as half
 *   of the runway; `shimmy`: from where to where; `fastest`: the tape's end, in m/s
 */

/** How far the runway goes before touchdown and beyond the roll, as shares of it. */
const [before, beyond] = [0.13, 0.06];

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Size} size
 * @param {Shown} shown
 * @param {Theme} theme
 * @param {Voice} voice
 * @returns {{ frame: Box, at: (distance: number) => number, from: (x: number) => number } | null} where distances stand, and which distance stands at a place
 */
export function drawRunway(context, size, shown, theme, voice) {
  const tape = widthOfTape(theme);
  const [left, right] = [theme.size * 1.2, size.width - tape - theme.size * 2];
  const flagRows = size.height > 8.5 * theme.size ? 2 : 1;
  const [top, bottom] = [theme.size * (0.9 + 1.5 * flagRows), size.height - theme.size * 2.1];
  if (right - left < 60 || bottom - top < 20) return null;
  const ends = /** @type {[number, number]} */ ([-before, 1 + beyond].map((share) => share * Math.max(shown.length, 1)));
  const at = linear(ends, [left, right]);
  const frame = { left, right, top, bottom };
  drawPavement(context, frame, theme);
  drawDistances(context, frame, at, ends[1], theme, voice);
  if (shown.now || !shown.veiled) drawSpeedTape(context, { left: size.width - tape - theme.size * 0.6, right: size.width - theme.size * 0.6, top: theme.size * 0.6, bottom: size.height - theme.size * 0.6 }, { velocity: shown.now?.velocity ?? shown.fastest, fastest: shown.fastest }, theme, voice);
  const now = at(shown.now?.distance ?? 0);
  const seen = shown.veiled ? now : right;
  context.save();
  context.globalAlpha = shown.isOld ? 0.45 : 1;
  context.beginPath();
  context.rect(left, 0, Math.max(seen - left, 0), size.height);
  context.clip();
  if (shown.shimmy) markShimmy(context, frame, shown.shimmy.map(at), theme);
  drawSwing(context, frame, shown, at, now, theme);
  context.restore();
  if (shown.veiled) drawVeil(context, { ...frame, left: Math.max(now, left) }, theme);
  else drawFlags(context, frame, shown.flags, at, flagRows, theme);
  if (shown.now) drawAircraft(context, { x: now, y: (top + bottom) / 2, length: Math.min(6.5 * theme.size, 0.15 * (right - left)) }, theme);
  return { frame, at, from: linear([left, right], ends) };
}

/** Asphalt between its edges, the threshold's bars, the centre line. @param {CanvasRenderingContext2D} context @param {Box} frame @param {Theme} theme */
function drawPavement(context, { left, right, top, bottom }, theme) {
  context.fillStyle = theme.ground;
  context.fillRect(left, top, right - left, bottom - top);
  context.strokeStyle = theme.ghost;
  context.lineWidth = 1.5 * theme.line;
  context.beginPath();
  for (const y of [top, bottom]) {
    context.moveTo(left, y);
    context.lineTo(right, y);
  }
  context.stroke();
  context.fillStyle = theme.surface;
  const [height, bar] = [bottom - top, (bottom - top) / 17];
  for (let i = 0; i < 8; i++) {
    if (i === 3 || i === 4) continue;
    context.fillRect(left + 3, top + height * 0.06 + i * 2 * bar, theme.size * 1.1, bar);
  }
  context.strokeStyle = theme.surface;
  context.lineWidth = 2 * theme.line;
  context.setLineDash([10, 8]);
  context.beginPath();
  context.moveTo(left + theme.size * 1.8, (top + bottom) / 2);
  context.lineTo(right, (top + bottom) / 2);
  context.stroke();
  context.setLineDash([]);
}

/** @param {CanvasRenderingContext2D} context @param {Box} frame @param {(distance: number) => number} at @param {number} end in m @param {Theme} theme @param {Voice} voice */
function drawDistances(context, { left, right, bottom }, at, end, theme, voice) {
  const marks = ticks(0, end, Math.min(10, (right - left) / (theme.size * 5)));
  const decimals = tickDecimals(marks);
  context.strokeStyle = theme.ghost;
  context.lineWidth = 1;
  context.beginPath();
  for (const mark of marks) {
    context.moveTo(Math.round(at(mark)) + 0.5, bottom);
    context.lineTo(Math.round(at(mark)) + 0.5, bottom + theme.size * 0.4);
  }
  context.stroke();
  context.font = textFont(theme, 0.95);
  context.fillStyle = theme.ink2;
  context.textBaseline = 'alphabetic';
  marks.forEach((mark, i) => {
    context.textAlign = 'center';
    context.fillText(`${voice.number(mark, decimals)}${i === marks.length - 1 ? ' m' : ''}`, at(mark), bottom + theme.size * 1.6);
  });
}

/** Where it shimmies: hatched, as all that is unstable. @param {CanvasRenderingContext2D} context @param {Box} frame @param {number[]} ends in px @param {Theme} theme */
function markShimmy(context, { top, bottom }, [from, to], theme) {
  const width = Math.max(to - from, 2);
  const { globalAlpha } = context;
  context.save();
  context.beginPath();
  context.rect(from, top, width, bottom - top);
  context.clip();
  context.fillStyle = theme.unstable;
  context.globalAlpha = globalAlpha * 0.13;
  context.fillRect(from, top, width, bottom - top);
  context.globalAlpha = globalAlpha * 0.45;
  context.strokeStyle = theme.unstable;
  context.lineWidth = theme.line;
  context.beginPath();
  const height = bottom - top;
  for (let x = from - height; x < to; x += 8 * theme.line) {
    context.moveTo(x, bottom);
    context.lineTo(x + height, top);
  }
  context.stroke();
  context.restore();
}

/** What the nose wheel drew: as wide as it swung, dark so far, pale from now on. @param {CanvasRenderingContext2D} context @param {Box} frame @param {Shown} shown @param {(distance: number) => number} at @param {number} now in px @param {Theme} theme */
function drawSwing(context, { left, right, top, bottom }, { distance, low, high, limit, now: isThere }, at, now, theme) {
  const y = linear([-limit, limit], [bottom, top]);
  const count = distance.length;
  if (count < 2) return;
  const { globalAlpha } = context;
  const band = (/** @type {number} */ from, /** @type {number} */ to, /** @type {number} */ strength) => {
    if (to <= from) return;
    context.save();
    context.beginPath();
    context.rect(from, top, to - from, bottom - top);
    context.clip();
    context.globalAlpha = globalAlpha * strength;
    context.beginPath();
    // At least a hairline: a wheel that rolls straight draws a line.
    for (let i = 0; i < count; i++) context[i ? 'lineTo' : 'moveTo'](at(distance[i]), Math.min(y(high[i]), y(0) - 0.75));
    for (let i = count - 1; i >= 0; i--) context.lineTo(at(distance[i]), Math.max(y(low[i]), y(0) + 0.75));
    context.closePath();
    context.fill();
    context.restore();
  };
  context.fillStyle = theme.psi;
  const edge = isThere ? now : right;
  band(left, edge, 0.85);
  band(edge, right, theme.scheme === 'dark' ? 0.45 : 0.35);
}

/**
 * Flags above the runway; of those that stand in each other's way the later goes a row up, or where there is none loses its words.
 * @param {CanvasRenderingContext2D} context @param {Box} frame @param {readonly Flag[]} flags @param {(distance: number) => number} at @param {number} rows @param {Theme} theme
 */
function drawFlags(context, { left, right, top, bottom }, flags, at, rows, theme) {
  /** @type {number[]} Where each row is free from. */
  const free = Array.from({ length: rows }, () => left);
  context.textBaseline = 'alphabetic';
  for (const { distance, text, kind } of [...flags].sort((one, other) => one.distance - other.distance)) {
    const x = at(distance);
    const color = kind === 'shimmy' ? theme.unstable : theme.ink;
    context.font = textFont(theme, 1, kind === 'shimmy' ? 600 : 400);
    const width = context.measureText(text).width;
    const start = Math.min(Math.max(x + 4, left), right - width);
    const row = free.findIndex((from) => from <= start);
    const from = row < 0 ? top : top - theme.size * (0.45 + 1.5 * row);
    context.strokeStyle = color;
    context.lineWidth = 1.5 * theme.line;
    context.beginPath();
    context.moveTo(Math.round(x) + 0.5, from - (row < 0 ? 4 : 0));
    context.lineTo(Math.round(x) + 0.5, bottom);
    context.stroke();
    if (row < 0) continue;
    free[row] = start + width + theme.size;
    context.fillStyle = color;
    context.textAlign = 'left';
    writeEdged(context, text, start, from, theme);
  }
}
