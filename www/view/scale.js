/** Scales of plots: straight lines between data and pixels, and round numbers on them. */

/**
 * @param {[number, number]} domain
 * @param {[number, number]} range
 * @returns {(value: number) => number}
 */
export function linear([from, to], [start, end]) {
  const slope = (end - start) / (to - from);
  return (value) => start + (value - from) * slope;
}

/**
 * Multiples of 1, 2 or 5 times a power of ten within [low, high], at most `most` of them.
 * @param {number} low
 * @param {number} high
 * @param {number} most
 */
export function ticks(low, high, most) {
  const step = roundStep((high - low) / most);
  const first = Math.ceil(low / step - 1e-9);
  const last = Math.floor(high / step + 1e-9);
  return Array.from({ length: last - first + 1 }, (_, i) => ((first + i) * step) || 0);
}

/**
 * The powers of ten within [low, high], which are above 0.
 * @param {number} low
 * @param {number} high
 */
export function powers(low, high) {
  const first = Math.ceil(Math.log10(low) - 1e-9);
  const last = Math.floor(Math.log10(high) + 1e-9);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => 10 ** (first + i));
}

/**
 * Decimals that tell ticks of this spacing apart.
 * @param {number[]} values
 */
export function tickDecimals(values) {
  if (values.length < 2) return 0;
  return Math.max(0, Math.ceil(-Math.log10(Math.abs(values[1] - values[0])) - 1e-9));
}

/**
 * The next 1, 2 or 5 times a power of ten.
 * @param {number} least the smallest that may be returned
 */
export function roundStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  const digit = least / power;
  return power * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10);
}

/**
 * A limit for an axis that holds ± `largest` with a little room, round enough to read.
 * @param {number} largest
 */
export function roundLimit(largest) {
  const wanted = 1.12 * largest;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const digit = [1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10].find((candidate) => wanted <= candidate * power * (1 + 1e-9)) ?? 10;
  return digit * power;
}
