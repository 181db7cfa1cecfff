/**
 * A plane in parts, and its parts put together again.
 *
 * @typedef {{ column: number, row: number, columns: number, rows: number }} Tile
 */

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

/** @param {any} spec */
const countsOf = (spec) => ({ columns: Number(spec.x?.count ?? 1), rows: Number(spec.y?.count ?? 1) });

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
    return this.#result;
  }

  /** @param {Tile} tile @param {any} part */
  put(tile, part) {
    const cells = tile.columns * tile.rows;
    this.#result ??= {};
    for (const [key, value] of Object.entries(part)) this.#result[key] = this.#joined(this.#result[key], value, tile);
    this.#made += cells;
  }

  /** @param {any} whole @param {any} part @param {Tile} tile @returns {any} */
  #joined(whole, part, tile) {
    const { columns, rows } = this.#counts;
    const cells = tile.columns * tile.rows;
    if (isSeries(part) && part.length === cells) {
      whole ??= new /** @type {any} */ (part.constructor)(columns * rows);
      for (let row = 0; row < tile.rows; row++) {
        whole.set(part.subarray(row * tile.columns, (row + 1) * tile.columns), (tile.row + row) * columns + tile.column);
      }
      return whole;
    }
    // A share of the whole is the mean of those of its parts.
    if (typeof part === 'number') return ((whole ?? 0) * this.#made + part * cells) / (this.#made + cells);
    if (part && typeof part === 'object' && !Array.isArray(part) && !isSeries(part)) {
      whole ??= {};
      for (const [key, value] of Object.entries(part)) whole[key] = this.#joined(whole[key], value, tile);
      return whole;
    }
    return part;
  }
}

/** @param {unknown} value @returns {value is Float64Array | Uint8Array} */
const isSeries = (value) => value instanceof Float64Array || value instanceof Uint8Array;
