import { curveOf, strokeCurve } from './curve.js';
import { linear, roundLimit } from './scale.js';
import { ghost as ghostStyle, inStyle } from './strokes.js';
import { drawVeil } from './veil.js';

/**
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('./axes.js').Box} Box
 * @typedef {{ time: ArrayLike<number>, low: ArrayLike<number>, high: ArrayLike<number> }} Envelope
 *   the least and the largest ψ about each time, ascending
 * @typedef {{
 *   past: Envelope, future: Envelope, from: number, to: number, now: number, bracket: [number, number],
 *   ghosts?: Envelope[], veiled?: boolean,
 * }} Run times in s of the run; `ghosts`: pinned runs, past and future in one; `veiled`: the future is not to be seen yet
 */

/** A future that grows without end is cut here, in rad, or the past would be a line. */
const widestFuture = 1;
/** A wheel at rest still has an axis, in rad. */
const least = 1e-4;

/**
 * The whole run at a glance: how wide it swung, how wide it will if nothing changes, and which part is shown below.
 * @param {CanvasRenderingContext2D} context
 * @param {Box} box
 * @param {Run} run
 * @param {Theme} theme
 */
export function drawRunEnvelope(context, box, run, theme) {
  const x = linear([run.from, run.to], [box.left, box.right]);
  const limit = limitOf(run);
  const y = linear([-limit, limit], [box.bottom, box.top]);
  const now = x(run.now);

  context.strokeStyle = theme.rule;
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(box.left, y(0));
  context.lineTo(box.right, y(0));
  context.stroke();

  context.fillStyle = theme.psi;
  context.globalAlpha = theme.scheme === 'dark' ? 0.32 : 0.24;
  if (!run.veiled) fillBetween(context, joined(run), x, y, { ...box, left: now });
  context.globalAlpha = theme.scheme === 'dark' ? 0.8 : 0.78;
  fillBetween(context, run.past, x, y, { ...box, right: Math.min(now - 0.5, box.right) });
  context.globalAlpha = 1;
  if (run.veiled) drawVeil(context, { ...box, left: Math.max(now, box.left) }, theme);
  outlineGhosts(context, run.ghosts ?? [], x, y, box, theme);

  const [from, to] = run.bracket.map(x);
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.5;
  const left = Math.max(from, box.left);
  context.strokeRect(Math.round(left) + 0.5, Math.round(box.top) - 2.5, Math.max(4, Math.round(Math.min(to, box.right) - left)), Math.round(box.bottom - box.top) + 5);
}

/**
 * The end of the axis: it holds all that the lane shows, so the plots below may be fitted to a small swing while a
 * large one is still remembered.
 * @param {Run} run
 */
function limitOf({ past, future, ghosts = [] }) {
  const widest = (/** @type {Envelope} */ { low, high }) => {
    let most = 0;
    for (let i = 0; i < high.length; i++) most = Math.max(most, high[i], -low[i]);
    return most;
  };
  const ahead = Math.min(Math.max(widest(future), ...ghosts.map(widest)), widestFuture);
  return roundLimit(Math.max(widest(past), ahead, least));
}

/**
 * What comes, from the present on: the past looks back by a cycle and the future ahead by one, and between them a
 * growing swing would seem to jump.
 * @param {Run} run
 * @returns {Envelope}
 */
function joined({ past, future, now }) {
  const last = past.time.length - 1;
  if (last < 1) return future;
  let next = 0;
  while (next < future.time.length && future.time[next] <= now) next++;
  const from = (/** @type {number} */ present, /** @type {ArrayLike<number>} */ series) => [present, ...Array.from(series).slice(next)];
  return { time: from(now, future.time), low: from(past.low[last], future.low), high: from(past.high[last], future.high) };
}

/**
 * The band between least and largest, cut to the box and held beyond its first and last point.
 * @param {CanvasRenderingContext2D} context @param {Envelope} envelope
 * @param {(v: number) => number} x @param {(v: number) => number} y @param {Box} box
 */
function fillBetween(context, { time, low, high }, x, y, { left: from, right: to, top: ceiling, bottom: floor }) {
  const last = time.length - 1;
  if (last < 0 || to <= from) return;
  context.save();
  context.beginPath();
  context.rect(from, ceiling, to - from, floor - ceiling);
  context.clip();
  // At least a hairline, so that a wheel at rest is seen to be there.
  const top = (/** @type {number} */ i) => Math.min(y(high[i]), y(0) - 0.75);
  const bottom = (/** @type {number} */ i) => Math.max(y(low[i]), y(0) + 0.75);
  context.beginPath();
  context.moveTo(Math.min(from, x(time[0])), top(0));
  for (let i = 0; i <= last; i++) context.lineTo(x(time[i]), top(i));
  context.lineTo(Math.max(to, x(time[last])), top(last));
  context.lineTo(Math.max(to, x(time[last])), bottom(last));
  for (let i = last; i >= 0; i--) context.lineTo(x(time[i]), bottom(i));
  context.lineTo(Math.min(from, x(time[0])), bottom(0));
  context.closePath();
  context.fill();
  context.restore();
}

/**
 * The edges of pinned runs' bands.
 * @param {CanvasRenderingContext2D} context @param {Envelope[]} ghosts
 * @param {(v: number) => number} x @param {(v: number) => number} y @param {Box} box
 * @param {Theme} theme
 */
function outlineGhosts(context, ghosts, x, y, { left, right, top, bottom }, theme) {
  if (ghosts.length === 0) return;
  context.save();
  context.beginPath();
  context.rect(left, top, right - left, bottom - top);
  context.clip();
  ghosts.forEach(({ time, low, high }, i) => inStyle(context, theme, ghostStyle(i), () => {
    for (const edge of [low, high]) strokeCurve(context, curveOf(time, edge, x, y));
  }));
  context.restore();
}
