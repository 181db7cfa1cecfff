import { encodingOf, firstBytes } from './bytes.js';
import { Unreadable } from './problem.js';
import { TableReader } from './table.js';

/** A file from the disk as a table, piece by piece, so that the page goes on meanwhile. */

/** Larger files are refused before they are read, in bytes. */
export const largestFile = 100e6;
/** What is read from the disk at once, and what of that is taken apart at once, in bytes. */
const piece = 4_194_304;
const morsel = 65_536;
/** So long the page is kept waiting, in ms. */
const slice = 8;

/**
 * @param {Blob} file
 * @param {object} [options]
 * @param {(fraction: number) => void} [options.onProgress]
 * @param {AbortSignal} [options.signal]
 * @param {() => Promise<void>} [options.pause] lets others have their turn
 * @param {() => number} [options.now] in ms
 * @returns {Promise<import('./table.js').Table>} rejected with an `Unreadable`, or with the signal's reason
 */
export async function readRecordFile(file, { onProgress, signal, pause = turn, now = () => performance.now() } = {}) {
  if (file.size > largestFile) throw new Unreadable('tooLarge', { megabytes: Math.round(file.size / 1e6), most: largestFile / 1e6 });
  const bytesOf = async (/** @type {number} */ from, /** @type {number} */ to) => new Uint8Array(await file.slice(from, to).arrayBuffer());
  const encoding = encodingOf(await bytesOf(0, firstBytes));
  const decoder = new TextDecoder(encoding);
  const reader = new TableReader(encoding.startsWith('utf-16') ? file.size / 2 : file.size);
  let begun = now();
  for (let at = 0; at < file.size; at += piece) {
    const bytes = await bytesOf(at, at + piece);
    for (let from = 0; from < bytes.length; from += morsel) {
      reader.feed(decoder.decode(bytes.subarray(from, from + morsel), { stream: true }));
      if (now() - begun < slice) continue;
      onProgress?.((at + from) / file.size);
      await pause();
      signal?.throwIfAborted();
      begun = now();
    }
  }
  reader.feed(decoder.decode());
  return reader.end();
}

/** A message to oneself lets events and frames through, and does not wait as a timer would. */
function turn() {
  return /** @type {Promise<void>} */ (new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  }));
}
