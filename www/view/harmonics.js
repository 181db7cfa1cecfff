/**
 * Where a spectrum has peaks at multiples of its highest one.
 *
 * @typedef {{
 *   frequency: ArrayLike<number>, amplitude: ArrayLike<number>, peak: { frequency: number, amplitude: number } | null,
 * }} Spectrum frequencies ascending, in Hz; amplitudes in rad; `peak`: the highest, between the bins
 * @typedef {{ order: number, frequency: number, amplitude: number }} Harmonic
 */

/** An odd gear swings with odd harmonics. */
const orders = [3, 5, 7];
/** A peak stands out when it is so many times higher than the valleys on both its sides. */
const prominence = 4;

/**
 * The harmonics that stand out.
 * @param {Spectrum} spectrum
 * @returns {Harmonic[]}
 */
export function harmonicsOf({ frequency, amplitude, peak }) {
  if (!peak || !(peak.frequency > 0)) return [];
  const base = peak.frequency;
  const within = (/** @type {number} */ from, /** @type {number} */ to) => ({ from: firstAfter(frequency, from * base), to: firstAfter(frequency, to * base) });
  return orders.flatMap((order) => {
    const { from, to } = within(order - 0.25, order + 0.25);
    if (to >= frequency.length) return [];
    let top = from;
    for (let i = from; i < to; i++) if (amplitude[i] > amplitude[top]) top = i;
    const valley = Math.max(least(amplitude, within(order - 1, order)), least(amplitude, within(order, order + 1)));
    return amplitude[top] >= prominence * valley && amplitude[top] > 0 ? [{ order, frequency: frequency[top], amplitude: amplitude[top] }] : [];
  });
}

/** @param {ArrayLike<number>} ascending @param {number} value */
function firstAfter(ascending, value) {
  let low = 0;
  let high = ascending.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (ascending[middle] < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** @param {ArrayLike<number>} values @param {{ from: number, to: number }} range */
function least(values, { from, to }) {
  let lowest = Infinity;
  for (let i = from; i < Math.min(to, values.length); i++) lowest = Math.min(lowest, values[i]);
  return lowest;
}
