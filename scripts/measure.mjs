// Measures the built page in headless Chromium and prints the figures beside the goals; it judges nothing.
// npm run measure -- --minutes 1 --seconds 5 --lens phase --only frames,drag

import { cpus, loadavg } from 'node:os';
import { parseArgs } from 'node:util';
import { ensureBundle } from './build.mjs';
import { end } from './setup/run.mjs';
import { found } from './setup/say.mjs';
import { setUp } from './setup.mjs';

const { values } = parseArgs({
  options: {
    minutes: { type: 'string', default: '10' },
    seconds: { type: 'string', default: '10' },
    times: { type: 'string', default: '5' },
    lens: { type: 'string', default: '' },
    only: { type: 'string', default: 'opening,bytes,frames,looks,drag,memory' },
  },
});
const [minutes, seconds, times] = [values.minutes, values.seconds, values.times].map(Number);
const { lens } = values;
const wanted = values.only.split(',');

const tools = setUp('module', 'chromium');
try {
  ensureBundle(tools);
} catch (error) {
  end(error);
}

// Only now, because the set-up may just have installed what they need.
const { launch } = await import('./measure/page.mjs');
const { measureOpening } = await import('./measure/opening.mjs');
const { bytesOf, singleFile } = await import('./measure/bytes.mjs');
const { measureFrames } = await import('./measure/frames.mjs');
const { measureLooks } = await import('./measure/looks.mjs');
const { measureDrag } = await import('./measure/drag.mjs');
const { growth, measureMemory } = await import('./measure/memory.mjs');
const { percentile } = await import('./measure/statistics.mjs');
const { dist, fileAddress, serve } = await import('../tests/e2e/site.mjs');

/** @param {string} what @param {string} figure @param {string} [goal] */
const row = (what, figure, goal = '') => console.log(`  ${what.padEnd(54)}${figure.padStart(28)}   ${goal}`);
const ms = (/** @type {number} */ value) => `${value.toFixed(value < 100 ? 1 : 0)} ms`;
const kB = (/** @type {number} */ bytes) => `${(bytes / 1000).toFixed(1)} kB`;
const MB = (/** @type {number} */ bytes) => `${(bytes / 1e6).toFixed(2)} MB`;

const server = await serve();
const browser = await launch(tools.chromium);
found('measure', `Chromium ${browser.version()}, 1440 × 900, ${lens || 'the first'} lens, on ${cpus().length} × ${cpus()[0]?.model ?? 'unknown'}, load ${loadavg()[0].toFixed(1)}`);

if (wanted.includes('opening') || wanted.includes('bytes')) {
  const fromServer = await measureOpening(browser, server.address, wanted.includes('opening') ? times : 1);
  if (wanted.includes('opening')) {
    const fromFile = await measureOpening(browser, fileAddress, times);
    console.log(`\nFrom the start of the navigation to the first moving wheel, median and worst of ${times}`);
    for (const [place, { cold, warm }] of /** @type {const} */ ([['server', fromServer], ['file', fromFile]]))
      for (const [visit, found] of /** @type {const} */ ([['first visit', cold], ['next visit', warm]]))
        row(`${place}, ${visit}`, `${ms(percentile(found, 50))}, ${ms(Math.max(...found))}`, '≤ 300 ms');
  }
  if (wanted.includes('bytes')) {
    const sizes = bytesOf(dist, server.address, fromServer.requests);
    const sum = (/** @type {(size: { name: string }) => boolean} */ isMeant) => sizes.filter(isMeant).reduce((bytes, { wire }) => bytes + wire, 0);
    const isModule = (/** @type {{ name: string }} */ { name }) => name.endsWith('.wasm');
    console.log('\nBytes over the wire, brotli');
    for (const { name, raw, wire } of sizes) row(name, `${kB(wire)} of ${kB(raw)}`);
    row('module', kB(sum(isModule)), '≤ 120 kB with everything in it');
    row('first paint: all but the module', kB(sum((size) => !isModule(size))), '≤ 250 kB');
    row('everything', kB(sum(() => true)));
    const single = singleFile(dist);
    row(`${single.name}, by itself`, `${kB(single.wire)} of ${kB(single.raw)}`);
  }
}

if (wanted.includes('frames')) {
  const { mean, p95, max, perSecond, parts } = await measureFrames(browser, server.address, { lens, seconds });
  console.log(`\nA frame while it plays, over ${seconds} s`);
  row('script: mean, 95th percentile, worst', `${ms(mean)}, ${ms(p95)}, ${ms(max)}`, '< 4 ms');
  row('frames a second', perSecond.toFixed(1), '60');
  row('processor time: scripts, layout, all tasks', `${ms(parts.scripts)}, ${ms(parts.layout)}, ${ms(parts.tasks)}`);
}

if (wanted.includes('looks')) {
  const looked = lens || 'cycles';
  console.log(`\nA view of the lens ${looked} looked at for the first time: its longest frame's scripts, and the longest task of the main thread (0: below 50 ms)`);
  for (const { view, script, task } of await measureLooks(browser, server.address, { lens: looked })) row(view, `${ms(script)}, ${ms(task)}`, '≤ 50 ms');
}

if (wanted.includes('drag')) {
  const { count, fromInput, fromHand } = await measureDrag(browser, server.address, { lens, seconds });
  console.log(`\nA slider dragged, to the end of the drawing, median, 95th percentile and worst of ${count}`);
  row('from the input event', `${ms(fromInput.p50)}, ${ms(fromInput.p95)}, ${ms(fromInput.max)}`, 'p95 ≤ 16.7 ms, never > 50 ms');
  row('from the hand, with the wait for the frame', `${ms(fromHand.p50)}, ${ms(fromHand.p95)}, ${ms(fromHand.max)}`);
}

if (wanted.includes('memory')) {
  const samples = await measureMemory(browser, server.address, { lens, minutes });
  console.log(`\nMemory over ${minutes} min of play, each sample after a forced collection`);
  for (const { minute, heap, buffers, wasm } of samples) row(`${minute.toFixed(1)} min`, `heap ${MB(heap)}, buffers ${MB(buffers)}, module ${MB(wasm)}`);
  row('heap and module grow by', `${(growth(samples) / 1000).toFixed(1)} kB a minute`, 'flat');
}

await browser.close();
server.close();
