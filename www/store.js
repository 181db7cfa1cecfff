/**
 * The one state of the page. Every change goes through `update`; views read `state` and subscribe.
 *
 * Undo walks what describes the experiment (object, parameters, run), not how it is looked at. All changes of one
 * gesture (a drag, a series of arrow keys) are one step of undo.
 *
 * @typedef {{
 *   object: string,
 *   parameters: Record<string, number>,
 *   run: { initial: Record<string, number> },
 *   clock: { slow: number | null },
 *   lens: string,
 *   language: import('./words/number.js').Language,
 *   theme: 'system' | 'light' | 'dark',
 * }} State `clock.slow`: how many times slower than life, null where the page chooses
 *
 * @typedef {Pick<State, 'object' | 'parameters' | 'run'>} Experiment
 */

const longestMemory = 200;

export class Store {
  /** @type {Experiment[]} */ #past = [];
  /** @type {Experiment[]} */ #future = [];
  /** @type {string | null} */ #gesture = null;
  /** @type {Set<(state: State, before: State) => void>} */ #listeners = new Set();

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
   */
  update(change, gesture = null) {
    const before = this.state;
    const after = { ...before, ...change };
    if (!isSameExperiment(before, after)) {
      if (gesture === null || gesture !== this.#gesture) this.#remember(before);
      this.#gesture = gesture;
    }
    this.#become(after);
  }

  /**
   * Changes the state without a step of undo: for what the run itself brings back, as when its time is moved.
   * @param {Partial<State>} change
   */
  follow(change) {
    this.#become({ ...this.state, ...change });
  }

  /** Ends the gesture: the next change is a step of undo of its own. */
  settle() {
    this.#gesture = null;
  }

  undo() {
    this.#walk(this.#past, this.#future);
  }

  redo() {
    this.#walk(this.#future, this.#past);
  }

  /**
   * Calls `listener` with the state and the one before it, after each change.
   * @param {(state: State, before: State) => void} listener
   * @returns {() => void} ends the subscription
   */
  subscribe(listener) {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** @param {State} before */
  #remember(before) {
    this.#past.push(experimentOf(before));
    if (this.#past.length > longestMemory) this.#past.shift();
    this.#future.length = 0;
  }

  /** @param {Experiment[]} from @param {Experiment[]} to */
  #walk(from, to) {
    const experiment = from.pop();
    if (!experiment) return;
    to.push(experimentOf(this.state));
    this.settle();
    this.#become({ ...this.state, ...experiment });
  }

  /** @param {State} after */
  #become(after) {
    const before = this.state;
    this.state = after;
    for (const listener of this.#listeners) listener(after, before);
  }
}

/** @param {Experiment} state @returns {Experiment} */
function experimentOf({ object, parameters, run }) {
  return { object, parameters, run };
}

/** @param {Experiment} one @param {Experiment} other */
function isSameExperiment(one, other) {
  return one.object === other.object && isSameRecord(one.parameters, other.parameters)
    && isSameRecord(one.run.initial, other.run.initial);
}

/** @param {Record<string, number>} one @param {Record<string, number>} other */
function isSameRecord(one, other) {
  const names = new Set([...Object.keys(one), ...Object.keys(other)]);
  return [...names].every((name) => one[name] === other[name]);
}
