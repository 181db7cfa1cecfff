// What a visitor does, in both places where the page must work.

import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { gearPixels, knob, type, untilVerdict, verdict, withPage } from './chromium.mjs';
import { fileAddress } from './site.mjs';

const site = withPage();

/** @type {[string, () => string][]} */
const places = [['a server, under a sub-path', () => site.address], ['a file', () => fileAddress]];

for (const [place, address] of places) {
  describe(`from ${place}`, () => {
    test('it opens running: the wheel moves, and shimmies', async () => {
      const { page, leave } = await site.openAt(address());
      await untilVerdict(page, 'It shimmies');
      const one = await gearPixels(page);
      await page.waitForTimeout(150);
      const other = await gearPixels(page);
      // The wheel is in the middle of the upper rows; the ground moves too, so many places change.
      assert.ok(one.filter((sum, i) => sum !== other[i]).length > 8, 'the drawing stands still');
      assert.equal(await page.getByRole('button', { name: 'Pause', exact: true }).count(), 1);
      await leave();
    });

    test('the cycle at 80 m/s and 20 N m s/rad is read off the page', async () => {
      const { page, leave } = await site.openAt(address());
      await page.locator('.destination', { hasText: '0.26508 rad' }).waitFor();
      assert.match(await page.locator('.destination').innerText(), /±15\.188° \(0\.26508 rad\) · 51\.87 Hz/);
      await leave();
    });

    test('the damping dragged past its boundary, it dies out; undone, it shimmies again', async () => {
      const { page, leave } = await site.openAt(address());
      await untilVerdict(page, 'It shimmies');
      const { slider, number } = knob(page, 'dampingConstant');
      const box = await slider.boundingBox();
      assert.ok(box);
      const y = box.y + box.height / 2;
      await page.mouse.move(box.x + 14 + 0.1 * (box.width - 28), y);
      await page.mouse.down();
      await page.mouse.move(box.x + 0.2 * box.width, y, { steps: 5 });
      await page.mouse.move(box.x + 0.4 * box.width, y, { steps: 10 });
      await page.mouse.up();
      await untilVerdict(page, 'It dies out');
      assert.ok(Number(await number.inputValue()) > 60);
      assert.equal(await page.locator('.destination').innerText(), 'No limit cycle from here: this swing dies out.');
      await page.getByRole('button', { name: 'Undo' }).click();
      await untilVerdict(page, 'It shimmies');
      assert.equal(await number.inputValue(), '20.0');
      assert.ok(await page.getByRole('button', { name: 'Undo' }).isDisabled(), 'one drag is one undo');
      await page.getByRole('button', { name: 'Redo' }).click();
      await untilVerdict(page, 'It dies out');
      await leave();
    });

    test('both decimal signs are taken; what is refused is explained, and the run keeps the last good value', async () => {
      const { page, leave } = await site.openAt(address());
      await untilVerdict(page, 'It shimmies');
      const { number, refusal } = knob(page, 'velocity');
      await type(page, 'velocity', '60,5');
      assert.equal(await number.inputValue(), '60.5');
      await type(page, 'velocity', '-3');
      assert.equal(await refusal.innerText(), 'Speed must be above 0 m/s. It stays at 60.5.');
      assert.equal(await number.getAttribute('aria-invalid'), 'true');
      await type(page, 'velocity', 'fast');
      assert.equal(await refusal.innerText(), 'That is not a number. Speed stays at 60.5.');
      await type(page, 'velocity', '1e400');
      assert.equal(await refusal.innerText(), 'Speed is too large to compute with. It stays at 60.5.');
      await type(page, 'freeplayAngle', '-1');
      assert.equal(await knob(page, 'freeplayAngle').refusal.innerText(), 'Freeplay, half gap must be 0° or more. It stays at 0.00.');
      assert.equal(await verdict(page), 'It shimmies');
      await type(page, 'velocity', '60.50');
      assert.equal(await number.inputValue(), '60.5', 'written as all numbers are');
      await type(page, 'velocity', '70.25');
      assert.equal(await refusal.innerText(), '');
      assert.equal(await number.inputValue(), '70.25');
      await leave();
    });

    test('a link brings everything back', async () => {
      const { page, leave } = await site.openAt(address());
      await untilVerdict(page, 'It shimmies');
      await type(page, 'velocity', '50');
      await type(page, 'dampingConstant', '100');
      await type(page, 'freeplayAngle', '1');
      await untilVerdict(page, 'It rattles in the gap');
      await page.getByRole('combobox', { name: 'Rate' }).selectOption('25');
      await page.waitForURL(/slow=25/);
      const link = page.url();
      assert.match(link, /#shimmy=2&dampingConstant=100&freeplayAngle=0\.0174\d+&initial\.torsionAngle=0\.05&was\.velocity=80&was\.dampingConstant=20&was\.freeplayAngle=0&do=[\d.]+,velocity:50&do=[\d.]+,dampingConstant:100&do=[\d.]+,freeplayAngle:0\.0174\d+&time=[\d.]+&slow=25$/);
      await leave();

      const again = await site.openAt(link);
      await untilVerdict(again.page, 'It rattles in the gap');
      assert.equal(await knob(again.page, 'freeplayAngle').number.inputValue(), '1.00');
      assert.equal(await again.page.getByRole('combobox', { name: 'Rate' }).inputValue(), '25');
      assert.match(await again.page.locator('.destination').innerText(), /0\.022268 rad/);
      await again.leave();
    });

    test('a bad link opens what could be read and lists what could not', async () => {
      const { page, leave } = await site.openAt(`${address()}#shimmy=1&velocity=-3&dampingConstant=60&color=red&initial.torsionAngle=0.05`);
      await untilVerdict(page, 'It dies out');
      assert.equal(await page.locator('.note').innerText().then((text) => text.split('\n')[0]),
        'Not all of the link could be read: velocity = -3 (not allowed), so it is 50; color (unknown).');
      assert.equal(await knob(page, 'dampingConstant').number.inputValue(), '60.0');
      assert.equal(await knob(page, 'velocity').number.inputValue(), '50.0');
      await leave();
    });

    test('in Turkish, with its own decimal sign, kept for the next visit', async () => {
      const { page, leave } = await site.openAt(address());
      await untilVerdict(page, 'It shimmies');
      await page.keyboard.press('?');
      await page.getByRole('radio', { name: 'Türkçe' }).check();
      await untilVerdict(page, 'Shimmy var');
      assert.equal(await knob(page, 'velocity').number.inputValue(), '80,0');
      assert.equal(await page.locator('html').getAttribute('lang'), 'tr');
      await type(page, 'dampingConstant', '-1');
      assert.equal(await knob(page, 'dampingConstant').refusal.innerText(), 'Sönüm en az 0 N m s/rad olmalı. 20,0 olarak kaldı.');
      await page.waitForTimeout(400);
      await page.reload();
      await untilVerdict(page, 'Shimmy var');
      await leave();
    });
  });
}

test('the clock pauses, steps, scrubs back and starts anew', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  const time = async () => Number(await page.getByRole('slider', { name: 'Time' }).getAttribute('aria-valuenow'));
  await page.waitForTimeout(900);
  await page.keyboard.press(' ');
  await page.getByRole('button', { name: 'Play', exact: true }).waitFor();
  await page.waitForTimeout(400);
  const paused = await time();
  assert.ok(paused > 0.01, `${paused} s after a second`);
  await page.waitForTimeout(400);
  assert.equal(await time(), paused);

  await page.getByRole('button', { name: 'Step on' }).click();
  await page.waitForTimeout(400);
  assert.ok(Math.abs((await time()) - paused - 0.001) < 6e-4);
  await page.keyboard.press('ArrowLeft');

  const lane = await page.locator('shimmy-timeline').boundingBox();
  assert.ok(lane);
  await page.mouse.move(lane.x + 0.6 * lane.width, lane.y + 0.75 * lane.height);
  await page.mouse.down();
  await page.mouse.move(lane.x + 0.65 * lane.width, lane.y + 0.75 * lane.height, { steps: 4 });
  await page.mouse.up();
  await page.waitForTimeout(400);
  assert.ok((await time()) < paused - 0.002, 'the strip was not taken along');

  await page.mouse.click(lane.x + 0.8 * lane.width, lane.y + 0.15 * lane.height);
  await page.waitForTimeout(400);
  assert.ok((await time()) > 0.2, 'a press on the whole run goes there');
  await page.getByRole('button', { name: 'Back to the start' }).click();
  await page.waitForTimeout(400);
  assert.equal(await time(), 0);
  await leave();
});

test('while it stands still the words follow every change, however quick', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await page.keyboard.press(' ');
  await page.getByRole('button', { name: 'Play', exact: true }).waitFor();
  await type(page, 'dampingConstant', '31');
  for (const key of ['ArrowUp', 'ArrowUp', 'ArrowUp', 'Shift+ArrowUp']) await page.keyboard.press(key);
  await page.locator('.verdict-numbers', { hasText: 'heads for ±6.4°' }).waitFor({ timeout: 5000 });
  await page.locator('.destination', { hasText: '±6.434°' }).waitFor({ timeout: 5000 });
  await leave();
});

test('a wheel at rest is kicked', async () => {
  const { page, leave } = await site.open('#shimmy=1&velocity=80&dampingConstant=60');
  await untilVerdict(page, 'It rests');
  await page.getByRole('button', { name: 'Kick' }).click();
  await untilVerdict(page, 'It dies out');
  await leave();
});

test('an absurd value stops the run, not the page, and is undone', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await type(page, 'casterLength', '500000');
  await page.locator('.note', { hasText: 'with Caster = 500\u202f000 m it leaves' }).waitFor();
  assert.match(await knob(page, 'casterLength').refusal.innerText(), /^Set, though far beyond the slider/);
  assert.equal(await page.locator('.verdict-message').innerText(), 'The run stopped');
  await page.locator('.note').getByRole('button', { name: 'Undo' }).click();
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await untilVerdict(page, 'It shimmies');
  assert.equal(await page.locator('.note').count(), 0);
  await leave();
});

test('what stopped the run may be mended by hand, and the complaint goes', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await page.getByRole('button', { name: 'All 15 values' }).click();
  const relaxation = page.locator('shimmy-drawer shimmy-knob[data-name="relaxationLength"] .number');
  await relaxation.fill('1e-300');
  await relaxation.press('Enter');
  await page.locator('.note', { hasText: 'with Relaxation length = 1e−300 m' }).waitFor();
  assert.equal(await relaxation.inputValue(), '1e−300');
  await relaxation.fill('0.3');
  await relaxation.press('Enter');
  await untilVerdict(page, 'It shimmies');
  assert.equal(await page.locator('.note').count(), 0);
  await leave();
});

test('a link with an absurd value opens stopped, and Reset all gets it going', async () => {
  const { page, leave } = await site.open('#shimmy=1&relaxationLength=1e-300&initial.torsionAngle=0.05');
  await page.locator('.note', { hasText: 'The run stopped at 0.000 s' }).waitFor();
  await page.getByRole('button', { name: 'Reset all' }).click();
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await untilVerdict(page, 'It shimmies');
  assert.equal(await page.locator('.note').count(), 0);
  await leave();
});

test('all values are in a drawer beside the gear, each live', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await page.getByRole('button', { name: 'All 15 values' }).click();
  const drawer = page.locator('shimmy-drawer');
  assert.equal(await drawer.locator('shimmy-knob').count(), 15);
  const stage = await page.locator('shimmy-stage').boundingBox();
  const sheet = await drawer.boundingBox();
  assert.ok(stage && sheet && sheet.x >= stage.x + stage.width - 1, 'the drawer covers the gear');
  const stiffness = drawer.locator('shimmy-knob[data-name="torsionalStiffness"] .number');
  await stiffness.fill('300000');
  await stiffness.press('Enter');
  await page.waitForURL(/torsionalStiffness=300000/);
  await page.keyboard.press('Escape');
  await drawer.waitFor({ state: 'detached' });
  assert.equal(await page.evaluate(() => document.activeElement?.textContent?.trim()), 'All 15 values ▴', 'the focus is lost');
  await leave();
});

test('with reduced motion it opens paused, the whole run drawn', async () => {
  const { page, leave } = await site.open('', { reducedMotion: 'reduce' });
  await untilVerdict(page, 'It shimmies');
  await page.getByRole('button', { name: 'Play', exact: true }).waitFor();
  const one = await gearPixels(page);
  await page.waitForTimeout(300);
  assert.deepEqual(await gearPixels(page), one);
  // The future's band reaches the right end of the run's lane.
  const drawn = await page.locator('shimmy-timeline canvas').evaluate((/** @type {HTMLCanvasElement} */ canvas) => {
    const copy = /** @type {OffscreenCanvasRenderingContext2D} */ (new OffscreenCanvas(1, canvas.height).getContext('2d', { willReadFrequently: true }));
    copy.drawImage(canvas, -Math.round(canvas.width * 0.9), 0);
    // The upper lane is the upper third; its zero line alone would be a single row.
    return [...Array(Math.round(canvas.height / 3)).keys()].filter((y) => copy.getImageData(0, y, 1, 1).data[3] > 0).length;
  });
  assert.ok(drawn > 10, `${drawn} rows of the future are drawn`);
  const time = page.getByRole('slider', { name: 'Time' });
  assert.ok(Number(await time.getAttribute('aria-valuenow')) > 0.1, 'the past is empty');
  assert.ok(await page.getByRole('button', { name: 'Step on' }).evaluate((button) => button.classList.contains('primary')));
  await leave();
});

test('the time takes the keys of a slider', async () => {
  const { page, leave } = await site.open('', { reducedMotion: 'reduce' });
  await untilVerdict(page, 'It shimmies');
  const time = page.getByRole('slider', { name: 'Time' });
  await time.focus();
  const after = async (/** @type {string} */ key) => {
    await time.press(key);
    await page.waitForTimeout(400);
    return Number(await time.getAttribute('aria-valuenow'));
  };
  assert.equal(await after('Home'), 0);
  const end = await after('End');
  assert.ok(end > 0.2);
  const before = await after('Shift+ArrowLeft');
  assert.ok(Math.abs(end - before - 0.01) < 1e-3, `${before} of ${end} s`);
  assert.ok(await after('ArrowRight') > before);
  await leave();
});

test('a change by the keyboard is spoken once it is made', async () => {
  const { page, leave } = await site.open('', { reducedMotion: 'reduce' });
  await untilVerdict(page, 'It shimmies');
  const { slider } = knob(page, 'dampingConstant');
  await slider.focus();
  await slider.press('Shift+ArrowUp');
  assert.equal(await slider.getAttribute('aria-valuetext'), '30.0 N m s/rad');
  await page.locator('shimmy-verdict [aria-live]', { hasText: 'heads for ±11.8°' }).waitFor({ timeout: 5000 });
  // What is seen goes on changing: an old verdict beside it would contradict it.
  await page.waitForFunction(() => document.querySelector('shimmy-verdict [aria-live]')?.textContent === '');
  await leave();
});

test('keys are the page’s again once a number is entered, and after a click on a lens', async () => {
  const { page, leave } = await site.open('#shimmy=2&velocity=80&dampingConstant=20&initial.torsionAngle=0.05');
  await untilVerdict(page, 'It shimmies');
  const field = page.locator('shimmy-dock shimmy-knob[data-name="dampingConstant"] .number');
  await field.fill('33');
  await field.press('p');
  assert.equal(await field.inputValue(), '33p', 'what is being typed is the field’s');
  await field.fill('33');
  await field.press('Enter');
  await page.waitForURL(/dampingConstant:33/);
  await field.press('Control+z');
  await page.waitForURL((url) => !url.hash.includes('dampingConstant:33'));
  await page.waitForFunction(() => /** @type {HTMLInputElement} */ (document.querySelector('shimmy-dock shimmy-knob[data-name="dampingConstant"] .number')).value === '20.0');
  const isPlaying = () => page.getByRole('button', { name: 'Pause', exact: true }).count();
  assert.equal(await isPlaying(), 1);
  await field.press(' ');
  assert.equal(await isPlaying(), 0);
  assert.equal(await field.inputValue(), '20.0');
  await page.getByRole('tab', { name: 'Forces' }).click();
  await page.keyboard.press(' ');
  assert.equal(await isPlaying(), 1);
  assert.equal(await page.getByRole('tab', { name: 'Forces' }).getAttribute('aria-selected'), 'true');
  // Who came there by the keyboard presses what has the focus.
  await page.keyboard.press('Tab');
  await page.keyboard.press('Shift+Tab');
  await page.keyboard.press(' ');
  assert.equal(await isPlaying(), 1);
  await leave();
});

test('while the engine is slow to come the gear is there, at rest, and says what it waits for', async () => {
  const context = await site.browser.newContext({ viewport: { width: 1440, height: 900 } });
  const page = await context.newPage();
  /** @type {() => void} */
  let arrive = () => {};
  const arrived = new Promise((done) => { arrive = () => done(undefined); });
  await page.route('**/*.wasm', async (route) => {
    await arrived;
    await route.continue();
  });
  await page.goto(site.address, { waitUntil: 'commit' });
  await page.locator('.verdict-message', { hasText: 'Starting the engine' }).waitFor();
  assert.ok(new Set(await gearPixels(page)).size > 20, 'the gear is not drawn');
  arrive();
  await untilVerdict(page, 'It shimmies');
  assert.equal(await page.locator('.verdict-message').count(), 0);
  await context.close();
});

test('where WebAssembly is refused the picture stays, with the reason', async () => {
  const context = await site.browser.newContext({ viewport: { width: 1440, height: 900 } });
  const page = await context.newPage();
  await page.addInitScript(() => {
    const refuse = () => Promise.reject(new Error('no modules today'));
    Object.assign(WebAssembly, { compile: refuse, compileStreaming: refuse });
  });
  await page.goto(site.address);
  await page.locator('.verdict-message', { hasText: 'no modules today' }).waitFor();
  const drawn = await gearPixels(page);
  assert.ok(new Set(drawn).size > 20, 'the gear is not drawn');
  await context.close();
});
