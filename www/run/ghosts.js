/**
 * Runs kept as they were, going on beside the live one at the same time, so that both are seen at once.
 *
 * @typedef {import('../engine/engine.js').Engine} Engine
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {import('../engine/engine.js').Energy} Energy
 * @typedef {{ object: string, parameters: Record<string, number>, initial: Record<string, number>, from: number }} Kept
 *   a run pinned at the time `from`, with the state of then
 * @typedef {{ kept: Kept, live: LiveRun, outlook: Outlook | null, energy: Energy | null }} Ghost
 */

import { LiveRun } from './live-run.js';

/** More wheels than this on one sheet tell nothing. */
export const mostGhosts = 4;
const stepsAhead = 30_000;

export class Ghosts {
  #engine;
  /** @type {Ghost[]} */ #all = [];

  /** @param {Engine} engine */
  constructor(engine) {
    this.#engine = engine;
  }

  get all() {
    return this.#all;
  }

  /**
   * Has the ghosts that the state names: those it knows stay, new ones begin, others go.
   * @param {readonly Kept[]} kept
   * @param {number} time where the live run is, in s
   */
  follow(kept, time) {
    for (const { kept: old, live } of this.#all) if (!kept.includes(old)) live.free();
    this.#all = kept.flatMap((one) => this.#all.find((ghost) => ghost.kept === one) ?? this.#begun(one) ?? []);
    this.goTo(time);
    this.refresh();
  }

  /** Brings all to a time of the live run. A ghost that cannot go on stands where it got to. @param {number} time in s */
  goTo(time) {
    for (const { live, kept } of this.#all) {
      const own = Math.max(0, time - kept.from);
      try {
        if (own >= live.time) live.advance(own - live.time);
        else live.seek(own);
      } catch {
        // Its last picture stays.
      }
    }
  }

  /** Looks where they go, and what goes in and out of each now. */
  refresh() {
    for (const ghost of this.#all) {
      const { object: model, parameters, stateByName: initial } = ghost.live;
      const run = { model, parameters, initial, maxSteps: stepsAhead };
      try {
        ghost.outlook = this.#engine.outlook(run);
        const frequency = ghost.outlook.present.frequency ?? ghost.outlook.frequency;
        ghost.energy = frequency ? this.#engine.energy({ ...run, duration: 1 / frequency }) : null;
      } catch {
        ghost.outlook = null;
        ghost.energy = null;
      }
    }
  }

  /**
   * @param {Kept} kept
   * @returns {Ghost | null} null for one that the engine refuses, as a damaged link may bring it
   */
  #begun(kept) {
    const { object, parameters, initial } = kept;
    try {
      const live = new LiveRun(this.#engine, { object, parameters, initial, changes: [], time: 0 });
      return { kept, live, outlook: null, energy: null };
    } catch {
      return null;
    }
  }
}
