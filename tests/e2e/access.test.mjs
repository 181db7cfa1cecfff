// The page for everybody: axe-core's rules in every layout, theme and state; nothing wider than the screen; targets
// large enough for a thumb; everything within reach of the keyboard.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { type, untilVerdict, withPage } from './chromium.mjs';

const axe = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const sizes = [[1440, 900], [1024, 768], [390, 844], [720, 450]];

const site = withPage();

for (const [width, height] of [[1440, 900], [1100, 700], [1024, 768], [768, 1024], [900, 600], [390, 844], [390, 667]])
  test(`wheel, verdict and the damping's slider share the screen at ${width} × ${height}, scrolled or not`, async () => {
    const { page, leave } = await site.open('', { viewport: { width, height } });
    await untilVerdict(page, 'It shimmies');
    const isCut = await page.locator('shimmy-transport .scale').evaluate((scale) => scale.scrollWidth > scale.clientWidth);
    assert.ok(!isCut, 'the rate in words is cut');
    for (const down of [0, 10_000]) {
      await page.evaluate((top) => window.scrollTo(0, top), down);
      for (const what of ['.gear', 'shimmy-verdict h1', 'shimmy-dock [data-name="dampingConstant"] .slider']) {
        const box = await page.locator(what).boundingBox();
        assert.ok(box && box.height > 20 && box.y >= 0 && box.y + box.height <= height, `${what}, scrolled by ${down}: ${JSON.stringify(box)}`);
      }
    }
    await leave();
  });

for (const [width, height] of [[720, 450], [844, 390]])
  test(`at ${width} × ${height} wheel, verdict and slider share the screen, scrolled the whole plot and the slider do`, async () => {
    const { page, leave } = await site.open('', { viewport: { width, height } });
    await untilVerdict(page, 'It shimmies');
    const seen = async (/** @type {string} */ what) => {
      const box = await page.locator(what).boundingBox();
      assert.ok(box && box.height > 20 && box.y > -1 && box.y + box.height <= height, `${what}: ${JSON.stringify(box)}`);
      return box;
    };
    for (const what of ['.gear', 'shimmy-verdict h1', 'shimmy-dock [data-name="dampingConstant"] .slider']) await seen(what);
    await page.evaluate(() => document.querySelector('.tabs')?.scrollIntoView());
    await seen('.tabs');
    const plot = await seen('#lens-panel .plot');
    const slider = await seen('shimmy-dock [data-name="dampingConstant"] .slider');
    assert.ok(plot.height >= 200 && plot.y + plot.height <= slider.y, JSON.stringify({ plot, slider }));
    await leave();
  });

/** The edges of what is shown, by selector. @param {import('playwright-core').Page} page @param {string[]} parts */
const edges = (page, ...parts) => page.evaluate((names) => names.map((name) => {
  const { left, right, top, bottom } = /** @type {Element} */ (document.querySelector(name)).getBoundingClientRect();
  return { left, right, top, bottom };
}), parts);

for (const [width, height] of [[1440, 900], [1366, 620], [1100, 700], [1024, 768]])
  test(`the lens is beside the stage at ${width} × ${height}`, async () => {
    const { page, leave } = await site.open('', { viewport: { width, height } });
    await untilVerdict(page, 'It shimmies');
    const [stage, lens] = await edges(page, 'shimmy-stage', '.lens');
    assert.ok(lens.left >= stage.right - 1 && lens.right === width, 'beside it');
    await leave();
  });

// 720 × 450 is a laptop's 1440 × 900, zoomed to 200 %.
for (const [width, height] of [[720, 450], [900, 600], [1050, 620], [768, 1024], [390, 844]])
  test(`the lens is under the stage at ${width} × ${height}, and each of its parts can be scrolled into sight`, async () => {
    const { page, leave } = await site.open('#shimmy=2&initial.torsionAngle=0.05&story=first-look', { viewport: { width, height } });
    await untilVerdict(page, 'It shimmies');
    const [beneath, over] = await edges(page, '.lens', 'shimmy-stage');
    assert.ok(beneath.top >= over.bottom - 1 && beneath.left === 0 && beneath.right === width, 'under it, as wide as the page');
    for (const part of ['.tabs', '#lens-panel .plot', '#lens-panel footer', 'shimmy-why summary', 'shimmy-strip']) {
      await page.evaluate((name) => document.querySelector(name)?.scrollIntoView({ block: 'nearest' }), part);
      const [shown, stage, dock] = await edges(page, part, 'shimmy-stage', 'shimmy-dock');
      assert.ok(shown.top >= stage.bottom - 1 && shown.bottom <= dock.top + 1, `${part}: ${JSON.stringify({ shown, stage, dock })}`);
    }
    await page.locator('.chips button').last().click();
    await page.waitForTimeout(300);
    const [close, stage, dock] = await edges(page, 'shimmy-drawer header button', 'shimmy-stage', 'shimmy-dock');
    assert.ok(close.top >= stage.bottom && close.bottom <= dock.top, 'the way out of all values is in sight');
    await leave();
  });

for (const [width, height] of [[720, 450], [640, 360], [390, 844]])
  test(`the clock's buttons have room at ${width} × ${height} in Turkish, whose words are longer`, async () => {
    const { page, leave } = await site.open('', { viewport: { width, height }, locale: 'tr-TR' });
    await untilVerdict(page, 'Shimmy var');
    const [last, clock] = await edges(page, 'shimmy-transport .kick', 'shimmy-transport');
    assert.ok(last.right <= clock.right && clock.right <= width, JSON.stringify({ last, clock }));
    await leave();
  });

test('what is narrow and low scrolls as a whole, with nothing in the way', async () => {
  const { page, leave } = await site.open('', { viewport: { width: 360, height: 320 } });
  await untilVerdict(page, 'It shimmies');
  await page.evaluate(() => window.scrollTo(0, 10_000));
  const [stage, dock] = await edges(page, 'shimmy-stage', 'shimmy-dock');
  assert.ok(stage.bottom < 0 && dock.bottom <= 321, 'the stage is gone, the slider is at the end');
  await leave();
});

/** @param {import('playwright-core').Page} page @returns {Promise<string[]>} */
async function violations(page) {
  await page.evaluate(axe);
  return page.evaluate(async () => {
    const { violations } = await /** @type {any} */ (window).axe.run();
    return violations.flatMap((/** @type {any} */ { id, nodes }) => nodes.map((/** @type {any} */ { target, failureSummary }) => `${id} ${target}: ${failureSummary}`));
  });
}

for (const [width, height] of sizes)
  for (const colorScheme of /** @type {const} */ (['light', 'dark']))
    test(`axe-core finds nothing at ${width} × ${height}, ${colorScheme}`, async () => {
      const { page, leave } = await site.open('', { viewport: { width, height }, colorScheme });
      await untilVerdict(page, 'It shimmies');
      assert.deepEqual(await violations(page), []);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width, 'wider than the screen');
      await page.locator('shimmy-dock button[aria-expanded]:visible').first().click();
      await page.locator('.menu summary').click();
      assert.deepEqual(await violations(page), [], 'with drawer and menu open');
      await leave();
    });

test('axe-core finds nothing while a value is refused and a link is bad', async () => {
  const { page, leave } = await site.open('#shimmy=1&color=red&velocity=80');
  await page.locator('.note').waitFor();
  await type(page, 'velocity', 'fast');
  assert.deepEqual(await violations(page), []);
  await leave();
});

test('on a phone every target is large enough for a thumb', async () => {
  const { page, leave } = await site.open('', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await untilVerdict(page, 'It shimmies');
  const small = await page.evaluate(() => [...document.querySelectorAll('button, select, summary, input')]
    // A label takes the press for its radio button.
    .map((element) => ({ name: element.className || element.id || element.tagName, box: (element.closest('label') ?? element).getBoundingClientRect(), isShown: element.checkVisibility({ visibilityProperty: true }) }))
    .filter(({ box, isShown }) => isShown && box.width > 0 && (box.height < 44 || box.width < 44))
    .map(({ name, box }) => `${name} ${box.width} × ${box.height}`));
  assert.deepEqual(small, []);
  await leave();
});

for (const [device, least, options] of /** @type {const} */ ([
  ['a mouse', 24, { viewport: { width: 1440, height: 900 } }],
  ['a projector’s pointer', 24, { viewport: { width: 1024, height: 768 } }],
  ['a thumb', 44, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }],
  ['a finger on a tablet', 44, { viewport: { width: 768, height: 1024 }, hasTouch: true, isMobile: true }],
  ['a finger on a wide tablet', 44, { viewport: { width: 1180, height: 820 }, hasTouch: true, isMobile: true }],
]))
  test(`the lists over the drawings show a mark and are large enough for ${device}`, async () => {
    const { page, leave } = await site.open('', options);
    await untilVerdict(page, 'It shimmies');
    const lists = await page.evaluate(() => ['.magnify', '.shown'].map((name) => {
      const label = /** @type {Element} */ (document.querySelector(name));
      const { width, height, left, top } = label.getBoundingClientRect();
      const hit = document.elementFromPoint(left + width / 2, top + height / 2);
      const mark = getComputedStyle(label, '::before');
      return { name, width, height, isHit: hit?.closest(name) === label, mark: parseFloat(mark.width), content: mark.content };
    }));
    for (const { name, width, height, isHit, mark, content } of lists) {
      assert.ok(width >= least && height >= least, `${name} is ${width} × ${height}`);
      assert.ok(isHit, `${name} is covered`);
      assert.ok(content.includes('▾') && mark >= 20, `the mark of ${name} is ${mark} px`);
    }
    await leave();
  });

test('on a phone the menu has what the dock has no room for', async () => {
  const { page, leave } = await site.open('', { viewport: { width: 390, height: 844 } });
  await untilVerdict(page, 'It shimmies');
  await page.locator('.chips button').first().click();
  await type(page, 'velocity', '60');
  await page.locator('.menu summary').click();
  await page.locator('.menu-sheet').getByRole('button', { name: 'Reset all' }).click();
  assert.equal(await page.locator('shimmy-dock [data-name="velocity"] .number').inputValue(), '80.0');
  await page.keyboard.press('Escape');
  await page.locator('.chips button').last().click();
  const list = await page.locator('.drawer-knobs').boundingBox();
  const dock = await page.locator('shimmy-dock').boundingBox();
  assert.ok(list && dock && dock.y - list.y > 300, 'three values and more are in sight');
  await leave();
});

test('on a phone the gear stays in sight and the page scrolls under it', async () => {
  const { page, leave } = await site.open('', { viewport: { width: 390, height: 844 } });
  await untilVerdict(page, 'It shimmies');
  await page.mouse.move(200, 600);
  await page.mouse.wheel(0, 2000);
  await page.waitForTimeout(200);
  const gear = await page.locator('.gear').boundingBox();
  assert.ok(gear && gear.y >= 0 && gear.y < 10, `the gear is at ${gear?.y}`);
  await leave();
});

test('the keyboard reaches every control, with its focus to be seen', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  const reached = new Set();
  for (let i = 0; i < 60; i++) {
    await page.keyboard.press('Tab');
    const at = await page.evaluate(() => {
      const element = document.activeElement;
      if (!element || element === document.body) return null;
      const { outlineStyle, outlineWidth } = getComputedStyle(element);
      return { name: element.getAttribute('aria-label') ?? element.textContent?.trim() ?? element.id, isSeen: outlineStyle !== 'none' && parseFloat(outlineWidth) >= 2 };
    });
    if (!at) continue;
    assert.ok(at.isSeen, `${at.name} has the focus, unseen`);
    reached.add(at.name);
  }
  for (const name of ['Pause', 'Step back', 'Rate', 'Time', 'Phase', 'Fit', 'Speed, exact number', 'All 15 values ▴'])
    assert.ok(reached.has(name), `${name} is out of reach: ${[...reached].join(' | ')}`);
  await leave();
});

test('a slider obeys the arrow keys: one step, Shift × 10, Alt ÷ 10; a series of them is one undo', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  const number = page.locator('shimmy-dock shimmy-knob[data-name="dampingConstant"] .number');
  await number.focus();
  for (const key of ['ArrowUp', 'Shift+ArrowUp', 'Alt+ArrowUp', 'Shift+ArrowDown']) await page.keyboard.press(key);
  assert.equal(await number.inputValue(), '21.1');
  await page.locator('body').click({ position: { x: 700, y: 25 } });
  await page.keyboard.press('Control+z');
  await page.waitForTimeout(100);
  assert.notEqual(await number.inputValue(), '21.1');
  await leave();
});
