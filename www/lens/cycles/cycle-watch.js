/**
 * The limit cycle of the gear as it is, followed while values change: from each cycle to the one of the next values, which
 * takes the engine half a millisecond. Where the thread breaks it is searched for anew, but not more often than a frame can
 * bear.
 *
 * @typedef {import('../../run/cycle-looks.js').CycleLooks} CycleLooks
 * @typedef {import('../../run/cycle-looks.js').LimitCycle} LimitCycle
 * @typedef {import('../../run/cycle-looks.js').Guess} Guess
 * @typedef {{ object: string, parameters: Readonly<Record<string, number>>, cycles: CycleLooks }} Gear
 */

import { guessOf } from '../../run/cycle-looks.js';
import { isSameRecord } from '../../store.js';

/** Between two searches from nothing while values change, in ms. */
export const pause = 120;

export class CycleWatch {
  /** The cycle, or that there is none; null before the first search, and where none could be computed. @type {LimitCycle | null} */ cycle = null;
  /** Whether the gear has changed since the cycle was found, or lost. */ isOwed = false;
  /** @type {Pick<Gear, 'object' | 'parameters'> | null} */ #gear = null;
  #searchedAt = -Infinity;
  /** Where the next one is, as somebody knows. @type {Guess | null} */ #hint = null;

  /**
   * @param {Gear} gear
   * @param {number} now in ms
   * @returns {boolean} whether the cycle is another
   */
  follow({ object, parameters, cycles }, now) {
    const before = this.#gear;
    if (!before || before.object !== object || !isSameRecord(before.parameters, parameters)) {
      const guess = this.#hint ?? (before?.object === object ? guessOf(this.cycle) : null);
      this.#hint = null;
      this.#gear = { object, parameters };
      this.isOwed = true;
      if (guess && this.#take(() => cycles.near(guess))) return true;
      if (guess) {
        // What has just been lost is looked for once the hand is slower.
        this.#searchedAt = now;
        return true;
      }
    }
    if (!this.isOwed || now - this.#searchedAt < pause) return false;
    this.#search(cycles, now);
    return true;
  }

  /** Goes to a cycle that is known, or to where the run goes. @param {Gear} gear @param {Guess | null} guess @param {number} now in ms */
  goTo({ object, parameters, cycles }, guess, now) {
    this.#gear = { object, parameters };
    if (!guess || !this.#take(() => cycles.near(guess))) this.#search(cycles, now);
  }

  /** The gear is about to be put on a cycle that is known. @param {Guess} guess */
  expect(guess) {
    this.#hint = guess;
    this.#gear = null;
  }

  /** First where the motion goes: of several cycles that is the one that one sees. @param {CycleLooks} cycles @param {number} now */
  #search(cycles, now) {
    this.#searchedAt = now;
    if (!this.#take(() => cycles.ofMotion())) this.#take(() => cycles.fromRest());
    this.isOwed = false;
  }

  /** @param {() => LimitCycle} ask @returns {boolean} whether there is one */
  #take(ask) {
    try {
      this.cycle = ask();
    } catch {
      // Values so wild that no number comes of them.
      this.cycle = null;
    }
    if (this.cycle?.found) this.isOwed = false;
    return this.cycle?.found ?? false;
  }
}
