/**
 * Something that is computed beside the page for a gear, and anew when the gear has changed. One thing is worked on at a time.
 * Quick work is done before the next begins, so that its result follows a slider; slow work is given up as soon as something else
 * is wanted, and begun once the gear stands still. Until there is a new result the old one stays, and is told to be old.
 */

/** So long the gear stands still before slow work is begun anew, in ms. */
const patience = 200;
/** How often it is told how much is done, in all. */
const told = 50;

/**
 * @template Spec, Result
 */
export class BesideWork {
  /** @type {Result | null} */ result = null;
  /** Whether the result is of other values than those asked for. */ isOld = false;
  /** Whether the last one could not be computed. */ isFailed = false;
  /** How much of slow work is done, 0 … 1. */ fraction = 0;
  /** Is called when there is something new. */ onChange = () => {};
  #run;
  #isSlow;
  /** @type {{ key: string, shape: string, spec: Spec } | null} */ #wanted = null;
  /** What is worked on. @type {{ key: string, shape: string, abort: AbortController } | null} */ #going = null;
  /** What the last finished work was of. */ #done = '';
  /** What the result, whole or not, is over. */ #shape = '';
  #timer = /** @type {ReturnType<typeof setTimeout> | null} */ (null);

  /**
   * @param {(spec: Spec, options: { signal: AbortSignal, onPart?: (part: Result) => void, onProgress?: (fraction: number) => void }) => Promise<Result>} run
   * @param {{ isSlow?: boolean }} [manner] slow work also shows what it has so far
   */
  constructor(run, { isSlow = false } = {}) {
    this.#run = run;
    this.#isSlow = isSlow;
  }

  /** Whether something is worked on, or about to be. */
  get isGoing() {
    return this.#going !== null || this.#timer !== null;
  }

  /** @param {{ key: string, shape: string, spec: Spec }} wanted `key`: all that it depends on; `shape`: what it is over, whatever the gear */
  look(wanted) {
    if (wanted.key === this.#wanted?.key) return;
    const isFirst = this.result === null || wanted.shape !== this.#shape;
    this.#wanted = wanted;
    this.isFailed = false;
    if (isFirst) this.result = null;
    this.isOld = wanted.key !== this.#done;
    // Of another shape nothing is worth waiting for.
    if (this.#going && (this.#isSlow || this.#going.shape !== wanted.shape)) this.#going.abort.abort();
    if (this.#timer !== null) clearTimeout(this.#timer);
    this.#timer = null;
    if (!this.#isSlow || isFirst) this.#next();
    else
      this.#timer = setTimeout(() => {
        this.#timer = null;
        this.#next();
      }, patience);
  }

  /** Gives up what is worked on: what there is of it stays, until something else is wanted. */
  cancel() {
    if (this.#timer !== null) clearTimeout(this.#timer);
    this.#timer = null;
    this.#done = this.#wanted?.key ?? '';
    this.#going?.abort.abort();
    this.onChange();
  }

  /** Nobody looks any more. */
  stop() {
    if (this.#timer !== null) clearTimeout(this.#timer);
    this.#timer = null;
    this.#wanted = null;
    this.#going?.abort.abort();
  }

  async #next() {
    const wanted = this.#wanted;
    if (!wanted || this.#going || this.#timer !== null || wanted.key === this.#done) return;
    const abort = new AbortController();
    this.#going = { key: wanted.key, shape: wanted.shape, abort };
    try {
      // While there is nothing else to see, what there is so far is seen.
      const onPart = this.result && !this.#isSlow ? undefined : (/** @type {Result} */ part) => !abort.signal.aborted && this.#put(wanted, part, !this.#isSlow);
      this.fraction = 0;
      const onProgress = (/** @type {number} */ fraction) => {
        const isNews = Math.floor(told * fraction) > Math.floor(told * this.fraction);
        this.fraction = fraction;
        if (isNews && !abort.signal.aborted) this.onChange();
      };
      const result = await this.#run(wanted.spec, { signal: abort.signal, ...(onPart && { onPart }), ...(this.#isSlow && { onProgress }) });
      if (!abort.signal.aborted) {
        this.#done = wanted.key;
        this.#put(wanted, result, this.#wanted?.key !== wanted.key);
      }
    } catch {
      // Values so wild that nothing can be computed, or a worker that died.
      if (!abort.signal.aborted) {
        this.#done = wanted.key;
        this.result = null;
        this.isFailed = this.#wanted?.key === wanted.key;
        this.onChange();
      }
    }
    this.#going = null;
    if (abort.signal.aborted) this.onChange();
    this.#next();
  }

  /** @param {{ shape: string }} wanted @param {Result} result @param {boolean} isOld */
  #put(wanted, result, isOld) {
    if (wanted.shape !== this.#wanted?.shape) return;
    this.#shape = wanted.shape;
    this.result = result;
    this.isOld = isOld;
    this.onChange();
  }
}
