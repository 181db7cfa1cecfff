/**
 * The one state of the page. Every change goes through `update`; views read `state` and subscribe.
 *
 * Undo walks what describes the experiment (object, parameters, run, links, ghosts), not how it is looked at; only where
 * another experiment was opened with a look of its own, the look comes back too. All changes of one gesture (a drag, a
 * series of arrow keys) are one step of undo. What was done to the run under way comes back with its instant: undo takes
 * the run to just before it, redo to where it had come to.
 *
 * @typedef {import('./run/live-run.js').Change} Change
 * @typedef {import('./run/session.js').Place} Place
 * @typedef {import('./run/ghosts.js').Kept} Kept
 * @typedef {{
 *   object: string,
 *   parameters: Record<string, number>,
 *   run: { initial: Record<string, number>, start?: Record<string, number>, changes?: readonly Change[], time?: number },
 *   links: Readonly<Record<string, boolean>>,
 *   ghosts: readonly Kept[],
 *   clock: { mode: import('./run/clock.js').Mode, slow: number | null },
 *   lens: string,
 *   views: Readonly<Record<string, string>>,
 *   story: { name: string, step: number } | null,
 *   predict: { guess: Guess | null, outcome: import('./present/outcome.js').Outcome | null } | null,
 *   isBig: boolean,
 *   velocityUnit: import('./controls/unit.js').VelocityUnit,
 *   language: import('./words/number.js').Language,
 *   theme: 'system' | 'light' | 'dark',
 * }} State `run`: how it begins, and what was done to it up to `time`; `start`: values that were others then.
 *   `clock.slow`: how many times slower than life, null where the page chooses. `views`: what each lens (and the timeline)
 *   shows, by its name, and the `magnification` where a hand chose it. `predict`: what would tell the future is veiled until
 *   there is an `outcome`; `isBig`: for the last row
 *
 * @typedef {'dies-out' | 'holds' | 'grows'} Guess
 *
 * @typedef {Pick<State, 'object' | 'parameters' | 'run' | 'links' | 'ghosts' | 'story'>} Experiment
 * @typedef {Pick<State, 'clock' | 'lens' | 'views'>} Look
 * @typedef {Experiment & { look: Look | null, before: Place | null, after: Place | null }} Entry a step of undo; `look`: where
 *   it comes back too; `before`: where the run was when it was done to it, if it was; `after`: where it was when that was undone
 */

const longestMemory = 200;

export class Store {
  /** @type {Entry[]} */ #past = [];
  /** @type {Entry[]} */ #future = [];
  /** @type {string | null} */ #gesture = null;
  /** @type {Set<(state: State, before: State, place: Place | null) => void>} */ #listeners = new Set();

  /** Where the run is: whoever runs it says so. @type {() => Place | null} */ here = () => null;

  /** @param {State} state */
  constructor(state) {
    /** @type {Readonly<State>} */ this.state = state;
  }

  get canUndo() {
    return this.#past.length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  /**
   * Changes the state. Changes that carry the same gesture, with no other between, are undone together.
   * @param {Partial<State>} change
   * @param {string | null} [gesture]
   * @param {Place | null} [place] where the run was before, if this was done to it
   */
  update(change, gesture = null, place = null) {
    const before = this.state;
    const after = { ...before, ...change };
    if (!isSameExperiment(before, after)) {
      if (gesture === null || gesture !== this.#gesture) this.#remember(before, { place });
      this.#gesture = gesture;
    }
    this.#become(after, null);
  }

  /**
   * Changes the state to another experiment with its look: a step of undo that brings back both.
   * @param {Partial<State>} change
   */
  open(change) {
    const before = this.state;
    const after = { ...before, ...change };
    if (!isSameExperiment(before, after)) this.#remember(before, { look: lookOf(before), place: this.here() });
    this.settle();
    this.#become(after, null);
  }

  /**
   * The run as far as it has come takes the place of the run as it began, here and in the steps of undo that share it:
   * for an experiment that is left and may be come back to. Nobody is told, for nothing changes.
   * @param {State['run']} run
   */
  keepRun(run) {
    const begun = this.state.run;
    for (const entry of [...this.#past, ...this.#future]) if (entry.run === begun) entry.run = run;
    this.state = { ...this.state, run };
  }

  /**
   * Changes the state without a step of undo: for what the run itself brings back, as when its time is moved.
   * @param {Partial<State>} change
   */
  follow(change) {
    this.#become({ ...this.state, ...change }, null);
  }

  /**
   * Something was done to the run that is no change of the state, and is a step of undo; all of one gesture is one.
   * @param {Place} place where it was before
   * @param {string | null} [gesture]
   */
  did(place, gesture = null) {
    if (gesture === null || gesture !== this.#gesture) this.#remember(this.state, { place });
    this.#gesture = gesture;
    this.#become({ ...this.state }, null);
  }

  /** Ends the gesture: the next change is a step of undo of its own. */
  settle() {
    this.#gesture = null;
  }

  undo() {
    this.#walk('undo', this.#past, this.#future);
  }

  redo() {
    this.#walk('redo', this.#future, this.#past);
  }

  /**
   * Calls `listener` with the state and the one before it, after each change; with the place that undo or redo goes to.
   * @param {(state: State, before: State, place: Place | null) => void} listener
   * @returns {() => void} ends the subscription
   */
  subscribe(listener) {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** @param {State} state @param {{ look?: Look | null, place: Place | null }} besides */
  #remember(state, { look = null, place: before }) {
    this.#past.push({ ...experimentOf(state), look, before, after: null });
    if (this.#past.length > longestMemory) this.#past.shift();
    this.#future.length = 0;
  }

  /** @param {'undo' | 'redo'} direction @param {Entry[]} from @param {Entry[]} to */
  #walk(direction, from, to) {
    const entry = from.pop();
    if (!entry) return;
    const { before, after, look, ...experiment } = entry;
    const isBack = direction === 'undo';
    to.push({ ...experimentOf(this.state), look: look && lookOf(this.state), before, after: isBack && before ? this.here() : after });
    this.settle();
    this.#become({ ...this.state, ...experiment, ...look }, isBack ? before : after);
  }

  /** @param {State} after @param {Place | null} place */
  #become(after, place) {
    const before = this.state;
    this.state = after;
    for (const listener of this.#listeners) listener(after, before, place);
  }
}

/** @param {State} state @returns {Experiment} */
function experimentOf({ object, parameters, run, links, ghosts, story }) {
  return { object, parameters, run, links, ghosts, story };
}

/** @param {State} state @returns {Look} */
function lookOf({ clock, lens, views }) {
  return { clock, lens, views };
}

/** @param {Experiment} one @param {Experiment} other */
export function isSameExperiment(one, other) {
  return one.object === other.object && one.ghosts === other.ghosts && isSameRecord(one.parameters, other.parameters)
    && isSameRecord(one.links, other.links) && isSameRun(one.run, other.run);
}

/** @param {State['run']} one @param {State['run']} other */
function isSameRun(one, other) {
  return one === other || (isSameRecord(one.initial, other.initial) && one.changes === other.changes && one.time === other.time);
}

/** @param {readonly unknown[]} one @param {readonly unknown[]} other */
export function isSameList(one, other) {
  return one.length === other.length && one.every((value, i) => value === other[i]);
}

/** @param {Readonly<Record<string, unknown>>} one @param {Readonly<Record<string, unknown>>} other */
export function isSameRecord(one, other) {
  const names = new Set([...Object.keys(one), ...Object.keys(other)]);
  return [...names].every((name) => one[name] === other[name]);
}
