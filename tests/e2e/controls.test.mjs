// The knobs: what their tracks tell, what follows what, what a name opens, and the units they speak in.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { knob, type, untilVerdict, withPage } from './chromium.mjs';

/** @typedef {import('playwright-core').Page} Page */

const site = withPage();

/** @param {Page} page @param {string} name @param {'dock' | 'drawer'} [place] */
const placed = (page, name, place = 'dock') => page.locator(`shimmy-${place} shimmy-knob[data-name="${name}"]`);

/** What a knob's track tells: numbers, caption, hatched places in per cent. @param {Page} page @param {string} name @param {'dock' | 'drawer'} [place] */
async function scent(page, name, place) {
  const one = placed(page, name, place);
  return {
    numbers: await one.locator('.scent-number').allInnerTexts(),
    caption: await one.locator('.scent-caption').allInnerTexts().then((texts) => texts.join()),
    hatches: await one.locator('.hatch').evaluateAll((all) => all.map((hatch) => {
      const track = /** @type {HTMLElement} */ (hatch.parentElement).getBoundingClientRect();
      const box = hatch.getBoundingClientRect();
      return [box.left, box.right].map((x) => Math.round((100 * (x - track.left)) / track.width));
    })),
    // How widely it will swing is said, too, as soon as that is known.
    said: (await one.locator('.slider').getAttribute('aria-description'))?.replace(/(^|\. )Swings .*/, '') || null,
  };
}

/** @param {Page} page */
const openDrawer = (page) => page.locator('shimmy-dock button[aria-expanded]:not(.name):visible').first().click();

test('a track is hatched where the gear shimmies, with tick, number and caption', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  // Speed 27.600 of 1 … 120, damping 48.530 of 0 … 200, caster −0.0431 and 0.3190 of −0.5 … 0.5.
  assert.deepEqual(await scent(page, 'velocity'), { numbers: ['27.6'], caption: 'shimmies above', hatches: [[22, 100]], said: 'shimmies above 27.6 m/s' });
  assert.deepEqual(await scent(page, 'dampingConstant'), { numbers: ['48.6'], caption: 'dies out above', hatches: [[0, 24]], said: 'dies out above 48.6 N m s/rad' });
  assert.deepEqual(await scent(page, 'casterLength'), { numbers: ['−0.044', '0.319'], caption: 'shimmies between', hatches: [[46, 82]], said: 'shimmies between −0.044 m and 0.319 m' });
  assert.deepEqual(await scent(page, 'freeplayAngle'), { numbers: [], caption: '', hatches: [], said: null });
  assert.equal(await placed(page, 'casterLength').locator('.tick').count(), 2);
  await leave();
});

test('a scent moves while another value is dragged', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  const box = await knob(page, 'dampingConstant').slider.boundingBox();
  assert.ok(box);
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + 14 + 0.1 * (box.width - 28), y);
  await page.mouse.down();
  await page.mouse.move(box.x + 14 + 0.2 * (box.width - 28), y, { steps: 8 });
  // At c = 40 it shimmies from 51.88 m/s on; the hand has not let go.
  await page.waitForFunction(() => document.querySelector('[data-name="velocity"] .scent-number')?.textContent === '51.8');
  const value = Number(await knob(page, 'dampingConstant').number.inputValue());
  assert.ok(Math.abs(value - 40) < 0.3, `${value}`);
  await page.mouse.move(box.x + 14 + 0.3 * (box.width - 28), y, { steps: 8 });
  await placed(page, 'velocity').locator('.hatch').waitFor({ state: 'detached' });
  assert.equal((await scent(page, 'velocity')).said, 'dies out everywhere here');
  await page.mouse.up();
  await leave();
});

test('with freeplay the captions speak of linear theory, and never of dying out', async () => {
  const { page, leave } = await site.open('#shimmy=1&dampingConstant=100&freeplayAngle=0.017453292519943295&initial.torsionAngle=0.05');
  await untilVerdict(page, 'It rattles in the gap');
  assert.deepEqual(await scent(page, 'dampingConstant'), {
    numbers: ['39.0'], caption: 'linear theory: stable above', hatches: [[0, 19]], said: 'linear theory, spring engaged: stable above 39.0 N m s/rad',
  });
  await openDrawer(page);
  await page.locator('shimmy-drawer .scent-caption').first().waitFor();
  const said = await page.locator('.scent-caption').allInnerTexts();
  assert.ok(said.length >= 5, `${said}`);
  for (const caption of said) assert.match(caption, /^linear theory(, spring engaged)?: /);
  await leave();
});

for (const [width, height] of [[1440, 900], [1100, 700], [1024, 768], [720, 450], [390, 844]])
  test(`labels stay apart and on their track at ${width} × ${height}, in both languages`, async () => {
    for (const locale of ['en-US', 'tr-TR'])
      for (const freeplayAngle of [0, 0.01]) {
        const { page, leave } = await site.open(`#shimmy=1&velocity=80&dampingConstant=20&freeplayAngle=${freeplayAngle}&initial.torsionAngle=0.05`,
          { viewport: { width, height }, locale });
        await page.locator('shimmy-dock .scent-number').first().waitFor();
        await openDrawer(page);
        await page.locator('shimmy-drawer .scent-number').first().waitFor();
        const wrong = await page.evaluate(() => [...document.querySelectorAll('.scent')].flatMap((row) => {
          const track = row.getBoundingClientRect();
          const boxes = [...row.querySelectorAll('span')].map((label) => ({ text: label.textContent, box: label.getBoundingClientRect() }));
          return boxes.flatMap(({ text, box }, i) => [
            ...(box.left < track.left - 1 || box.right > track.right + 1 ? [`${text} leaves its track`] : []),
            ...boxes.slice(i + 1).filter((other) => box.left < other.box.right && other.box.left < box.right && box.top < other.box.bottom - 1 && other.box.top < box.bottom - 1)
              .map((other) => `${text} over ${other.text}`),
          ]);
        }));
        assert.deepEqual(wrong, []);
        await leave();
      }
  });

for (const [width, height] of [[1440, 900], [1366, 768], [1100, 700], [1024, 768], [720, 450], [390, 844], [360, 640]])
  test(`no knob's name and no number is cut at ${width} × ${height}, wherever it stands, in both languages`, async () => {
    for (const locale of ['en-US', 'tr-TR']) {
      const { page, leave } = await site.open('', { viewport: { width, height }, locale, reducedMotion: 'reduce' });
      await page.locator('shimmy-dock .scent-number').first().waitFor();
      await page.evaluate(() => document.fonts.ready);
      const cut = await page.evaluate(async () => {
        const dock = /** @type {any} */ (document.querySelector('shimmy-dock'));
        const names = dock.quantities.map((/** @type {{ name: string }} */ { name }) => name);
        // All can be brought back, so each line has all that it may have.
        const usual = Object.fromEntries(names.map((/** @type {string} */ name) => [name, -1]));
        const found = new Set();
        for (let turn = 0; turn < names.length; turn++) {
          Object.assign(dock, { knobs: [...names.slice(turn), ...names.slice(0, turn)], usual });
          await dock.updateComplete;
          await new Promise((drawn) => requestAnimationFrame(drawn));
          for (const line of dock.querySelectorAll('.knob-line')) {
            const name = line.querySelector('.name > span:last-child');
            const { right } = name.getBoundingClientRect();
            const isCut = name.scrollWidth > name.clientWidth || right > line.querySelector('.number').getBoundingClientRect().left;
            const number = line.querySelector('.number');
            if (number.scrollWidth > number.clientWidth) found.add(`${name.textContent} ${number.value}`);
            if (isCut || line.lastElementChild.getBoundingClientRect().right > line.getBoundingClientRect().right + 0.5) found.add(name.textContent);
          }
        }
        return [...found];
      });
      assert.deepEqual(cut, [], locale);
      await leave();
    }
  });

test('what is veiled has no scent, nor has what a screen reader says of it', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await openDrawer(page);
  await page.evaluate(() => {
    for (const element of document.querySelectorAll('shimmy-dock, shimmy-drawer')) Object.assign(element, { isVeiled: true });
  });
  await page.locator('.hatch').first().waitFor({ state: 'detached' });
  assert.equal(await page.locator('.hatch, .tick, .scent-number, .scent-caption').count(), 0);
  assert.equal(await page.locator('.slider[aria-description]').count(), 0);
  await leave();
});

test('a chain is parted and joined from either end; a linked value follows, and parts under the hand', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await openDrawer(page);
  const chain = (/** @type {string} */ name) => placed(page, name, 'drawer').locator('.chain').first();
  const number = (/** @type {string} */ name) => placed(page, name, 'drawer').locator('.number');
  const set = async (/** @type {string} */ name, /** @type {string} */ text) => {
    await number(name).fill(text);
    await number(name).press('Enter');
  };
  assert.equal(await chain('relaxationLength').getAttribute('aria-pressed'), 'true');
  assert.equal(await placed(page, 'relaxationLength', 'drawer').getByRole('button', { name: 'The relaxation length follows the half contact length' }).count(), 1);
  assert.equal(await placed(page, 'halfContactLength', 'drawer').locator('.chain').count(), 2);
  await set('halfContactLength', '0.12');
  assert.equal(await number('relaxationLength').inputValue(), '0.360');
  // κ = 0.15 · 0.12² · 20 · 9000.
  assert.equal(await number('treadWidthMomentConstant').inputValue(), '388.8');
  await chain('halfContactLength').click();
  assert.equal(await chain('relaxationLength').getAttribute('aria-pressed'), 'false');
  await set('halfContactLength', '0.1');
  assert.equal(await number('relaxationLength').inputValue(), '0.360');
  assert.equal(await number('treadWidthMomentConstant').inputValue(), '270');
  await chain('relaxationLength').click();
  assert.equal(await number('relaxationLength').inputValue(), '0.300');
  await set('treadWidthMomentConstant', '300');
  assert.equal(await chain('treadWidthMomentConstant').getAttribute('aria-pressed'), 'false', 'what is set by hand follows no more');
  await leave();
});

test('a name opens its meaning and the equations with its symbol lit, by the keyboard, and gives the focus back', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  const sheet = page.locator('shimmy-explanation');
  const name = placed(page, 'velocity').locator('.name');
  await name.focus();
  await page.keyboard.press('Enter');
  await sheet.waitFor();
  assert.equal(await name.getAttribute('aria-expanded'), 'true');
  assert.match(await sheet.innerText(), /Taxiing velocity, constant during a run\..*Any value > 0 is valid\./);
  assert.match(await sheet.innerText(), /50\.0 m\/s/);
  assert.equal(await sheet.locator('math .lit').count(), 3);
  const accent = await page.evaluate(() => {
    const probe = document.body.appendChild(document.createElement('i'));
    probe.style.color = 'var(--psi)';
    const { color } = getComputedStyle(probe);
    probe.remove();
    return color;
  });
  assert.equal(await sheet.locator('math .lit mi').first().evaluate((symbol) => getComputedStyle(symbol).color), accent);
  const [stage, box] = [await page.locator('shimmy-stage').boundingBox(), await sheet.boundingBox()];
  assert.ok(stage && box && box.x >= stage.x + stage.width - 1, 'it covers the gear');
  assert.ok(await sheet.evaluate((element) => element.contains(document.activeElement)), 'the focus is elsewhere');
  await page.keyboard.press('Escape');
  await sheet.waitFor({ state: 'detached' });
  await page.waitForFunction(() => document.activeElement?.classList.contains('name'));
  assert.ok(await name.evaluate((element) => element === document.activeElement));
  await leave();
});

test('the meaning is closed by a press elsewhere, changed by another name, and is in Turkish, too', async () => {
  const { page, leave } = await site.open('', { locale: 'tr-TR' });
  await untilVerdict(page, 'Shimmy var');
  const sheet = page.locator('shimmy-explanation');
  await placed(page, 'dampingConstant').locator('.name').click();
  assert.match(await sheet.innerText(), /Burulma sönüm katsayısı/);
  await placed(page, 'casterLength').locator('.name').click();
  assert.match(await sheet.innerText(), /Kaster boyu/);
  assert.equal(await sheet.locator('math .lit').count(), 2);
  await placed(page, 'casterLength').locator('.name').click();
  await sheet.waitFor({ state: 'detached' });
  await placed(page, 'casterLength').locator('.name').click();
  await sheet.waitFor();
  await page.locator('.gear').click({ position: { x: 30, y: 400 } });
  await sheet.waitFor({ state: 'detached' });
  await leave();
});

test('every value has its meaning, and its equations do not run out of their sheet', async () => {
  for (const viewport of [{ width: 1440, height: 900 }, { width: 1024, height: 768 }, { width: 390, height: 844 }]) {
    const { page, leave } = await site.open('', { viewport });
    await untilVerdict(page, 'It shimmies');
    await openDrawer(page);
    const names = page.locator('shimmy-drawer .name');
    assert.equal(await names.count(), 15);
    for (const name of await names.all()) {
      await name.click();
      const sheet = page.locator('shimmy-explanation');
      await sheet.waitFor();
      assert.ok(await sheet.locator('math .lit').count() > 0);
      const cut = await sheet.locator('.equations li').evaluateAll((rows) => rows.filter((row) => row.scrollWidth > row.clientWidth).map((row) => row.textContent));
      assert.deepEqual(cut, []);
      await sheet.getByRole('button', { name: 'Close' }).click();
      await sheet.waitFor({ state: 'detached' });
    }
    await leave();
  }
});

test('a speed is shown, typed and refused in knots, and the choice stays', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  const { number, refusal } = knob(page, 'velocity');
  const unit = placed(page, 'velocity').locator('.unit');
  const place = await knob(page, 'velocity').slider.inputValue();
  await unit.click();
  assert.equal(await unit.innerText(), 'kn');
  assert.equal(await number.inputValue(), '155.5');
  assert.equal(await knob(page, 'velocity').slider.inputValue(), place, 'the thumb has moved');
  assert.deepEqual((await scent(page, 'velocity')).numbers, ['53.6']);
  assert.ok(await page.getByRole('button', { name: 'Undo', exact: true }).isDisabled(), 'a unit is no change of the run');
  await type(page, 'velocity', '100,5');
  assert.equal(await number.inputValue(), '100.5');
  // 100.5 kn = 51.7017 m/s.
  await page.waitForURL(/#.*velocity=51\.7016/);
  assert.match(page.url(), /view\.velocityUnit=kn/);
  await type(page, 'velocity', '-3');
  assert.equal(await refusal.innerText(), 'Speed must be above 0 kn. It stays at 100.5.');
  assert.equal(await placed(page, 'velocity').locator('.scent').isVisible(), false, 'sentence and numbers share a place');
  await number.press('Escape');
  await number.press('ArrowUp');
  assert.equal(await number.inputValue(), '101.5');
  await number.press('Alt+ArrowDown');
  assert.equal(await number.inputValue(), '101.4');
  await number.press('Shift+ArrowDown');
  assert.equal(await number.inputValue(), '91.4');
  await unit.click();
  assert.equal(await unit.innerText(), 'km/h');
  await unit.click();
  assert.equal(await unit.innerText(), 'm/s');
  await unit.click();
  await page.waitForURL(/view\.velocityUnit=kn/);
  await page.reload();
  await untilVerdict(page, 'It shimmies');
  assert.equal(await unit.innerText(), 'kn');
  await leave();
});

test('the reader’s own unit stays where a link names none', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  const unit = placed(page, 'velocity').locator('.unit');
  await unit.click();
  await page.waitForURL(/view\.velocityUnit=kn/);
  await page.evaluate(() => { location.hash = '#shimmy=2&velocity=60&dampingConstant=20&initial.torsionAngle=0.05'; });
  await page.waitForFunction(() => /** @type {HTMLInputElement} */ (document.querySelector('[data-name="velocity"] .number')).value === '116.6');
  assert.equal(await unit.innerText(), 'kn');
  await page.evaluate(() => { location.hash = '#shimmy=2&velocity=60&dampingConstant=20&initial.torsionAngle=0.05&view.velocityUnit=km/h'; });
  await page.waitForFunction(() => /** @type {HTMLInputElement} */ (document.querySelector('[data-name="velocity"] .number')).value === '216');
  await leave();
});

test('the dock shows the knobs that its layout has room for, a story’s before the usual ones', async () => {
  const shown = async (/** @type {Page} */ page) => page.locator('shimmy-dock shimmy-knob').evaluateAll((all) => all.map((one) => /** @type {HTMLElement} */ (one).dataset.name));
  const { page, leave } = await site.open('#shimmy=1&velocity=80&dampingConstant=25&initial.torsionAngle=0.05');
  await untilVerdict(page, 'It shimmies');
  assert.deepEqual(await shown(page), ['velocity', 'dampingConstant', 'casterLength', 'freeplayAngle']);
  await page.setViewportSize({ width: 1024, height: 768 });
  await page.waitForFunction(() => document.querySelectorAll('shimmy-dock shimmy-knob').length === 2);
  assert.deepEqual(await shown(page), ['velocity', 'dampingConstant']);
  await leave();

  const story = await site.open('#shimmy=2&story=freeplay');
  await story.page.locator('shimmy-dock [data-name="velocity"]').waitFor();
  assert.deepEqual(await shown(story.page), ['freeplayAngle', 'velocity', 'dampingConstant', 'casterLength']);
  await story.page.setViewportSize({ width: 1024, height: 768 });
  await story.page.waitForFunction(() => document.querySelectorAll('shimmy-dock shimmy-knob').length === 2);
  assert.deepEqual(await shown(story.page), ['freeplayAngle', 'velocity']);
  await story.page.setViewportSize({ width: 390, height: 844 });
  await story.page.waitForFunction(() => document.querySelectorAll('shimmy-dock shimmy-knob').length === 1);
  assert.deepEqual(await shown(story.page), ['freeplayAngle']);
  await story.page.locator('.chips button', { hasText: 'Speed' }).click();
  await story.page.waitForFunction(() => document.querySelector('shimmy-dock shimmy-knob')?.getAttribute('data-name') === 'velocity');
  await story.leave();
});

test('the linear gear has its own values, groups and equations', async () => {
  const { page, leave } = await site.open('#shimmy=2&model=torsional-linear&velocity=80&dampingConstant=60&initial.torsionAngle=0.02');
  await untilVerdict(page, 'It dies out');
  await openDrawer(page);
  assert.equal(await page.locator('shimmy-drawer shimmy-knob').count(), 12);
  assert.deepEqual(await page.locator('shimmy-drawer h3').allInnerTexts(), ['Motion and load', 'Gear', 'Tire', 'MR damper']);
  assert.deepEqual((await scent(page, 'dampingConstant', 'drawer')).numbers, ['48.6']);
  await placed(page, 'casterLength', 'drawer').locator('.name').click();
  assert.equal(await page.locator('shimmy-explanation .equations li').count(), 3);
  assert.equal(await page.locator('shimmy-explanation math .lit').count(), 2);
  await leave();
});

for (const [width, height, colorScheme] of /** @type {const} */ ([[1440, 900, 'light'], [390, 844, 'dark']]))
  test(`axe-core finds nothing in knobs, drawer and meaning at ${width} × ${height}, ${colorScheme}`, async () => {
    const axe = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
    const { page, leave } = await site.open('', { viewport: { width, height }, colorScheme });
    await untilVerdict(page, 'It shimmies');
    await page.evaluate(axe);
    const violations = (/** @type {string[]} */ ...include) => page.evaluate(async (within) => {
      const found = await /** @type {any} */ (window).axe.run({ include: within });
      return found.violations.flatMap((/** @type {any} */ { id, nodes }) => nodes.map((/** @type {any} */ { target, failureSummary }) => `${id} ${target}: ${failureSummary}`));
    }, include);
    await openDrawer(page);
    await placed(page, 'halfContactLength', 'drawer').locator('.chain').first().click();
    assert.deepEqual(await violations('shimmy-dock', 'shimmy-drawer'), []);
    await placed(page, 'halfContactLength', 'drawer').locator('.name').click();
    // On its way up it is pale.
    await page.locator('shimmy-explanation').evaluate((sheet) => Promise.all(sheet.getAnimations().map(({ finished }) => finished)));
    assert.deepEqual(await violations('shimmy-explanation'), []);
    await leave();
  });
