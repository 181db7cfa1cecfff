/**
 * A table as CSV, as csv.js writes series: one header row with units, SI or what the header says, "." as the decimal sign.
 * What is not known is left empty.
 *
 * @param {readonly { name: string, unit: string }[]} columns
 * @param {readonly (readonly (number | string | null)[])[]} rows
 */
export function tableCsv(columns, rows) {
  const lines = rows.map((row) => row.map((cell) => quoted(cell === null ? '' : String(cell))).join(','));
  return [headerOf(columns), ...lines].map((line) => `${line}\r\n`).join('');
}

/** Names with their units. @param {readonly { name: string, unit: string }[]} columns */
export function headerOf(columns) {
  return columns.map(({ name, unit }) => quoted(unit === '' || unit === '1' ? name : `${name} (${unit})`)).join(',');
}

/** @param {string} field */
function quoted(field) {
  return /[",\r\n]/.test(field) ? `"${field.replaceAll('"', '""')}"` : field;
}
