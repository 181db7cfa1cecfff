/**
 * A plane in parts, and its parts put together again.
 *
 * @typedef {{ column: number, row: number, columns: number, rows: number }} Tile
 */

import { joinedEndings, placesOf } from './endings.js';

/** How many tiles a worker gets at least: those that take long would leave the others without work. */
const perWorker = 4;
/** Whole rows that are made one by one: each goes on where the cell before has ended. */
const rowwise = ['sweep'];

/**
 * @param {string} kind of the job
 * @param {any} spec with `x.count` and `y.count`
 * @param {number} workers
 * @param {{ columns?: number, rows?: number }} [size]
 * @returns {Tile[]} row by row
 */
export function tilesOf(kind, spec, workers, size = {}) {
  const { columns, rows } = countsOf(spec);
  const across = rowwise.includes(kind) ? columns : Math.max(1, Math.min(columns, size.columns ?? columns));
  const along = Math.max(1, Math.min(rows, size.rows ?? Math.ceil(rows / (perWorker * workers))));
  const tiles = [];
  for (let row = 0; row < rows; row += along)
    for (let column = 0; column < columns; column += across)
      tiles.push({ column, row, columns: Math.min(across, columns - column), rows: Math.min(along, rows - row) });
  return tiles;
}

/** Cells across and along; a sweep over one parameter is a row. @param {any} spec */
function countsOf(spec) {
  const { x, y } = spec.over ?? spec;
  return { columns: Number(x?.count ?? spec.over?.count ?? 1), rows: Number(y?.count ?? 1) };
}

/** What is the same of every tile, and what is counted. */
const shared = ['value', 'kinds', 'apart'];
const counted = ['followed'];

/** The result of a plane, from those of its tiles. */
export class Assembly {
  #counts;
  /** @type {any} */ #result = null;
  #made = 0;

  /** @param {any} spec */
  constructor(spec) {
    this.#counts = countsOf(spec);
  }

  /** What there is of it. */
  get result() {
    if (this.#result?.endings) this.#result.ending = placesOf(this.#result);
    return this.#result;
  }

  /** @param {Tile} tile @param {any} part */
  put(tile, part) {
    this.#result = this.#joined(this.#result, part, tile, '');
    this.#made += tile.columns * tile.rows;
  }

  /** @param {any} whole @param {any} part @param {Tile} tile @param {string} name @returns {any} */
  #joined(whole, part, tile, name) {
    const { columns, rows } = this.#counts;
    const cells = tile.columns * tile.rows;
    if (shared.includes(name)) return part;
    if (name === 'endings') return joinedEndings([...(whole ?? []), ...part], this.#result.apart);
    if (isSeries(part) && part.length === cells) {
      whole ??= new /** @type {any} */ (part.constructor)(columns * rows);
      for (let row = 0; row < tile.rows; row++) {
        whole.set(part.subarray(row * tile.columns, (row + 1) * tile.columns), (tile.row + row) * columns + tile.column);
      }
      return whole;
    }
    if (counted.includes(name)) return (whole ?? 0) + part;
    // A share of the whole is the mean of those of its parts.
    if (typeof part === 'number') return ((whole ?? 0) * this.#made + part * cells) / (this.#made + cells);
    if (!part || typeof part !== 'object' || Array.isArray(part) || isSeries(part)) return part;
    whole ??= {};
    if (!name) this.#result = whole;
    for (const [key, value] of Object.entries(part)) whole[key] = this.#joined(whole[key], value, tile, key);
    return whole;
  }
}

/** @param {unknown} value @returns {value is Float64Array | Uint8Array} */
const isSeries = (value) => value instanceof Float64Array || value instanceof Uint8Array;
