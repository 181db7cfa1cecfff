import { Stopwatch } from './stopwatch.js';

/**
 * The first seconds of a fresh page: the wheel alone, then one sentence, then one knob's breath, then what to try. Whatever
 * a visitor does ends it.
 *
 * It has no timer: frames tell it the time. What it says is true when it is said, for it goes by the time that was seen,
 * as the run does: with the opening's start and rate the swing reaches ±10° at 6 s.
 *
 * @typedef {'wheel' | 'sentence' | 'breath' | 'over'} Moment the last that has begun
 */

/** When each begins, in s. @type {readonly { moment: Moment, at: number }[]} */
const moments = [{ moment: 'wheel', at: 0 }, { moment: 'sentence', at: 3 }, { moment: 'breath', at: 8 }, { moment: 'over', at: 12 }];

export class OpeningAct {
  /** When the knob breathes, in s: where a page that must not move stands still. */
  static end = 8;

  #watch = new Stopwatch();
  #seen = 0;

  /** @returns {Moment} */
  get moment() {
    return moments.findLast(({ at }) => at <= this.#seen + 1e-9)?.moment ?? 'wheel';
  }

  /**
   * Lets a frame go by.
   * @param {number} now wall time in s, on any steady scale
   * @param {boolean} isPlaying whether the run goes on
   * @returns {boolean} whether another moment has begun
   */
  elapse(now, isPlaying) {
    const before = this.moment;
    this.#seen += this.#watch.elapse(now, isPlaying);
    return this.moment !== before;
  }
}
