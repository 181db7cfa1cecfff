import { linear, tickDecimals, ticks } from './scale.js';
import { drawLabel, textFont } from './text.js';

/**
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{ left: number, right: number, top: number, bottom: number }} Box
 * @typedef {{ time: ArrayLike<number>, torsionAngle: ArrayLike<number> }} History times in s, relative to now
 * @typedef {{
 *   past: History, future: History, from: number, to: number, limit: number, freeplay: number,
 *   angle: number, frequency: number | null,
 * }} Moment `from` … `to`: the window in s relative to now; `limit`: end of the axis in rad; `angle`: ψ now
 */

const degrees = 180 / Math.PI;

/**
 * ψ(t) around now: past solid, future dotted, now a line with a dot.
 * @param {CanvasRenderingContext2D} context
 * @param {Box} box
 * @param {Moment} moment
 * @param {Theme} theme
 * @param {Voice} voice
 * @param {{ isSmall: boolean }} options `isSmall` leaves out the words above the plot
 */
export function drawTimeHistory(context, box, moment, theme, voice, { isSmall }) {
  const x = linear([moment.from, moment.to], [box.left, box.right]);
  const y = linear([-moment.limit, moment.limit], [box.bottom, box.top]);

  drawBand(context, box, moment, y, theme);
  drawTimes(context, box, moment, x, theme, voice);
  drawAngles(context, box, moment, y, theme, voice, isSmall);

  context.save();
  context.beginPath();
  context.rect(box.left, box.top - 2, box.right - box.left, box.bottom - box.top + 4);
  context.clip();
  context.strokeStyle = theme.psi;
  context.lineJoin = 'round';
  context.lineWidth = 2.2 * theme.line;
  trace(context, moment.past, x, y);
  context.globalAlpha = 0.65;
  context.setLineDash([2 * theme.line, 3.5 * theme.line]);
  trace(context, moment.future, x, y);
  context.setLineDash([]);
  context.globalAlpha = 1;
  context.restore();

  context.strokeStyle = theme.ink;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(x(0), box.top - 4);
  context.lineTo(x(0), box.bottom);
  context.stroke();
  context.fillStyle = theme.psi;
  context.beginPath();
  context.arc(x(0), y(moment.angle), 4.5 * Math.sqrt(theme.line), 0, 2 * Math.PI);
  context.fill();
}

/**
 * @param {CanvasRenderingContext2D} context @param {Box} box @param {Moment} moment @param {(v: number) => number} y @param {Theme} theme
 */
function drawBand(context, box, { freeplay, limit }, y, theme) {
  if (!(freeplay > 0)) return;
  const edge = Math.min(freeplay, limit);
  context.globalAlpha = 0.25;
  context.fillStyle = theme.freeplay;
  context.fillRect(box.left, y(edge), box.right - box.left, y(-edge) - y(edge));
  context.globalAlpha = 1;
}

/**
 * @param {CanvasRenderingContext2D} context @param {Box} box @param {Moment} moment @param {(v: number) => number} x
 * @param {Theme} theme @param {Voice} voice
 */
function drawTimes(context, box, moment, x, theme, voice) {
  const times = ticks(moment.from * 1000, moment.to * 1000, Math.min(6, (box.right - box.left) / (theme.size * 3.8)));
  const decimals = tickDecimals(times);
  context.strokeStyle = theme.rule;
  context.lineWidth = 1;
  context.font = textFont(theme, 0.95);
  context.fillStyle = theme.ink2;
  context.textAlign = 'center';
  context.textBaseline = 'alphabetic';
  context.beginPath();
  times.forEach((time, i) => {
    const at = Math.round(x(time / 1000)) + 0.5;
    context.moveTo(at, box.top);
    context.lineTo(at, box.bottom);
    const number = voice.number(time, decimals);
    const words = time === 0 ? voice.say('timeline.now') : i === 0 ? `${number} ms` : time > 0 ? `+${number}` : number;
    const half = context.measureText(words).width / 2;
    context.fillText(words, Math.min(at, box.right + theme.size * 0.9 - half), box.bottom + theme.size * 1.15);
  });
  context.stroke();
}

/**
 * @param {CanvasRenderingContext2D} context @param {Box} box @param {Moment} moment @param {(v: number) => number} y
 * @param {Theme} theme @param {Voice} voice @param {boolean} isSmall
 */
function drawAngles(context, box, moment, y, theme, voice, isSmall) {
  const [tick] = ticks(0, moment.limit * degrees, 2.5).slice(-1);
  const decimals = tick < 1 ? Math.ceil(-Math.log10(tick)) : 0;
  context.font = textFont(theme, 0.95);
  context.fillStyle = theme.ink2;
  context.strokeStyle = theme.rule;
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  for (const angle of [tick, 0, -tick]) {
    const at = Math.round(y(angle / degrees)) + 0.5;
    context.strokeStyle = angle === 0 ? theme.ghost : theme.rule;
    context.beginPath();
    context.moveTo(box.left, at);
    context.lineTo(box.right, at);
    context.stroke();
    if (angle !== 0 || !isSmall) context.fillText(`${voice.number(angle, angle === 0 ? 0 : decimals)}°`, box.left - 8, at);
  }
  context.fillStyle = theme.psi;
  if (isSmall) {
    drawLabel(context, [{ symbol: 'ψ' }], box.left - 10, y(0) + theme.size * 0.35, theme, { align: 'right' });
    return;
  }
  const beat = moment.frequency ? `, ${voice.number(moment.frequency, 1)} Hz` : '';
  const name = ` ${voice.say('state.torsionAngle')}${beat}`;
  drawLabel(context, [{ symbol: 'ψ' }, { text: name }], box.left, box.top - theme.size * 0.65, theme, { weight: 600 });
}

/**
 * @param {CanvasRenderingContext2D} context @param {History} history @param {(v: number) => number} x @param {(v: number) => number} y
 */
function trace(context, { time, torsionAngle }, x, y) {
  if (time.length < 2) return;
  context.beginPath();
  context.moveTo(x(time[0]), y(torsionAngle[0]));
  for (let i = 1; i < time.length; i++) context.lineTo(x(time[i]), y(torsionAngle[i]));
  context.stroke();
}
