import { headerOf } from './table-csv.js';

/**
 * Series as CSV (RFC 4180): one header row with units, SI, "." as the decimal sign, every number so that it reads back
 * to the last bit. No comment lines: spreadsheets would show them as data, and pandas and NumPy would trip over them.
 *
 * `columns.time` comes first, then the states in the order of the model's table.
 * @param {{ time: ArrayLike<number> }} columns with one for each state, under its name
 * @param {{ state: { name: string, unit: string }[] }} table
 */
export function csvOf(columns, { state }) {
  const series = /** @type {Record<string, ArrayLike<number>>} */ (columns);
  const named = [{ name: 'time', unit: 's' }, ...state];
  const rows = [headerOf(named)];
  for (let i = 0; i < series.time.length; i++) rows.push(named.map(({ name }) => series[name][i]).join(','));
  return `${rows.join('\r\n')}\r\n`;
}
