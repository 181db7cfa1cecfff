// The measuring script still finds on the page what it measures. What it measures is no test's business.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bytesOf } from '../../scripts/measure/bytes.mjs';
import { measureDrag } from '../../scripts/measure/drag.mjs';
import { measureFrames } from '../../scripts/measure/frames.mjs';
import { growth, measureMemory } from '../../scripts/measure/memory.mjs';
import { measureOpening } from '../../scripts/measure/opening.mjs';
import { percentile } from '../../scripts/measure/statistics.mjs';
import { withPage } from './chromium.mjs';
import { dist, fileAddress } from './site.mjs';

const site = withPage();

test('opening: both visits come to a moving wheel, and the files asked for are the build’s', async () => {
  const { cold, warm, requests } = await measureOpening(site.browser, site.address, 1);
  assert.ok([...cold, ...warm].every((time) => time > 10 && time < 20_000), `${cold} ${warm}`);
  const sizes = bytesOf(dist, site.address, requests);
  assert.ok(sizes.some(({ name }) => name.endsWith('.wasm')) && sizes.some(({ name }) => name === 'index.html'));
  assert.ok(sizes.every(({ raw, wire }) => wire > 0 && wire <= raw));
  assert.ok((await measureOpening(site.browser, fileAddress, 1)).cold[0] > 10);
});

test('frames, a drag and memory are counted', async () => {
  const { mean, p95, max, perSecond, parts } = await measureFrames(site.browser, site.address, { lens: 'phase', seconds: 1 });
  assert.ok(mean > 0 && p95 <= max && perSecond > 0 && parts.scripts > 0 && parts.tasks > parts.scripts);
  const drag = await measureDrag(site.browser, site.address, { lens: '', seconds: 2 });
  assert.ok(drag.count > 2);
  for (const { p50, p95, max } of [drag.fromInput, drag.fromHand]) assert.ok(p50 > 0 && p50 <= p95 && p95 <= max);
  assert.ok(drag.fromInput.p50 < drag.fromHand.p50, 'the page is told after the hand has moved');
  const samples = await measureMemory(site.browser, site.address, { lens: '', minutes: 0.02 });
  assert.equal(samples.length, 11);
  assert.ok(samples.every(({ heap, wasm }) => heap > 1e6 && wasm > 1e6));
});

test('growth is the slope of the samples, percentiles are among the values', () => {
  const samples = [9e9, 0, 1, 2, 3].map((minute) => ({ minute, heap: minute === 9e9 ? 5 : 1000 + 70 * minute, buffers: 0, wasm: 30 * minute }));
  assert.ok(Math.abs(growth(samples) - 100) < 1e-9);
  assert.equal(percentile([5, 1, 4, 2, 3], 50), 3);
  assert.equal(percentile([5, 1, 4, 2, 3], 95), 5);
});
