// What the lenses say beside their pictures: names for those who do not see them, lines under them, tables.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { ghostDashes } from '../../www/view/strokes.js';
import { knob, untilVerdict, withPage } from './chromium.mjs';

const site = withPage();
const settled = '#shimmy=2&velocity=80&dampingConstant=20&initial.torsionAngle=0.05&time=1.5';
const ghost = (/** @type {number} */ velocity) => `&ghost=0,torsional,velocity:${velocity},dampingConstant:20,state.torsionAngle:0.05`;

test('the spectrum’s name tells its peak: the cycle’s own frequency and amplitude', async () => {
  for (const [locale, said] of [['en-US', /Its peak: 51\.\d Hz · 15\.\d°\.$/], ['tr-TR', /Tepesi: 51,\d Hz · 15,\d°\.$/]]) {
    const { page, leave } = await site.open(`${settled}&view.phase=spectrum`, { locale: String(locale) });
    const picture = page.locator('#lens-panel canvas');
    await picture.waitFor();
    await page.waitForFunction(() => /\d Hz/.test(document.querySelector('#lens-panel canvas')?.getAttribute('aria-label') ?? ''));
    assert.match(await picture.getAttribute('aria-label') ?? '', /** @type {RegExp} */ (said));
    await leave();
  }
});

test('as the damping kills the swing, so does the peak that is told', async () => {
  const { page, leave } = await site.open(`${settled}&view.phase=spectrum-log`);
  const degreesTold = () => page.locator('#lens-panel canvas').getAttribute('aria-label').then((name) => Number(name?.match(/([\d.]+)°\.$/)?.[1] ?? NaN));
  await page.waitForFunction(() => /\d Hz/.test(document.querySelector('#lens-panel canvas')?.getAttribute('aria-label') ?? ''));
  const before = await degreesTold();
  await knob(page, 'dampingConstant').number.fill('100');
  await page.keyboard.press('Enter');
  await untilVerdict(page, 'It dies out');
  await page.getByRole('button', { name: 'Strobe', exact: true }).click();
  await page.waitForTimeout(1500);
  assert.ok((await degreesTold()) < 0.7 * before, `${before}° before, now ${await degreesTold()}°`);
  await leave();
});

test('under the force laws stands what the side force does within a cycle, at every instant of it', async () => {
  // Three steps of 1 ms at a time, of a cycle of 19 ms: the slip angle passes through zero on the way.
  const instants = 8;
  for (const [link, line] of [
    [settled, 'In each cycle the side force meets its limit: it feeds no more, however wide the swing.'],
    // At ±1° the slip angle stays far below the 5° at which the side force stops growing.
    ['#shimmy=2&velocity=80&dampingConstant=48.5&initial.torsionAngle=0.0175&time=0.1', 'The side force stays below its limit and grows with the slip angle.'],
  ]) {
    const { page, leave } = await site.open(`${link}&lens=forces`, { reducedMotion: 'reduce' });
    const said = page.locator('shimmy-forces-lens footer p');
    await said.waitFor();
    const slips = [];
    for (let i = 0; i < instants; i++) {
      assert.equal(await said.innerText(), line);
      slips.push(await page.evaluate(() => /** @type {any} */ (document.querySelector('shimmy-stage')).scene.forces.slipAngle));
      for (let step = 0; step < 3; step++) await page.getByRole('button', { name: 'Step on', exact: true }).click();
      await page.waitForTimeout(50);
    }
    assert.ok(Math.max(...slips) > 0 && Math.min(...slips) < 0, `a whole cycle was seen: ${slips}`);
    if (link === settled) assert.ok(slips.some((slip) => Math.abs(slip) < 0.07), 'and instants below the limit');
    await leave();
  }
});

test('the table shows each ghost’s line as the plots dash it', async () => {
  const { page, leave } = await site.open(`${settled}&lens=compare${[60, 70, 90, 100].map(ghost).join('')}`);
  const lines = page.locator('shimmy-compare-table tbody .ghost');
  await lines.nth(3).waitFor({ state: 'attached' });
  const dashes = await lines.evaluateAll((all) => all.map((line) => getComputedStyle(line).strokeDasharray.replaceAll('px', '').split(', ').map(Number)));
  assert.deepEqual(dashes, ghostDashes);
  await leave();
});

test('while it is to be guessed the table hides what becomes of each run, from sight and from screen readers', async () => {
  const { page, leave } = await site.open(`${settled}&lens=compare${ghost(60)}${ghost(20)}`);
  const rows = page.locator('shimmy-compare-table tbody tr');
  await rows.nth(2).waitFor();
  assert.match(await rows.nth(2).innerText(), /It dies out/);
  await page.keyboard.press('p');
  await page.locator('shimmy-compare-table td.veil').nth(2).waitFor();
  assert.equal(await rows.count(), 3);
  for (let row = 0; row < 3; row++) {
    const text = await rows.nth(row).textContent() ?? '';
    assert.ok(text.includes('?'), text);
    assert.doesNotMatch(text, /It shimmies|It dies out|Hz|°|\d J/, 'it tells what is to be guessed');
  }
  assert.match(await rows.nth(1).innerText(), /v = 60/, 'what sets it apart is no secret');
  await page.keyboard.press('1');
  await page.keyboard.press('Enter');
  await page.locator('shimmy-compare-table td.veil').first().waitFor({ state: 'detached' });
  assert.match(await rows.nth(1).innerText(), /Hz/);
  await leave();
});

test('each row of the table is of the motion that the run settles on: on a cycle as much goes out as comes in', async () => {
  const { page, leave } = await site.open(`#shimmy=2&velocity=80&dampingConstant=20&initial.torsionAngle=0.05&lens=compare${ghost(60)}${ghost(20)}`, { reducedMotion: 'reduce' });
  const rows = page.locator('shimmy-compare-table tbody tr');
  await rows.nth(2).waitFor();
  await page.keyboard.press('r');
  const cells = async (/** @type {number} */ row) => (await rows.nth(row).locator('.figure').allInnerTexts());
  for (const row of [0, 1]) {
    const [amplitude, frequency, energy] = await cells(row);
    const [fed, taken] = energy.split('\n').map((text) => Number(text.replaceAll(/[^\d.]/g, '')));
    assert.ok(fed > 1000 && Math.abs(fed - taken) <= 1, `${fed} ${taken}`);
    if (row === 0) assert.deepEqual([amplitude, frequency].map((text) => text.replaceAll('\u00a0', ' ')), ['±15.2°', '51.9 Hz']);
  }
  assert.deepEqual(await cells(2), ['0°', '–', '–'], 'what dies out has no cycle to count');
  await leave();
});

for (const locale of ['en-US', 'tr-TR'])
  test(`the table of ghosts fits beside the gear: ${locale}`, async () => {
    const { page, leave } = await site.open(`${settled}&lens=compare${ghost(50)}`, { viewport: { width: 1440, height: 900 }, locale });
    await page.locator('shimmy-compare-table tbody tr').nth(1).waitFor();
    const over = () => page.locator('shimmy-compare-table .scroll').evaluate((one) => one.scrollWidth - one.clientWidth);
    await page.waitForTimeout(500);
    assert.ok((await over()) <= 0, `${await over()} px too wide`);
    await leave();
  });

for (const [width, height] of [[390, 844], [720, 450], [768, 1024]])
  test(`the parts of the lens Compare stand one under the other at ${width} × ${height}, and all can be scrolled to`, async () => {
    for (const [ghosts, last] of [['', '.empty button'], [ghost(60), 'tbody tr:last-child']]) {
      const { page, leave } = await site.open(`${settled}&lens=compare${ghosts}`, { viewport: { width, height } });
      await page.locator(`shimmy-compare-table ${last}`).waitFor();
      await page.evaluate(() => window.scrollTo(0, 10_000));
      const parts = ['shimmy-compare-lens shimmy-canvas', 'shimmy-compare-table', '#lens-panel footer', 'shimmy-strip', 'shimmy-dock'];
      const boxes = await page.evaluate((names) => names.map((name) => /** @type {Element} */ (document.querySelector(name)).getBoundingClientRect().toJSON()), parts);
      for (const [i, one] of boxes.entries())
        for (const other of boxes.slice(0, i)) assert.ok(one.top >= other.bottom - 1 || one.bottom <= other.top + 1, `${parts[i]} over another: ${JSON.stringify(boxes)}`);
      assert.ok(boxes[0].height >= 200);
      const row = page.locator(`shimmy-compare-table ${last}`);
      await row.scrollIntoViewIfNeeded();
      const [shown, dock] = [await row.boundingBox(), await page.locator('shimmy-dock').boundingBox()];
      assert.ok(shown && dock && shown.y + shown.height <= dock.y + 1);
      await leave();
    }
  });

test('on a phone what to try stands beside its button, not under it', async () => {
  const { page, leave } = await site.open(settled, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await page.locator('.story').waitFor();
  const [words, button] = await page.evaluate(() => ['.story > :first-child', '.story .story-walk button'].map((one) => document.querySelector(one)?.getBoundingClientRect().toJSON()));
  assert.ok(words.right <= button.left, `${words.right} over ${button.left}`);
  await leave();
});
