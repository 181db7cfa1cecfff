/**
 * A run under way: the engine's simulator, and a record of what has been done to it. From the record the run can be
 * begun again elsewhere: as a ghost beside it, from an address after a reload.
 *
 * @typedef {import('../engine/engine.js').Engine} Engine
 * @typedef {{ time: number, set?: Record<string, number>, state?: Record<string, number>, kick?: number }} Change
 *   what was done at an instant: values set, a state put in its place, a blow in N m s
 * @typedef {{
 *   object: string, parameters: Record<string, number>, initial: Record<string, number>, changes: readonly Change[], time: number,
 * }} Recipe `parameters`: those of the start; `time`: how far it goes, in s
 */

/** Steps that one call may take. A gear of sensible size takes a few a millisecond; an absurd one is stopped. */
const stepsOfCall = 100_000;
/** A run is begun again in stretches of this length, each with steps of its own, in s. */
const stretch = 0.5;
/** A record longer than this is a burden to an address: such a run is begun again where it is now. */
const longestRecord = 40;
const longestTime = 60;

export class LiveRun {
  /** @type {(Change & { gesture: string | null })[]} */ #changes = [];
  /** Whether the record still goes back to the start. */ #isWhole = true;
  #start;
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

  get time() {
    return this.#simulator.time;
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
  apply({ set, state, kick }, gesture = null) {
    for (const [name, value] of Object.entries(set ?? {})) this.#simulator.set(name, value);
    for (const [name, value] of Object.entries(state ?? {})) this.#simulator.setState(name, value);
    if (kick !== undefined) this.#simulator.kick(kick);
    if (set) this.parameters = { ...this.parameters, ...set };
    this.#record({ time: this.time, gesture, ...(set && { set }), ...(state && { state }), ...(kick !== undefined && { kick }) });
  }

  /**
   * Takes the run back to an instant, to the state before a hand touched it; all after it is forgotten. What else was
   * done at that instant stays on record, so the state is written down after it.
   * @param {number} time in s
   * @param {Record<string, number>} state of then
   */
  takeBack(time, state) {
    this.seek(time);
    this.apply({ state });
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
    const { time } = this;
    const changes = this.#changes.filter((change) => change.time <= time).map(({ gesture: _, ...change }) => change);
    const { parameters, initial } = this.#start;
    if (this.#isWhole && changes.length <= longestRecord && time <= longestTime) return { object: this.object, parameters, initial, changes, time };
    return { object: this.object, parameters: this.parameters, initial, changes: [{ time: 0, state: this.stateByName }], time: 0 };
  }

  free() {
    this.#simulator.free();
  }

  /** @param {Change & { gesture: string | null }} change */
  #record(change) {
    this.#changes = this.#changes.filter(({ time }) => time <= change.time);
    const last = this.#changes.at(-1);
    const isSame = last && change.gesture !== null && last.gesture === change.gesture;
    if (isSame) this.#changes[this.#changes.length - 1] = { ...last, ...change, set: last.set && { ...last.set, ...change.set } };
    else this.#changes.push(change);
    if (this.#changes.length <= 4 * longestRecord) return;
    this.#changes = this.#changes.slice(-2 * longestRecord);
    this.#isWhole = false;
  }

  /** @param {number} time */
  #advanceTo(time) {
    while (this.time < time - 1e-12) this.#simulator.advance(Math.min(stretch, time - this.time));
  }
}
