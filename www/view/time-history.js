import { drawGrid, drawNumbers } from './axes.js';
import { strokeBlurred } from './blur.js';
import { cursorWords, drawCursors, widthOfReading, writeReading } from './cursors.js';
import { curveOf, strokeCurve } from './curve.js';
import { fillGap } from './gap.js';
import { drawGhosts } from './ghosts.js';
import { nameOf, quantities } from './quantities.js';
import { linear, tickDecimals, ticks } from './scale.js';
import { drawLabel, widthOfLabel } from './text.js';
import { drawVeil } from './veil.js';

/**
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./axes.js').Mark} Mark
 * @typedef {import('./quantities.js').Quantity} Quantity
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {'torsionAngle' | 'torsionRate' | 'lateralDeformation'} StateName
 * @typedef {{ time: ArrayLike<number> } & Partial<Record<StateName, ArrayLike<number>>>} History times in s, relative to now
 * @typedef {{
 *   past: History, future: History, from: number, to: number, limit: number, freeplay: number, value: number,
 *   frequency: number | null, shown?: StateName, ghosts?: { label: string, past: History }[], cursors?: number[],
 *   veiled?: boolean, exposure?: number,
 * }} Moment `from` … `to`: the window in s relative to now; `limit`: end of the axis; `value`: the shown state now;
 *   `shown`: which state, ψ unless said; `cursors`: one or two times; `veiled`: the future is not to be seen yet;
 *   `exposure`: the time of a frame, in s, where that is too long for a single position, else 0
 */

/** The symbol stands between the numbers of a small lane where it is this many times as high as a letter. */
const linesBesideLevels = 3.5;

/**
 * A state around now: past solid, future dotted, pinned runs dashed, now a line with a dot.
 * @param {CanvasRenderingContext2D} context
 * @param {Box} box
 * @param {Moment} moment
 * @param {Theme} theme
 * @param {Voice} voice
 * @param {{ isSmall: boolean }} options `isSmall` leaves out the words above the plot
 */
export function drawTimeHistory(context, box, moment, theme, voice, { isSmall }) {
  const { past, future, from, to, limit, ghosts = [], cursors = [], shown = 'torsionAngle', exposure = 0 } = moment;
  const quantity = quantities[shown];
  const x = linear([from, to], [box.left, box.right]);
  const y = linear([-limit, limit], [box.bottom, box.top]);
  const curve = (/** @type {History} */ history) => curveOf(history.time, history[shown] ?? [], x, y);
  const stroke = (/** @type {History} */ history) =>
    (exposure > 0 ? strokeBlurred(context, curve(history), x(exposure) - x(0)) : strokeCurve(context, curve(history)));

  if (shown === 'torsionAngle' && moment.freeplay > 0) {
    const edge = Math.min(moment.freeplay, limit);
    fillGap(context, { ...box, top: y(edge), bottom: y(-edge) }, theme);
  }
  const levels = levelsOf(quantity, limit, y, voice, isSmall);
  const times = timesOf(moment, x, (box.right - box.left) / (theme.size * 3.8), voice);
  drawGrid(context, box, times, levels, theme);
  drawNumbers(context, box, times, levels, theme);
  const history = cursors.length === 0 || moment.veiled ? past : joined(past, future, shown);
  const words = cursorWords(cursors, history, shown, limit, voice);
  const room = box.right - box.left - (words === '' ? 0 : widthOfReading(context, words, theme) + theme.size);
  nameState(context, box, quantity, moment.frequency, theme, voice, isSmall ? null : room);

  context.save();
  context.beginPath();
  context.rect(box.left, box.top - 2, box.right - box.left, box.bottom - box.top + 4);
  context.clip();
  drawGhosts(context, ghosts.map((ghost) => ({ curve: curve(ghost.past), isClosed: false })), theme);
  context.strokeStyle = theme[quantity.color];
  context.lineJoin = 'round';
  context.lineWidth = 2.2 * theme.line;
  stroke(past);
  if (!moment.veiled) {
    context.globalAlpha = 0.65;
    context.setLineDash([2 * theme.line, 3.5 * theme.line]);
    stroke(future);
    context.setLineDash([]);
    context.globalAlpha = 1;
  }
  context.restore();
  if (moment.veiled) drawVeil(context, { ...box, left: x(0) }, theme);

  context.strokeStyle = theme.ink;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(x(0), box.top - 4);
  context.lineTo(x(0), box.bottom);
  context.stroke();
  if (exposure === 0) {
    drawNow(context, box, x(0), y(moment.value), theme[quantity.color], theme);
  }
  if (words === '') return;
  drawCursors(context, { cursors, history, shown }, box, x, y, theme);
  writeReading(context, words, box, theme, { isSmall });
}

/** The state now; beyond the axis a triangle at its end, pointing on. @param {CanvasRenderingContext2D} context @param {Box} box @param {number} x @param {number} y @param {string} color @param {Theme} theme */
function drawNow(context, { top, bottom }, x, y, color, theme) {
  const size = 4.5 * Math.sqrt(theme.line);
  context.fillStyle = color;
  context.beginPath();
  if (y >= top && y <= bottom) context.arc(x, y, size, 0, 2 * Math.PI);
  else {
    const [edge, inward] = y < top ? [top, 1] : [bottom, -1];
    context.moveTo(x, edge);
    context.lineTo(x - size, edge + inward * 1.8 * size);
    context.lineTo(x + size, edge + inward * 1.8 * size);
    context.closePath();
  }
  context.fill();
}

/**
 * Past and future as one history, so that a cycle across now can be read.
 * @param {History} past @param {History} future @param {StateName} shown @returns {History}
 */
export function joined(past, future, shown) {
  const end = past.time.length ? past.time[past.time.length - 1] : -Infinity;
  let next = 0;
  while (next < future.time.length && future.time[next] <= end) next++;
  const both = (/** @type {ArrayLike<number>} */ one, /** @type {ArrayLike<number>} */ other) => [...Array.from(one), ...Array.from(other).slice(next)];
  return { time: both(past.time, future.time), [shown]: both(past[shown] ?? [], future[shown] ?? []) };
}

/**
 * @param {Moment} moment @param {(time: number) => number} x @param {number} room how many numbers fit
 * @param {Voice} voice @returns {Mark[]}
 */
function timesOf({ from, to }, x, room, voice) {
  const times = ticks(from * 1000, to * 1000, Math.min(6, room));
  const decimals = tickDecimals(times);
  return times.map((time, i) => {
    const number = voice.number(time, decimals);
    const text = time === 0 ? voice.say('timeline.now') : i === 0 ? `${number} ms` : time > 0 ? `+${number}` : number;
    return { at: x(time / 1000), text, isZero: false };
  });
}

/**
 * Zero and a round value either side: a lane has no room for more.
 * @param {Quantity} quantity @param {number} limit @param {(value: number) => number} y @param {Voice} voice
 * @param {boolean} isSmall @returns {Mark[]}
 */
function levelsOf({ perSI, unit }, limit, y, voice, isSmall) {
  const [level] = ticks(0, limit * perSI, 2.5).slice(-1);
  const decimals = level < 1 ? Math.ceil(-Math.log10(level)) : 0;
  return [level, 0, -level].map((value) => {
    // In a small lane the symbol stands at zero instead.
    const text = value === 0 && isSmall ? '' : voice.number(value, value === 0 ? 0 : decimals) + (unit === '°' ? '°' : '');
    return { at: y(value / perSI), text, isZero: value === 0 };
  });
}

/**
 * The state's name and beat above the lane, in as many words as there is room for; within a small lane its symbol.
 * @param {CanvasRenderingContext2D} context @param {Box} box @param {Quantity} quantity @param {number | null} frequency
 * @param {Theme} theme @param {Voice} voice @param {number | null} room null for none
 */
function nameState(context, box, quantity, frequency, theme, voice, room) {
  const { symbol, dotted, unit, color } = quantity;
  context.fillStyle = theme[color];
  const hasPlace = box.bottom - box.top > linesBesideLevels * theme.size;
  if (room === null && unit === '°' && hasPlace) {
    drawLabel(context, [{ symbol, dotted }], box.left - 10, (box.top + box.bottom) / 2 + theme.size * 0.35, theme, { align: 'right' });
  } else if (room === null) {
    drawLabel(context, nameOf(quantity, voice, true), box.left + theme.size * 0.4, box.top + theme.size, theme, { weight: 600, halo: theme.surface });
  } else {
    const name = nameOf(quantity, voice);
    const wishes = [[...name, { text: frequency ? ` · ${voice.number(frequency, 1)} Hz` : '' }], name, nameOf(quantity, voice, true)];
    const fitting = wishes.find((wish) => widthOfLabel(context, wish, theme, 600) <= room);
    drawLabel(context, fitting ?? [{ symbol, dotted }], box.left, box.top - theme.size * 0.65, theme, { weight: 600 });
  }
}
