// A hand on the wheel: mouse, finger, keys; and what may take the wheel out of it.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { untilVerdict, verdict, withPage } from './chromium.mjs';
import { drawn, shown } from './frames.mjs';

/** @typedef {import('playwright-core').Page} Page */

const degrees = 180 / Math.PI;
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

const site = withPage();

/** @param {import('playwright-core').BrowserContextOptions} [options] @param {string} [hash] */
async function paused(options, hash = '') {
  const visit = await site.open(hash, options);
  await visit.page.locator('shimmy-verdict h1').waitFor();
  await visit.page.getByRole('button', { name: 'Pause', exact: true }).click();
  await visit.page.getByRole('button', { name: 'Play', exact: true }).waitFor();
  await visit.page.waitForTimeout(300);
  return visit;
}

/** Where the wheel is: its middle and its rear. @param {Page} page */
async function wheelOf(page) {
  const box = await page.locator('shimmy-wheel').boundingBox();
  assert.ok(box);
  return { middle: { x: box.x + box.width / 2, y: box.y + box.height / 2 }, rear: { x: box.x + 0.2 * box.width, y: box.y + box.height / 2 } };
}

const wheel = (/** @type {Page} */ page) => page.getByRole('slider', { name: 'Wheel' });
const undo = (/** @type {Page} */ page) => page.getByRole('button', { name: 'Undo' });
const angleOf = async (/** @type {Page} */ page) => (await shown(page)).state[0] * degrees;

/** @param {Page} page @param {number} angle */
const untilAngle = (page, angle) => page.waitForFunction((wanted) =>
  Math.abs(/** @type {any} */ (document.querySelector('shimmy-stage')).scene.state[0] * (180 / Math.PI) - wanted) < 1e-3, angle);

test('the mouse twists the wheel; let go, the run goes on from there; one undo takes it back', async () => {
  const { page, leave } = await paused();
  const before = await shown(page);
  const { rear } = await wheelOf(page);
  await page.mouse.move(rear.x, rear.y);
  assert.equal(await page.locator('shimmy-gear').evaluate((gear) => gear.style.cursor), 'grab');
  await page.mouse.down();
  assert.equal(await page.locator('shimmy-gear').evaluate((gear) => gear.style.cursor), 'grabbing');
  // Behind the axis, down is counter-clockwise.
  await page.mouse.move(rear.x, rear.y + 30, { steps: 4 });
  await untilVerdict(page, 'In your hand');
  const twisted = await angleOf(page);
  assert.ok(twisted > before.state[0] * degrees + 5, `${twisted}°`);
  assert.equal((await shown(page)).time, before.time, 'a paused run stands');
  await page.mouse.move(rear.x, rear.y - 30, { steps: 4 });
  await page.waitForTimeout(100);
  assert.ok(await angleOf(page) < before.state[0] * degrees - 5);
  await page.mouse.move(rear.x, rear.y + 20, { steps: 2 });
  await page.waitForTimeout(100);
  const last = await angleOf(page);
  await page.mouse.up();
  await untilVerdict(page, 'It shimmies');
  assert.ok(Math.abs(await angleOf(page) - last) < 1e-9);
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await page.waitForTimeout(400);
  assert.ok(Math.abs(await angleOf(page) - last) > 0.1, 'the run stands still');
  await page.getByRole('button', { name: 'Pause', exact: true }).click();
  await undo(page).click();
  await page.waitForTimeout(200);
  const after = await shown(page);
  assert.ok(Math.abs(after.time - before.time) < 1e-9);
  after.state.forEach((value, i) => assert.ok(Math.abs(value - before.state[i]) < 1e-9 * Math.max(1, Math.abs(value))));
  assert.ok(await undo(page).isDisabled(), 'one hold is one undo');
  await leave();
});

test('while the run plays the ground rolls on under a held wheel', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  const { middle } = await wheelOf(page);
  await page.mouse.move(middle.x, middle.y);
  await page.mouse.down();
  await untilVerdict(page, 'In your hand');
  await page.mouse.move(middle.x, middle.y + 12, { steps: 2 });
  await page.waitForTimeout(200);
  const one = await shown(page);
  await page.waitForTimeout(600);
  const other = await shown(page);
  assert.ok(other.time > one.time, 'time stands still');
  assert.equal(other.state[0], one.state[0]);
  assert.equal(other.state[1], 0);
  await page.mouse.up();
  await untilVerdict(page, 'It shimmies');
  await leave();
});

test('a tap on the wheel is a kick, and a step of undo', async () => {
  const { page, leave } = await paused();
  const before = await shown(page);
  const { middle } = await wheelOf(page);
  await page.mouse.click(middle.x, middle.y);
  await page.waitForTimeout(200);
  const after = await shown(page);
  // 10 N m s about an axis with 1 kg m².
  assert.ok(Math.abs(after.state[1] - before.state[1] - 10) < 1e-6, `${after.state[1] - before.state[1]} rad/s`);
  assert.ok(Math.abs(after.state[0] - before.state[0]) < 1e-9);
  await undo(page).click();
  assert.ok(await undo(page).isDisabled());
  await leave();
});

test('the arrow keys twist the wheel by half a degree, with Shift by 2.5; Enter and Escape let go, and so does leaving it', async () => {
  const { page, leave } = await paused();
  const start = await angleOf(page);
  await wheel(page).focus();
  await page.keyboard.press('ArrowLeft');
  await untilAngle(page, start + 0.5);
  await page.keyboard.press('Shift+ArrowLeft');
  await page.keyboard.press('ArrowRight');
  await untilAngle(page, start + 2.5);
  await untilVerdict(page, 'In your hand');
  await page.waitForFunction((text) => document.querySelector('[aria-label="Wheel"]')?.getAttribute('aria-valuetext') === text, `${(start + 2.5).toFixed(1).replace('-', '−')}°`);
  await page.keyboard.press('Enter');
  await untilVerdict(page, 'It shimmies');
  assert.ok(!await undo(page).isDisabled());
  await undo(page).click();
  await untilAngle(page, start);
  for (const letGo of [() => page.keyboard.press('Escape'), () => page.keyboard.press('Tab')]) {
    await wheel(page).focus();
    await page.keyboard.press('ArrowRight');
    await untilVerdict(page, 'In your hand');
    await letGo();
    await untilVerdict(page, 'It shimmies');
  }
  await leave();
});

test('what takes the wheel out of the hand: a lost pointer, another window, another time, a stop', async () => {
  const { page, leave } = await paused();
  const { middle, rear } = await wheelOf(page);
  const grab = async () => {
    await page.mouse.move(rear.x, rear.y);
    await page.mouse.down();
    await page.mouse.move(rear.x, rear.y + 10);
    await untilVerdict(page, 'In your hand');
  };
  /** @type {[string, () => Promise<unknown>][]} */
  const ways = [
    ['a lost pointer', async () => {
      await page.evaluate(() => document.querySelector('shimmy-gear')?.releasePointerCapture(1));
      await page.mouse.move(rear.x, rear.y + 11);
    }],
    ['another window', () => page.evaluate(() => window.dispatchEvent(new Event('blur')))],
    ['the way back to the start', () => page.keyboard.press('r')],
    ['undo', () => page.keyboard.press('Control+z')],
  ];
  for (const [what, act] of ways) {
    await grab();
    await act();
    await untilVerdict(page, 'It shimmies');
    await drawn(page);
    const angle = await angleOf(page);
    await page.mouse.move(middle.x - 20, middle.y - 20);
    await page.waitForTimeout(150);
    assert.equal(await verdict(page), 'It shimmies', what);
    assert.ok(Math.abs(await angleOf(page) - angle) < 1e-9, `${what}: the hand still turns it`);
    await page.mouse.up();
  }
  await grab();
  await page.evaluate(() => { location.hash = '#shimmy=2&relaxationLength=1e-300&initial.torsionAngle=0.05'; });
  await page.locator('.verdict-message', { hasText: 'The run stopped' }).waitFor();
  await page.mouse.move(middle.x, middle.y + 30);
  await page.mouse.up();
  assert.equal(await page.locator('.verdict-message').innerText(), 'The run stopped');
  await leave();
});

test('a window that changes its size under the hand does not turn the wheel', async () => {
  const { page, leave } = await paused();
  const { rear } = await wheelOf(page);
  await page.mouse.move(rear.x, rear.y);
  await page.mouse.down();
  await page.mouse.move(rear.x, rear.y + 15, { steps: 2 });
  await untilVerdict(page, 'In your hand');
  const angle = await angleOf(page);
  await page.setViewportSize({ width: 1300, height: 820 });
  await page.waitForTimeout(200);
  await page.mouse.move(rear.x, rear.y + 15);
  await page.mouse.move(rear.x + 1, rear.y + 15);
  await page.waitForTimeout(100);
  assert.ok(Math.abs(await angleOf(page) - angle) < 1.5, `${await angleOf(page)}° instead of ${angle}°`);
  await page.mouse.up();
  await leave();
});

/** Fingers on the screen. @param {Page} page */
async function fingers(page) {
  const session = await page.context().newCDPSession(page);
  const send = (/** @type {'touchStart' | 'touchMove' | 'touchEnd'} */ type, /** @type {{ x: number, y: number }[]} */ ...points) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map((point, id) => ({ ...point, id })) });
  const drag = async (/** @type {{ x: number, y: number }} */ from, /** @type {{ x: number, y: number }} */ by) => {
    await send('touchStart', from);
    for (let i = 1; i <= 8; i++) {
      await send('touchMove', { x: from.x + (by.x * i) / 8, y: from.y + (by.y * i) / 8 });
      await page.waitForTimeout(20);
    }
  };
  return { send, drag };
}

test('a finger on the wheel twists it and the page stays; beside it the page scrolls', async () => {
  const { page, leave } = await paused(phone);
  const { send, drag } = await fingers(page);
  const before = await angleOf(page);
  const { rear } = await wheelOf(page);
  await drag(rear, { x: 0, y: 24 });
  await untilVerdict(page, 'In your hand');
  assert.ok(await angleOf(page) > before + 4, `${await angleOf(page)}°`);
  assert.equal(await page.evaluate(() => scrollY), 0, 'the page scrolls under the hand');
  const held = await angleOf(page);
  await send('touchStart', { x: rear.x, y: rear.y + 24 }, { x: 60, y: 300 });
  await send('touchMove', { x: rear.x, y: rear.y + 24 }, { x: 60, y: 250 });
  await page.waitForTimeout(100);
  assert.equal(await verdict(page), 'In your hand', 'a second finger');
  assert.ok(Math.abs(await angleOf(page) - held) < 0.5);
  await send('touchEnd');
  await untilVerdict(page, 'It shimmies');

  await drag({ x: 340, y: 300 }, { x: 0, y: -200 });
  await send('touchEnd');
  await page.waitForFunction(() => scrollY > 20);
  assert.equal(await verdict(page), 'It shimmies');
  await leave();
});

test('on a phone a swipe shows the gear from the right, and the dots do', async () => {
  const { page, leave } = await paused(phone);
  const { send, drag } = await fingers(page);
  const above = page.getByRole('button', { name: 'From above' });
  const right = page.getByRole('button', { name: 'From the right' });
  assert.equal(await above.getAttribute('aria-pressed'), 'true');
  await drag({ x: 300, y: 290 }, { x: -120, y: 6 });
  await send('touchEnd');
  await page.locator('.pager [aria-pressed="true"][aria-label="From the right"]').waitFor();
  assert.equal(await wheel(page).count(), 0, 'a wheel that is not seen cannot be twisted');
  await drag({ x: 100, y: 200 }, { x: 120, y: -6 });
  await send('touchEnd');
  await page.locator('.pager [aria-pressed="true"][aria-label="From above"]').waitFor();
  await right.click();
  assert.equal(await right.getAttribute('aria-pressed'), 'true');
  await page.setViewportSize({ width: 1440, height: 900 });
  await page.locator('.pager').waitFor({ state: 'detached' });
  assert.equal(await wheel(page).count(), 1);
  await leave();
});

test('angles and tire are drawn as large as a hand chooses, and the link keeps it', async () => {
  const { page, leave } = await paused();
  const choice = page.getByRole('combobox', { name: 'How much larger' });
  assert.match(await choice.locator('option').first().innerText(), /now × 1\)$/);
  await choice.selectOption('10');
  await page.waitForURL(/view\.magnification=10/);
  const link = page.url();
  await leave();
  const again = await paused(undefined, new URL(link).hash);
  assert.equal(await again.page.getByRole('combobox', { name: 'How much larger' }).inputValue(), '10');
  // The hand turns what is drawn: in truth a tenth of it.
  const before = await angleOf(again.page);
  const { rear } = await wheelOf(again.page);
  await again.page.mouse.move(rear.x, rear.y);
  await again.page.mouse.down();
  await again.page.mouse.move(rear.x, rear.y + 20, { steps: 3 });
  await untilVerdict(again.page, 'In your hand');
  const turned = Math.abs(await angleOf(again.page) - before);
  assert.ok(turned > 0.2 && turned < 3, `${turned}°`);
  await again.page.mouse.up();
  await again.leave();
});

test('a ghost goes on beside the run, named by what differs; a fifth is explained', async () => {
  const { page, leave } = await paused();
  const pin = page.getByRole('button', { name: /^Pin ghost/ });
  await pin.click();
  await page.getByRole('button', { name: 'Pin ghost (1)' }).waitFor();
  for (let i = 0; i < 3; i++) await pin.click();
  assert.equal(await pin.getAttribute('aria-disabled'), 'true');
  await pin.press('Enter');
  await page.locator('.note', { hasText: '4 ghosts are on the sheet' }).waitFor();
  await leave();
});
