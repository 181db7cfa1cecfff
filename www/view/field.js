/**
 * A quantity on the cells of a plane, row by row from the lowest, each value at the middle of its cell. Places in it go
 * from 0 to 1 to the right and upward.
 *
 * @typedef {{ values: ArrayLike<number>, columns: number, rows: number }} Field
 */

/**
 * The value at a place, between the nearest four middles.
 * @param {Field} field
 * @param {number} across 0 … 1
 * @param {number} up 0 … 1
 */
export function valueIn({ values, columns, rows }, across, up) {
  const column = Math.min(Math.max(across * columns - 0.5, 0), columns - 1);
  const row = Math.min(Math.max(up * rows - 0.5, 0), rows - 1);
  const left = Math.min(Math.floor(column), columns - 2);
  const below = Math.min(Math.floor(row), rows - 2);
  const [right, above] = [column - left, row - below];
  const at = below * columns + left;
  const lower = values[at] + right * (values[at + 1] - values[at]);
  const upper = values[at + columns] + right * (values[at + columns + 1] - values[at + columns]);
  return lower + above * (upper - lower);
}

/**
 * The value of the cell at a place.
 * @param {Field} field
 * @param {number} across 0 … 1
 * @param {number} up 0 … 1
 */
export function cellAt({ values, columns, rows }, across, up) {
  const column = Math.min(Math.max(Math.floor(across * columns), 0), columns - 1);
  const row = Math.min(Math.max(Math.floor(up * rows), 0), rows - 1);
  return values[row * columns + column];
}
