/** Lists of numbers as people type them, whatever stands between them. */

import { parseNumber } from './number.js';

/**
 * Reads a list. A semicolon, or a comma before a space, stands between numbers; where there is neither, a space does; and
 * commas do where they can be nothing else (`0.02,0.07,0.12`).
 * @param {string} text
 * @returns {{ values: number[], stranger: string | null }} `stranger`: the first that is no number
 */
export function parseList(text) {
  const separator = /;|,\s/.test(text) ? /;|,\s/ : /\s+/;
  const parts = text.split(separator).map((part) => part.trim()).filter((part) => part !== '');
  const pieces = parts.flatMap((part) => (Number.isNaN(parseNumber(part)) && part.includes(',') ? part.split(',').filter((piece) => piece !== '') : [part]));
  const values = pieces.map(parseNumber);
  const stranger = values.findIndex(Number.isNaN);
  return { values: stranger < 0 ? values : [], stranger: stranger < 0 ? null : pieces[stranger] };
}

/** Written so that it is read back the same, in any language. @param {readonly string[]} numbers */
export const writeList = (numbers) => numbers.join('; ');
