import { readRecordFile } from '../record/read-file.js';
import { recordsOf } from '../record/records.js';
import { Unreadable } from '../record/problem.js';
import { thinned } from './thin.js';
import { Fit } from './fit.js';

/**
 * What lies on the workbench: records, what is to be fitted to them, and how that goes. It outlives the element that shows it, so
 * that one can look elsewhere meanwhile.
 *
 * @typedef {import('../../../pkg/shimmy.js').IdentificationSpec} IdentificationSpec
 * @typedef {import('../../../pkg/shimmy.js').Identifiability} Identifiability
 * @typedef {import('../../../run/damper-looks.js').DamperTable} DamperTable
 * @typedef {import('../record/records.js').Record_} Measured
 * @typedef {import('../record/headings.js').Kind} Kind
 * @typedef {{ name: string, table: import('../record/table.js').Table | null, units: Partial<Record<Kind, string>>, command: number, records: Measured[], notices: import('../record/problem.js').Notice[], problem: Unreadable | null }} Source a file, or records that were made; `command`: of a file that does not tell it
 * @typedef {import('./fit.js').Means & { identifiability: (spec: IdentificationSpec, population: Float64Array) => Promise<Identifiability> }} Means
 */

/** A fit of more samples than this in all would keep a frame waiting while it is polished. */
const mostSamples = 4000;

export class Workbench {
  /** @type {Source[]} */ sources = [];
  /** The file that is being read, and how much of it is. @type {{ name: string, fraction: number, abort: AbortController } | null} */ reading = null;
  /** Which model is fitted. */ model = 'modified-bouc-wen';
  /** Bounds that are not the table's, by name. @type {Record<string, [number, number]>} */ bounds = {};
  population = 60;
  generations = 500;
  seed = 1;
  /** How many seeds go, one after the other. */ seeds = 3;
  /** Of the seeds, in their order; the last is under way. @type {Fit[]} */ fits = [];
  /** What the records fix, once all seeds have gone. @type {Identifiability | null} */ known = null;
  /** The values that made the records, where they were made here. @type {{ model: string, parameters: Record<string, number> } | null} */ truth = null;
  /** Why nothing could begin. @type {unknown} */ problem = null;
  onChange = () => {};
  #means;

  /** @param {Means} means */
  constructor(means) {
    this.#means = means;
  }

  get records() {
    return this.sources.flatMap(({ records }) => records);
  }

  /** The one under way, or the last. */
  get fit() {
    return this.fits.at(-1) ?? null;
  }

  get isBusy() {
    return this.fit !== null && ['running', 'paused'].includes(this.fit.state);
  }

  /** The best that the seeds have found. @returns {Fit | null} */
  get bestFit() {
    const found = this.fits.filter(({ result }) => result?.error !== null && result !== null);
    return found.reduce((/** @type {Fit | null} */ best, fit) => (best && (best.result?.error ?? Infinity) <= (fit.result?.error ?? Infinity) ? best : fit), null);
  }

  /** Reads a file; another one that is being read is given up. @param {Blob & { name?: string }} file */
  async open(file) {
    this.reading?.abort.abort();
    const reading = { name: file.name ?? '', fraction: 0, abort: new AbortController() };
    this.reading = reading;
    this.onChange();
    /** @type {Source} */ const source = { name: reading.name, table: null, units: {}, command: 0, records: [], notices: [], problem: null };
    try {
      source.table = await readRecordFile(file, { signal: reading.abort.signal, onProgress: (fraction) => { reading.fraction = fraction; this.onChange(); } });
    } catch (error) {
      if (reading.abort.signal.aborted) return;
      source.problem = problemOf(error);
    }
    this.reading = null;
    this.truth = null;
    // What was made here is no measurement, and a file that could not be read makes room for the next.
    this.sources = [...this.sources.filter(({ table, problem }) => table !== null && problem === null), source];
    this.#take(source);
  }

  /** Units or the command of a file are others. @param {Source} source @param {Partial<Pick<Source, 'units' | 'command'>>} change */
  change(source, change) {
    Object.assign(source, change);
    this.#take(source);
  }

  /** @param {Source} source */
  remove(source) {
    this.sources = this.sources.filter((one) => one !== source);
    this.#forget();
  }

  /** Records that were made here take the place of all others. @param {string} name @param {Measured[]} records @param {{ model: string, parameters: Record<string, number> }} truth */
  make(name, records, truth) {
    this.sources = [{ name, table: null, units: {}, command: 0, records, notices: [], problem: null }];
    this.truth = truth;
    this.#forget();
  }

  /** @param {Source} source */
  #take(source) {
    if (source.table) {
      source.problem = null;
      try {
        Object.assign(source, recordsOf(source.table, { units: source.units, command: source.command }));
      } catch (error) {
        source.records = [];
        source.problem = problemOf(error);
      }
    }
    this.#forget();
  }

  /** Of other records nothing is known. */
  #forget() {
    this.stop();
    this.fits = [];
    this.known = null;
    this.problem = null;
    this.onChange();
  }

  /** @returns {IdentificationSpec} */
  specOf(seed = this.seed) {
    const records = thinned(this.records, mostSamples).map(({ displacement, velocity, force, command, interval }) => ({ displacement, ...(velocity && { velocity }), force, command, interval }));
    return { model: this.model, records, bounds: this.bounds, population: this.population, generations: this.generations, seed, polish: true };
  }

  /** From the first generation of the first seed. */
  async start() {
    this.stop();
    this.fits = [];
    this.known = null;
    this.problem = null;
    /** @type {Fit[]} */ const mine = this.fits;
    try {
      for (let i = 0; i < this.seeds; i++) {
        const fit = new Fit(this.specOf(this.seed + i), this.#means, () => this.onChange());
        mine.push(fit);
        this.onChange();
        await fit.ended;
        if (this.fits !== mine || fit.state === 'failed') return;
        if (fit.state === 'stopped') break;
      }
      const { spec } = mine[0];
      const found = mine.flatMap(({ result }) => (result && result.error !== null ? [Object.values(result.parameters)] : []));
      if (found.length === 0) return;
      const known = await this.#means.identifiability(spec, Float64Array.from(found.flat()));
      if (this.fits === mine) this.known = known;
    } catch (error) {
      this.problem = error;
    }
    this.onChange();
  }

  pause() {
    this.fit?.pause();
  }

  goOn() {
    this.fit?.goOn();
  }

  stop() {
    this.fit?.stop();
  }
}

/** @param {unknown} error */
function problemOf(error) {
  if (error instanceof Unreadable) return error;
  // The disk took the file away, or there is no memory for it.
  return new Unreadable('unread', { reason: error instanceof Error ? error.message : String(error) });
}
