import { html } from 'lit';
import { tell } from '../../command.js';

/**
 * A table of numbers that is sorted by a press on what heads a column: upward, downward, and as it was.
 *
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

/**
 * @template Row
 * @typedef {{ name: string, title: unknown, value: (row: Row) => number | null, show: (row: Row) => unknown, isWord?: boolean, isSpare?: boolean }} Column
 *   `value`: by which it is sorted, what is not known last; `isWord`: no figure, so it stands to the left; `isSpare`: not
 *   shown where letters are large
 */

/**
 * Rows in the order that a setting names (`share,down`); as they are where it names none.
 * @template Row
 * @param {readonly Row[]} rows
 * @param {readonly Column<Row>[]} columns
 * @param {string} sorting
 * @returns {readonly Row[]}
 */
export function sorted(rows, columns, sorting) {
  const { column, sign } = sortingOf(columns, sorting);
  if (!column) return rows;
  return [...rows].sort((one, other) => {
    const [a, b] = [column.value(one), column.value(other)];
    return a === null || b === null ? Number(a === null) - Number(b === null) : sign * (a - b);
  });
}

/**
 * @template Row
 * @param {HTMLElement} host that tells the command `view` with how it is sorted
 * @param {{ caption: string, columns: readonly Column<Row>[], rows: readonly Row[], of: string, sorting: string, classOf?: (row: Row) => string }} table
 *   `of`: the setting; `sorting`: its text
 * @param {Voice} voice
 */
export function figuresTable(host, { caption, columns, rows, of, sorting, classOf = () => '' }, voice) {
  const { column: chosen, sign } = sortingOf(columns, sorting);
  const classOfCell = (/** @type {Column<Row>} */ { isWord, isSpare }) => `${isWord ? '' : 'figure'} ${isSpare ? 'spare' : ''}`;
  const head = (/** @type {Column<Row>} */ column) => {
    const { name, title } = column;
    const isChosen = chosen?.name === name;
    const next = !isChosen ? `${name},up` : sign > 0 ? `${name},down` : 'none';
    return html`
      <th scope="col" class=${classOfCell(column)} aria-sort=${isChosen ? (sign > 0 ? 'ascending' : 'descending') : 'none'}>
        <button type="button" class="plain" title=${voice.say('table.sort')} @click=${() => tell(host, 'view', { of, shows: next })}>${title}<span class="sort" aria-hidden="true">${isChosen ? (sign > 0 ? '▴' : '▾') : ''}</span></button>
      </th>`;
  };
  return html`
    <div class="figures-table" role="region" tabindex="0" aria-label=${caption}>
      <table>
        <thead><tr>${columns.map(head)}</tr></thead>
        <tbody>${sorted(rows, columns, sorting).map((row) => html`
          <tr class=${classOf(row)}>${columns.map((column, i) => (i === 0
            ? html`<th scope="row" class=${classOfCell(column)}>${column.show(row)}</th>` : html`<td class=${classOfCell(column)}>${column.show(row)}</td>`))}</tr>`)}</tbody>
      </table>
    </div>`;
}

/** @template Row @param {readonly Column<Row>[]} columns @param {string} sorting */
function sortingOf(columns, sorting) {
  const [name, way] = sorting.split(',');
  return { column: columns.find((one) => one.name === name), sign: way === 'down' ? -1 : 1 };
}
