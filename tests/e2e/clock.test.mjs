// The clock: slow, strobe and real, the timeline and its cursors. Frames and their times are the test's where it counts.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { before, test } from 'node:test';
import init, { simulate } from '../../www/pkg/shimmy.js';
import { untilVerdict, withPage } from './chromium.mjs';
import { frames, shown, takeFrames } from './frames.mjs';

/** @typedef {import('playwright-core').Page} Page */

const degrees = 180 / Math.PI;

const site = withPage();
before(async () => {
  await init({ module_or_path: await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)) });
});

/** The engine's own run of the opening. @param {number[]} times ascending, in s */
const opening = (times) => simulate({
  model: 'torsional', parameters: { velocity: 80, dampingConstant: 20 }, initial: { torsionAngle: 0.05 }, times: [0, ...times], rtol: 1e-9,
});

/** @param {Page} page @param {string} name */
const press = (page, name) => page.getByRole('button', { name, exact: true }).click();
const label = async (/** @type {Page} */ page) => (await page.locator('.scale').innerText()).replaceAll('\u00a0', ' ');

/** Paused at the start of the run, with the frames in hand. @param {import('playwright-core').BrowserContextOptions} [options] @param {string} [hash] */
async function atStart(options, hash = '') {
  const { page, leave } = await site.open(hash, options);
  await page.locator('shimmy-verdict h1').waitFor();
  await press(page, 'Pause');
  await press(page, 'Back to the start');
  await page.getByRole('button', { name: 'Play', exact: true }).waitFor();
  await takeFrames(page);
  return { page, leave };
}

test('under the strobe the swing is seen at 1 Hz while it grows at 1.18 times its true pace', async () => {
  const { page, leave } = await atStart();
  await press(page, 'Strobe');
  assert.equal(await label(page), 'one flash a cycle');
  await press(page, 'Play');
  await frames(page, 240, 60);
  const seen = await frames(page, 300, 60);
  const flashes = seen.filter(({ time }, i) => i > 0 && time !== seen[i - 1].time);
  // At 51.87 Hz and 60 frames a second a flash comes with most frames: 51.87 to 60 a second.
  assert.ok(flashes.length > 250 && flashes.length <= 300, `${flashes.length} flashes in 5 s`);
  const pace = (seen[299].time - seen[0].time) / (299 / 60);
  assert.ok(Math.abs(pace - 1.18) < 0.02, `${pace} times true`);
  const crossings = flashes.filter(({ state }, i) => i > 0 && state[0] > 0 !== flashes[i - 1].state[0] > 0).length;
  assert.ok(crossings === 10 || crossings === 9 || crossings === 11, `${crossings / 2} cycles in 5 s`);
  const widest = Math.max(...flashes.map(({ state }) => Math.abs(state[0])));
  // From flash to flash a sixtieth of a cycle: never more than 2π/50 of the swing.
  flashes.slice(1).forEach(({ state }, i) => assert.ok(Math.abs(state[0] - flashes[i].state[0]) < 0.13 * widest, 'the wheel jumps'));
  const { torsionAngle } = opening([flashes[200].time]);
  assert.ok(Math.abs(torsionAngle[1] - flashes[200].state[0]) < 1e-5, 'a flash shows an instant of the run');
  await leave();
});

test('the run does not depend on how many frames show it', async () => {
  /** @type {number[][]} */
  const states = [];
  for (const rate of [30, 60, 144]) {
    const { page, leave } = await atStart();
    await press(page, 'Play');
    const seen = await frames(page, 2 * rate + 1, rate);
    const { time, state } = seen[seen.length - 1];
    assert.ok(Math.abs(time - 2 / 50) < 1e-9, `${time} s after two seconds`);
    states.push(state);
    await leave();
  }
  for (const state of states.slice(1)) state.forEach((value, i) => assert.ok(Math.abs(value - states[0][i]) < 1e-9 * Math.max(1, Math.abs(value))));
});

test('a tab that was hidden for an hour goes on from where it was seen', async () => {
  const { page, leave } = await atStart();
  await press(page, 'Play');
  const [before] = (await frames(page, 10, 60)).slice(-1);
  const [later] = await frames(page, 1, 1 / 3600);
  assert.ok(later.time - before.time <= 0.1 / 50 + 1e-12, `${later.time - before.time} s of the run have gone by`);
  await leave();
});

test('real time is a fan of poses, and says so; a pause shows one', async () => {
  const { page, leave } = await atStart();
  await press(page, 'Real');
  assert.equal(await label(page), 'too fast for the screen');
  await press(page, 'Play');
  const seen = await frames(page, 31, 60);
  assert.ok(Math.abs(seen[30].time - 0.5) < 1e-9, 'not real time');
  assert.equal((await shown(page)).fan, 16);
  await press(page, 'Pause');
  await frames(page, 1, 60);
  assert.equal((await shown(page)).fan, null);
  await leave();
});

test('the list of rates says which are too fast and too slow; any but a true one is a fan', async () => {
  const { page, leave } = await atStart();
  const rate = page.getByRole('combobox', { name: 'Rate' });
  const options = await rate.locator('option').allInnerTexts();
  assert.equal(options.length, 10);
  assert.equal(options[0], 'As this run needs it');
  assert.match(options[4], /^Slow 1\/10 · too fast for the screen$/);
  assert.match(options[6], /^Slow 1\/50 · a cycle in 0\.9\d s$/);
  assert.match(options[9], /^Slow 1\/500 · too slow to see it swing, 9\.\d s a cycle$/);
  await rate.selectOption('10');
  assert.equal(await label(page), 'too fast for the screen');
  await press(page, 'Play');
  await frames(page, 3, 60);
  assert.equal((await shown(page)).fan, 16);
  await rate.selectOption('100');
  assert.match(await label(page), /^1 s .*= 10 ms/);
  await frames(page, 2, 60);
  assert.equal((await shown(page)).fan, null);
  await page.waitForURL(/slow=100/);
  await rate.selectOption('');
  await page.waitForURL((url) => !url.hash.includes('slow='));
  assert.equal(await label(page), '1 s = 20 ms');
  await leave();
});

test('from the strobe back to slow the keyboard finds the list', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await press(page, 'Strobe');
  assert.equal(await page.getByRole('button', { name: 'Strobe' }).getAttribute('aria-pressed'), 'true');
  await page.getByRole('button', { name: 'Slow 1/50' }).press('Enter');
  assert.equal(await page.evaluate(() => document.activeElement?.getAttribute('aria-label')), 'Rate');
  await leave();
});

test('where the wheel does not swing the strobe has nothing to lock to', async () => {
  const { page, leave } = await site.open('#shimmy=2&velocity=80&dampingConstant=60&clock=strobe');
  await untilVerdict(page, 'It rests');
  assert.match(await label(page), /^no steady beat/, 'in full or in short, as there is room');
  await press(page, 'Kick');
  await page.locator('.scale', { hasText: 'one flash a cycle' }).waitFor();
  await leave();
});

test('where less motion is asked for there is neither strobe nor real, and it says why', async () => {
  const { page, leave } = await site.open('#shimmy=2&velocity=80&dampingConstant=20&initial.torsionAngle=0.05&clock=real', { reducedMotion: 'reduce' });
  await untilVerdict(page, 'It shimmies');
  const strobe = page.getByRole('button', { name: 'Strobe' });
  assert.equal(await strobe.getAttribute('aria-disabled'), 'true');
  assert.equal(await label(page), '1 s = 20 ms');
  await strobe.press('Enter');
  assert.match(await label(page), /less motion/);
  assert.equal(await strobe.getAttribute('aria-pressed'), 'false');
  assert.ok(await page.getByRole('button', { name: 'Step on' }).evaluate((button) => button.classList.contains('primary')));
  await leave();
});

test('one step on and one back is where it was', async () => {
  const { page, leave } = await atStart();
  await press(page, 'Step on');
  await press(page, 'Step on');
  const [two] = await frames(page, 1, 60);
  assert.ok(Math.abs(two.time - 0.002) < 1e-12);
  await press(page, 'Step on');
  await press(page, 'Step back');
  assert.deepEqual(await frames(page, 1, 60), [two]);
  await leave();
});

test('scrubbed to the start and to the end of the lane', async () => {
  const { page, leave } = await atStart();
  await page.keyboard.press('End');
  const time = page.getByRole('slider', { name: 'Time' });
  const lane = await page.locator('shimmy-timeline').boundingBox();
  assert.ok(lane);
  const drag = async (/** @type {number} */ from, /** @type {number} */ to) => {
    const y = lane.y + 0.15 * lane.height;
    await page.mouse.move(lane.x + from * lane.width, y);
    await page.mouse.down();
    await page.mouse.move(lane.x + to * lane.width, y, { steps: 3 });
    await page.mouse.up();
    return (await frames(page, 1, 60))[0];
  };
  const end = Number(await time.getAttribute('aria-valuemax'));
  assert.ok(Math.abs((await drag(0.3, 0.94)).time - end) < 0.02 * end, 'the end of the lane is the end of the run');
  const start = await drag(0.5, 0);
  assert.equal(start.time, 0);
  assert.deepEqual(start.state, [0.05, 0, 0]);
  await leave();
});

/** What the timeline has written since, in order. @param {Page} page */
async function recordWords(page) {
  await page.evaluate(() => {
    const { fillText } = CanvasRenderingContext2D.prototype;
    const written = Object.assign(window, { written: /** @type {string[]} */ ([]) }).written;
    CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) {
      if (this.canvas.closest('shimmy-timeline')) written.push(text);
      return fillText.call(this, text, ...rest);
    };
  });
  return (/** @type {RegExp} */ pattern) => page.evaluate((source) => {
    const { written } = /** @type {any} */ (window);
    return written.splice(0).filter((/** @type {string} */ text) => new RegExp(source).test(text)).at(-1) ?? null;
  }, pattern.source);
}

test('the mouse over the lower lane reads what the engine computes; clicks pin it and give the difference; Escape takes it away', async () => {
  const { page, leave } = await atStart();
  await page.getByRole('slider', { name: 'Time' }).focus();
  for (let i = 0; i < 20; i++) await page.keyboard.press('Shift+ArrowRight');
  const [{ time: now }] = await frames(page, 1, 60);
  assert.ok(Math.abs(now - 0.2) < 1e-9);
  const read = await recordWords(page);
  const lane = await page.locator('shimmy-timeline').boundingBox();
  assert.ok(lane);
  // As lanesOf has it, with type of 13 px: from −80 ms to +20 ms between these two.
  const [left, right] = [lane.x + 4.4 * 13, lane.x + lane.width - 1.6 * 13];
  const at = (/** @type {number} */ offset) => left + ((offset + 0.08) / 0.1) * (right - left);
  const y = lane.y + 0.75 * lane.height;

  await page.mouse.move(at(-0.03), y);
  const one = await read(/ago/);
  const [, ago, angle, peaks, hertz] = one?.match(/^(\d+) ms ago · (\S+)° · pk–pk (\S+)° · (\S+) Hz$/) ?? [];
  assert.equal(ago, '30', `${one}`);
  const times = Array.from({ length: 1001 }, (_, i) => 0.12 + (0.08 * i) / 1000);
  const { torsionAngle } = opening(times);
  const truth = torsionAngle[1 + Math.round((now - 0.03 - 0.12) / 8e-5)] * degrees;
  assert.ok(Math.abs(Number(angle.replace('−', '-')) - truth) < 0.2, `${angle}° instead of ${truth}°`);
  const zeros = times.filter((_, i) => i > 0 && torsionAngle[i] < 0 !== torsionAngle[i + 1] < 0);
  const before = zeros.findLastIndex((zero) => zero <= now - 0.03);
  const beats = [before - 1, before].map((i) => 1 / (zeros[i + 2] - zeros[i]));
  assert.ok(beats.some((beat) => Math.abs(beat - Number(hertz)) < 0.4), `${hertz} Hz instead of ${beats}`);
  const cycle = torsionAngle.slice(1).filter((_, i) => Math.abs(times[i] - (now - 0.03)) < 0.01);
  assert.ok(Math.abs(Number(peaks) - (Math.max(...cycle) - Math.min(...cycle)) * degrees) < 0.6, `${peaks}° from peak to peak`);

  await page.mouse.click(at(-0.04), y);
  await page.mouse.click(at(-0.02), y);
  await page.mouse.move(lane.x + 0.5 * lane.width, lane.y - 40);
  await frames(page, 1, 60);
  const two = await read(/Δt/);
  const [, apart, inverse] = two?.match(/^Δt (\S+) ms · 1\/Δt (\S+) Hz · Δψ \S+°$/) ?? [];
  assert.ok(Math.abs(Number(apart) - 20) < 0.3 && Math.abs(Number(inverse) - 50) < 0.8, `${two}`);
  await page.getByRole('slider', { name: 'Time' }).focus();
  await page.keyboard.press('Escape');
  await read(/./);
  await page.keyboard.press('ArrowLeft');
  await frames(page, 1, 60);
  assert.equal(await read(/Δt|ago/), null);
  await leave();
});

test('with the keys Enter brings a cursor that is read out, and the arrows move it instead of the time', async () => {
  const { page, leave } = await site.open('', { reducedMotion: 'reduce' });
  await untilVerdict(page, 'It shimmies');
  const slider = page.getByRole('slider', { name: 'Time' });
  await slider.focus();
  const time = await slider.getAttribute('aria-valuenow');
  await page.keyboard.press('Enter');
  assert.match(await slider.getAttribute('aria-valuetext') ?? '', /^now · /);
  for (let i = 0; i < 12; i++) await page.keyboard.press('ArrowLeft');
  assert.match(await slider.getAttribute('aria-valuetext') ?? '', /^12 ms ago · \S+° · pk–pk \d+\.\d° · 5\d\.\d Hz$/);
  assert.equal(await slider.getAttribute('aria-valuenow'), time);
  await page.keyboard.press('Enter');
  await page.keyboard.press('Shift+ArrowLeft');
  assert.match(await slider.getAttribute('aria-valuetext') ?? '', /^Δt −10\.0 ms · 1\/Δt 100\.0 Hz · Δψ /);
  await page.keyboard.press('Escape');
  assert.match(await slider.getAttribute('aria-valuetext') ?? '', /^\d\.\d+ s into the run/);
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction((before) => document.querySelector('.timeline-grip')?.getAttribute('aria-valuenow') !== before, time);
  await leave();
});

test('the lower lane shows another state when asked, and the link keeps it', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  const read = await recordWords(page);
  await page.getByRole('combobox', { name: 'What the lane shows' }).selectOption('lateralDeformation');
  await page.waitForURL(/view\.timeline=lateralDeformation/);
  assert.match(await read(/deformation/) ?? '', /lateral deformation, mm/);
  await leave();
});
