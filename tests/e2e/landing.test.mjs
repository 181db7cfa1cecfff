// The lens Landing: the roll of the gear on the stage, what is said of it, many of them, the table, how it is hidden and taken along.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { type, withPage } from './chromium.mjs';
import { fileAddress } from './site.mjs';

const axe = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const site = withPage();

/** @typedef {import('playwright-core').Page} Page */

const gear = '#shimmy=2&velocity=80&dampingConstant=20&initial.torsionAngle=0.05&lens=landing';

/** Waits until an element says so. @param {Page} page @param {string} selector @param {RegExp} words */
const untilSaid = (page, selector, words) => page.locator(selector).filter({ hasText: words }).first().waitFor({ timeout: 8000 });

/** How fast the gear on the stage is said to be where it is on the runway, in m/s. @param {Page} page */
const speed = async (page) => Number((await page.locator('.roll-runway').getAttribute('aria-valuetext'))?.match(/([\d.]+) m\/s$/)?.[1]);

test('the tab opens the lens, which comes then; it says when the gear shimmies and why, and follows the values', async () => {
  const { page, leave, requests } = await site.open('#shimmy=2&velocity=80&dampingConstant=20&initial.torsionAngle=0.05');
  await page.getByRole('tab', { name: 'Landing' }).waitFor();
  assert.ok(!requests.some((url) => /landing-/.test(url)), 'the page does not wait for it');
  await page.getByRole('tab', { name: 'Landing' }).click();
  // As the unit tests have it: down to 23.2 m/s, the branch a degree wide at 27.6.
  await untilSaid(page, '.roll-words', /It shimmies from 79\.8 m\/s down to 23\.\d m\/s, over 97\d m; ±18\.1°/);
  await untilSaid(page, '.roll-words', /The branch falls below 1\.0° at 27\.6 m\/s.*That is delay, not a fold\./);
  await type(page, 'dampingConstant', '60');
  await untilSaid(page, '.roll-words', /^\s*No shimmy/);
  await page.getByRole('button', { name: 'Undo' }).click();
  await untilSaid(page, '.roll-words', /It shimmies/);
  await leave();
});

test('another landing is typed, kept in the link, and refused where it is none', async () => {
  const { page, leave } = await site.open(gear);
  await untilSaid(page, '.roll-words', /It shimmies/);
  const braking = page.getByRole('textbox', { name: 'Braking' });
  await braking.fill('1');
  await braking.press('Enter');
  await untilSaid(page, '.roll-words', /down to 25\.\d m\/s/);
  await page.waitForURL(/view\.landingRoll=80,1,5,0,0\.01/);
  await braking.fill('0');
  await braking.press('Enter');
  await untilSaid(page, '#roll-why', /must be above 0/);
  assert.match(page.url(), /landingRoll=80,1,5/);
  await leave();
});

test('it touches down: the gear on the stage slows down under the strobe, dragging along the runway moves all, undo brings back', async () => {
  const { page, leave } = await site.open(gear);
  await untilSaid(page, '.roll-words', /It shimmies/);
  await page.getByRole('button', { name: 'Touch down' }).click();
  await page.getByRole('button', { name: 'Strobe', pressed: true }).waitFor();
  await page.waitForFunction(() => /\D7\d\.\d m\/s$/.test(document.querySelector('.roll-runway')?.getAttribute('aria-valuetext') ?? ''), null, { timeout: 8000 });
  await page.getByRole('button', { name: 'Pause' }).click();
  const box = await page.locator('.roll-history').boundingBox();
  assert.ok(box);
  await page.mouse.move(box.x + 0.2 * box.width, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.55 * box.width, box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  await page.waitForFunction(() => /\D[2-3]\d\.\d m\/s$/.test(document.querySelector('.roll-runway')?.getAttribute('aria-valuetext') ?? ''));
  const slow = await speed(page);
  await page.locator('.roll-runway').focus();
  await page.keyboard.press('Shift+ArrowLeft');
  await page.waitForFunction((before) => Number(document.querySelector('.roll-runway')?.getAttribute('aria-valuetext')?.match(/([\d.]+) m\/s$/)?.[1]) > before + 5, slow);
  await page.waitForURL(/model=torsional\.none\.none\.landing/);
  await page.getByRole('button', { name: 'Undo' }).click();
  await page.waitForURL((url) => !url.hash.includes('landing.'));
  await leave();
});

test('sixteen landings beside each other; a press rolls one; the table is sorted and taken along', async () => {
  const { page, leave } = await site.open(`${gear}&view.landing=beside`);
  const press = page.getByRole('button', { name: /^60\.0 N m s\/rad, 0\.5 A: no shimmy/ });
  await press.waitFor({ timeout: 20_000 });
  await press.click();
  await page.waitForURL(/model=torsional\.current-dependent-bouc-wen\.none\.landing/);
  await untilSaid(page, '.roll-words', /No shimmy/);
  await page.getByRole('combobox', { name: 'What the lens shows' }).selectOption('table');
  await page.waitForFunction(() => document.querySelectorAll('.figures-table tbody tr:not(.old)').length === 16, null, { timeout: 20_000 });
  const table = page.locator('.figures-table');
  await table.getByRole('button', { name: /^ψ/ }).click();
  await table.getByRole('button', { name: /^ψ/ }).click();
  assert.match(await table.locator('tbody tr').first().innerText(), /^20\s+0\s+79/);
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'CSV' }).last().click();
  const csv = await readFile(await (await download).path(), 'utf8');
  assert.match(csv.split('\n')[0], /dampingConstant.*current.*begins.*ends.*widest.*at/);
  assert.equal(csv.trim().split('\n').length, 17);
  await leave();
});

test('what is to be guessed is hidden, from screen readers too; figures open in one click, also from a file', async () => {
  const { page, leave } = await site.openAt(`${fileAddress}${gear}`);
  await untilSaid(page, '.roll-words', /It shimmies/);
  await page.keyboard.press('p');
  await page.locator('.landing-roll .panel-veil').waitFor();
  assert.doesNotMatch(await page.locator('shimmy-landing-lens').innerText(), /shimmies|calm/);
  await page.keyboard.press('p');
  await untilSaid(page, '.roll-words', /It shimmies/);
  await page.keyboard.press('/');
  await page.keyboard.type('7.31');
  await page.getByRole('option', { name: /7\.31/ }).first().click();
  await page.waitForURL(/story=figure-7\.31/);
  await untilSaid(page, '.roll-words', /shimm/i);
  await leave();
});

for (const scheme of /** @type {const} */ (['light', 'dark']))
  test(`axe-core finds nothing in the lens, ${scheme}`, async () => {
    for (const view of ['roll', 'beside', 'table']) {
      const { page, leave } = await site.open(`${gear}&view.landing=${view}`, { colorScheme: scheme });
      await page.locator('shimmy-landing-lens .landing').waitFor();
      await page.waitForTimeout(1500);
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => /** @type {any} */ (window).axe.run('shimmy-landing-lens'));
      assert.deepEqual(violations.map((/** @type {any} */ { id, nodes }) => [id, nodes[0].html]), [], view);
      await leave();
    }
  });
