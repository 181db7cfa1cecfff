import { Unreadable } from './problem.js';

/** A line of a table, cell by cell. */

export const separators = /** @type {const} */ ([';', '\t', ',']);
/** @typedef {typeof separators[number]} Separator */

/**
 * What stands between the cells of a heading. A semicolon or a tab does wherever there is one: a comma may be part of a name.
 * @param {string} line
 * @returns {Separator | null}
 */
export function separatorOf(line) {
  const bare = line.replaceAll(/"[^"]*"/g, '');
  return separators.find((one) => bare.includes(one)) ?? null;
}

/**
 * @param {string} line
 * @param {string} separator
 * @param {number} number of the line, for whom it concerns
 * @returns {string[]} without the quotes around them
 */
export function cellsOf(line, separator, number) {
  if (!line.includes('"')) return line.split(separator);
  const cells = [];
  let at = 0;
  while (at <= line.length) {
    const [cell, end] = line[at] === '"' ? quoted(line, at, number) : [line.slice(at, endOf(line, separator, at)), endOf(line, separator, at)];
    cells.push(cell);
    if (end < line.length && line[end] !== separator) throw new Unreadable('quote', { line: number });
    at = end + 1;
  }
  return cells;
}

/** @param {string} line @param {string} separator @param {number} from */
function endOf(line, separator, from) {
  const end = line.indexOf(separator, from);
  return end < 0 ? line.length : end;
}

/** What is between two quotes, of which a doubled one is a letter. @param {string} line @param {number} from @param {number} number @returns {[string, number]} */
function quoted(line, from, number) {
  let cell = '';
  for (let at = from + 1; at < line.length; at++) {
    if (line[at] !== '"') cell += line[at];
    else if (line[at + 1] === '"') {
      cell += '"';
      at++;
    } else return [cell, at + 1];
  }
  throw new Unreadable('quote', { line: number });
}

/**
 * A number as an instrument writes it; NaN for all else, and for what is not finite.
 * @param {string} text
 * @param {boolean} hasComma whether a comma is the decimal sign
 */
export function numeral(text, hasComma) {
  if (hasComma) return text.includes('.') ? NaN : decimal(text.replace(',', '.'));
  return decimal(text);
}

/** There are millions of them: what need not be looked at is not. @param {string} text */
function decimal(text) {
  const number = Number(text);
  if (Number.isNaN(number) && text.includes('\u2212')) return decimal(text.replace('\u2212', '-'));
  if (number === 0 && text.trim() === '') return NaN;
  // 0x1F is a number to JavaScript alone.
  return Number.isFinite(number) && !isOfCode(text) ? number : NaN;
}

/** @param {string} text */
function isOfCode(text) {
  if (!text.startsWith('0') && !text.startsWith(' ')) return false;
  return /^\s*0[xob]/i.test(text);
}
