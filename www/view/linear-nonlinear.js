import { axisOf, axisUp, drawAxes, frameOf } from './axes.js';
import { writeCornerReading } from './corner-reading.js';
import { curveOf, strokeCurve } from './curve.js';
import { keysAbove } from './key.js';
import { quantities } from './quantities.js';
import { inStyle } from './strokes.js';
import { widthOfLabel } from './text.js';

/**
 * A state over time, by linear theory (dashed) and in full (solid). Where there are so many cycles that dashes would fill the
 * picture, both are drawn by the line along their peaks, with a tint between those of the gear in full.
 *
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {ArrayLike<number>} Series
 * @typedef {{
 *   time: Series, linear: Series, nonlinear: Series, state: 'torsionAngle' | 'lateralDeformation', duration: number, limit: number,
 *   readings: readonly string[],
 * }} Shown `limit`: ± of the axis, in SI; `readings`: of linear theory, in fewer and fewer words
 */

/** More cycles than this are drawn by their peaks. */
const mostCycles = 25;
/** What is so many times beyond the axis is left out: dashes far outside would cost as much as those within. */
const cut = 4;
/** How strongly what lies between the peaks is filled. */
const tint = 0.18;
/** Above this the time is written in seconds, in s. */
const longMoment = 0.5;

/** @type {import('./strokes.js').Style} */
const byTheory = (context, theme) => {
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.6 * theme.line;
  context.setLineDash([6, 4].map((dash) => dash * theme.line));
};

/**
 * @param {CanvasRenderingContext2D} context
 * @param {import('./canvas.js').Size} size
 * @param {Shown} shown
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawLinearNonlinear(context, size, { time, linear, nonlinear, state, duration, limit, readings }, theme, voice) {
  const quantity = quantities[state];
  const inFull = (/** @type {CanvasRenderingContext2D} */ one, /** @type {Theme} */ { line }) => {
    one.strokeStyle = theme[quantity.color];
    one.lineWidth = 1.6 * line;
    one.setLineDash([]);
  };
  const keys = [{ entry: { text: voice.say('histories.nonlinear'), style: inFull }, color: theme[quantity.color] }, { entry: { text: voice.say('histories.linear'), style: byTheory }, color: theme.ink }];
  const whole = frameOf(size, theme, 'above');
  const { frame, draw: drawKeys } = keysAbove(context, { ...whole, top: whole.top + theme.size * 1.2 }, keys, theme);
  const [width, height] = [frame.right - frame.left, frame.bottom - frame.top];
  if (width < 20 || height < 20) return;
  const isLong = duration > longMoment;
  const x = axisOf({ ...quantity, unit: '', perSI: isLong ? 1 : 1000 }, [0, duration], [frame.left, frame.right], Math.min(8, width / (theme.size * 4)), voice);
  const y = axisUp(quantity, [-limit, limit], frame, theme, voice);
  drawAxes(context, frame, { ...x, name: () => [{ symbol: 't' }, { text: isLong ? ', s' : ', ms' }] }, y, theme, { up: 'above', nameAt: whole.top });
  drawKeys();
  context.save();
  context.beginPath();
  context.rect(frame.left, frame.top, width, height);
  context.clip();
  context.lineJoin = 'round';
  const end = Array.from(linear).findIndex((value) => Math.abs(value) > cut * limit);
  const seen = end < 0 ? linear : Array.from(linear).slice(0, end);
  const happens = peaksOf(time, nonlinear);
  if (happens.above.time.length <= mostCycles) {
    inStyle(context, theme, inFull, () => strokeCurve(context, curveOf(time, nonlinear, x.at, y.at)));
    inStyle(context, theme, byTheory, () => strokeCurve(context, curveOf(time, seen, x.at, y.at)));
  } else {
    const along = (/** @type {ReturnType<typeof peaksOf>} */ { above, below }) => {
      for (const { time: at, value } of [above, below]) strokeCurve(context, curveOf(at, value, x.at, y.at));
    };
    tintBetween(context, happens, x.at, y.at, theme[quantity.color]);
    inStyle(context, theme, inFull, () => along(happens));
    inStyle(context, theme, byTheory, () => along(peaksOf(time, seen)));
  }
  context.restore();
  writeCornerReading(context, readings, { ...frame, top: whole.top }, width - widthOfLabel(context, y.name(false), theme, 600) - theme.size, theme);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {ReturnType<typeof peaksOf>} peaks
 * @param {(time: number) => number} x @param {(value: number) => number} y
 * @param {string} color
 */
function tintBetween(context, { above, below }, x, y, color) {
  context.beginPath();
  above.time.forEach((time, i) => context.lineTo(x(time), y(above.value[i])));
  for (let i = below.time.length - 1; i >= 0; i--) context.lineTo(x(below.time[i]), y(below.value[i]));
  context.closePath();
  context.save();
  context.globalAlpha *= tint;
  context.fillStyle = color;
  context.fill();
  context.restore();
}

/**
 * Where a series turns back, above and below; what it starts from counts, its last value does not.
 * @param {Series} time
 * @param {Series} values
 */
export function peaksOf(time, values) {
  const last = values.length - 1;
  /** @type {{ time: number[], value: number[] }[]} */
  const [above, below] = [1, -1].map((sign) => {
    const at = [];
    for (let i = 0; i < last; i++) if ((i === 0 || sign * values[i] >= sign * values[i - 1]) && sign * values[i] > sign * values[i + 1] && sign * values[i] > 0) at.push(i);
    return { time: at.map((i) => time[i]), value: at.map((i) => values[i]) };
  });
  return { above, below };
}
