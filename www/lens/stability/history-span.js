/**
 * How long linear theory and the gear in full are shown beside each other, where nobody has said: long enough to see them part,
 * and no longer than both can be seen.
 *
 * @typedef {import('../../run/linear-looks.js').LinearLooks} LinearLooks
 */

import { historySpans } from './settings.js';

/** The axis reaches so far beyond what happens in full; linear theory may leave it. */
export const headroom = 1.5;
/** A swing that falls is shown until it is so many times smaller. */
const fallen = 20;
/** Where linear theory leaves the picture, it has been in it for two thirds. */
const past = 1.5;
const fewestCycles = 5;
/** No longer than the figures of the thesis, in s. */
const longest = 2;
/** A hundred cycles of 50 Hz, with ten samples each: enough to know how large they are. */
const samples = 1000;
/** A span stays while what is wanted is no less than this share of it. */
const held = 0.2;
const circle = 2 * Math.PI;

/**
 * So long it takes to see what becomes of the swing, in s.
 * @param {LinearLooks} linear
 * @param {'torsionAngle' | 'lateralDeformation'} state
 */
export function wantedSpan(linear, state) {
  const roots = linear.eigenvalues();
  const [{ re: growthRate }] = roots;
  const beat = Math.max(...roots.map(({ im }) => im)) / circle;
  const cycles = beat > 0 ? fewestCycles / beat : 0;
  if (growthRate <= 0) return Math.min(longest, Math.max(cycles, Math.log(fallen) / -growthRate));
  const histories = linear.histories(longest, samples);
  if (!histories) return longest;
  const limit = headroom * largest(histories.nonlinear[state]);
  const leaves = histories.linear[state].findIndex((value) => Math.abs(value) > limit);
  return leaves < 0 ? longest : Math.min(longest, Math.max(cycles, past * histories.linear.time[leaves]));
}

/**
 * The least of the spans that holds what is wanted; the one before, while that does so and not much of it is empty.
 * @param {number} wanted in s
 * @param {number} [before]
 */
export function fittingSpan(wanted, before = 0) {
  if (wanted <= before && wanted >= held * before) return before;
  return historySpans.find((span) => span >= wanted) ?? historySpans[historySpans.length - 1];
}

/** @param {Float64Array} values */
export const largest = (values) => values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
