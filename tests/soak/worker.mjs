// Plays the cases in a thread of its own, so that one that never ends can be seen and ended from outside.

import { readFile } from 'node:fs/promises';
import { parentPort, workerData } from 'node:worker_threads';

import init, * as shimmy from '../../www/pkg/shimmy.js';

import { playCase } from './cases.mjs';

const { seed, from, to, progress } = workerData;
const playing = new Int32Array(progress);

const { memory } = await init({ module_or_path: await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)) });
const half = from + Math.floor((to - from) / 2);
let bytesAtHalf = memory.buffer.byteLength;
/** @type {{ index: number, message: string } | undefined} */
let defect;
for (let index = from; index < to && !defect; index++) {
  Atomics.store(playing, 0, index);
  if (index === half) bytesAtHalf = memory.buffer.byteLength;
  try {
    playCase(shimmy, seed, index);
  } catch (error) {
    defect = { index, message: error instanceof Error ? (error.name === 'Error' ? error.message : `${error.message}\n${error.stack}`) : String(error) };
  }
  // What was left to the garbage collector is freed between cases only.
  if (index % 100 === 0) await new Promise(setImmediate);
}
parentPort?.postMessage({ defect, bytesAtHalf, bytesAtEnd: memory.buffer.byteLength });
