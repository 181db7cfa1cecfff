/**
 * A landing roll and the branches under it, worked on beside the page and anew when the gear has changed, with what is made of them
 * for looking at.
 *
 * @typedef {import('./ask.js').Gear} Gear
 * @typedef {import('./settings.js').RollValues} RollValues
 * @typedef {import('./roll.js').Roll} Roll
 * @typedef {import('./why.js').Reason} Reason
 * @typedef {{ roll: Roll, shimmy: import('./roll.js').Shimmy, stretches: import('./roll.js').Stretches, at: ReturnType<typeof momentsOf>, threshold: number }} Seen
 */

import { BesideWork } from '../cycles/beside-work.js';
import { branchSpec, rollSpec } from './ask.js';
import { momentsOf, shimmyOf, stretchesOf, thresholdOf } from './roll.js';
import { reasonsOf } from './why.js';

/** Stretches of the whole roll: more than a picture has columns. */
const stretches = 900;

export class RollWork {
  /** Is called when there is something new. */ onChange = () => {};
  /** @type {BesideWork<ReturnType<typeof rollSpec>, Seen>} */ #roll;
  /** @type {BesideWork<import('../../pkg/shimmy.js').BifurcationSpec, import('../../pkg/shimmy.js').Bifurcation>} */ #branches;
  /** @type {{ of: readonly unknown[], reasons: readonly Reason[] }} */ #reasons = { of: [], reasons: [] };

  /** @param {typeof import('../../engine/workers.js').runJob} run */
  constructor(run) {
    this.#roll = new BesideWork(async (spec, { signal }) => seenOf(await run('landingRoll', spec, { signal }), thresholdOf(spec.parameters)));
    this.#branches = new BesideWork((spec, options) => run('bifurcation', spec, options));
    for (const work of [this.#roll, this.#branches]) work.onChange = () => this.onChange();
  }

  /** @param {Gear} gear @param {RollValues} roll */
  look(gear, roll) {
    const others = Object.entries(gear.parameters).filter(([name]) => name !== 'velocity');
    const key = JSON.stringify([gear.model, others, roll]);
    this.#roll.look({ key, shape: 'roll', spec: rollSpec(gear, roll) });
    const { from, to } = branchSpec(gear, roll);
    this.#branches.look({ key: JSON.stringify([gear.model, others, from, to]), shape: JSON.stringify([from, to]), spec: branchSpec(gear, roll) });
  }

  stop() {
    this.#roll.stop();
    this.#branches.stop();
  }

  get seen() {
    return this.#roll.result;
  }

  /** Whether the roll is of other values than the gear's now. */
  get isOld() {
    return this.#roll.isOld;
  }

  get isFailed() {
    return this.#roll.isFailed;
  }

  get diagram() {
    return this.#branches.result;
  }

  get isDiagramOld() {
    return this.#branches.isOld;
  }

  /** Why it begins and ends where it does; none while either is not known for the gear as it is. */
  get reasons() {
    const { seen, diagram } = this;
    if (!seen || !diagram || this.isOld || this.isDiagramOld) return [];
    if (this.#reasons.of[0] !== seen || this.#reasons.of[1] !== diagram) this.#reasons = { of: [seen, diagram], reasons: reasonsOf(seen.shimmy, diagram, seen.threshold) };
    return this.#reasons.reasons;
  }
}

/** @param {Roll} roll @param {number} threshold @returns {Seen} */
const seenOf = (roll, threshold) => ({ roll, threshold, shimmy: shimmyOf(roll, threshold), stretches: stretchesOf(roll, stretches), at: momentsOf(roll) });
