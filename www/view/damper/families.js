import { decimalsFor } from '../../words/number.js';
import { axisUp, drawAxes, frameOf, logAxisUp } from '../axes.js';
import { curveOf, strokeCurve } from '../curve.js';
import { grids, inPanel, panelsIn } from '../panels.js';
import { drawPresentWithin } from '../points.js';
import { nameOf } from '../quantities.js';
import { linear, powers, roundLimit } from '../scale.js';
import { textFont } from '../text.js';
import { drawVeil } from '../veil.js';
import { colorOf, writeNames } from './loops.js';

/**
 * Families of curves over one quantity by its logarithm, a curve a command: panels with an upward axis each, the chosen curve
 * strong, with the point where the bench is.
 *
 * @typedef {import('../../style/theme.js').Theme} Theme
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('../quantities.js').Quantity} Quantity
 * @typedef {{ label: string, isChosen: boolean, amplitude: ArrayLike<number>, values: ArrayLike<number> }} Curve
 * @typedef {{ quantity: Quantity, curves: readonly Curve[], now: number | null }} Panel
 * @typedef {{ panels: readonly Panel[], across: Quantity, at: number, veiled: boolean }} Shown `at`: where the bench is
 */

/** An upward axis that would span more than this is one of logarithms. */
const widest = 30;

/** @param {CanvasRenderingContext2D} context @param {import('../canvas.js').Size} size @param {Shown} shown @param {Theme} theme @param {Voice} voice */
export function drawFamilies(context, size, { panels, across, at, veiled }, theme, voice) {
  if (size.width < 40 || size.height < 40) return;
  panelsIn(size, grids(panels.length)).forEach((panel, i) => inPanel(context, panel, (within, room) => drawOne(within, room, panels[i], { across, at, veiled }, theme, voice)));
}

/** @param {CanvasRenderingContext2D} context @param {import('../canvas.js').Size} size @param {Panel} panel @param {Pick<Shown, 'across' | 'at' | 'veiled'>} shown @param {Theme} theme @param {Voice} voice */
function drawOne(context, size, { quantity, curves, now }, { across, at, veiled }, theme, voice) {
  const area = frameOf(size, theme, 'above');
  context.font = textFont(theme, 0.95, 600);
  const room = Math.max(0, ...curves.map(({ label }) => context.measureText(label).width));
  const frame = { ...area, left: area.left + theme.size, right: Math.min(area.right, size.width - room - theme.size * 0.9) };
  if (frame.right - frame.left < 20 || frame.bottom - frame.top < 20) return;
  const all = curves.flatMap(({ amplitude }) => Array.from(amplitude));
  const domain = all.length > 0 ? /** @type {[number, number]} */ ([Math.min(...all), Math.max(...all)]) : /** @type {[number, number]} */ ([at / 10, 2 * at]);
  const x = logAcross(across, domain, frame, theme, voice);
  const values = curves.flatMap((curve) => Array.from(curve.values)).filter((value) => value > 0);
  const [least, most] = [Math.min(...values, Infinity), Math.max(...values, 0)];
  const isLog = most > widest * least;
  const y = isLog ? logAxisUp(quantity, [least, most * 1.1], frame, voice) : axisUp(quantity, [0, most > 0 ? roundLimit(most) : 1], frame, theme, voice);
  drawAxes(context, frame, x, y, theme, { up: 'above' });
  if (veiled) {
    drawVeil(context, frame, theme);
    return;
  }
  curves.forEach((curve, i) => {
    context.strokeStyle = colorOf(curve, i, curves.length, theme);
    context.lineWidth = (curve.isChosen ? 2.8 : 1.5) * theme.line;
    strokeCurve(context, curveOf(curve.amplitude, curve.values, x.at, y.at));
  });
  writeNames(context, curves.map((curve, i) => ({ text: curve.label, isStrong: curve.isChosen, color: colorOf(curve, i, curves.length, theme), y: y.at(curve.values[curve.values.length - 1]) })), frame, theme);
  if (now !== null && at >= domain[0] && at <= domain[1]) drawPresentWithin(context, frame, x.at(at), y.at(now), theme.psi, theme);
}

/** An axis to the right by logarithms, a mark at each 1, 2 and 5; where they would touch, at each power of ten. @param {Quantity} quantity @param {[number, number]} domain @param {import('../axes.js').Box} frame @param {Theme} theme @param {Voice} voice @returns {import('../axes.js').Axis} */
function logAcross(quantity, [from, to], frame, theme, voice) {
  const place = linear([Math.log10(from), Math.log10(to)], [frame.left, frame.right]);
  const at = (/** @type {number} */ value) => place(Math.log10(value));
  const decade = (frame.right - frame.left) / Math.log10(to / from);
  const leading = decade < 7 * theme.size ? [1] : [1, 2, 5];
  const shown = powers((from * quantity.perSI) / 10, to * quantity.perSI).flatMap((power) => leading.map((digit) => digit * power)).filter((one) => one >= from * quantity.perSI * (1 - 1e-9) && one <= to * quantity.perSI * (1 + 1e-9));
  const marks = shown.map((one) => ({ at: at(one / quantity.perSI), text: voice.number(one, decimalsFor(one, 1)), isZero: false }));
  return { at, marks, name: (isShort) => nameOf(quantity, voice, isShort) };
}
