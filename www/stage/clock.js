/**
 * Wall time in, model time out. The clock has no timer of its own: whoever draws tells it the time, so a test can.
 *
 * A frame that comes late (a hidden tab, a machine that slept) counts as `longestFrame`: the run goes on from where it
 * was seen and does not catch up.
 */
export class Clock {
  static longestFrame = 0.1;

  /** @type {number | null} */ #last = null;

  /** @param {number} slow how many times slower than life */
  constructor(slow) {
    this.slow = slow;
    this.isPlaying = false;
  }

  play() {
    this.isPlaying = true;
    this.#last = null;
  }

  pause() {
    this.isPlaying = false;
  }

  /**
   * Model time gone by since the last call, in seconds; 0 while paused and at the first call after it.
   * @param {number} now wall time in seconds, on any steady scale
   */
  elapse(now) {
    const last = this.#last;
    this.#last = now;
    if (!this.isPlaying || last === null) return 0;
    return Math.min(Math.max(now - last, 0), Clock.longestFrame) / this.slow;
  }

  /** Model time of one press of "Step": a twentieth of a second of what is seen. */
  get step() {
    return 0.05 / this.slow;
  }
}
