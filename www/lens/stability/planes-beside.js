/**
 * The maps of planes side by side, computed one after another in slices, so that no frame waits for them. While values
 * change the planes of before stay, and are told to be old.
 *
 * @typedef {import('../../run/linear-looks.js').LinearLooks} LinearLooks
 * @typedef {import('../../run/linear-looks.js').BoundaryCurve} BoundaryCurve
 * @typedef {import('./beside-settings.js').Beside} Beside
 * @typedef {{ columns: number, rows: number, stable: Uint8Array }} StableMap
 * @typedef {{
 *   values: Record<string, number>, map: StableMap | null, share: number | null, boundary: readonly BoundaryCurve[], isOld: boolean,
 * }} Item `values`: what sets it apart; `share`: of the plane that is stable, in per cent, null where it cannot be computed
 */

import { planesOf, writeBeside } from './beside-settings.js';

const cells = { columns: 120, rows: 90 };

export class PlanesBeside {
  /** @type {readonly Item[]} */ items = [];
  /** What the items are of. */ #key = '';
  #shape = '';
  /** @type {{ linear: LinearLooks, beside: Beside, next: number } | null} */ #work = null;

  /**
   * Begins anew where anything has changed.
   * @param {{ object: string, parameters: Readonly<Record<string, number>>, linear: LinearLooks }} gear
   * @param {Beside} beside
   */
  look({ object, parameters, linear }, beside) {
    const varied = [beside.x, beside.y, ...beside.lists].map(({ parameter }) => parameter);
    const others = Object.entries(parameters).filter(([name]) => !varied.includes(name));
    const shape = writeBeside(beside);
    const key = JSON.stringify([object, shape, others]);
    if (key === this.#key) return;
    const isSameShape = shape === this.#shape;
    this.#key = key;
    this.#shape = shape;
    this.items = planesOf(beside).map((values, i) => (isSameShape && this.items[i] ? { ...this.items[i], isOld: true } : { values, map: null, share: null, boundary: [], isOld: true }));
    this.#work = { linear, beside, next: 0 };
  }

  get isDone() {
    return this.#work === null;
  }

  /**
   * Goes on for some time: one plane at least.
   * @param {number} milliseconds
   * @param {() => number} now in ms
   */
  advance(milliseconds, now = () => performance.now()) {
    const end = now() + milliseconds;
    const items = [...this.items];
    do {
      if (!this.#work) break;
      const { linear, beside, next } = this.#work;
      items[next] = itemOf(linear, beside, items[next].values);
      this.#work = next + 1 < items.length ? { linear, beside, next: next + 1 } : null;
    } while (now() < end);
    this.items = items;
  }
}

/** @param {LinearLooks} linear @param {Beside} beside @param {Record<string, number>} values @returns {Item} */
function itemOf(linear, { x, y }, values) {
  try {
    const { stable, stableArea } = linear.map({ ...x, count: cells.columns }, { ...y, count: cells.rows }, ['stable'], values);
    return { values, map: { ...cells, stable }, share: stableArea, boundary: linear.boundary(x, y, values), isOld: false };
  } catch {
    return { values, map: null, share: null, boundary: [], isOld: false };
  }
}
