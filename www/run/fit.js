/** Scales that fit a motion: chosen at the start of a run and after a change, held in between. */

import { roundLimit } from '../view/scale.js';

/** The factors on offer. */
export const magnifications = [1, 2, 5, 10, 20, 50];
const degree = Math.PI / 180;
/** Swings are drawn between 10° and 20°; this is the middle of that, in ratio. */
const drawnSwing = Math.sqrt(10 * 20) * degree;
/** What a wheel at rest is fitted to, so that axes have a length. */
const least = 0.02 * degree;

/**
 * The factor at which a swing of ± `angle` draws nearest to 10–20°.
 * @param {number} angle in rad
 */
export function magnificationFor(angle) {
  const off = (/** @type {number} */ factor) => Math.abs(Math.log((factor * Math.max(angle, least)) / drawnSwing));
  return magnifications.reduce((best, factor) => (off(factor) < off(best) ? factor : best));
}

/**
 * @typedef {{ angle: number, rate: number, deformation: number }} Swing the largest ψ, ψ̇ and y of a motion
 * @param {Swing} swing
 * @returns {Swing} ends of axes that hold it, in rad, rad/s and m; the angle's is round in degrees, y's in mm
 */
export function limitsFor({ angle, rate, deformation }) {
  return {
    angle: roundLimit(Math.max(angle, least) / degree) * degree,
    rate: roundLimit(Math.max(rate, 0.01)),
    deformation: roundLimit(Math.max(deformation, 1e-5) * 1000) / 1000,
  };
}

/**
 * Whether axes still serve a motion: it stays inside and is more than a third of them.
 * @param {Swing} limits
 * @param {Swing} swing
 */
export function stillFits(limits, swing) {
  const share = Math.max(swing.angle / limits.angle, swing.rate / limits.rate, swing.deformation / limits.deformation);
  return share <= 1 && share > 1 / 3;
}

/**
 * Whether a state lies beyond axes.
 * @param {Swing} limits
 * @param {ArrayLike<number>} state ψ, ψ̇, y
 */
export function isBeyond(limits, state) {
  return Math.abs(state[0]) > limits.angle || Math.abs(state[1]) > limits.rate || Math.abs(state[2]) > limits.deformation;
}

/**
 * @typedef {{ time: ArrayLike<number>, low: ArrayLike<number>, high: ArrayLike<number> }} Envelope
 */

/**
 * The stretch of the run that the timeline shows: from its start over the time in which the motion settles, growing
 * when now comes near its end.
 * @param {Envelope} ahead what comes, times from the start of the run
 * @param {number} now in s
 * @param {ArrayLike<number>} range what the run remembers, in s
 * @param {number} [least] how long it is at least, in s
 */
export function spanFor(ahead, now, range, least = 0.2) {
  const from = range[0];
  return { from, to: from + roundLimit(Math.max(settlingTime(ahead) - from, 1.1 * (now - from), least)) };
}

/**
 * When the swing has come within 2 % of where it ends, of the way it has to go.
 * @param {Envelope} envelope
 */
export function settlingTime({ time, low, high }) {
  const count = time.length;
  if (count === 0) return 0;
  const width = (/** @type {number} */ i) => high[i] - low[i];
  const end = width(count - 1);
  let way = 0;
  for (let i = 0; i < count; i++) way = Math.max(way, Math.abs(width(i) - end));
  let last = count - 1;
  while (last > 0 && Math.abs(width(last - 1) - end) <= 0.02 * way) last--;
  return time[last];
}
