import { axisAcross, axisUp, drawAxes, frameOf, logAxisUp } from './axes.js';
import { curveOf, strokeCurve } from './curve.js';
import { drawGhosts, keysOfGhosts } from './ghosts.js';
import { harmonicsOf } from './harmonics.js';
import { placeKeys } from './key.js';
import { drawRing } from './points.js';
import { decimalsUpTo, quantities, valueOf } from './quantities.js';
import { drawLabel, widthOfLabel } from './text.js';

/**
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./canvas.js').Size} Size
 * @typedef {import('./harmonics.js').Spectrum} Spectrum
 * @typedef {import('./text.js').Run} Run
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{
 *   spectrum: Spectrum, limits: { frequency: number, amplitude: number }, isLogarithmic?: boolean,
 *   ghosts?: { label: string, spectrum: Spectrum }[],
 * }} Shown `limits`: the ends of the axes, in Hz and rad; a logarithmic axis goes down from there by `decades`
 */

/** How far down a logarithmic axis goes. */
const decades = 5;
/** A mark on a peak lower than this cannot be seen to belong to one, in pixels. */
const lowest = 3;

/**
 * How large ψ swings at each frequency, the peak named.
 * @param {CanvasRenderingContext2D} context
 * @param {Size} size
 * @param {Shown} shown
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawSpectrum(context, size, { spectrum, limits, isLogarithmic = false, ghosts = [] }, theme, voice) {
  const { frame, draw: drawKeys } = placeKeys(context, frameOf(size, theme),
    keysOfGhosts(ghosts, theme, voice).map((key) => ({ ...key, wishes: ['top-right', 'top-left'] })), theme);
  const x = axisAcross(quantities.frequency, [0, limits.frequency], frame, theme, voice);
  const y = isLogarithmic
    ? logAxisUp(quantities.amplitude, [limits.amplitude / 10 ** decades, limits.amplitude], frame, voice)
    : axisUp(quantities.amplitude, [0, limits.amplitude], frame, theme, voice);
  const curve = (/** @type {Spectrum} */ { frequency, amplitude }) => curveOf(frequency, amplitude, x.at, y.at);
  const live = curve(spectrum);
  const pinned = ghosts.map((ghost) => ({ curve: curve(ghost.spectrum), isClosed: false }));

  drawAxes(context, frame, x, y, theme);
  context.save();
  context.beginPath();
  context.rect(frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top + 1);
  context.clip();
  fillBelow(context, live, frame.bottom, theme);
  drawGhosts(context, pinned, theme);
  context.strokeStyle = theme.psi;
  context.lineWidth = 2 * theme.line;
  context.lineJoin = 'round';
  strokeCurve(context, live);
  context.restore();

  const { peak } = spectrum;
  for (const { order, frequency, amplitude } of harmonicsOf(spectrum)) {
    const [across, up] = [x.at(frequency), y.at(amplitude)];
    if (across > frame.right || frame.bottom - up < lowest) continue;
    markHarmonic(context, order, across, Math.max(up, frame.top + theme.size), frame, theme);
  }
  const taken = peak && peak.frequency <= limits.frequency ? [namePeak(context, peak, limits, x.at, y.at, frame, theme, voice)] : [];
  drawKeys(taken, [live, ...pinned.map((ghost) => ghost.curve)]);
}

/** @param {CanvasRenderingContext2D} context @param {import('./curve.js').Curve} curve @param {number} floor @param {Theme} theme */
function fillBelow(context, { count, x, y }, floor, theme) {
  if (count < 2) return;
  context.fillStyle = theme.psi;
  context.globalAlpha = 0.12;
  context.beginPath();
  context.moveTo(x(0), floor);
  for (let i = 0; i < count; i++) context.lineTo(x(i), Math.min(y(i), floor));
  context.lineTo(x(count - 1), floor);
  context.closePath();
  context.fill();
  context.globalAlpha = 1;
}

/**
 * "51.9 Hz · 15.2°"
 * @param {NonNullable<Spectrum['peak']>} peak @param {number} limit end of the axis, in rad: how exactly it is said @param {Voice} voice
 */
export function wordsOfPeak({ frequency, amplitude }, limit, voice) {
  return `${voice.number(frequency, 1)} Hz · ${valueOf(quantities.amplitude, amplitude, decimalsUpTo(quantities.amplitude, limit), voice)}`;
}

/**
 * A ring on the peak, and beside it frequency and amplitude.
 * @param {CanvasRenderingContext2D} context @param {NonNullable<Spectrum['peak']>} peak @param {Shown['limits']} limits
 * @param {(v: number) => number} x @param {(v: number) => number} y @param {Box} frame @param {Theme} theme @param {Voice} voice
 * @returns {Box} the room that its name takes
 */
function namePeak(context, { frequency, amplitude }, limits, x, y, frame, theme, voice) {
  const [across, up] = [x(frequency), Math.max(y(amplitude), frame.top)];
  drawRing(context, across, up, 4.5 * Math.sqrt(theme.line), theme.psi, theme);
  /** @type {Run[]} */
  const name = [{ text: wordsOfPeak({ frequency, amplitude }, limits.amplitude, voice) }];
  const width = widthOfLabel(context, name, theme, 600);
  const gap = theme.size * 0.8;
  const left = across + gap + width <= frame.right ? across + gap : across - gap - width;
  const baseline = Math.max(up + theme.size * 0.35, frame.top + theme.size);
  context.fillStyle = theme.psi;
  drawLabel(context, name, left, baseline, theme, { weight: 600, halo: theme.surface });
  return { left, right: left + width, top: baseline - theme.size, bottom: baseline + theme.size * 0.4 };
}

/**
 * A tick on the axis and `3f` on the peak.
 * @param {CanvasRenderingContext2D} context @param {number} order @param {number} x @param {number} y
 * @param {Box} frame @param {Theme} theme
 */
function markHarmonic(context, order, x, y, frame, theme) {
  context.strokeStyle = theme.ink2;
  context.lineWidth = 1.5 * theme.line;
  context.beginPath();
  context.moveTo(x, frame.bottom);
  context.lineTo(x, frame.bottom + theme.size * 0.4);
  context.stroke();
  context.fillStyle = theme.ink2;
  drawLabel(context, [{ text: String(order) }, { symbol: 'f' }], x, y - theme.size * 0.6, theme, { align: 'center', weight: 600, halo: theme.surface });
}
