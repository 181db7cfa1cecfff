/**
 * Answers row by row, computed in slices once the gear has stood still for a moment, so that no frame waits for them. While
 * values change the answers of before stay, and are told to be old.
 */

/** So long the gear stands still before anything is computed anew, in ms. */
export const patience = 100;

/**
 * @template Spec, Answer
 */
export class Rows {
  /** @type {readonly { spec: Spec, answer: Answer | null, isOld: boolean }[]} */ items = [];
  #key = '';
  #shape = '';
  /** @type {{ ask: (spec: Spec, before: Answer | null) => Answer | null, next: number, from: number } | null} */ #work = null;

  /**
   * Begins anew where anything has changed.
   * @param {{ key: string, shape: string, specs: readonly Spec[] }} wanted `key`: all that the answers depend on; `shape`: what
   *   the rows are, whatever the gear
   * @param {(spec: Spec, before: Answer | null) => Answer | null} ask also gets the answer of the row before
   * @param {number} now in ms
   */
  look({ key, shape, specs }, ask, now) {
    if (key === this.#key) return;
    const isSameShape = shape === this.#shape;
    // What is seen for the first time need not wait.
    const from = isSameShape && this.items.length > 0 ? now + patience : now;
    this.#key = key;
    this.#shape = shape;
    this.items = specs.map((spec, i) => ({ spec, answer: isSameShape ? this.items[i]?.answer ?? null : null, isOld: true }));
    this.#work = { ask, next: 0, from };
  }

  get isDone() {
    return this.#work === null;
  }

  /**
   * Goes on for some time: one row at least, once it has waited.
   * @param {number} milliseconds
   * @param {() => number} [now] in ms
   * @returns {boolean} whether there is anything new
   */
  advance(milliseconds, now = () => performance.now()) {
    const work = this.#work;
    if (!work || now() < work.from) return false;
    const end = now() + milliseconds;
    const items = [...this.items];
    do {
      const { spec } = items[work.next];
      const before = work.next > 0 ? items[work.next - 1].answer : null;
      items[work.next++] = { spec, answer: answered(() => work.ask(spec, before)), isOld: false };
    } while (work.next < items.length && now() < end);
    if (work.next >= items.length) this.#work = null;
    this.items = items;
    return true;
  }
}

/** Where values are so wild that no number comes of them there is none. @template Answer @param {() => Answer | null} ask */
function answered(ask) {
  try {
    return ask();
  } catch {
    return null;
  }
}
