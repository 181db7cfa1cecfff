import { cellsOf, numeral, separatorOf } from './cells.js';
import { headingOf, kinds, needed, unitOf, units } from './headings.js';
import { Unreadable } from './problem.js';

/**
 * A table of measured columns, read line by line as its text comes. The first problem ends it: a wrong number in a record
 * would be fitted as if it had been measured.
 *
 * @typedef {import('./headings.js').Kind} Kind
 * @typedef {{
 *   columns: Partial<Record<Kind, Float64Array>>, rows: number, units: Partial<Record<Kind, string>>, headings: Partial<Record<Kind, string>>,
 *   restarts: number[], notices: import('./problem.js').Notice[],
 * }} Table `columns`: as the file has them, in `units`, which are '' where none is named; `restarts`: rows at which the time
 *   begins again
 */

/** A record that begins again has come so far before, in rows. */
const leastBeforeRestart = 20;
/** More rows than this no fit has use for. */
export const mostRows = 3_000_000;
/** Beyond this a line is no row of numbers. */
const longestLine = 20_000;
const comment = /^\s*(#|%|\/\/)/;
/** How much of a strange cell is shown. */
const shown = 24;

export class TableReader {
  #rest = '';
  #line = 0;
  #separator = '';
  #hasComma = /** @type {boolean | null} */ (null);
  /** Which column each quantity is in. @type {Partial<Record<Kind, number>>} */ #places = {};
  #width = 0;
  #isUnitsRow = false;
  /** How many letters there are to come in all, to make room for rows at once. */ #letters;
  #capacity = 0;
  /** When the record under way began, and in which row. */ #start = { time: 0, row: 0 };
  /** @type {Table} */ #table = { columns: {}, rows: 0, units: {}, headings: {}, restarts: [], notices: [] };

  /** @param {number} [letters] about as many as the text has in all */
  constructor(letters = 0) {
    this.#letters = letters;
  }

  /** @param {string} text the next piece of the file */
  feed(text) {
    const whole = this.#rest + text;
    let from = 0;
    for (;;) {
      const end = whole.indexOf('\n', from);
      if (end < 0) break;
      this.#take(whole.slice(from, end));
      from = end + 1;
    }
    this.#rest = whole.slice(from);
    if (this.#rest.length > longestLine) this.#rest = this.#parted(this.#rest);
  }

  /** Lines that end as they did on machines of old; else this is no table. @param {string} rest */
  #parted(rest) {
    if (!rest.includes('\r')) throw new Unreadable('longLine', { line: this.#line + 1 });
    const lines = rest.split('\r');
    for (const line of lines.slice(0, -1)) this.#take(line);
    return lines[lines.length - 1];
  }

  /** @returns {Table} */
  end() {
    const lines = this.#rest.split('\r');
    this.#rest = '';
    for (const line of lines) this.#take(line);
    const table = this.#table;
    if (this.#width === 0) throw new Unreadable('empty');
    if (table.rows === 0) throw new Unreadable('noRows');
    for (const kind of kinds) if (table.columns[kind]) table.columns[kind] = table.columns[kind].subarray(0, table.rows);
    return table;
  }

  /** @param {string} raw a line */
  #take(raw) {
    this.#line++;
    const line = raw.endsWith('\r') ? raw.slice(0, -1) : raw;
    // Most lines begin with a digit, and are what they seem.
    if (!/^\d/.test(line) && (line.trim() === '' || comment.test(line))) return;
    if (line.length > longestLine) throw new Unreadable('longLine', { line: this.#line });
    if (this.#width === 0) this.#readHeading(line);
    else this.#readRow(line);
  }

  /** @param {string} line */
  #readHeading(line) {
    const separator = separatorOf(line);
    const cells = cellsOf(line, separator ?? '\n', this.#line).map((cell) => cell.trim());
    if (cells.every((cell) => cell === '' || !Number.isNaN(numeral(cell, cell.includes(','))))) throw new Unreadable('noHeader', { line: this.#line });
    if (!separator) throw new Unreadable('separator', { line: this.#line });
    const { units: named, headings, notices } = this.#table;
    const ignored = [];
    for (const [place, cell] of cells.entries()) {
      const { kind, unit, stranger } = headingOf(cell);
      if (!kind) {
        if (cell) ignored.push(cell);
        continue;
      }
      if (this.#places[kind] !== undefined) throw new Unreadable('twice', { kind, first: headings[kind] ?? '', second: cell, line: this.#line });
      if (stranger) throw new Unreadable('unit', { unit: stranger, heading: cell, allowed: Object.keys(units[kind]).join(', '), line: this.#line });
      this.#places[kind] = place;
      named[kind] = unit;
      headings[kind] = cell;
    }
    const missing = needed.filter((kind) => this.#places[kind] === undefined);
    if (missing.length > 0) throw new Unreadable('missing', { kind: missing[0], found: cells.filter(Boolean).join(', ') || '–', line: this.#line });
    this.#separator = separator;
    this.#width = cells.length;
    this.#isUnitsRow = true;
    if (ignored.length > 0) notices.push({ code: 'ignored', values: { columns: ignored.join(', ') } });
  }

  /** @param {string} line */
  #readRow(line) {
    const cells = cellsOf(line, this.#separator, this.#line);
    // Some instruments end each row with a separator.
    const isOpen = cells.length === this.#width + 1 && cells[this.#width].trim() === '';
    if (this.#isUnitsRow) {
      this.#isUnitsRow = false;
      if (this.#readUnits(cells)) return;
    }
    if (cells.length !== this.#width && !isOpen) {
      if (cells.length === 2 * this.#width && this.#separator === ',') throw new Unreadable('commas', { line: this.#line });
      throw new Unreadable('cells', { line: this.#line, found: cells.length, wanted: this.#width });
    }
    // The first row with a fraction tells how fractions are written.
    if (this.#hasComma === null && cells.some((cell) => /[.,]/.test(cell))) this.#hasComma = this.#separator !== ',' && cells.some((cell) => cell.includes(','));
    this.#add(cells);
  }

  /** A second heading of nothing but units. @param {string[]} cells */
  #readUnits(cells) {
    const { units: named } = this.#table;
    /** @type {[Kind, string][]} */ const found = [];
    for (const [kind, place] of /** @type {[Kind, number][]} */ (Object.entries(this.#places))) {
      const text = (cells[place] ?? '').trim().replace(/^[([{](.*)[)\]}]$/, '$1');
      const unit = unitOf(kind, text);
      if (unit) found.push([kind, unit]);
      else if (text !== '') return false;
    }
    for (const [kind, unit] of found) named[kind] ||= unit;
    return found.length > 0;
  }

  /** @param {string[]} cells */
  #add(cells) {
    const { columns, rows } = this.#table;
    if (rows >= mostRows) throw new Unreadable('tooManyRows', { most: mostRows });
    if (rows === this.#capacity) this.#makeRoom(cells);
    for (const kind of kinds) {
      const place = this.#places[kind];
      if (place === undefined) continue;
      const value = numeral(cells[place], Boolean(this.#hasComma));
      if (Number.isNaN(value)) throw this.#noNumber(kind, cells[place], place);
      /** @type {Float64Array} */ (columns[kind])[rows] = value;
    }
    this.#watchTime(rows);
    this.#table.rows = rows + 1;
  }

  /** @param {Kind} kind @param {string} cell @param {number} place */
  #noNumber(kind, cell, place) {
    const where = { line: this.#line, column: place + 1, kind };
    const text = cell.trim();
    if (text === '') return new Unreadable('emptyCell', where);
    if (/^[+-]?(nan|inf|infinity|n\/a|na|null|#\S+)$/i.test(text)) return new Unreadable('notMeasured', { ...where, cell: text });
    return new Unreadable('notANumber', { ...where, cell: text.length > shown ? `${text.slice(0, shown)}…` : text });
  }

  /** Time goes on; back it goes only to where another record begins. @param {number} row */
  #watchTime(row) {
    const time = /** @type {Float64Array} */ (this.#table.columns.time);
    if (row === 0) {
      this.#start = { time: time[0], row };
      return;
    }
    const [before, now] = [time[row - 1], time[row]];
    if (now > before) return;
    const { time: start, row: first } = this.#start;
    if (now === before) throw new Unreadable('timeStands', { line: this.#line, time: now });
    if (row - first < leastBeforeRestart || now > start + 0.01 * (before - start)) throw new Unreadable('timeBack', { line: this.#line, before, time: now });
    this.#table.restarts.push(row);
    this.#start = { time: now, row };
  }

  /** @param {string[]} cells of a row like the others */
  #makeRoom(cells) {
    const letters = cells.reduce((sum, cell) => sum + cell.length + 1, 0);
    const guess = Math.ceil((1.1 * this.#letters) / letters);
    this.#capacity = Math.min(mostRows, Math.max(1024, 2 * this.#capacity, this.#capacity === 0 ? guess : 0));
    for (const kind of kinds) {
      if (this.#places[kind] === undefined) continue;
      const column = new Float64Array(this.#capacity);
      const filled = this.#table.columns[kind];
      if (filled) column.set(filled);
      this.#table.columns[kind] = column;
    }
  }
}
