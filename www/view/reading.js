/**
 * What a cursor reads off a time history.
 *
 * @typedef {ArrayLike<number>} Series
 * @typedef {{ time: number, value: number, peakToPeak: number | null, frequency: number | null }} Reading
 *   `peakToPeak`, `frequency` (Hz): of the cycle around the cursor, where there is one
 */

/**
 * @param {Series} time ascending, in s
 * @param {Series} values
 * @param {number} at
 * @returns {Reading | null} null outside the series
 */
export function readingAt(time, values, at) {
  const last = time.length - 1;
  if (last < 1 || !(at >= time[0] && at <= time[last])) return null;
  const cycle = cycleAround(crossings(time, values), at);
  return {
    time: at,
    value: valueAt(time, values, at),
    peakToPeak: cycle && extreme(time, values, cycle, 1) - extreme(time, values, cycle, -1),
    frequency: cycle && 1 / (cycle[1] - cycle[0]),
  };
}

/**
 * From the first cursor to the second.
 * @param {Reading} first
 * @param {Reading} second
 * @returns {{ time: number, frequency: number | null, value: number }} `frequency`: 1/|Δt|, in Hz
 */
export function differenceOf(first, second) {
  const time = second.time - first.time;
  return { time, frequency: time === 0 ? null : 1 / Math.abs(time), value: second.value - first.value };
}

/**
 * The value at a time, straight between its neighbors.
 * @param {Series} time @param {Series} values @param {number} at
 */
function valueAt(time, values, at) {
  let low = 0;
  let high = time.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (time[middle] <= at) low = middle;
    else high = middle;
  }
  const share = (at - time[low]) / (time[high] - time[low] || 1);
  return values[low] + share * (values[high] - values[low]);
}

/**
 * The times at which the values change sign.
 * @param {Series} time @param {Series} values
 */
function crossings(time, values) {
  const found = [];
  for (let i = 1; i < time.length; i++) {
    const [before, after] = [values[i - 1], values[i]];
    if (before < 0 !== after < 0) found.push(time[i - 1] + ((time[i] - time[i - 1]) * before) / (before - after));
  }
  return found;
}

/**
 * The whole cycle whose middle is nearest: from a change of sign to the next but one.
 * @param {number[]} zeros @param {number} at @returns {[number, number] | null}
 */
function cycleAround(zeros, at) {
  /** @type {[number, number] | null} */
  let nearest = null;
  let off = Infinity;
  for (let i = 2; i < zeros.length; i++) {
    const distance = Math.abs((zeros[i - 2] + zeros[i]) / 2 - at);
    if (distance < off) [nearest, off] = [[zeros[i - 2], zeros[i]], distance];
  }
  return nearest;
}

/**
 * The largest or least value within a cycle, on the parabola through the outermost sample and its neighbors: samples
 * alone would miss the top.
 * @param {Series} time @param {Series} values @param {[number, number]} cycle @param {1 | -1} sign
 */
function extreme(time, values, [from, to], sign) {
  let at = -1;
  for (let i = 0; i < time.length; i++)
    if (time[i] >= from && time[i] <= to && (at < 0 || sign * values[i] > sign * values[at])) at = i;
  if (at < 1 || at === time.length - 1) return at < 0 ? 0 : values[at];
  const [t, v] = [time[at], values[at]];
  const [before, after] = [time[at - 1] - t, time[at + 1] - t];
  const [left, right] = [(values[at - 1] - v) / before, (values[at + 1] - v) / after];
  const bend = (right - left) / (after - before);
  const slope = left - bend * before;
  return bend * sign < 0 ? v - (slope * slope) / (4 * bend) : v;
}
