import { html } from 'lit';
import { download } from '../../out/download.js';
import { plateOf } from '../../out/plate.js';
import { pngOf } from '../../out/png.js';
import { svgOf } from '../../out/svg.js';
import { tableCsv } from '../../out/table-csv.js';
import { tablePicture } from '../../view/table-picture.js';

/**
 * A table that can be taken along: as numbers in SI, and as a picture.
 *
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('../../style/theme.js').Theme} Theme
 */

/**
 * @template Row
 * @typedef {import('../stability/figures-table.js').Column<Row> & { head: string, text: (row: Row) => string, unit: string, csv?: (row: Row) => number | string | null }} OutColumn
 *   `head`, `text`: as plain text, for the picture; `unit`: of `value`, which is SI; `csv`: what the file has in its place
 */

/**
 * @template Row
 * @typedef {{ file: string, title: string, note: string, link: string, columns: readonly OutColumn<Row>[], rows: readonly Row[] }} Taken `file`: its name without an ending
 */

/**
 * The buttons.
 * @param {{ said: string, take: (format: 'csv' | 'png' | 'svg') => void }} host
 * @param {Voice} voice
 */
export function tableOutButtons({ said, take }, voice) {
  return html`
    ${/** @type {const} */ (['csv', 'png', 'svg']).map((format) => html`<button type="button" class="framed" @click=${() => take(format)}>${format === 'csv' ? voice.say('table.csv') : voice.say(`out.${format}`)}</button>`)}
    <span role="status">${said}</span>`;
}

/**
 * Makes the file and gives it away; tells what came of it.
 * @template Row
 * @param {'csv' | 'png' | 'svg'} format
 * @param {Taken<Row>} taken
 * @param {Theme} theme
 * @param {Voice} voice
 */
export async function takeTable(format, taken, theme, voice) {
  const name = `${taken.file}.${format}`;
  try {
    const outcome = await download(format === 'csv' ? new Blob([csvOf(taken)], { type: 'text/csv' }) : await pictureOf(format, taken, theme), name);
    return outcome === 'cancelled' ? '' : voice.say(`out.${outcome}`, { file: name });
  } catch (error) {
    return voice.say('out.failed', { reason: error instanceof Error ? error.message : String(error) });
  }
}

/** @template Row @param {Taken<Row>} taken */
export function csvOf({ columns, rows }) {
  return tableCsv(columns.map(({ name, unit }) => ({ name, unit })), rows.map((row) => columns.map(({ csv, value }) => {
    const cell = csv ? csv(row) : value(row);
    return typeof cell === 'number' && !Number.isFinite(cell) ? null : cell;
  })));
}

/** @template Row @param {'png' | 'svg'} format @param {Taken<Row>} taken @param {Theme} theme */
async function pictureOf(format, { title, note, link, columns, rows }, theme) {
  const ruler = document.createElement('canvas').getContext('2d');
  if (!ruler) throw new Error('this browser gives no canvas to draw on');
  const picture = tablePicture({ heads: columns.map(({ head, isWord }) => ({ text: head, isWord })), rows: rows.map((row) => columns.map(({ text }) => text(row))) }, theme, ruler);
  const plate = plateOf(picture, { title, values: note, link }, theme, ruler);
  return format === 'png' ? pngOf(plate) : new Blob([svgOf(plate, `${title}. ${note}`, ruler)], { type: 'image/svg+xml' });
}
