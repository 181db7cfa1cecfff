/**
 * A run under way: the engine's simulator, and a record of what has been done to it. From the record the run can be
 * begun again elsewhere, as from an address after a reload, and brought back to what it was, as undo and redo do.
 *
 * @typedef {import('../engine/engine.js').Engine} Engine
 * @typedef {{ time: number, set?: Record<string, number>, state?: Record<string, number>, kick?: number }} Change
 *   what was done at an instant: values set, a state put in its place, a blow in N m s
 * @typedef {{
 *   object: string, parameters: Record<string, number>, initial: Record<string, number>, changes: readonly Change[], time: number,
 * }} Recipe `parameters`: those of the start; `time`: how far it goes, in s
 * @typedef {Change & { gesture: string | null, since: number }} Done a change on record; changes of one gesture are one, that
 *   began at `since`
 * @typedef {{ parameters: Readonly<Record<string, number>>, initial: Record<string, number> }} Start
 * @typedef {{
 *   object: string, start: Start, changes: readonly Done[], isWhole: boolean, time: number, latest: number,
 *   state: Record<string, number>, parameters: Readonly<Record<string, number>>,
 * }} Place where a run is, and how it came there. `isWhole`: whether its record goes back to its start; `latest`: how far it
 *   had come before it was taken back to `time`
 */

import { gearAt } from './landing.js';

/** Steps that one call may take. A gear of sensible size takes a few a millisecond; an absurd one is stopped. */
const stepsOfCall = 100_000;
/** A run is begun again in stretches of this length, each with steps of its own, in s. */
const stretch = 0.5;
/** A record longer than this is a burden to an address: such a run is begun again where it is now. */
const longestRecord = 40;
const longestTime = 60;

export class LiveRun {
  /** @type {readonly Done[]} */ #changes = [];
  /** Whether the record still goes back to the start. */ #isWhole = true;
  /** Whether the last gesture on record has ended: one like it is another. */ #isSettled = true;
  /** @type {Start} */ #start;
  #simulator;
  #names;

  /**
   * @param {Engine} engine
   * @param {Recipe} recipe
   */
  constructor(engine, recipe) {
    const { object, parameters, initial } = recipe;
    this.object = object;
    this.#simulator = new engine.Simulator({ model: object, parameters, initial, maxSteps: stepsOfCall });
    this.#start = { parameters: this.#simulator.parameters(), initial };
    this.#names = Object.keys(this.#simulator.history(0, 0, 2)).filter((name) => name !== 'time');
    /** Values in force. @type {Readonly<Record<string, number>>} */
    this.parameters = this.#start.parameters;
    /** Why it does not get as far as the recipe goes, if so. @type {unknown} */
    this.failure = null;
    try {
      for (const change of recipe.changes) {
        this.#advanceTo(change.time);
        this.apply(change);
      }
      this.#advanceTo(recipe.time);
    } catch (error) {
      this.failure = error;
    }
  }

  /** The state that it started from, by name; zeros are left out. */
  get initial() {
    return this.#start.initial;
  }

  get time() {
    return this.#simulator.time;
  }

  /** The gear as it is now: at the speed that it has, where it slows down. */
  get present() {
    return gearAt(this.object, this.parameters, this.time);
  }

  /** The earliest and the latest time that can be seen. */
  get range() {
    return this.#simulator.range;
  }

  /** The state in the order of the model's table. */
  get state() {
    return this.#simulator.state();
  }

  /** The state by name. @returns {Record<string, number>} */
  get stateByName() {
    const state = this.state;
    return Object.fromEntries(this.#names.map((name, i) => [name, state[i]]));
  }

  /** When something was last done to it; 0 where nothing was. */
  get changedAt() {
    return this.#changes.findLast(({ time }) => time <= this.time)?.time ?? 0;
  }

  /** When it was last struck or put in its place by a hand; −∞ where never. */
  get struckAt() {
    return this.#changes.findLast(({ time, set }) => time <= this.time && !set)?.time ?? -Infinity;
  }

  /** @param {number} seconds */
  advance(seconds) {
    this.#simulator.advance(seconds);
  }

  /**
   * Moves to a time: back within what is remembered, or on.
   * @param {number} time in s
   */
  seek(time) {
    const [earliest, latest] = this.range;
    this.#simulator.seek(Math.min(Math.max(time, earliest), latest));
    if (time > latest) this.#advanceTo(time);
    this.parameters = this.#simulator.parameters();
  }

  /**
   * Does something to the run, now. What had been done after this instant is forgotten. Throws what the engine refuses;
   * then nothing has changed.
   * @param {Omit<Change, 'time'>} change
   * @param {string | null} [gesture] changes of one gesture are one in the record
   */
  apply(change, gesture = null) {
    const before = livedOf(this.place);
    this.#enact(change);
    const { set, state, kick } = change;
    this.#record(before, { time: this.time, since: this.time, gesture, ...(set && { set }), ...(state && { state }), ...(kick !== undefined && { kick }) });
  }

  /** A hand let go: its gesture has ended. */
  settle() {
    this.#isSettled = true;
  }

  /** Where it is, and how it came there. @returns {Place} */
  get place() {
    const { object, time, parameters, stateByName: state } = this;
    return { object, start: this.#start, changes: this.#changes, isWhole: this.#isWhole, time, latest: this.range[1], state, parameters };
  }

  /** Whether a place is one of this run. @param {Place} place */
  knows({ start }) {
    return start === this.#start;
  }

  /**
   * Brings the run to what it was at a place that it knows: back to where the two part, then on by the changes of then. What
   * lies further back than is remembered is not lived again: its values and its state come to the present.
   * @param {Place} place
   */
  goTo(place) {
    const { changes, isWhole, time, latest, state, parameters } = place;
    const [earliest, reached] = this.range;
    const parting = partingOf(this.place, place);
    if (Math.min(parting, time) < earliest) {
      this.apply({ set: parameters, state });
      return;
    }
    if (parting < Infinity) {
      const isUndone = parting >= time;
      this.seek(Math.min(isUndone ? time : parting, reached));
      // What was done at this very instant has touched the state already: the place has it as it was.
      if (isUndone) this.#enact({ set: parameters, state });
      for (const change of changes.filter((one) => (isUndone ? one.time > time : one.time >= parting))) {
        this.#advanceTo(change.time);
        this.#enact(change);
      }
      this.#advanceTo(latest);
    }
    this.#changes = changes;
    this.#isWhole = isWhole;
    this.#isSettled = true;
    this.seek(time);
  }

  /** @param {number} from @param {number} to @param {number} samples */
  history(from, to, samples) {
    return this.#simulator.history(from, to, samples);
  }

  /** @param {number} from @param {number} to @param {number} stretches */
  envelope(from, to, stretches) {
    return this.#simulator.envelope(from, to, stretches);
  }

  /**
   * How to begin it again and come to where it is. A long record is left out: the run then begins with the state of now.
   * @returns {Recipe}
   */
  get recipe() {
    return recipeOf(this.place);
  }

  free() {
    this.#simulator.free();
  }

  /** @param {Omit<Change, 'time'>} change */
  #enact({ set = {}, state, kick }) {
    const names = Object.keys(set);
    for (const [i, name] of names.entries()) {
      try {
        this.#simulator.set(name, set[name]);
      } catch (error) {
        for (const done of names.slice(0, i)) this.#simulator.set(done, this.parameters[done]);
        throw error;
      }
    }
    for (const [name, value] of Object.entries(state ?? {})) this.#simulator.setState(name, value);
    if (kick !== undefined) this.#simulator.kick(kick);
    this.parameters = { ...this.parameters, ...set };
  }

  /** @param {readonly Done[]} before what had been done @param {Done} change */
  #record(before, change) {
    const last = before.at(-1);
    const isSame = last && !this.#isSettled && change.gesture !== null && last.gesture === change.gesture;
    this.#isSettled = false;
    const merged = isSame && { ...last, ...change, since: last.since, ...(last.set && { set: { ...last.set, ...change.set } }) };
    this.#changes = merged ? [...before.slice(0, -1), merged] : [...before, change];
    if (this.#changes.length <= 4 * longestRecord) return;
    this.#changes = this.#changes.slice(-2 * longestRecord);
    this.#isWhole = false;
  }

  /** @param {number} time */
  #advanceTo(time) {
    while (this.time < time - 1e-12) this.#simulator.advance(Math.min(stretch, time - this.time));
  }
}

/**
 * How to begin a run and come to a place of it.
 * @param {Place} place
 * @returns {Recipe}
 */
export function recipeOf({ object, start, changes, isWhole, time, state, parameters }) {
  const until = livedOf({ changes, time, state, parameters }).map(({ gesture: _, since: __, ...change }) => change);
  const { initial } = start;
  if (isWhole && until.length <= longestRecord && time <= longestTime) return { object, parameters: { ...start.parameters }, initial, changes: until, time };
  return { object, parameters: { ...parameters }, initial, changes: [{ time: 0, state }], time: 0 };
}

/**
 * What has been done by the time of a place. Of a gesture that goes on beyond it there is the part that had been made: what
 * was in force then.
 * @param {Pick<Place, 'changes' | 'time' | 'state' | 'parameters'>} place
 * @returns {readonly Done[]}
 */
function livedOf({ changes, time, state, parameters }) {
  const then = (/** @type {Record<string, number>} */ values, /** @type {Readonly<Record<string, number>>} */ inForce) =>
    Object.fromEntries(Object.keys(values).map((name) => [name, inForce[name]]));
  return changes.filter(({ since }) => since <= time).map((change) => (change.time <= time ? change : {
    ...change, time, ...(change.set && { set: then(change.set, parameters) }), ...(change.state && { state: then(change.state, state) }),
  }));
}

/**
 * When the records of two places of one run part; never where they are the same. What one of them has forgotten was common.
 * @param {Place} one @param {Place} other
 */
function partingOf(one, other) {
  const known = Math.max(...[one, other].map(({ isWhole, changes }) => (isWhole ? -Infinity : changes[0].time)));
  const alone = [...one.changes, ...other.changes].filter((change) => !one.changes.includes(change) || !other.changes.includes(change));
  return alone.reduce((first, { time }) => (time >= known ? Math.min(first, time) : first), Infinity);
}
