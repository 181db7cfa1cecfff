import { Unreadable } from './problem.js';

/** From the first bytes of a file: how its letters are written. */

/** As many are looked at. */
export const firstBytes = 65_536;

/**
 * @param {Uint8Array} bytes the first of the file
 * @returns {'utf-8' | 'utf-16le' | 'utf-16be' | 'windows-1252'} what is no UTF-8 was written before there was any
 */
export function encodingOf(bytes) {
  if (bytes.length === 0) throw new Unreadable('empty');
  const [a, b, c, d] = bytes;
  if (a === 0xff && b === 0xfe) return 'utf-16le';
  if (a === 0xfe && b === 0xff) return 'utf-16be';
  // A zip is what XLSX and ODS files are, D0 CF 11 E0 an old XLS.
  if ((a === 0x50 && b === 0x4b && c === 3 && d === 4) || (a === 0xd0 && b === 0xcf && c === 0x11 && d === 0xe0)) throw new Unreadable('spreadsheet');
  if (bytes.some((one) => one < 32 && one !== 9 && one !== 10 && one !== 13 && one !== 12 && one !== 26)) throw new Unreadable('binary');
  try {
    // A letter may be cut in two at the end.
    new TextDecoder('utf-8', { fatal: true }).decode(bytes, { stream: true });
    return 'utf-8';
  } catch {
    return 'windows-1252';
  }
}
