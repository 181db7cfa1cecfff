/**
 * How widely a gear swings in the end, over a plane of two of its values: one branch of cycles over the first for each value of
 * the second, followed beside the page, coarse first. While values change the plane of before stays, and is told to be old.
 *
 * @typedef {import('../../pkg/shimmy.js').Bifurcation} Bifurcation
 * @typedef {import('../../pkg/shimmy.js').BifurcationSpec} BifurcationSpec
 * @typedef {import('../../run/linear-looks.js').Range} Range
 * @typedef {(spec: BifurcationSpec, options: { signal: AbortSignal }) => Promise<Bifurcation>} RunJob
 * @typedef {import('./two-motions.js').Spans} Spans
 * @typedef {{ values: Float64Array, columns: number, rows: number, two: readonly Spans[] }} Amplitudes row by row from the lowest, in rad, at the middle of cells; 0 where it rests.
 *   `two`: where on each row rest and a cycle are both stable
 */

import { frictionParameter } from '../../run/linear-looks.js';
import { widest } from './branches.js';
import { twoAlong } from './two-motions.js';

export const [columns, rows] = [120, 32];
/** So long the gear stands still before anything is followed anew, in ms. */
const patience = 150;
const quick = { step: 0.05, tolerance: 1e-4, points: 200, probes: 2 };

/** A row of which nothing can be computed. */
const none = { amplitudes: new Float64Array(columns), two: [] };

export class SwingPlane {
  /** What is there so far: rows not yet known are as the nearest that is. @type {Amplitudes | null} */ amplitudes = null;
  /** How much of it is known, 0 … 1. */ share = 0;
  /** Whether it is of other values than those asked for. */ isOld = false;
  /** Is called when there is something new. */ onChange = () => {};
  #run;
  #key = '';
  #shape = '';
  #abort = new AbortController();
  #timer = /** @type {ReturnType<typeof setTimeout> | null} */ (null);

  /** @param {RunJob} run */
  constructor(run) {
    this.#run = run;
  }

  /** @param {{ key: string, shape: string, gear: { model: string, parameters: Readonly<Record<string, number>> }, x: Range, y: Range }} wanted */
  look({ key, shape, gear, x, y }) {
    if (key === this.#key) return;
    this.stop();
    const isFirst = shape !== this.#shape;
    this.#key = key;
    this.#shape = shape;
    this.isOld = true;
    if (isFirst) this.amplitudes = null;
    this.share = 0;
    this.#timer = setTimeout(() => this.#begin(gear, x, y), isFirst ? 0 : patience);
  }

  /** Nobody looks any more. */
  stop() {
    if (this.#timer !== null) clearTimeout(this.#timer);
    this.#timer = null;
    this.#abort.abort();
    this.#abort = new AbortController();
    this.#key = '';
  }

  /** @param {{ model: string, parameters: Readonly<Record<string, number>> }} gear @param {Range} x @param {Range} y */
  #begin({ model, parameters }, x, y) {
    const { signal } = this.#abort;
    /** @type {({ amplitudes: Float64Array, two: Spans } | null)[]} */
    const known = Array.from({ length: rows }, () => null);
    let done = 0;
    for (const row of coarseFirst(rows)) {
      const value = y.from + ((row + 0.5) / rows) * (y.to - y.from);
      const values = { ...parameters, [y.parameter]: value };
      const spec = { model, parameters: values, parameter: x.parameter, from: x.from, to: x.to, ...quick };
      this.#run(spec, { signal }).then((diagram) => ({ amplitudes: steadyAlong(diagram, x), two: twoAlong(diagram, x, values[frictionParameter] ?? 0) }), () => none).then((followed) => {
        if (signal.aborted) return;
        known[row] = followed;
        done++;
        this.share = done / rows;
        this.isOld = false;
        this.amplitudes = { columns, rows, ...filled(known) };
        this.onChange();
      });
    }
  }
}

/**
 * The amplitude of the widest stable cycle along a parameter, at the middle of cells.
 * @param {Bifurcation} diagram
 * @param {Range} range
 */
export function steadyAlong({ parameter, cycles, points }, { from, to }) {
  const along = new Float64Array(columns);
  cycles.forEach((branch, at) => {
    const turns = new Set(points.filter((point) => point.branch === at && point.kind !== 'hopf').map(({ index }) => index));
    for (let i = 0; i + 1 < branch.amplitude.length; i++) {
      if (branch.stable[turns.has(i + 1) ? i : i + 1] !== 1) continue;
      const [one, other] = [branch[parameter][i], branch[parameter][i + 1]];
      const cells = [one, other].map((value) => ((value - from) / (to - from)) * columns - 0.5);
      for (let column = Math.max(0, Math.ceil(Math.min(...cells))); column <= Math.min(columns - 1, Math.floor(Math.max(...cells))); column++) {
        const share = cells[1] === cells[0] ? 0 : (column - cells[0]) / (cells[1] - cells[0]);
        const amplitude = branch.amplitude[i] + share * (branch.amplitude[i + 1] - branch.amplitude[i]);
        along[column] = Math.max(along[column], Math.min(amplitude, widest));
      }
    }
  });
  return along;
}

/** All places from 0, each halving what the ones before have left. @param {number} count @returns {number[]} */
export function coarseFirst(count) {
  const bits = Math.ceil(Math.log2(count));
  const reversed = (/** @type {number} */ value) => Array.from({ length: bits }, (_, bit) => ((value >> bit) & 1) << (bits - 1 - bit)).reduce((sum, bit) => sum + bit, 0);
  return Array.from({ length: 2 ** bits }, (_, i) => reversed(i)).filter((place) => place < count);
}

/** Rows that are not known are as the nearest one that is. @param {readonly ({ amplitudes: Float64Array, two: Spans } | null)[]} known */
function filled(known) {
  const values = new Float64Array(known.length * columns);
  const there = known.flatMap((row, i) => (row ? [i] : []));
  const two = known.map((_, i) => {
    const nearest = known[there.reduce((best, one) => (Math.abs(one - i) < Math.abs(best - i) ? one : best), there[0])] ?? none;
    values.set(nearest.amplitudes, i * columns);
    return nearest.two;
  });
  return { values, two };
}
