import { axisAcross, axisUp, drawAxes, frameOf } from './axes.js';
import { curveOf, strokeCurve } from './curve.js';
import { drawGap, nameGap } from './gap.js';
import { drawHollow, drawPresent, drawSmear } from './points.js';
import { decimalsUpTo, valueOf } from './quantities.js';
import { drawLabel, textFont, writeEdged } from './text.js';

/**
 * One force law: its curve, the part that the last cycle ran through, and the point where it is now.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./canvas.js').Size} Size
 * @typedef {import('./curve.js').Series} Series
 * @typedef {import('./quantities.js').Quantity} Quantity
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{ across: number, up: number }} Place in SI units
 * @typedef {{ across: Series, up: Series }} Places all along the exposure of a frame, where that is too long for one
 * @typedef {{ symbol: string, sub?: string, at: number }} LimitAngle where the law changes, on both sides of zero
 * @typedef {{
 *   across: Quantity, up: Quantity, limits: Place, curve: Places, now: Place | Places,
 *   cycle: [number, number] | null, limitAngle: LimitAngle | null, freeplay: number, ghosts: (Place | Places)[],
 * }} Law `limits`: the ends of the axes; `cycle`: least and largest of the last cycle, across; `freeplay`: half of a gap
 */

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Size} size
 * @param {Law} law
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawLaw(context, size, law, theme, voice) {
  const { limits, now, cycle, freeplay, ghosts } = law;
  const area = frameOf(size, theme, 'above');
  const frame = law.limitAngle ? { ...area, top: area.top + theme.size * 1.1 } : area;
  const x = axisAcross(law.across, [-limits.across, limits.across], frame, theme, voice);
  const y = axisUp(law.up, [-limits.up, limits.up], frame, theme, voice);
  const curve = curveOf(law.curve.across, law.curve.up, x.at, y.at);
  const color = theme[law.up.color];

  drawGap(context, frame, freeplay, x.at, theme);
  drawAxes(context, frame, x, y, theme, { up: 'above', nameAt: area.top });
  nameGap(context, frame, freeplay, x.at, theme, voice);
  if (law.limitAngle) drawLimitAngle(context, law.limitAngle, x.at, frame, theme);

  context.strokeStyle = color;
  context.lineJoin = 'round';
  if (cycle) {
    inBox(context, { ...frame, left: Math.max(frame.left, x.at(cycle[0])), right: Math.min(frame.right, x.at(cycle[1])) }, () => {
      context.globalAlpha = 0.3;
      context.lineWidth = 9 * theme.line;
      strokeCurve(context, curve);
      context.globalAlpha = 1;
    });
  }
  inBox(context, frame, () => {
    context.lineWidth = 2.2 * theme.line;
    strokeCurve(context, curve);
    for (const ghost of ghosts) {
      if (isPlace(ghost)) drawHollow(context, x.at(ghost.across), y.at(ghost.up), theme);
      else drawSmear(context, curveOf(ghost.across, ghost.up, x.at, y.at), theme.ghost, theme, 0.6);
    }
    if (!isPlace(now)) drawSmear(context, curveOf(now.across, now.up, x.at, y.at), color, theme);
  });
  if (ghosts.length > 1 && ghosts.every(isPlace)) numberGhosts(context, ghosts, x.at, y.at, theme);
  if (!isPlace(now)) return;
  writeNow(context, law, now, x.at, y.at, frame, theme, voice);
  drawPresent(context, x.at(now.across), y.at(now.up), color, theme);
}

/** @param {Place | Places} shown @returns {shown is Place} */
const isPlace = (shown) => typeof shown.across === 'number';

/**
 * Draws within a box only.
 * @param {CanvasRenderingContext2D} context @param {Box} box @param {() => void} draw
 */
function inBox(context, { left, right, top, bottom }, draw) {
  if (!(right > left)) return;
  context.save();
  context.beginPath();
  context.rect(left, top, right - left, bottom - top);
  context.clip();
  draw();
  context.restore();
}

/**
 * Dotted lines where the law changes, each with the angle's symbol above it.
 * @param {CanvasRenderingContext2D} context @param {LimitAngle} limitAngle @param {(v: number) => number} x
 * @param {Box} frame @param {Theme} theme
 */
function drawLimitAngle(context, { symbol, sub, at }, x, frame, theme) {
  const lines = [at, -at].filter((angle) => x(angle) >= frame.left && x(angle) <= frame.right);
  context.strokeStyle = theme.ink2;
  context.lineWidth = theme.line;
  context.setLineDash([1.5, 3]);
  context.beginPath();
  for (const angle of lines) {
    context.moveTo(x(angle), frame.top - 2);
    context.lineTo(x(angle), frame.bottom);
  }
  context.stroke();
  context.setLineDash([]);
  context.fillStyle = theme.ink2;
  for (const angle of lines)
    drawLabel(context, [...(angle < 0 ? [{ text: '−' }] : []), { symbol, sub }], x(angle), frame.top - theme.size * 0.55, theme, { align: 'center' });
}

/**
 * The value now, read off at the upward axis: a dotted line leads there from the point, and the number stands on the
 * axis' other side, which an odd law leaves free, and off the line through zero.
 * @param {CanvasRenderingContext2D} context @param {Law} law @param {Place} now @param {(v: number) => number} x
 * @param {(v: number) => number} y @param {Box} frame @param {Theme} theme @param {Voice} voice
 */
function writeNow(context, { up, limits }, now, x, y, frame, theme, voice) {
  const [across, height, axis, zero] = [x(now.across), y(now.up), x(0), y(0)];
  context.strokeStyle = theme[up.color];
  context.lineWidth = 1.2 * theme.line;
  context.setLineDash([2, 3]);
  context.beginPath();
  context.moveTo(across, height);
  context.lineTo(axis, height);
  context.stroke();
  context.setLineDash([]);

  const decimals = decimalsUpTo(up, limits.up);
  const isLeft = now.across >= 0;
  const room = (isLeft ? axis - frame.left : frame.right - axis) - theme.size * 0.6;
  context.font = textFont(theme, 1, 600);
  const full = valueOf(up, now.up, decimals, voice);
  // Where it is narrow the unit at the axis' name must do.
  const words = context.measureText(full).width <= room ? full : voice.number(now.up * up.perSI, decimals);
  const least = 0.9 * theme.size;
  const free = Math.abs(height - zero) >= least ? height : zero + (now.up < 0 ? least : -least);
  const middle = Math.min(Math.max(free, frame.top + theme.size / 2), frame.bottom - theme.size / 2);
  const place = axis + (isLeft ? -0.6 : 0.6) * theme.size;
  context.textAlign = isLeft ? 'right' : 'left';
  context.textBaseline = 'middle';
  context.fillStyle = theme[up.color];
  writeEdged(context, words, place, middle, theme);
}

/** @param {CanvasRenderingContext2D} context @param {Place[]} ghosts @param {(v: number) => number} x @param {(v: number) => number} y @param {Theme} theme */
function numberGhosts(context, ghosts, x, y, theme) {
  context.font = textFont(theme, 0.9, 600);
  context.textAlign = 'center';
  context.textBaseline = 'alphabetic';
  context.fillStyle = theme.ghost;
  ghosts.forEach(({ across, up }, i) => writeEdged(context, String(i + 1), x(across), y(up) - theme.size * 0.6, theme));
}
