// The module with relaxed SIMD: asked for by the first ensemble, never by the page's first paint, and never needed.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { untilVerdict, withPage } from './chromium.mjs';

const site = withPage();

const basins = '#shimmy=2&velocity=42&dampingConstant=10&casterLength=-0.05&sideForceLimitAngle=0.05235987755982988&aligningMomentLimitAngle=0.3490658503988659&initial.torsionAngle=0.3&lens=cycles&view.cycles=basins';

/** @param {import('playwright-core').Page} page */
const untilTold = (page) => page.locator('.endings').filter({ hasText: /dies out.*shimmies, ±17/s }).first().waitFor({ timeout: 10_000 });

test('it comes with the first ensemble, and not before', async () => {
  const { page, leave, requests } = await site.open(basins.replace('&view.cycles=basins', ''));
  const asked = () => requests.filter((url) => /shimmy_relaxed.*\.wasm$/.test(url)).length;
  await untilVerdict(page, 'It shimmies');
  assert.equal(asked(), 0);
  await page.locator('shimmy-cycles-lens .cycles').waitFor();
  await page.evaluate(() => { location.hash += '&view.cycles=basins'; });
  await page.reload();
  await untilTold(page);
  assert.equal(asked(), 1);
  await leave();
});

test('where it cannot be had, the other one does', async () => {
  let refused = 0;
  const { page, leave } = await site.open(basins, {}, async (page) => {
    await page.route('**/shimmy_relaxed*.wasm', (route) => {
      refused++;
      return route.fulfill({ status: 200, contentType: 'application/wasm', body: 'no module' });
    });
  });
  await untilTold(page);
  assert.equal(refused, 1);
  await leave();
});
