/**
 * Wall time in, model time out. The clock has no timer of its own: whoever draws tells it the time, so a test can.
 *
 * A frame that comes late (a hidden tab, a machine that slept) counts as `longestFrame`: the run goes on from where it
 * was seen and does not catch up.
 *
 * Three ways: *slow*, so many times slower than life; *strobe*, one flash a cycle, so that the swing is seen at one cycle
 * a second while it grows and falls at nearly its true pace; *real*.
 *
 * @typedef {'slow' | 'strobe' | 'real'} Mode
 */

import { isShownTruly } from './rate.js';

/** A swing is seen at this pace under the strobe, in Hz. */
const strobeBeat = 1;
/** A strobe never flashes faster than this, in s; a little less than a sixtieth, as frames come a little early. */
const shortestDark = 1 / 60 - 0.002;
/** It flashes at the frame nearest to a whole cycle, so up to this much before it, in s. */
const halfFrame = 1 / 120;

export class Clock {
  static longestFrame = 0.1;

  /** @type {number | null} */ #last = null;
  /** Time since the last flash, in s. */ #dark = 0;

  /** @param {number} slow how many times slower than life */
  constructor(slow) {
    this.slow = slow;
    /** @type {Mode} */ this.mode = 'slow';
    /** The cycle that the strobe locks to, in s; null where there is no steady beat. @type {number | null} */
    this.period = null;
    this.isPlaying = false;
    /** Model time that the last frame took, in s. */
    this.exposure = 0;
  }

  play() {
    this.isPlaying = true;
    this.#last = null;
    this.#dark = 0;
  }

  pause() {
    this.isPlaying = false;
  }

  /**
   * Model time gone by since the last call, in seconds; 0 while paused, at the first call after it, and between two
   * flashes of the strobe.
   * @param {number} now wall time in seconds, on any steady scale
   */
  elapse(now) {
    const last = this.#last;
    this.#last = now;
    if (!this.isPlaying || last === null) return 0;
    const passed = Math.min(Math.max(now - last, 0), Clock.longestFrame);
    this.exposure = this.#isStrobing ? this.#flash(passed) : passed / this.rate;
    return this.exposure;
  }

  /** How many times slower than life time goes. */
  get rate() {
    return this.mode === 'slow' ? this.slow : 1;
  }

  /** Whether a single pose would lie about a motion of this frequency. @param {number | null} frequency in Hz */
  isTooFast(frequency) {
    return !this.#isStrobing && !isShownTruly(this.rate, frequency);
  }

  /** Model time of one press of "Step": a twentieth of a second of what is seen. */
  get step() {
    return 0.05 / (this.mode === 'slow' ? this.slow : 50);
  }

  get #isStrobing() {
    return this.mode === 'strobe' && this.period !== null;
  }

  /**
   * So many whole cycles as fit best into the dark, and a little more, by which the swing is seen to move.
   * @param {number} passed time since the last frame, in s
   */
  #flash(passed) {
    const period = this.period ?? 1;
    this.#dark += passed;
    const cycles = Math.round(this.#dark / period);
    if (cycles < 1 || this.#dark < Math.max(shortestDark, cycles * period - halfFrame)) return 0;
    const model = (cycles + this.#dark * strobeBeat) * period;
    this.#dark = 0;
    return model;
  }
}
