import { linear, ticks, tickDecimals } from './scale.js';
import { drawLabel, textFont } from './text.js';

/**
 * @typedef {import('./canvas.js').Size} Size
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {ArrayLike<number>} Series
 * @typedef {{
 *   limits: { angle: number, rate: number },
 *   trail: { torsionAngle: Series, torsionRate: Series },
 *   orbit: { torsionAngle: Series, torsionRate: Series },
 *   orbitLabel: string,
 *   state: Series,
 *   freeplay: number,
 * }} Portrait all in radians and rad/s; `limits` are the ends of the axes, `freeplay` half of the gap
 */

const degrees = 180 / Math.PI;
const pieces = 32;

/**
 * Torsion rate over torsion angle: where the motion comes from (fading trail), is (dot) and goes (dotted orbit).
 * @param {CanvasRenderingContext2D} context
 * @param {Size} size
 * @param {Portrait} portrait
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawPhasePortrait(context, size, portrait, theme, voice) {
  const frame = frameOf(size, theme);
  const { angle, rate } = portrait.limits;
  const x = linear([-angle, angle], [frame.left, frame.right]);
  const y = linear([-rate, rate], [frame.bottom, frame.top]);

  drawGap(context, portrait.freeplay, angle, x, frame, theme);
  drawGrid(context, portrait.limits, x, y, frame, theme, voice);
  nameGap(context, portrait.freeplay, x, frame, theme, voice);

  context.save();
  context.beginPath();
  context.rect(frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top);
  context.clip();
  drawTrail(context, portrait.trail, x, y, theme);
  drawOrbit(context, portrait.orbit, x, y, theme);
  context.restore();
  drawOrbitKey(context, portrait, frame, theme);

  context.fillStyle = theme.psi;
  context.strokeStyle = theme.surface;
  context.lineWidth = 2;
  context.beginPath();
  context.arc(x(portrait.state[0]), y(portrait.state[1]), 6 * Math.sqrt(theme.line), 0, 2 * Math.PI);
  context.fill();
  context.stroke();
}

/** @param {Size} size @param {Theme} theme */
function frameOf({ width, height }, theme) {
  return { left: theme.size * 5.2, right: width - theme.size * 1.6, top: theme.size * 1.2, bottom: height - theme.size * 3.3 };
}

/** @typedef {ReturnType<typeof frameOf>} Frame */
/** @typedef {(value: number) => number} Scale */

/**
 * @param {CanvasRenderingContext2D} context @param {number} freeplay @param {number} angle @param {Scale} x
 * @param {Frame} frame @param {Theme} theme
 */
function drawGap(context, freeplay, angle, x, frame, theme) {
  if (!(freeplay > 0)) return;
  const left = x(-Math.min(freeplay, angle));
  const right = x(Math.min(freeplay, angle));
  context.globalAlpha = 0.25;
  context.fillStyle = theme.freeplay;
  context.fillRect(left, frame.top, right - left, frame.bottom - frame.top);
  context.globalAlpha = 1;
  context.strokeStyle = theme.freeplayText;
  context.lineWidth = 1.5 * theme.line;
  context.setLineDash([2, 3]);
  context.beginPath();
  for (const edge of [left, right]) {
    context.moveTo(edge, frame.top);
    context.lineTo(edge, frame.bottom);
  }
  context.stroke();
  context.setLineDash([]);
}

/**
 * @param {CanvasRenderingContext2D} context @param {number} freeplay @param {Scale} x @param {Frame} frame
 * @param {Theme} theme @param {Voice} voice
 */
function nameGap(context, freeplay, x, frame, theme, voice) {
  if (!(freeplay > 0)) return;
  const [left, right] = [x(-freeplay), x(freeplay)];
  context.font = textFont(theme, 0.95, 600);
  const words = voice.say('phase.gap');
  context.textBaseline = 'alphabetic';
  context.textAlign = 'center';
  const baseline = frame.bottom - theme.size * 0.7;
  // Words wider than the gap stand on a halo, to be read across the grid.
  context.lineJoin = 'round';
  context.lineWidth = 4;
  context.strokeStyle = theme.surface;
  if (context.measureText(words).width + 8 > right - left) context.strokeText(words, (left + right) / 2, baseline);
  context.fillStyle = theme.freeplayText;
  context.fillText(words, (left + right) / 2, baseline);
}

/**
 * @param {CanvasRenderingContext2D} context @param {Portrait['limits']} limits @param {Scale} x @param {Scale} y
 * @param {Frame} frame @param {Theme} theme @param {Voice} voice
 */
function drawGrid(context, { angle, rate }, x, y, frame, theme, voice) {
  const angles = ticks(-angle * degrees, angle * degrees, Math.min(10, (frame.right - frame.left) / (theme.size * 4.2)));
  const rates = ticks(-rate, rate, Math.min(6, (frame.bottom - frame.top) / (theme.size * 2.6)));
  context.lineWidth = 1;
  for (const isZero of [false, true]) {
    context.strokeStyle = isZero ? theme.ghost : theme.rule;
    context.beginPath();
    for (const tick of angles) if ((tick === 0) === isZero) line(context, x(tick / degrees), frame.top, x(tick / degrees), frame.bottom);
    for (const tick of rates) if ((tick === 0) === isZero) line(context, frame.left, y(tick), frame.right, y(tick));
    context.stroke();
  }
  context.font = textFont(theme, 0.95);
  context.fillStyle = theme.ink2;
  context.textBaseline = 'middle';
  context.textAlign = 'right';
  for (const tick of rates) context.fillText(voice.number(tick, tickDecimals(rates)), frame.left - 8, y(tick));
  context.textAlign = 'center';
  for (const tick of angles) context.fillText(`${voice.number(tick, tickDecimals(angles))}°`, x(tick / degrees), frame.bottom + theme.size);

  context.fillStyle = theme.ink2;
  drawLabel(context, [{ symbol: 'ψ' }, { text: ` ${voice.say('state.torsionAngle')}` }], frame.right, frame.bottom + theme.size * 2.7, theme, { align: 'right', weight: 600 });
  context.save();
  context.translate(theme.size * 1.25, (frame.top + frame.bottom) / 2);
  context.rotate(-Math.PI / 2);
  const isLow = frame.bottom - frame.top < 14 * theme.size;
  const rateName = isLow ? ' rad/s' : ` ${voice.say('state.torsionRate')}, rad/s`;
  drawLabel(context, [{ symbol: 'ψ', dotted: true }, { text: rateName }], 0, 0, theme, { align: 'center', weight: 600 });
  context.restore();
}

/** @param {CanvasRenderingContext2D} context @param {number} x1 @param {number} y1 @param {number} x2 @param {number} y2 */
function line(context, x1, y1, x2, y2) {
  context.moveTo(Math.round(x1) + 0.5, Math.round(y1) + 0.5);
  context.lineTo(Math.round(x2) + 0.5, Math.round(y2) + 0.5);
}

/**
 * The past, the older the fainter.
 * @param {CanvasRenderingContext2D} context @param {Portrait['trail']} trail @param {Scale} x @param {Scale} y @param {Theme} theme
 */
function drawTrail(context, { torsionAngle, torsionRate }, x, y, theme) {
  const last = torsionAngle.length - 1;
  if (last < 1) return;
  context.strokeStyle = theme.psi;
  context.lineWidth = 2.2 * theme.line;
  context.lineJoin = 'round';
  context.lineCap = 'butt';
  for (let piece = 0; piece < pieces; piece++) {
    const from = Math.floor((last * piece) / pieces);
    const to = Math.floor((last * (piece + 1)) / pieces);
    if (to === from) continue;
    context.globalAlpha = 0.06 + 0.94 * ((piece + 1) / pieces) ** 1.6;
    context.beginPath();
    context.moveTo(x(torsionAngle[from]), y(torsionRate[from]));
    for (let i = from + 1; i <= to; i++) context.lineTo(x(torsionAngle[i]), y(torsionRate[i]));
    context.stroke();
  }
  context.globalAlpha = 1;
}

/**
 * @param {CanvasRenderingContext2D} context @param {Portrait['orbit']} orbit @param {Scale} x @param {Scale} y @param {Theme} theme
 */
function drawOrbit(context, { torsionAngle, torsionRate }, x, y, theme) {
  if (torsionAngle.length < 2) return;
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.4 * theme.line;
  context.setLineDash([1.5, 4]);
  context.beginPath();
  context.moveTo(x(torsionAngle[0]), y(torsionRate[0]));
  for (let i = 1; i < torsionAngle.length; i++) context.lineTo(x(torsionAngle[i]), y(torsionRate[i]));
  context.closePath();
  context.stroke();
  context.setLineDash([]);
}

/**
 * Names the destination in the corner that an orbit leaves free.
 * @param {CanvasRenderingContext2D} context @param {Portrait} portrait @param {Frame} frame @param {Theme} theme
 */
function drawOrbitKey(context, { orbit, orbitLabel }, frame, theme) {
  if (!orbitLabel) return;
  const x = frame.left + 6;
  const y = frame.top + theme.size * 1.1;
  context.fillStyle = theme.ink;
  drawLabel(context, [{ text: orbitLabel }], x, y, theme);
  if (orbit.torsionAngle.length < 2) return;
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.4 * theme.line;
  context.setLineDash([1.5, 4]);
  context.beginPath();
  context.moveTo(x, y + theme.size * 0.6);
  context.lineTo(x + theme.size * 2.2, y + theme.size * 0.6);
  context.stroke();
  context.setLineDash([]);
}
