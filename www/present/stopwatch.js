import { Clock } from '../run/clock.js';

/**
 * Time as it was seen: frames tell it when they are, and one that comes late (a hidden tab) counts as a long frame and no
 * more, as for the run's own clock.
 */
export class Stopwatch {
  /** @type {number | null} */ #last = null;

  /**
   * Seconds since the frame before; 0 at the first one, and while it does not run.
   * @param {number} now wall time in s, on any steady scale
   * @param {boolean} isRunning
   */
  elapse(now, isRunning) {
    const last = this.#last;
    this.#last = isRunning ? now : null;
    if (!isRunning || last === null) return 0;
    return Math.min(Math.max(now - last, 0), Clock.longestFrame);
  }
}
