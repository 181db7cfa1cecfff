/**
 * Workers that share jobs: each works on one at a time, and takes the next when it is done.
 *
 * @typedef {import('./slices.js').Told} Told
 * @typedef {import('./slices.js').Refusal} Refusal
 * @typedef {{ addEventListener: (type: 'message' | 'error', hear: (event: any) => void) => void, postMessage: (message: any) => void,
 *   terminate: () => void }} Hand a worker, or what a test puts in its place
 * @typedef {object} Options
 * @property {(fraction: number) => void} [onProgress] how much is done, 0 … 1
 * @property {(part: any) => void} [onPart] what is there on the way, ten times a second
 * @property {AbortSignal} [signal] ends the job
 * @typedef {{ id: number, kind: string, spec: object, options: Options, resolve: (result: any) => void, reject: (error: unknown) => void }} Task
 */

export class Pool {
  #start;
  #most;
  #ids = 0;
  /** @type {Task[]} */ #waiting = [];
  /** What each worker is at. @type {Map<Hand, Task | null>} */ #hands = new Map();
  /** How many workers are about to be there. */ #starting = 0;

  /**
   * @param {() => Promise<Hand>} start a worker that has its module
   * @param {number} most how many workers there may be
   */
  constructor(start, most) {
    this.#start = start;
    this.#most = Math.max(1, most);
  }

  /** How many workers there may be. */
  get size() {
    return this.#most;
  }

  /**
   * Runs a job to its end. Where it cannot, the promise is rejected with what the engine says, or the signal's reason.
   * @param {string} kind
   * @param {object} spec
   * @param {Options} [options]
   * @returns {Promise<any>} its result
   */
  run(kind, spec, options = {}) {
    const { signal } = options;
    return new Promise((resolve, reject) => {
      if (signal?.aborted) {
        reject(signal.reason);
        return;
      }
      /** @type {Task} */
      const task = { id: this.#ids++, kind, spec, options, resolve, reject };
      const abort = () => this.#cancel(task);
      const over = (/** @type {(value: any) => void} */ tell) => (/** @type {any} */ value) => {
        signal?.removeEventListener('abort', abort);
        tell(value);
      };
      Object.assign(task, { resolve: over(resolve), reject: over(reject) });
      signal?.addEventListener('abort', abort);
      this.#waiting.push(task);
      this.#assign();
    });
  }

  /** Ends all workers; jobs that were not done are rejected. */
  close() {
    const left = [...this.#waiting, ...this.#hands.values()];
    for (const hand of this.#hands.keys()) hand.terminate();
    this.#hands.clear();
    this.#waiting = [];
    for (const task of left) task?.reject(new Error('the workers were closed'));
  }

  /** Gives out what waits, to workers that have nothing to do or to new ones. */
  #assign() {
    for (const [hand, at] of this.#hands) {
      if (at) continue;
      const task = this.#waiting.shift();
      if (!task) return;
      this.#give(hand, task);
    }
    while (this.#starting < this.#waiting.length && this.#hands.size + this.#starting < this.#most) {
      this.#starting++;
      this.#hire().finally(() => this.#starting--).then(() => this.#assign(), (error) => this.#giveUp(error));
    }
  }

  async #hire() {
    const hand = await this.#start();
    hand.addEventListener('message', ({ data }) => this.#hear(hand, data));
    // A script that does not load says so here; an instance that dies tells it by a message.
    hand.addEventListener('error', ({ message }) => this.#lose(hand, new Error(`a worker failed: ${message ?? 'its script did not load'}`)));
    this.#hands.set(hand, null);
  }

  /** No worker can be had. @param {unknown} error */
  #giveUp(error) {
    if (this.#hands.size > 0) return; // the others go on
    for (const task of this.#waiting.splice(0)) task.reject(error);
  }

  /** @param {Hand} hand @param {Task} task */
  #give(hand, task) {
    const { id, kind, spec, options } = task;
    try {
      hand.postMessage({ id, kind, spec, parts: Boolean(options.onPart) });
      this.#hands.set(hand, task);
    } catch (error) {
      task.reject(error); // a spec that cannot be sent
      this.#assign();
    }
  }

  /** @param {Hand} hand @param {Told} told */
  #hear(hand, told) {
    const task = this.#hands.get(hand);
    if (task?.id !== told.id) return;
    const { onProgress, onPart, signal } = task.options;
    if ('fraction' in told) {
      if (signal?.aborted) return;
      onProgress?.(told.fraction);
      if (told.part !== undefined) onPart?.(told.part);
      return;
    }
    if ('trap' in told) {
      this.#lose(hand, new Error(`the engine stopped: ${told.trap}`));
      return;
    }
    this.#hands.set(hand, null);
    if ('result' in told) task.resolve(told.result);
    if ('refusal' in told) task.reject(Object.assign(new Error(told.refusal.message), told.refusal));
    this.#assign();
  }

  /** A worker is gone; another takes its place when there is work. @param {Hand} hand @param {Error} error */
  #lose(hand, error) {
    if (!this.#hands.has(hand)) return;
    const task = this.#hands.get(hand);
    this.#hands.delete(hand);
    hand.terminate();
    task?.reject(error);
    this.#assign();
  }

  /** @param {Task} task */
  #cancel(task) {
    task.reject(task.options.signal?.reason);
    const place = this.#waiting.indexOf(task);
    if (place >= 0) this.#waiting.splice(place, 1);
    // The worker has other work once it says that it has stopped.
    for (const [hand, at] of this.#hands) if (at === task) hand.postMessage({ cancel: task.id });
  }
}
