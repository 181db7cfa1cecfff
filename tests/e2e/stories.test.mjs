// Stories on the page: found by one field, opened by a click, walked with a clicker, left again; and the choice of an object.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { presets } from '../../www/story/presets.js';
import { voiceOf } from '../../www/words/voice.js';
import { knob, type, untilVerdict, withPage } from './chromium.mjs';

const axe = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

const site = withPage();

/** @typedef {import('playwright-core').Page} Page */

/** @param {Page} page */
const place = (page) => page.locator('.story-title').innerText();
/** @param {Page} page @param {string} words */
const untilPlace = (page, words) => page.locator('.story-title', { hasText: words }).waitFor({ timeout: 5000 });
/** Rows of the list that was found. @param {Page} page @param {{ selected?: boolean, disabled?: boolean }} [which] */
const rows = (page, which) => page.getByRole('listbox').getByRole('option', which);
/** @param {Page} page */
const time = async (page) => Number(await page.getByRole('slider', { name: 'Time' }).getAttribute('aria-valuenow'));

test('each preset opens by a click, and says what the gear then does', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  const verdicts = ['It shimmies', 'It dies out', 'It dies out', 'It shimmies', 'It shimmies', 'It dies out', 'It dies out', 'It rattles in the gap', 'It shimmies', 'It shimmies', 'It dies out', 'It dies out', 'It comes to rest', 'It shimmies', 'It grows beyond the model'];
  assert.equal(presets.length, verdicts.length);
  for (const [i, { name, steps }] of presets.entries()) {
    const title = voiceOf('en').say(/** @type {import('../../www/words/voice.js').Key} */ (`preset.${name}`));
    await page.getByRole('combobox', { name: 'Presets, figures, lessons' }).click();
    await rows(page).filter({ has: page.getByText(title, { exact: true }) }).click();
    await untilPlace(page, `${title} · 1 of ${steps.length}`);
    await untilVerdict(page, verdicts[i]);
    await page.waitForURL(new RegExp(`story=${name}$`));
    assert.ok(await page.getByRole('listbox').isHidden());
  }
  await leave();
});

test('a figure is found by its number and opened by Enter, in English and in Turkish', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await page.keyboard.press('/');
  await page.keyboard.type('5.88a');
  const field = page.getByRole('combobox', { name: 'Presets, figures, lessons' });
  assert.equal(await field.getAttribute('aria-activedescendant'), 'story-figure-5.88a');
  await page.keyboard.press('Enter');
  await untilPlace(page, 'Figure 5.88a · orbit in space');
  await page.locator('.turntable').waitFor();
  assert.match(await page.locator('shimmy-strip').innerText(), /Limit cycle, v.=.30.m\/s, c.=.10.N.m.s\/rad, ψ\(0\).=.0\.01/);
  assert.equal(await knob(page, 'velocity').number.inputValue(), '30.0');
  assert.equal(await knob(page, 'dampingConstant').number.inputValue(), '10.0');
  await page.waitForURL(/view\.cycleOrbit=space&story=figure-5\.88a$/);
  await leave();

  const other = await site.open('', { locale: 'tr-TR' });
  await untilVerdict(other.page, 'Shimmy var');
  await other.page.keyboard.press('/');
  await other.page.keyboard.type('boşluk 0,5 v 50');
  assert.match(await rows(other.page, { selected: true }).innerText(), /Boşluk/);
  await other.page.keyboard.type(' şekil');
  await other.page.keyboard.press('ArrowDown');
  await other.page.keyboard.press('Enter');
  await untilPlace(other.page, 'Şekil 6.7 · zamana karşı ψ');
  assert.match(await other.page.locator('shimmy-strip').innerText(), /Burulma açısı, 0,5° boşlukla, v.=.50.m\/s/);
  await other.leave();
});

test('the list obeys its keys: arrows past what is not built, Escape, and nothing found says so', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await page.keyboard.press('/');
  const active = () => rows(page, { selected: true }).innerText();
  assert.match(await active(), /First look/);
  await page.keyboard.press('ArrowDown');
  assert.match(await active(), /Quiet taxi/);
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ArrowUp');
  assert.match(await active(), /Table 7\.4/, 'around the end, past what cannot be opened');
  await page.keyboard.type('Lorenz');
  assert.ok(await rows(page, { disabled: true }).count() >= 2);
  assert.match(await rows(page).first().innerText(), /not built yet/);
  await page.keyboard.press('Enter');
  await page.keyboard.type(' of the moon');
  await page.locator('.search-none', { hasText: 'Nothing found' }).waitFor();
  await page.keyboard.press('Escape');
  assert.ok(await page.getByRole('listbox').isHidden());
  await page.keyboard.press('Escape');
  await page.keyboard.press(' ');
  await page.getByRole('button', { name: 'Play', exact: true }).waitFor();
  assert.equal(await place(page), 'What to try');
  await leave();
});

test('back to what you had: value, time, pause', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await type(page, 'dampingConstant', '33');
  await page.waitForTimeout(500);
  await page.getByRole('button', { name: 'Pause' }).click();
  await page.waitForTimeout(400);
  const then = await time(page);
  assert.ok(then > 0);
  await page.keyboard.press('/');
  await page.keyboard.type('quiet');
  await page.keyboard.press('Enter');
  await untilVerdict(page, 'It dies out');
  assert.equal(await page.getByRole('button', { name: 'Pause' }).count(), 1, 'a story plays');
  await page.getByRole('button', { name: 'Next' }).click();
  await untilPlace(page, 'Quiet taxi · 2 of 3');
  await page.getByRole('button', { name: 'Back to what you had' }).click();
  await untilVerdict(page, 'It shimmies');
  await page.waitForTimeout(400);
  assert.equal(await knob(page, 'dampingConstant').number.inputValue(), '33.0');
  assert.equal(await time(page), then);
  assert.equal(await page.getByRole('button', { name: 'Play', exact: true }).count(), 1);
  assert.equal(await page.getByRole('button', { name: 'Back to what you had' }).count(), 0);
  await leave();
});

test('a clicker walks the first look, and a link takes another there', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await page.keyboard.press('PageDown');
  await untilPlace(page, 'First look · 1 of 5');
  await page.keyboard.press('PageDown');
  await page.getByText('Nothing shakes this wheel but its own tire. Drag the damping past 48.6 and let it die out.').waitFor();
  await page.keyboard.press('PageDown');
  await page.keyboard.press('PageUp');
  await untilPlace(page, 'First look · 2 of 5');
  await page.keyboard.press('PageDown');
  await untilPlace(page, 'First look · 3 of 5');
  await page.waitForURL(/story=first-look,2$/);
  const link = page.url();
  await leave();

  const again = await site.openAt(link);
  await untilPlace(again.page, 'First look · 3 of 5');
  await again.page.getByRole('button', { name: 'End the story' }).click();
  await untilPlace(again.page, 'What to try');
  await again.leave();
});

test('a question is guessed at, answered by the story, and gone on from: all with the keys of a clicker, or by hand', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  for (let i = 0; i < 4; i++) await page.keyboard.press('PageDown');
  await untilPlace(page, 'First look · 4 of 5');
  await page.getByRole('button', { name: 'Next' }).waitFor({ state: 'hidden' });
  await page.keyboard.press('PageDown');
  const asked = page.locator('shimmy-prediction');
  await asked.getByText('Now the damping goes up to 60. What becomes of the swing?').waitFor();
  assert.equal(await knob(page, 'dampingConstant').number.inputValue(), '60.0');
  await page.locator('.verdict-veil').waitFor();
  await page.keyboard.press('1');
  await page.keyboard.press('PageDown');
  await asked.getByText('You said 1, it dies out. Right.').waitFor();
  await untilVerdict(page, 'It dies out');
  await page.keyboard.press('PageDown');
  await untilPlace(page, 'First look · 5 of 5');
  await page.keyboard.press('PageUp');
  await untilPlace(page, 'First look · 4 of 5');
  await untilVerdict(page, 'It shimmies');
  await page.locator('shimmy-strip').getByRole('button', { name: 'Predict' }).click();
  await asked.getByRole('button', { name: 'grows' }).click();
  await asked.getByRole('button', { name: 'Reveal' }).click();
  await asked.getByText('You said 3, it grows. No. It dies out.').waitFor();
  await asked.getByRole('button', { name: 'Next' }).click();
  await untilPlace(page, 'First look · 5 of 5');
  await leave();
});

test('a clicker walks on after a mouse was at a slider or at the time; by the keyboard these page themselves', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await page.getByRole('slider', { name: 'Time' }).click();
  await page.keyboard.press('PageDown');
  await untilPlace(page, 'First look · 1 of 5');
  await type(page, 'velocity', '81');
  await page.keyboard.press('PageDown');
  await untilPlace(page, 'First look · 2 of 5');
  await page.getByRole('button', { name: 'Pause' }).focus();
  while (!(await page.evaluate(() => document.activeElement?.matches('[type="range"]')))) await page.keyboard.press('Tab');
  const before = await knob(page, 'velocity').number.inputValue();
  await page.keyboard.press('PageUp');
  assert.notEqual(await knob(page, 'velocity').number.inputValue(), before);
  assert.equal(await place(page), 'First look · 2 of 5');
  await leave();
});

test('another object: the dock follows its table, and what is not built is dimmed', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await page.getByRole('combobox', { name: 'Object' }).selectOption('torsional-linear');
  await untilVerdict(page, 'It grows beyond the model');
  assert.equal(await knob(page, 'velocity').number.inputValue(), '80.0');
  assert.equal(await knob(page, 'freeplayAngle').number.count(), 0);
  assert.equal(await knob(page, 'torsionalStiffness').number.count(), 1);
  await page.getByRole('button', { name: 'All 12 values' }).click();
  assert.equal(await page.locator('.drawer-knobs shimmy-knob').count(), 12);
  assert.ok(await page.locator('select.object:visible option[value="van-der-pol"]').isDisabled());
  await page.waitForURL(/model=torsional-linear/);
  await page.getByRole('button', { name: 'Undo' }).click();
  await untilVerdict(page, 'It shimmies');
  assert.equal(await page.getByRole('combobox', { name: 'Object' }).inputValue(), 'torsional');
  await leave();
});

test('on a phone the field is behind its button, its rows are large, and the story is read under the gear', async () => {
  const { page, leave } = await site.open('', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await untilVerdict(page, 'It shimmies');
  await page.getByRole('button', { name: 'Search presets and figures' }).tap();
  await page.getByRole('combobox', { name: 'Presets, figures, lessons' }).fill('5.9');
  const heights = await rows(page).evaluateAll((rows) => rows.map((row) => row.getBoundingClientRect().height));
  assert.ok(heights.length > 30 && heights.every((height) => height >= 44), `${Math.min(...heights)}`);
  await rows(page).filter({ hasText: 'Figure 5.92b' }).tap();
  await untilPlace(page, 'Figure 5.92b · phase portrait');
  const strip = await page.locator('shimmy-strip').boundingBox();
  assert.ok(strip && strip.y > 0 && strip.y + strip.height < 844 - 140, 'the story is in sight, above the slider');
  // The last step of this one is seen through the lens at the end of the row.
  await page.getByRole('button', { name: 'Search presets and figures' }).tap();
  await page.getByRole('combobox', { name: 'Presets, figures, lessons' }).fill('double the gap');
  await rows(page).first().tap();
  for (let i = 0; i < 2; i++) await page.getByRole('button', { name: 'Next' }).tap();
  await untilPlace(page, 'Double the gap, double the rattle · 3 of 4');
  const tab = await page.getByRole('tab', { name: 'Compare' }).boundingBox();
  assert.ok(tab && tab.x >= 0 && tab.x + tab.width <= 390, 'the tab of the chosen lens is in sight');
  await page.locator('.menu summary').tap();
  assert.ok(await page.locator('.menu-sheet').getByRole('combobox', { name: 'Object' }).isVisible());
  await leave();
});

for (const locale of ['en-US', 'tr-TR'])
  test(`a projector has place, Back, Next, the way out, undo and all lenses in sight: ${locale}`, async () => {
    const { page, leave } = await site.open('#shimmy=2&velocity=50&dampingConstant=100&freeplayAngle=0.01745&initial.torsionAngle=0.05', { viewport: { width: 1024, height: 768 }, locale });
    // What to try is to close the gap: its knob is one of the two.
    await page.locator('shimmy-dock [data-name="freeplayAngle"]').waitFor();
    assert.equal(await page.locator('shimmy-dock shimmy-knob').count(), 2);
    await type(page, 'freeplayAngle', '0');
    await page.locator('shimmy-dock [data-name="freeplayAngle"]').waitFor();
    await page.keyboard.press('PageDown');
    await page.keyboard.press('PageDown');
    await page.locator('.tale').getByText(/2 (of|\/) 5/).waitFor();
    for (const what of ['.story-title', '.tale .back', '.tale .next', '.tale .come-back', 'shimmy-header > .undo', 'shimmy-header > .redo', '#tab-compare']) {
      const box = await page.locator(what).boundingBox();
      assert.ok(box && box.width > 20 && box.height > 10 && box.x >= 0 && box.x + box.width <= 1024, `${what}: ${JSON.stringify(box)}`);
    }
    const cut = await page.locator('.story-title').evaluate((title) => title.scrollWidth > title.clientWidth);
    assert.ok(!cut, 'the place in the story is whole');
    await page.locator('.tale .come-back').click();
    await page.waitForURL(/dampingConstant=100/);
    await leave();
  });

for (const [width, height] of [[1440, 900], [1024, 768], [390, 844]])
  for (const colorScheme of /** @type {const} */ (['light', 'dark']))
    test(`axe-core finds nothing with a story told and the list open at ${width} × ${height}, ${colorScheme}`, async () => {
      const { page, leave } = await site.open('', { viewport: { width, height }, colorScheme });
      await untilVerdict(page, 'It shimmies');
      await page.keyboard.press('PageDown');
      await untilVerdict(page, 'It shimmies');
      await page.evaluate(axe);
      const violations = () => page.evaluate(async () => {
        const { violations } = await /** @type {any} */ (window).axe.run();
        return violations.flatMap((/** @type {any} */ { id, nodes }) => nodes.map((/** @type {any} */ { target, failureSummary }) => `${id} ${target}: ${failureSummary}`));
      });
      assert.deepEqual(await violations(), []);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width, 'wider than the screen');
      await page.keyboard.press('/');
      await page.keyboard.type('figure 5.8');
      assert.deepEqual(await violations(), []);
      await leave();
    });
