/**
 * The branches of cycles over a parameter, computed beside the page. One diagram is worked on at a time; when it is done and
 * the gear has changed meanwhile the next one begins, so that the branch follows a slider. Until then the old one stays, and is
 * told to be old.
 *
 * @typedef {import('../../pkg/shimmy.js').Bifurcation} Bifurcation
 * @typedef {import('../../pkg/shimmy.js').BifurcationSpec} BifurcationSpec
 * @typedef {(spec: BifurcationSpec, options: { signal: AbortSignal, onPart?: (part: Bifurcation) => void }) => Promise<Bifurcation>} RunJob
 */

export class BranchWork {
  /** @type {Bifurcation | null} */ diagram = null;
  /** Whether the diagram is of other values than those asked for. */ isOld = false;
  /** Whether the last one could not be computed. */ isFailed = false;
  /** Is called when there is something new. */ onChange = () => {};
  #run;
  /** @type {{ key: string, shape: string, spec: BifurcationSpec } | null} */ #wanted = null;
  /** What is worked on. @type {{ key: string, shape: string, abort: AbortController } | null} */ #going = null;
  /** What the diagram is of. */ #done = { key: '', shape: '' };

  /** @param {RunJob} run */
  constructor(run) {
    this.#run = run;
  }

  /** @param {{ key: string, shape: string, spec: BifurcationSpec }} wanted `key`: all that it depends on; `shape`: the axes */
  look(wanted) {
    if (wanted.key === this.#wanted?.key) return;
    this.#wanted = wanted;
    this.isFailed = false;
    if (wanted.shape !== this.#done.shape) this.diagram = null;
    this.isOld = wanted.key !== this.#done.key;
    // Of other axes nothing is worth waiting for.
    if (this.#going && this.#going.shape !== wanted.shape) this.#going.abort.abort();
    this.#next();
  }

  /** Nobody looks any more. */
  stop() {
    this.#wanted = null;
    this.#going?.abort.abort();
  }

  async #next() {
    const wanted = this.#wanted;
    if (!wanted || this.#going || wanted.key === this.#done.key) return;
    const abort = new AbortController();
    this.#going = { key: wanted.key, shape: wanted.shape, abort };
    try {
      // While there is nothing to see, what there is so far is seen.
      const onPart = this.diagram ? undefined : (/** @type {Bifurcation} */ part) => !abort.signal.aborted && this.#put(wanted, part, true);
      const diagram = await this.#run(wanted.spec, { signal: abort.signal, ...(onPart && { onPart }) });
      if (!abort.signal.aborted) {
        this.#done = { key: wanted.key, shape: wanted.shape };
        this.#put(wanted, diagram, this.#wanted?.key !== wanted.key);
      }
    } catch {
      // Values so wild that nothing can be computed, or a worker that died.
      if (!abort.signal.aborted) {
        this.#done = { key: wanted.key, shape: wanted.shape };
        this.diagram = null;
        this.isFailed = this.#wanted?.key === wanted.key;
        this.onChange();
      }
    }
    this.#going = null;
    this.#next();
  }

  /** @param {{ shape: string }} wanted @param {Bifurcation} diagram @param {boolean} isOld */
  #put(wanted, diagram, isOld) {
    if (wanted.shape !== this.#wanted?.shape) return;
    this.diagram = diagram;
    this.isOld = isOld;
    this.onChange();
  }
}
