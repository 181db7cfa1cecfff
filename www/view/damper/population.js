import { textFont, drawLabel, widthOfLabel } from '../text.js';

/**
 * A population in parallel coordinates: an axis a parameter, from its least to its most, by logarithms where it spans decades; a
 * line an individual, the best of them strong. On a wide picture the axes stand, on a narrow one they lie below each other.
 *
 * @typedef {import('../../style/theme.js').Theme} Theme
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('../text.js').Run} Run
 * @typedef {{ name: Run[], min: number, max: number, isLog: boolean, write: (value: number) => string, isLoose?: boolean }} Axis `isLoose`: the data do not fix it
 * @typedef {{ axes: readonly Axis[], individuals: readonly ArrayLike<number>[], best: ArrayLike<number> | null, known?: ArrayLike<number> | null, ranks?: ArrayLike<number> }} Shown `individuals`: values in SI in the order of the axes;
 *   `known`: what the data were made with; `ranks`: 0 for the best to 1 for the worst of each
 */

/** Axes nearer than this stand in each other's names, in widths of small type. */
const nearest = 4.6;

/**
 * @param {CanvasRenderingContext2D} context
 * @param {import('../canvas.js').Size} size
 * @param {Shown} shown
 * @param {Theme} theme
 */
export function drawPopulation(context, size, { axes, individuals, best, known = null, ranks }, theme) {
  if (axes.length === 0 || size.width < 60 || size.height < 60) return;
  const sheet = size.width / axes.length >= nearest * theme.size ? standing(size, axes.length, theme) : lying(context, size, axes, theme);
  drawAxes(context, sheet, axes, theme);
  const lines = individuals.map((values, i) => ({ values, rank: ranks?.[i] ?? 0.5 })).sort((one, other) => other.rank - one.rank);
  context.strokeStyle = theme.ghost;
  context.lineWidth = theme.line;
  for (const { values, rank } of lines) {
    context.globalAlpha = 0.5 - 0.36 * rank;
    trace(context, sheet, axes, values);
  }
  context.globalAlpha = 1;
  if (known) {
    context.strokeStyle = theme.y;
    context.lineWidth = 2 * theme.line;
    context.setLineDash([6 * theme.line, 4 * theme.line]);
    trace(context, sheet, axes, known);
    context.setLineDash([]);
  }
  if (!best) return;
  context.strokeStyle = theme.psi;
  context.lineWidth = 2.8 * theme.line;
  trace(context, sheet, axes, best);
  writeBest(context, sheet, axes, best, theme);
}

/**
 * Where a value stands on an axis, 0 … 1; what lies outside stands at its end.
 * @param {Axis} axis @param {number} value
 */
export function placeOn({ min, max, isLog }, value) {
  const share = isLog ? Math.log(value / min) / Math.log(max / min) : (value - min) / (max - min);
  return Math.min(1, Math.max(0, Number.isNaN(share) ? 0 : share));
}

/** @typedef {{ isLying: boolean, from: number, to: number, axis: (i: number) => number }} Sheet `axis`: where the i-th stands, across its length */

/** @param {import('../canvas.js').Size} size @param {number} count @param {Theme} theme @returns {Sheet} */
function standing({ width, height }, count, theme) {
  const margin = 2.6 * theme.size;
  return { isLying: false, from: height - 3.4 * theme.size, to: 2.6 * theme.size, axis: (i) => margin + ((width - 2 * margin) * i) / Math.max(1, count - 1) };
}

/** @param {CanvasRenderingContext2D} context @param {import('../canvas.js').Size} size @param {readonly Axis[]} axes @param {Theme} theme @returns {Sheet} */
function lying(context, { width, height }, axes, theme) {
  const names = Math.max(...axes.map(({ name }) => widthOfLabel(context, name, theme, 600)));
  const margin = 1.2 * theme.size;
  return { isLying: true, from: names + 1.6 * theme.size, to: width - 5.4 * theme.size, axis: (i) => margin + ((height - 2 * margin) * i) / Math.max(1, axes.length - 1) };
}

/** @param {Sheet} sheet @param {number} i @param {number} share @returns {[number, number]} */
const pointOn = ({ isLying, from, to, axis }, i, share) => (isLying ? [from + share * (to - from), axis(i)] : [axis(i), from + share * (to - from)]);

/** @param {CanvasRenderingContext2D} context @param {Sheet} sheet @param {readonly Axis[]} axes @param {Theme} theme */
function drawAxes(context, sheet, axes, theme) {
  axes.forEach((one, i) => {
    const [[x1, y1], [x2, y2]] = [pointOn(sheet, i, 0), pointOn(sheet, i, 1)];
    context.strokeStyle = one.isLoose ? theme.unstable : theme.ghost;
    context.lineWidth = 1.2 * theme.line;
    context.setLineDash(one.isLoose ? [4, 3] : []);
    context.beginPath();
    context.moveTo(x1, y1);
    context.lineTo(x2, y2);
    context.stroke();
    context.setLineDash([]);
    context.fillStyle = one.isLoose ? theme.unstable : theme.ink;
    if (sheet.isLying) drawLabel(context, one.name, x1 - 0.8 * theme.size, y1 + 0.35 * theme.size, theme, { align: 'right', weight: 600 });
    else {
      drawLabel(context, one.name, x1, y2 - 1.5 * theme.size, theme, { align: 'center', weight: 600 });
      context.font = textFont(theme, 0.8);
      context.fillStyle = theme.ink2;
      context.textAlign = 'center';
      context.fillText(one.write(one.max), x1, y2 - 0.4 * theme.size);
      context.fillText(one.write(one.min), x1, y1 + 1.1 * theme.size);
    }
  });
}

/** @param {CanvasRenderingContext2D} context @param {Sheet} sheet @param {readonly Axis[]} axes @param {ArrayLike<number>} values */
function trace(context, sheet, axes, values) {
  context.beginPath();
  axes.forEach((one, i) => context[i === 0 ? 'moveTo' : 'lineTo'](...pointOn(sheet, i, placeOn(one, values[i]))));
  context.stroke();
}

/** The best's values: under each axis that stands, at the end of one that lies. @param {CanvasRenderingContext2D} context @param {Sheet} sheet @param {readonly Axis[]} axes @param {ArrayLike<number>} best @param {Theme} theme */
function writeBest(context, sheet, axes, best, theme) {
  context.fillStyle = theme.psi;
  context.font = textFont(theme, 0.9, 600);
  axes.forEach((one, i) => {
    const [x, y] = pointOn(sheet, i, sheet.isLying ? 1 : 0);
    context.textAlign = sheet.isLying ? 'left' : 'center';
    if (sheet.isLying) context.fillText(one.write(best[i]), x + 0.6 * theme.size, y + 0.33 * theme.size);
    else context.fillText(one.write(best[i]), x, y + 2.5 * theme.size);
  });
}
