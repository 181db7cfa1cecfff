/**
 * A small swing as linear theory has it, with the envelope that the leading root foretells.
 *
 * @typedef {import('../../run/linear-looks.js').LinearLooks} LinearLooks
 * @typedef {import('../../view/root-paths.js').Root} Root
 */

import { roundLimit } from '../../view/scale.js';

/** How long it is watched, in s: the first of these that holds some cycles. */
const durations = [0.02, 0.03, 0.05, 0.07, 0.1, 0.15, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3, 5];
const cycles = 8;
/** A swing that grows is watched until it is so many times its start, for some cycles at least. */
const seen = 3;
/** The axis reaches so far, measured by the start, unless the swing goes beyond. */
const usualLimit = 3;
const fewestCycles = 3;
const samplesPerCycle = 40;
const mostSamples = 1200;
/** What of it tells the amplitude: after the start, when only the leading root is left. */
const [settledFrom, settledTo] = [0.3, 0.6];
const circle = 2 * Math.PI;

/**
 * @param {LinearLooks} linear
 * @param {readonly Root[]} roots by falling real part
 */
export function smallSwing(linear, roots) {
  const [{ re: growthRate, im }] = roots;
  // A wheel that turns aside has left the picture before it could swing.
  const beat = growthRate > 0 && im === 0 ? 0 : Math.max(...roots.map((root) => root.im)) / circle;
  const fitting = growthRate > 0 ? Math.log(seen) / growthRate : Infinity;
  const wanted = beat > 0 ? Math.min(Math.max(fitting, fewestCycles / beat), cycles / beat) : Math.min(fitting, 3 / Math.abs(growthRate || 1));
  const duration = durations.find((one) => one >= wanted) ?? durations[durations.length - 1];
  const samples = Math.min(mostSamples, Math.max(200, Math.ceil(duration * beat * samplesPerCycle)));
  const { time, angle } = linear.smallSwing(duration, samples);
  const peak = angle.reduce((most, one) => Math.max(most, Math.abs(one)), 0);
  return { time, angle, growthRate, amplitude: amplitudeOf(time, angle, growthRate), duration, limit: peak > usualLimit ? roundLimit(peak) : usualLimit };
}

/**
 * How high an envelope e^(σt) must begin to touch the swing once that has settled into it.
 * @param {ArrayLike<number>} time from 0
 * @param {ArrayLike<number>} angle
 * @param {number} growthRate σ
 */
export function amplitudeOf(time, angle, growthRate) {
  let most = 0;
  const last = time.length - 1;
  for (let i = Math.ceil(settledFrom * last); i <= settledTo * last; i++)
    most = Math.max(most, Math.abs(angle[i]) * Math.exp(-growthRate * time[i]));
  return most;
}
