/**
 * The swing of the run so far, in stretches of equal length, kept so that each is asked for once.
 *
 * @typedef {{ time: number, readonly range: ArrayLike<number>,
 *   envelope: (from: number, to: number, stretches: number) => { low: Float64Array, high: Float64Array } }} Source
 */
export class PastEnvelope {
  #width = 0;
  #first = 0;
  /** @type {number[]} */ #low = [];
  /** @type {number[]} */ #high = [];

  /** Forgets everything: another run has begun. */
  clear() {
    this.#width = 0;
  }

  /**
   * Least and largest ψ from `from` to the source's present; times of the stretches' middles, then of the present.
   * @param {Source} source
   * @param {number} from in s
   * @param {number} width of a stretch, in s; a cycle or more, or single swings would show
   */
  upTo(source, from, width) {
    const first = Math.ceil(from / width - 1e-9);
    const whole = Math.max(first, Math.floor(source.time / width));
    if (width !== this.#width || first < this.#first) this.#begin(first, width);
    this.#drop(first - this.#first, whole - first);
    const known = first + this.#low.length;
    if (whole > known) this.#append(source.envelope(known * width, whole * width, whole - known));
    // The present looks back by a whole stretch, or it would seem narrow whenever a stretch begins.
    const since = Math.max(source.time - width, source.range[0]);
    const now = source.time > since ? source.envelope(since, source.time, 1) : { low: [0], high: [0] };
    return {
      time: [...this.#low.map((_, i) => (first + i + 0.5) * width), source.time],
      low: [...this.#low, now.low[0]],
      high: [...this.#high, now.high[0]],
    };
  }

  /** @param {number} first @param {number} width */
  #begin(first, width) {
    this.#first = first;
    this.#width = width;
    this.#low = [];
    this.#high = [];
  }

  /**
   * Lets go of what lies before the window and after the present.
   * @param {number} before
   * @param {number} count how many may stay
   */
  #drop(before, count) {
    for (const list of [this.#low, this.#high]) {
      list.splice(0, before);
      list.splice(count);
    }
    this.#first += before;
  }

  /** @param {{ low: Float64Array, high: Float64Array }} stretches */
  #append({ low, high }) {
    this.#low.push(...low);
    this.#high.push(...high);
  }
}
