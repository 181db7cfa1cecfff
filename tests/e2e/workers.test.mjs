// Long work beside the page, in real workers: from a server under a sub-path, without a network, and from a double-click.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { untilVerdict, withPage } from './chromium.mjs';
import { fileAddress } from './site.mjs';

/** @typedef {import('playwright-core').Page} Page */

const MAP = {
  model: 'torsional',
  x: { parameter: 'velocity', from: 0.5, to: 100, count: 300 },
  y: { parameter: 'casterLength', from: 0, to: 0.5, count: 200 },
};
const site = withPage();

/** What the page's workers make of a map, as a whole and in tiles; and what becomes of a job that is cancelled. @param {Page} page */
const worked = (page) =>
  page.evaluate(async (map) => {
    const { runJob, mapTiles } = /** @type {any} */ (document.querySelector('shimmy-page')).work;
    const whole = await runJob('stabilityMap', map);
    const tiles = await mapTiles('stabilityMap', map);
    const end = new AbortController();
    const many = { ...map, x: { ...map.x, count: 3000 }, y: { ...map.y, count: 3000 } };
    const cancelled = runJob('stabilityMap', many, { signal: end.signal, onProgress: () => end.abort() }).then(() => 'done', (/** @type {Error} */ error) => error.name);
    const refused = await runJob('stabilityMap', { ...map, x: { ...map.x, parameter: 'velocty' } }).catch((/** @type {any} */ error) => error.suggestion);
    return { stable: whole.stable.length, percent: whole.stablePercent, same: whole.stable.every((/** @type {number} */ cell, /** @type {number} */ place) => cell === tiles.stable[place]), cancelled: await cancelled, refused };
  }, MAP);

/** @param {Page} page */
async function assertWorks(page) {
  await untilVerdict(page, 'It shimmies');
  const { stable, percent, same, cancelled, refused } = await worked(page);
  assert.equal(stable, 60_000);
  assert.ok(percent > 0 && percent < 100);
  assert.deepEqual({ same, cancelled, refused }, { same: true, cancelled: 'AbortError', refused: 'velocity' });
}

test('workers work on a site under a sub-path, and without a network', async () => {
  const { page, leave } = await site.open();
  await assertWorks(page);
  await page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
  await page.context().setOffline(true);
  await page.reload();
  await assertWorks(page);
  await leave();
});

test('workers work in the page as one file, from a double-click', async () => {
  const { page, leave } = await site.openAt(fileAddress);
  await assertWorks(page);
  await leave();
});
