/**
 * Landings beside each other, computed beside the page one after the other, and anew once the gear has stood still for a moment. What
 * was there before stays until then, and is told to be old.
 *
 * @typedef {import('./ask.js').Gear} Gear
 * @typedef {import('./cases.js').Case} Case
 * @typedef {import('./settings.js').RollValues} RollValues
 * @typedef {{ shimmy: import('./roll.js').Shimmy, stretches: import('./roll.js').Stretches, threshold: number }} Answer
 * @typedef {{ spec: Case, answer: Answer | null, isOld: boolean, isFailed: boolean }} Item
 */

import { rollSpec } from './ask.js';
import { gearWith } from './gear.js';
import { shimmyOf, stretchesOf, thresholdOf } from './roll.js';

/** So long the gear stands still before all is computed anew, in ms. */
const patience = 250;
/** Stretches of a small picture. */
const stretches = 200;

export class RollSet {
  /** Is called when there is something new. */ onChange = () => {};
  /** @type {readonly Item[]} */ items = [];
  #run;
  #cases;
  #key = '';
  #timer = /** @type {ReturnType<typeof setTimeout> | null} */ (null);
  /** @type {AbortController | null} */ #going = null;

  /** @param {readonly Case[]} cases @param {typeof import('../../engine/workers.js').runJob} run */
  constructor(cases, run) {
    this.#cases = cases;
    this.#run = run;
  }

  /** How much of it is done, 0 … 1. */
  get fraction() {
    return this.items.length === 0 ? 0 : this.items.filter(({ isOld }) => !isOld).length / this.items.length;
  }

  /** @param {Gear} gear @param {RollValues} roll */
  look(gear, roll) {
    const others = Object.entries(gear.parameters).filter(([name]) => !['velocity', 'dampingConstant', 'damper.command'].includes(name));
    const key = JSON.stringify([gear.model, others, roll]);
    if (key === this.#key) return;
    this.#key = key;
    const isFirst = this.items.length === 0;
    this.items = this.#cases.map((spec, i) => ({ spec, answer: this.items[i]?.answer ?? null, isOld: true, isFailed: false }));
    this.#end();
    if (isFirst) this.#begin(gear, roll);
    else
      this.#timer = setTimeout(() => {
        this.#timer = null;
        this.#begin(gear, roll);
      }, patience);
  }

  /** Nobody looks any more: what is not there yet is begun anew when somebody does. */
  stop() {
    this.#end();
    if (this.items.some(({ isOld }) => isOld)) this.#key = '';
  }

  #end() {
    if (this.#timer !== null) clearTimeout(this.#timer);
    this.#timer = null;
    this.#going?.abort();
    this.#going = null;
  }

  /** @param {Gear} gear @param {RollValues} roll */
  #begin(gear, roll) {
    const abort = new AbortController();
    this.#going = abort;
    this.#cases.forEach(async (spec, i) => {
      const fitted = gearWith(gear, spec);
      const answer = await this.#run('landingRoll', rollSpec(fitted, roll), { signal: abort.signal }).then((one) => answerOf(one, thresholdOf(fitted.parameters)), () => null);
      if (abort.signal.aborted) return;
      this.items = this.items.map((item, at) => (at === i ? { spec, answer, isOld: false, isFailed: answer === null } : item));
      this.onChange();
    });
  }
}

/** @param {import('./roll.js').Roll} roll @param {number} threshold @returns {Answer} */
const answerOf = (roll, threshold) => ({ shimmy: shimmyOf(roll, threshold), stretches: stretchesOf(roll, stretches), threshold });
