import { axisOf, drawAxes, frameOf } from './axes.js';
import { writeCornerReading } from './corner-reading.js';
import { curveOf, strokeCurve } from './curve.js';
import { linear } from './scale.js';
import { destination, inStyle } from './strokes.js';
import { textFont, widthOfLabel } from './text.js';
import { drawVeil } from './veil.js';

/**
 * How a small swing goes on by linear theory, as multiples of where it starts, within the envelope that its growth rate
 * foretells.
 *
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{
 *   time: ArrayLike<number>, angle: ArrayLike<number>, growthRate: number, amplitude: number, duration: number, limit: number,
 *   readings: readonly string[], veiled?: boolean,
 * }} Shown `amplitude`: of the envelope at the start; `limit`: ± of the axis;
 *   `readings`: of the envelope, in fewer and fewer words
 */

const envelopePoints = 60;
/** A swing is drawn until its envelope is so many times as high as the picture. */
const cut = 1.5;

/**
 * @param {CanvasRenderingContext2D} context
 * @param {import('./canvas.js').Size} size
 * @param {Shown} shown
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawLinearHistory(context, size, { time, angle, growthRate, amplitude, duration, limit, readings, veiled = false }, theme, voice) {
  const side = /** @type {const} */ ({ symbol: 't', word: 'roots.re', unit: '', color: 'psi' });
  const usual = frameOf(size, theme, 'above');
  // A swing that grows fast has long numbers.
  context.font = textFont(theme, 0.95);
  const frame = { ...usual, left: Math.max(usual.left, context.measureText(voice.number(-limit, 0)).width + theme.size) };
  const [width, height] = [frame.right - frame.left, frame.bottom - frame.top];
  if (width < 20 || height < 20) return;
  const x = axisOf({ ...side, perSI: 1000 }, [0, duration], [frame.left, frame.right], Math.min(6, width / (theme.size * 4)), voice);
  const y = {
    ...axisOf({ ...side, perSI: 1 }, [-limit, limit], [frame.bottom, frame.top], Math.min(6, height / (theme.size * 1.9)), voice),
    name: (/** @type {boolean} */ isShort) => [{ symbol: 'ψ' }, { text: isShort ? '' : ` ${voice.say('history.times')}` }],
  };
  drawAxes(context, frame, { ...x, name: () => [{ symbol: 't' }, { text: ', ms' }] }, y, theme, { up: 'above' });
  if (veiled) {
    drawVeil(context, frame, theme);
    return;
  }
  context.save();
  context.beginPath();
  context.rect(frame.left, frame.top, width, height);
  context.clip();
  const at = linear([0, envelopePoints], [0, duration]);
  const times = Array.from({ length: envelopePoints + 1 }, (_, i) => at(i));
  inStyle(context, theme, destination, () => {
    context.strokeStyle = growthRate > 0 ? theme.unstable : theme.stable;
    for (const sign of [1, -1]) strokeCurve(context, curveOf(times, times.map((t) => sign * amplitude * Math.exp(growthRate * t)), x.at, y.at));
  });
  context.strokeStyle = theme.psi;
  context.lineWidth = 1.6 * theme.line;
  context.lineJoin = 'round';
  // What has left the picture would fill it with upright lines.
  const end = Array.from(time).findIndex((t) => amplitude * Math.exp(growthRate * t) > cut * limit);
  const curve = curveOf(time, angle, x.at, y.at);
  strokeCurve(context, end < 0 ? curve : { ...curve, count: end + 1 });
  context.restore();
  writeCornerReading(context, readings, frame, width - widthOfLabel(context, y.name(false), theme, 600) - theme.size, theme);
}
