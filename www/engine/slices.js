/**
 * One job at a time, in slices of a few milliseconds: between two of them messages arrive, so that it can be cancelled.
 *
 * @typedef {{ id: number, kind: string, spec: object, parts: boolean }} Asked a job; `parts`: tell what is there on the way
 * @typedef {{ advance: (milliseconds: number) => { done: boolean, fraction: number }, result: () => any, free: () => void }} Job
 * @typedef {{ message: string, code: string, field: string, value: string, allowed: string, suggestion: string | null }} Refusal
 * @typedef {{ id: number } & ({ fraction: number, part?: any } | { result: any } | { refusal: Refusal } | { trap: string } | { cancelled: true })} Told
 *   `trap`: the instance is dead, and the worker with it
 */

/** Milliseconds that a slice takes. */
const slice = 8;
/** Milliseconds between two parts: to copy them costs time. */
const betweenParts = 100;

export class Slices {
  #begin;
  #tell;
  #now;
  /** @type {{ id: number, job: Job, parts: boolean, told: number } | null} */ #going = null;
  #channel = new MessageChannel();

  /**
   * @param {(kind: string, spec: object) => Job} begin
   * @param {(told: Told) => void} tell
   * @param {() => number} [now]
   */
  constructor(begin, tell, now = () => performance.now()) {
    this.#begin = begin;
    this.#tell = tell;
    this.#now = now;
    // A message to oneself lets others arrive first, and does not wait as a timer would.
    this.#channel.port1.onmessage = () => this.#advance();
  }

  /** @param {Asked} asked */
  work({ id, kind, spec, parts }) {
    this.#tried(id, () => {
      this.#going = { id, job: this.#begin(kind, spec), parts, told: this.#now() };
      this.#goOn();
    });
  }

  /** @param {number} id */
  cancel(id) {
    if (this.#going?.id !== id) return; // it has ended meanwhile, and that is told
    this.#end();
    this.#tell({ id, cancelled: true });
  }

  /** Nothing arrives any more. */
  close() {
    this.#channel.port1.close();
  }

  #goOn() {
    this.#channel.port2.postMessage(null);
  }

  #advance() {
    const going = this.#going;
    if (!going) return;
    const { id, job } = going;
    this.#tried(id, () => {
      const { done, fraction } = job.advance(slice);
      if (done) {
        const result = job.result();
        this.#end();
        this.#tell({ id, result });
        return;
      }
      const now = this.#now();
      if (going.parts && now - going.told >= betweenParts) {
        this.#tell({ id, fraction, part: job.result() });
        going.told = now;
      } else {
        this.#tell({ id, fraction });
      }
      this.#goOn();
    });
  }

  #end() {
    const going = this.#going;
    this.#going = null;
    going?.job.free();
  }

  /** @param {number} id @param {() => void} work */
  #tried(id, work) {
    try {
      work();
    } catch (error) {
      const refusal = refusalOf(error);
      // What is left of a dead instance is not touched.
      if (refusal) this.#end();
      this.#going = null;
      this.#tell(refusal ? { id, refusal } : { id, trap: String(error) });
    }
  }
}

/** An error's data, which a message would lose; null where the engine did not throw it in words. @param {any} error @returns {Refusal | null} */
function refusalOf(error) {
  if (!(error instanceof Error) || !('code' in error)) return null;
  const { message, code, field, value, allowed, suggestion } = /** @type {any} */ (error);
  return { message, code, field, value, allowed, suggestion };
}

/** The series of a message: they move, where all else is copied. @param {Told} told @returns {ArrayBuffer[]} */
export function transferable(told) {
  /** @type {Set<ArrayBuffer>} */
  const buffers = new Set();
  /** @param {unknown} value */
  const look = (value) => {
    if (ArrayBuffer.isView(value)) buffers.add(/** @type {ArrayBuffer} */ (value.buffer));
    else if (value && typeof value === 'object') Object.values(value).forEach(look);
  };
  look(told);
  return [...buffers];
}
