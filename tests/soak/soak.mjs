// Plays many hostile cases against the module in www/pkg/ and tells of the first that it does not stand.

import { Worker } from 'node:worker_threads';

/** No case takes a second; one that takes so many milliseconds never ends. */
const PATIENCE = 20_000;

/** The module's memory holds the largest case in hand; in the second half nothing larger comes. */
const GROWTH = 4 * 1024 * 1024;

/**
 * Plays the cases `from` to `to` of a seed. Rejects with the first defect, which says how to bring it back.
 * @param {number} seed
 * @param {number} from
 * @param {number} to
 * @param {(index: number) => void} [tell] called every second with the case in play
 * @returns {Promise<{ bytesAtHalf: number, bytesAtEnd: number }>}
 */
export function soak(seed, from, to, tell = () => {}) {
  const progress = new SharedArrayBuffer(4);
  const playing = new Int32Array(progress);
  const worker = new Worker(new URL('./worker.mjs', import.meta.url), { workerData: { seed, from, to, progress } });
  return new Promise((resolve, reject) => {
    let [last, since] = [-1, Date.now()];
    /** @param {number} index @param {string} message */
    const fail = (index, message) => reject(new Error(`case ${index} of seed ${seed}: ${message}\n(npm run soak -- --seed ${seed} --only ${index})`));
    const watch = setInterval(() => {
      const index = Atomics.load(playing, 0);
      if (index !== last) {
        [last, since] = [index, Date.now()];
        tell(index);
      } else if (Date.now() - since > PATIENCE) {
        clearInterval(watch);
        void worker.terminate();
        fail(index, 'it does not end');
      }
    }, 1000);
    worker.once('error', (error) => {
      clearInterval(watch);
      fail(Atomics.load(playing, 0), `the thread died: ${error.stack}`);
    });
    worker.once('message', ({ defect, bytesAtHalf, bytesAtEnd }) => {
      clearInterval(watch);
      const grown = bytesAtEnd - bytesAtHalf;
      if (defect) fail(defect.index, defect.message);
      else if (grown > GROWTH) fail(to, `the memory grew by ${grown} bytes in the second half, to ${bytesAtEnd}`);
      else resolve({ bytesAtHalf, bytesAtEnd });
    });
  });
}
