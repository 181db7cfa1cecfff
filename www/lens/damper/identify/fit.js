/**
 * One way to a damper's values, by one seed: generation by generation, their errors found by workers. It can be paused and gone on
 * with, and the same seed goes the same way.
 *
 * @typedef {import('../../../pkg/shimmy.js').IdentificationSpec} IdentificationSpec
 * @typedef {import('../../../pkg/shimmy.js').Generation} Generation
 * @typedef {import('../../../pkg/shimmy.js').Identified} Identified
 * @typedef {Pick<import('../../../pkg/shimmy.js').Identification, 'ask' | 'tell' | 'result' | 'free'>} Search
 * @typedef {{
 *   begin: (spec: IdentificationSpec) => Search,
 *   errors: (spec: IdentificationSpec, population: Float64Array, individuals: number, options: { signal: AbortSignal }) => Promise<Float64Array>,
 *   turn: () => Promise<void>,
 * }} Means `turn`: lets the page have its frame
 */

/** So many generations apart the best is held against the records, to be seen over them. */
const betweenFits = 5;

export class Fit {
  /** @type {'running' | 'paused' | 'done' | 'stopped' | 'failed'} */ state = 'running';
  /** Best and mean error of each generation. */ best = /** @type {number[]} */ ([]);
  mean = /** @type {number[]} */ ([]);
  /** The last generation whose errors are known, as values one after the other. @type {Float64Array} */ population = new Float64Array();
  /** @type {Float64Array} */ errors = new Float64Array();
  /** @type {Generation | null} */ last = null;
  /** What it has come to. @type {Identified | null} */ result = null;
  /** Why it cannot go on. @type {unknown} */ problem = null;
  #means;
  /** @type {Search | null} */ #search;
  #abort = new AbortController();
  #onChange;
  /** Resolved when it has ended, one way or another. @type {Promise<void>} */ ended;

  /** @param {IdentificationSpec} spec @param {Means} means @param {() => void} onChange throws what the engine refuses of the spec */
  constructor(spec, means, onChange) {
    this.spec = spec;
    this.#means = means;
    this.#onChange = onChange;
    this.#search = means.begin(spec);
    this.ended = this.#go();
  }

  get seed() {
    return this.spec.seed ?? 1;
  }

  pause() {
    if (this.state === 'running') this.#become('paused');
  }

  goOn() {
    if (this.state !== 'paused') return;
    this.#become('running');
    this.#wake();
  }

  /** Ends it: what it has found stays. */
  stop() {
    if (this.state !== 'running' && this.state !== 'paused') return;
    this.#end('stopped');
    this.#abort.abort();
    this.#wake();
  }

  #wake = () => {};

  async #go() {
    const { spec } = this;
    const { signal } = this.#abort;
    const individuals = spec.population ?? 60;
    try {
      for (;;) {
        await this.#held();
        const search = this.#search;
        if (!search) return;
        const population = search.ask();
        /** @type {Float64Array} */ const errors = population.length > 0 ? await this.#means.errors(spec, population, individuals, { signal }) : new Float64Array();
        // A generation that was under way as a hand paused it waits, or the count would go on; and it may have been ended.
        await this.#held();
        if (this.#search !== search) return;
        const told = search.tell(errors);
        this.last = told;
        if (errors.length > 0) {
          this.population = population;
          this.errors = errors;
        }
        if (this.best.length % betweenFits === 0) this.result = search.result();
        this.best.push(told.bestError ?? NaN);
        this.mean.push(told.meanError ?? NaN);
        if (told.done) {
          this.#end('done');
          return;
        }
        this.#onChange();
        await this.#means.turn();
      }
    } catch (error) {
      if (signal.aborted) return;
      this.problem = error;
      this.#end('failed');
    }
  }

  /** As long as it is paused. */
  async #held() {
    while (this.state === 'paused') await new Promise((resolve) => { this.#wake = () => resolve(undefined); });
  }

  /** @param {Fit['state']} state */
  #end(state) {
    const search = this.#search;
    this.#search = null;
    try {
      if (state !== 'failed') this.result = search?.result() ?? null;
      search?.free();
    } catch {
      // What is left of a dead instance is not touched.
    }
    this.#become(state);
  }

  /** @param {Fit['state']} state */
  #become(state) {
    this.state = state;
    this.#onChange();
  }
}
