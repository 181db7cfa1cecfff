// What a lecturer does: the first ten seconds, predict and reveal, pen, freeze, big, lost.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { gearPixels, knob, type, untilVerdict, withPage } from './chromium.mjs';

/** @typedef {import('playwright-core').Page} Page */

const axe = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

const site = withPage();

/** The page under a clock that the test winds, from its first frames on. */
async function openWound() {
  const { page, leave } = await site.open('', {}, async ({ clock }) => {
    await clock.install({ time: 0 });
    await clock.pauseAt(1000);
  });
  for (let i = 0; i < 600 && !(await page.locator('h1[data-verdict]').count()); i++) {
    await page.waitForTimeout(5);
    await page.clock.runFor(16);
  }
  return { page, leave };
}

/** Model time as the page shows it, in s. @param {Page} page */
const time = async (page) => Number(await page.getByRole('slider', { name: 'Time' }).getAttribute('aria-valuenow'));

/** @param {Page} page */
async function violations(page) {
  await page.evaluate(axe);
  return page.evaluate(async () => {
    const { violations: found } = await /** @type {any} */ (window).axe.run();
    return found.flatMap((/** @type {any} */ { id, nodes }) => nodes.map((/** @type {any} */ { target, failureSummary }) => `${id} ${target}: ${failureSummary}`));
  });
}

/** How many pixels of a view a pen has covered. @param {Page} page @param {string} view a selector */
function inked(page, view) {
  return page.evaluate((selector) => {
    const canvas = /** @type {HTMLCanvasElement | null} */ (document.querySelector(`${selector} > shimmy-pen-layer > canvas`));
    if (!canvas) return 0;
    const copy = /** @type {OffscreenCanvasRenderingContext2D} */ (new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', { willReadFrequently: true }));
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
    let covered = 0;
    for (let i = 3; i < data.length; i += 4) if (data[i] > 20) covered++;
    return covered;
  }, view);
}

const gear = 'shimmy-gear > shimmy-canvas';
const plot = '#lens-panel .plot > shimmy-canvas';

/** Draws with the mouse. @param {Page} page @param {string} view @param {[number, number][]} way as shares of the view */
async function draw(page, view, way) {
  const box = await page.locator(view).boundingBox();
  assert.ok(box);
  const [first, ...rest] = way.map(([x, y]) => /** @type {const} */ ([box.x + x * box.width, box.y + y * box.height]));
  await page.mouse.move(...first);
  await page.mouse.down();
  for (const place of rest) await page.mouse.move(...place, { steps: 8 });
  await page.mouse.up();
  await page.waitForTimeout(100);
}

test('the first ten seconds: the wheel, the sentence at 3 s, ±10° at 6 s, one breath at 8 s, silence', async () => {
  const { page, leave } = await openWound();
  const sentence = page.locator('.opening-line');
  // Which knobs have breathed: an animation has a clock of its own.
  await page.evaluate(() => {
    const breaths = /** @type {string[]} */ (Object.assign(window, { breaths: [] }).breaths);
    addEventListener('animationstart', ({ animationName, target }) => {
      if (animationName === 'breath') breaths.push(/** @type {HTMLElement} */ (target).dataset.name ?? '');
    });
  });
  const breaths = () => page.evaluate(() => /** @type {any} */ (window).breaths);
  const still = await gearPixels(page);
  assert.equal(await sentence.innerText(), '');

  await page.clock.runFor(1000);
  assert.ok((await gearPixels(page)).filter((sum, i) => sum !== still[i]).length > 8, 'it stands still at 1 s');
  await page.clock.runFor(1700);
  assert.equal(await sentence.innerText(), '');
  await page.clock.runFor(500);
  assert.equal(await sentence.innerText(), 'Nothing shakes this wheel but its own tire.');

  await page.clock.runFor(2900);
  assert.equal(await page.locator('shimmy-verdict h1').innerText(), 'It shimmies');
  assert.match(await page.locator('.verdict-numbers').innerText(), /^±(9\.[5-9]|10\.[0-4])° and growing/);
  assert.deepEqual(await breaths(), []);
  await page.clock.runFor(2000);
  await page.waitForFunction(() => /** @type {any} */ (window).breaths.length > 0);

  const words = () => page.locator('body').innerText().then((text) => text.replaceAll(/[\d.±]+/g, ''));
  const said = await words();
  await page.clock.runFor(1500);
  assert.equal(await words(), said, 'then silence');
  await page.clock.runFor(3000);
  assert.ok(await page.getByRole('button', { name: 'First look' }).isVisible(), 'until it says what to try');
  const last = await words();
  await page.clock.runFor(4000);
  assert.equal(await words(), last, 'and silence again');
  assert.deepEqual(await breaths(), ['dampingConstant']);
  assert.equal(await page.locator('dialog, [role="dialog"]').count(), 0);
  await leave();
});

test('whatever a visitor does ends it at once', async () => {
  for (const act of [
    (/** @type {Page} */ page) => page.mouse.wheel(0, 1),
    (/** @type {Page} */ page) => page.keyboard.press('Shift'),
    (/** @type {Page} */ page) => page.mouse.click(1200, 400),
  ]) {
    const { page, leave } = await openWound();
    await page.clock.runFor(4000);
    assert.equal(await page.locator('.opening-line').count(), 1);
    await act(page);
    await page.locator('.opening-line').waitFor({ state: 'detached' });
    await page.clock.runFor(6000);
    assert.equal(await page.locator('[data-breathes]').count(), 0);
    await leave();
  }
});

test('an earlier visit and a link are not begun with it', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  assert.equal(await page.locator('.opening-line').count(), 1);
  await page.waitForTimeout(600);
  await page.goto('about:blank');
  await page.goto(site.address);
  await untilVerdict(page, 'It shimmies');
  assert.equal(await page.locator('.opening-line').count(), 0);
  await leave();
});

test('with reduced motion it stands at the last of it, all said, and nothing breathes', async () => {
  const { page, leave } = await site.open('', { reducedMotion: 'reduce' });
  await untilVerdict(page, 'It shimmies');
  await page.waitForTimeout(400);
  assert.equal(await time(page), 0.16);
  assert.equal(await page.locator('.opening-line, [data-breathes]').count(), 0);
  assert.match(await page.locator('.lens').innerText(), /Nothing shakes this wheel but its own tire\./);
  await leave();
});

test('the engine is asked for once, while the script still arrives', async () => {
  const { page, requests, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  const ofEngine = requests.filter((url) => url.endsWith('.wasm'));
  assert.equal(ofEngine.length, 1);
  const initiator = await page.evaluate(() => performance.getEntriesByType('resource').find(({ name }) => name.endsWith('.wasm'))?.toJSON().initiatorType);
  assert.equal(initiator, 'link');
  await leave();
});

test('predict and reveal, with keys alone; nothing tells before, to eye or ear', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await page.waitForTimeout(1000);
  await page.keyboard.press('p');
  await page.locator('.prediction').waitFor();
  await page.waitForTimeout(300);
  const asked = await time(page);
  await knob(page, 'dampingConstant').slider.focus();
  await page.keyboard.press('Shift+ArrowDown');
  await page.keyboard.press('Shift+ArrowDown');
  assert.equal(await knob(page, 'dampingConstant').number.inputValue(), '0.0');
  const heard = await page.locator('body').ariaSnapshot();
  assert.doesNotMatch(heard, /shimmies|dies out above|growing|heads for|settles on|limit cycle|±/);
  assert.match(heard, /Hidden until you reveal/);
  const seen = await page.locator('shimmy-verdict, .destination').allInnerTexts();
  assert.deepEqual(seen.map((text) => text.trim()), ['?', '?']);
  assert.deepEqual(await violations(page), []);
  assert.equal(await time(page), asked);

  await page.keyboard.press('1');
  assert.equal(await page.getByRole('button', { name: 'dies out' }).getAttribute('aria-pressed'), 'true');
  await page.keyboard.press('Enter');
  await page.locator('.prediction [role="status"]', { hasText: 'You said 1, it dies out. No. It grows' }).waitFor();
  await page.locator('h1[data-verdict]').waitFor();
  await page.waitForTimeout(500);
  assert.ok((await time(page)) > asked, 'the run goes on');
  assert.deepEqual(await violations(page), []);
  await page.keyboard.press('Escape');
  await page.locator('.prediction').waitFor({ state: 'detached' });
  assert.match(await page.locator('shimmy-verdict h1').innerText(), /^It (grows|shimmies)/);
  await leave();
});

test('a clicker reveals, though a slider has the focus', async () => {
  const { page, leave } = await site.open('#shimmy=2&velocity=80&dampingConstant=60&initial.torsionAngle=0.1&predict=1');
  await page.locator('.prediction').waitFor();
  assert.equal(await page.locator('h1[data-verdict]').count(), 0);
  await page.keyboard.press('1');
  const { slider, number } = knob(page, 'dampingConstant');
  await slider.focus();
  await page.keyboard.press('PageDown');
  await page.locator('.prediction [role="status"]', { hasText: 'You said 1, it dies out. Right.' }).waitFor();
  assert.equal(await number.inputValue(), '60.0');
  await untilVerdict(page, 'It dies out');
  await leave();
});

test('who is asked while playing may leave without an answer, and it plays on', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await page.getByRole('button', { name: 'Predict' }).click();
  assert.equal(await page.getByRole('button', { name: 'Predict' }).getAttribute('aria-pressed'), 'true');
  await page.getByRole('button', { name: 'All 15 values' }).click();
  await page.keyboard.press('Escape');
  await page.locator('shimmy-drawer').waitFor({ state: 'detached' });
  assert.equal(await page.locator('.prediction').count(), 1, 'one thing at a time');
  await page.keyboard.press('Escape');
  await untilVerdict(page, 'It shimmies');
  await page.getByRole('button', { name: 'Pause' }).waitFor();
  await leave();
});

test('what a pen draws stays with its view, is taken back stroke by stroke, and fades when the run goes on', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await page.keyboard.press('f');
  await page.getByRole('button', { name: 'Play', exact: true }).waitFor();
  await page.keyboard.press('d');
  await draw(page, gear, [[0.2, 0.3], [0.4, 0.6], [0.3, 0.8]]);
  await draw(page, plot, [[0.3, 0.3], [0.7, 0.7]]);
  await draw(page, plot, [[0.7, 0.3], [0.3, 0.7]]);
  const both = await inked(page, plot);
  assert.ok((await inked(page, gear)) > 500 && both > 500);
  assert.deepEqual(await violations(page), []);
  await page.keyboard.press('Control+z');
  await page.waitForTimeout(100);
  const one = await inked(page, plot);
  assert.ok(one > 200 && one < 0.7 * both, `${both} → ${one}`);
  assert.equal(await knob(page, 'dampingConstant').number.inputValue(), '20.0', 'the experiment is not undone');

  // Another view of the lens, and back.
  const show = (/** @type {string} */ shows) => page.evaluate((value) => {
    document.querySelector('#lens-panel')?.dispatchEvent(new CustomEvent('command', { bubbles: true, detail: { name: 'view', value: { of: 'phase', shows: value } } }));
  }, shows);
  await show('spectrum');
  await page.waitForTimeout(200);
  assert.equal(await inked(page, plot), 0);
  assert.ok((await inked(page, gear)) > 500);
  await show('portrait');
  await page.waitForTimeout(200);
  assert.equal(await inked(page, plot), one);

  // Pinned it stays, let go it fades; and with the pen in hand the wheel is not grabbed.
  await page.getByRole('button', { name: 'Pin', exact: true }).click();
  await page.keyboard.press('f');
  await page.waitForTimeout(2500);
  assert.ok((await inked(page, gear)) > 500);
  await page.getByRole('button', { name: 'Pin', exact: true }).click();
  await page.waitForFunction((selector) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector(`${selector} > shimmy-pen-layer > canvas`));
    const copy = /** @type {OffscreenCanvasRenderingContext2D} */ (new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', { willReadFrequently: true }));
    copy.drawImage(canvas, 0, 0);
    return copy.getImageData(0, 0, canvas.width, canvas.height).data.every((value) => value === 0);
  }, gear, { timeout: 20_000, polling: 500 });
  assert.ok(await page.getByRole('button', { name: 'Undo', exact: true }).isDisabled(), 'drawing is no step of undo');
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('.pen-tools').count(), 0);
  await leave();
});

test('what a pen drew survives a reload, as the address carries it', async () => {
  const { page, leave } = await site.open('', { reducedMotion: 'reduce' });
  await untilVerdict(page, 'It shimmies');
  await page.keyboard.press('d');
  await draw(page, gear, [[0.2, 0.3], [0.4, 0.6], [0.3, 0.8]]);
  await draw(page, plot, [[0.3, 0.3], [0.7, 0.7]]);
  await page.waitForTimeout(100);
  const drawn = [await inked(page, gear), await inked(page, plot)];
  await page.waitForFunction(() => (location.hash.match(/pen=/g) ?? []).length === 2);
  await page.reload();
  await untilVerdict(page, 'It shimmies');
  await page.waitForTimeout(300);
  const again = [await inked(page, gear), await inked(page, plot)];
  drawn.forEach((count, i) => assert.ok(Math.abs(again[i] / count - 1) < 0.05, `${count} → ${again[i]}`));
  await leave();
});

test('a stroke keeps its place when the window changes its size', async () => {
  const { page, leave } = await site.open('', { reducedMotion: 'reduce' });
  await untilVerdict(page, 'It shimmies');
  await page.keyboard.press('d');
  await draw(page, gear, [[0.5, 0.2], [0.5, 0.8]]);
  const middle = () => page.evaluate((selector) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector(`${selector} > shimmy-pen-layer > canvas`));
    const copy = /** @type {OffscreenCanvasRenderingContext2D} */ (new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', { willReadFrequently: true }));
    copy.drawImage(canvas, 0, 0);
    const row = copy.getImageData(0, Math.round(canvas.height / 2), canvas.width, 1).data;
    const at = [...Array(canvas.width).keys()].filter((x) => row[4 * x + 3] > 20);
    return at.reduce((sum, x) => sum + x, 0) / at.length / canvas.width;
  }, gear);
  assert.ok(Math.abs((await middle()) - 0.5) < 0.01);
  await page.setViewportSize({ width: 1200, height: 800 });
  await page.waitForTimeout(300);
  assert.ok(Math.abs((await middle()) - 0.5) < 0.01);
  await leave();
});

test('one finger draws, two move the page; without a pen in hand the sheet lets everything through', async () => {
  const { page, leave } = await site.open('', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await untilVerdict(page, 'It shimmies');
  await page.locator('.menu summary').click();
  await page.locator('.menu-sheet').getByRole('button', { name: 'Pen' }).click();
  await page.locator('.menu summary').click();
  const style = () => page.locator('shimmy-gear shimmy-pen-layer').evaluate((layer) => [getComputedStyle(layer).pointerEvents, getComputedStyle(layer).touchAction]);
  assert.deepEqual(await style(), ['auto', 'pinch-zoom']);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390, 'wider than the screen');
  const small = await page.locator('shimmy-header button:visible').evaluateAll((buttons) => buttons.map((button) => button.getBoundingClientRect())
    .filter(({ width, height }) => width < 44 || height < 44).length);
  assert.equal(small, 0);
  await page.locator('shimmy-actions .pen').click();
  assert.deepEqual((await style())[0], 'none');
  await leave();
});

for (const [width, height] of [[1440, 900], [1100, 700], [1024, 768], [768, 1024], [390, 844], [360, 640]])
  test(`the pen's tools fit the head at ${width} × ${height}, in both languages`, async () => {
    for (const locale of ['en-US', 'tr-TR']) {
      const { page, leave } = await site.open('', { viewport: { width, height }, locale });
      await page.locator('h1[data-verdict]').waitFor();
      await page.keyboard.press('d');
      await page.locator('.pen-tools').waitFor();
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width, `wider than the screen: ${locale}`);
      const outside = await page.locator('shimmy-header :is(button, summary):visible').evaluateAll((buttons) => buttons
        .filter((button) => button.getBoundingClientRect().right > window.innerWidth || button.getBoundingClientRect().left < 0).map(({ className }) => className));
      assert.deepEqual(outside, [], locale);
      await leave();
    }
  });

test('big: the verdict is twice as large, and the gear keeps its size whatever is said', async () => {
  const { page, leave } = await site.open('', { viewport: { width: 1024, height: 768 } });
  await untilVerdict(page, 'It shimmies');
  const size = (/** @type {string} */ what) => page.locator(what).evaluate((element) => parseFloat(getComputedStyle(element).fontSize));
  const [word, numbers] = [await size('shimmy-verdict h1'), await size('.verdict-numbers')];
  await page.keyboard.press('b');
  await page.waitForTimeout(200);
  assert.ok((await size('shimmy-verdict h1')) > 1.85 * word && (await size('.verdict-numbers')) > 1.6 * numbers);
  const canvas = await page.locator(gear).boundingBox();
  const head = await page.locator('shimmy-verdict').boundingBox();
  assert.ok(canvas && head && head.y + head.height <= canvas.y + 1, 'nothing lies over the gear');
  assert.ok(await page.locator('shimmy-verdict').evaluate((verdict) => verdict.scrollWidth <= verdict.clientWidth), 'cut');
  assert.deepEqual(await violations(page), []);
  await type(page, 'dampingConstant', '2');
  await untilVerdict(page, 'It grows beyond the model');
  assert.deepEqual(await page.locator(gear).boundingBox(), canvas);
  await page.waitForURL(/big=1/);
  await page.locator('.brand').click();
  await page.keyboard.press('b');
  await page.waitForTimeout(200);
  assert.equal(await page.locator('[data-big]').count(), 0);
  await leave();
});

test('lost: Home brings the gear to rest and keeps the values; on the time it is the slider’s own', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await type(page, 'dampingConstant', '15');
  await page.getByRole('button', { name: 'Kick' }).click();
  await page.keyboard.press('Home');
  await untilVerdict(page, 'It rests');
  assert.equal(await knob(page, 'dampingConstant').number.inputValue(), '15.0');
  await page.getByRole('button', { name: 'Undo' }).click();
  await untilVerdict(page, 'It shimmies');
  await page.getByRole('slider', { name: 'Time' }).focus();
  await page.keyboard.press('Home');
  await untilVerdict(page, 'It shimmies');
  await leave();
});

test('every key of a lecturer is on the list', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await page.keyboard.press('?');
  await page.locator('.menu-sheet kbd').first().waitFor();
  const keys = await page.locator('.menu-sheet kbd').allInnerTexts();
  for (const key of ['P', '1 2 3', 'Enter', 'F', 'D', 'B', 'Home', 'Esc']) assert.ok(keys.includes(key), `${key}: ${keys.join(' | ')}`);
  await leave();
});
