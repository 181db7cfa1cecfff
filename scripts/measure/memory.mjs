// The heap of JavaScript and the memory of the module over minutes of play, each sample after a forced collection.

import { ask, open } from './page.mjs';

/** @typedef {{ minute: number, heap: number, buffers: number, wasm: number }} Sample bytes */

/**
 * @param {import('playwright-core').Browser} browser
 * @param {string} address
 * @param {{ lens: string, minutes: number }} options
 * @returns {Promise<Sample[]>}
 */
export async function measureMemory(browser, address, { lens, minutes }) {
  const page = await open(browser, address, lens);
  const devtools = await page.context().newCDPSession(page);
  await devtools.send('HeapProfiler.enable');
  const count = 10;
  /** @type {Sample[]} */
  const samples = [];
  const start = Date.now();
  for (let i = 0; i <= count; i++) {
    const due = start + (i * minutes * 60_000) / count;
    await page.waitForTimeout(Math.max(0, due - Date.now()));
    // What the probe gathers is no memory of the page's.
    await ask(page, (probe) => probe.clear());
    await devtools.send('HeapProfiler.collectGarbage');
    const { usedSize, backingStorageSize = 0 } = /** @type {{ usedSize: number, backingStorageSize?: number }} */ (await devtools.send('Runtime.getHeapUsage'));
    samples.push({ minute: (Date.now() - start) / 60_000, heap: usedSize, buffers: backingStorageSize, wasm: await ask(page, (probe) => probe.wasmBytes()) });
  }
  await page.context().close();
  return samples;
}

/** How fast the sum grows, in bytes a minute, by the straight line nearest to the samples; the first, taken while things settle, is left out. @param {Sample[]} samples */
export function growth(samples) {
  const settled = samples.slice(1);
  const at = settled.map(({ minute }) => minute);
  const size = settled.map(({ heap, wasm }) => heap + wasm);
  const [x, y] = [at, size].map((values) => values.reduce((sum, value) => sum + value, 0) / values.length);
  const [over, under] = at.reduce(([o, u], minute, i) => [o + (minute - x) * (size[i] - y), u + (minute - x) ** 2], [0, 0]);
  return over / under;
}
