/** How slowly the page shows a motion that is too fast for the eye. */

/** The rates on offer: times slower than life. */
export const slowRates = [1, 2, 5, 10, 25, 50, 100, 250, 500];

/** Below this many frames a cycle a single pose would lie about the motion. */
const fewestFramesPerCycle = 12;
const framesPerSecond = 60;

/**
 * The rate that shows nearest to one cycle a second (nearest in ratio). Without a frequency: 50, that of a gear with
 * the usual data.
 * @param {number | null} frequency in Hz
 */
export function slowRateFor(frequency) {
  if (!frequency) return 50;
  const offCycle = (/** @type {number} */ slow) => Math.abs(Math.log(frequency / slow));
  return slowRates.reduce((best, slow) => (offCycle(slow) < offCycle(best) ? slow : best));
}

/**
 * Whether a screen shows a motion of this frequency truly at this rate.
 * @param {number} slow
 * @param {number | null} frequency in Hz
 */
export function isShownTruly(slow, frequency) {
  return !frequency || (framesPerSecond * slow) / frequency >= fewestFramesPerCycle;
}

/** A cycle that takes longer than this to pass by is no longer seen as a swing, in s. */
const longestCycle = 4;

/**
 * How long a cycle takes on the screen at a rate, in s, and whether that shows the swing.
 * @param {number} slow
 * @param {number | null} frequency in Hz
 * @returns {{ cycle: number | null, pace: 'too-fast' | 'fits' | 'too-slow' }}
 */
export function paceAt(slow, frequency) {
  const cycle = frequency ? slow / frequency : null;
  const pace = !isShownTruly(slow, frequency) ? 'too-fast' : (cycle ?? 0) > longestCycle ? 'too-slow' : 'fits';
  return { cycle, pace };
}
