import { axisOf, drawAxes, frameOf, logAxisUp } from '../axes.js';
import { strokeCurve } from '../curve.js';
import { keysAbove } from '../key.js';
import { quantities } from '../quantities.js';

/**
 * How the errors of a search fall, generation by generation, by logarithms: of each seed the best, and of the last the mean.
 *
 * @typedef {import('../../style/theme.js').Theme} Theme
 * @typedef {{ runs: readonly { best: readonly number[], mean: readonly number[] }[], names: { best: string, mean: string } }} Shown
 */

/** @param {CanvasRenderingContext2D} context @param {import('../canvas.js').Size} size @param {Shown} shown @param {Theme} theme @param {import('../../words/voice.js').Voice} voice */
export function drawErrors(context, size, { runs, names }, theme, voice) {
  const last = runs.at(-1);
  if (!last) return;
  const bestStyle = styleOf(theme.psi, 2.4, []);
  const meanStyle = styleOf(theme.ghost, 1.6, [5, 4]);
  const area = frameOf(size, theme, 'above');
  const { frame, draw: drawKeys } = keysAbove(context, { ...area, left: area.left + 0.6 * theme.size, top: area.top + 1.2 * theme.size }, [
    { entry: { text: names.best, style: bestStyle }, color: theme.psi }, { entry: { text: names.mean, style: meanStyle }, color: theme.ghost },
  ], theme);
  if (frame.right - frame.left < 20 || frame.bottom - frame.top < 20) return;
  const all = runs.flatMap(({ best }) => best).concat(last.mean).filter((error) => error > 0 && error < 1e3);
  const [least, most] = [Math.min(...all, 0.1), Math.max(...all, 1)];
  const count = Math.max(20, ...runs.map(({ best }) => best.length));
  const x = { ...axisOf(quantities.generation, [0, count], [frame.left, frame.right], Math.min(8, (frame.right - frame.left) / (theme.size * 4.2)), voice), name: () => [{ text: voice.say('identify.generation') }] };
  const y = logAxisUp(quantities.fitError, [10 ** Math.floor(Math.log10(least)), 10 ** Math.ceil(Math.log10(most))], frame, voice);
  drawAxes(context, frame, x, y, theme, { up: 'above', nameAt: area.top });
  context.save();
  context.beginPath();
  context.rect(frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top);
  context.clip();
  const trace = (/** @type {readonly number[]} */ errors) => strokeCurve(context, { count: errors.length, x: (i) => x.at(i + 1), y: (i) => y.at(Math.min(most, errors[i] > 0 ? errors[i] : most)) });
  runs.slice(0, -1).forEach(({ best }) => {
    styleOf(theme.ghost, 1.4, [])(context, theme);
    trace(best);
  });
  meanStyle(context, theme);
  trace(last.mean);
  bestStyle(context, theme);
  trace(last.best);
  context.restore();
  context.setLineDash([]);
  drawKeys();
}

/** @param {string} color @param {number} width @param {number[]} dash @returns {import('../strokes.js').Style} */
const styleOf = (color, width, dash) => (context, theme) => {
  context.strokeStyle = color;
  context.lineWidth = width * theme.line;
  context.setLineDash(dash.map((one) => one * theme.line));
};
