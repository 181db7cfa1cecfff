// The lens Stability beside its planes: Routh's array, modes and their ghost, planes side by side, linear and nonlinear.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { type, untilVerdict, withPage } from './chromium.mjs';

/** @typedef {import('playwright-core').Page} Page */

const axe = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const site = withPage();

const start = '#shimmy=2&velocity=80&dampingConstant=20&initial.torsionAngle=0.05&lens=stability&view.stability=';

/** @param {string} view and what more the link says @param {import('./chromium.mjs').Options} [options] */
async function opened(view, options = {}) {
  const visit = await site.open(start + view, options);
  await visit.page.locator('.stability-panel :is(.panel-scroll, .panel-veil)').waitFor();
  return visit;
}

/** What the parameters are, as the address keeps them. @param {Page} page @param {RegExp} words */
const untilAddress = (page, words) => page.waitForFunction(([source]) => new RegExp(source).test(location.hash), [words.source]);

test('the array says which sign breaks, and a press on a critical speed goes there', async () => {
  const { page, leave } = await opened('routh', { reducedMotion: 'reduce' });
  const rows = page.locator('.routh-array tr');
  assert.equal(await rows.count(), 4);
  assert.equal(await page.locator('.routh-array .breaks').count(), 2);
  assert.match(await page.locator('.routh-formulas .broken').innerText(), /broken/);
  // theory: 27.600 and 501.75 m/s at c = 20, critical damping 48.530 at 80 m/s.
  const names = await page.locator('.routh-criticals button').allInnerTexts();
  assert.deepEqual(names.map((name) => name.replaceAll(/\s+/g, ' ')), ['v = 27.600 m/s', 'v = 501.75 m/s', 'c = 48.530 N m s/rad']);
  await page.getByRole('button', { name: 'Set v = 27.600 m/s' }).click();
  // Set in full, the gear is on the boundary and not a little beyond.
  await untilAddress(page, /velocity=27\.59960634/);
  await page.locator('h2', { hasText: 'On the boundary: 2 roots on the axis' }).waitFor();
  assert.match(await page.locator('.routh-formulas .equal').innerText(), /=[\s\S]*on the boundary/);
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await untilAddress(page, /velocity=80/);
  await type(page, 'dampingConstant', '60');
  await page.locator('h2', { hasText: 'No change of sign' }).waitFor();
  assert.equal(await page.locator('.routh-array .breaks').count(), 0);
  assert.equal(await page.locator('.routh-formulas .broken').count(), 0);
  await leave();
});

test('a mode is chosen, moves as a ghost on the gear, and leaves it with the view', async () => {
  const { page, leave } = await opened('modes', { reducedMotion: 'reduce' });
  const eigenmode = () => page.evaluate(() => /** @type {any} */ (document.querySelector('shimmy-gear')).eigenmode);
  assert.equal(await eigenmode(), '');
  assert.match(await page.locator('.mode-facts').innerText(), /53\.84 Hz[\s\S]*\+13\.2 s⁻¹[\s\S]*Doubles in/);
  // theory: at v = 80, c = 20 the pair is 13.2144 ± 338.264i; tire in = damper + tread + growth.
  const rates = await page.locator('.modes shimmy-energy-bars b').allInnerTexts();
  const [tire, ...others] = rates.map((text) => parseFloat(text.replace('+', '')));
  assert.ok(Math.abs(tire - others.reduce((sum, rate) => sum + rate, 0)) < 0.15, `${rates}`);
  const picture = () => page.evaluate(() => {
    const gear = /** @type {any} */ (document.querySelector('.gear shimmy-canvas'));
    gear.redraw();
    return gear.querySelector('canvas').toDataURL();
  });
  const swinging = await picture();
  await page.getByRole('radio', { name: /^−316/ }).check();
  await untilAddress(page, /view\.mode=real-1/);
  assert.equal(await eigenmode(), 'real-1');
  const aside = await picture();
  assert.notEqual(aside, swinging);
  const before = page.url();
  await page.getByLabel('What the lens shows').selectOption('routh');
  await page.waitForFunction(() => /** @type {any} */ (document.querySelector('shimmy-gear')).eigenmode === null);
  assert.notEqual(await picture(), aside);
  // The run was not touched.
  assert.equal(page.url().replace(/&lens.*/, ''), before.replace(/&lens.*/, ''));
  await leave();
});

test('lists are typed in either way of writing, refusals are explained, a plane opens by a click, the table sorts and leaves', async () => {
  const { page, leave } = await opened('beside', { reducedMotion: 'reduce', acceptDownloads: true });
  const planes = page.locator('.planes-beside button');
  await page.waitForFunction(() => document.querySelectorAll('.figures-table tbody tr').length === 3);
  await page.getByText('Any parameter, any list').click();
  const field = page.locator('.list-field').first();
  const write = async (/** @type {string} */ text) => {
    await field.fill(text);
    await field.press('Enter');
  };
  await write('100 000; abc');
  assert.match(await page.locator('.why-refused').innerText(), /“abc” is not a number/);
  assert.equal(await field.getAttribute('aria-invalid'), 'true');
  await write('-5; 0');
  assert.match(await page.locator('.why-refused').innerText(), /stiffness must be 0 N m\/rad or more/i);
  assert.equal(await planes.count(), 3, 'the planes stay');
  await write('80 000, 40 000');
  await page.waitForFunction(() => document.querySelectorAll('.planes-beside button').length === 2);
  assert.equal(await page.locator('.why-refused').count(), 0);
  await untilAddress(page, /view\.beside=velocity:0\.5:100,casterLength:0:0\.5,torsionalStiffness:80000:40000/);
  await page.getByLabel('A second one').selectOption('halfContactLength');
  const second = page.locator('.list-field').nth(1);
  await second.fill('0,09; 0,11');
  await second.press('Enter');
  await page.waitForFunction(() => document.querySelectorAll('.planes-beside button').length === 4);

  await page.getByRole('button', { name: 'stable %' }).click();
  await page.getByRole('button', { name: 'stable %' }).click();
  await untilAddress(page, /view\.besideSort=share,down/);
  const shares = (await page.locator('.figures-table tbody tr > :last-child').allInnerTexts()).map(Number);
  assert.deepEqual(shares, shares.toSorted((one, other) => other - one));
  assert.equal(await page.locator('th[aria-sort="descending"]').count(), 1);
  const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'CSV', exact: true }).click()]);
  assert.equal(file.suggestedFilename(), 'shimmy-stable-share-torsionalStiffness-halfContactLength.csv');
  const [header, first] = (await readFile(await file.path(), 'utf8')).split('\r\n');
  const varied = 'torsionalStiffness (N m/rad),halfContactLength (m),stableShare (%),velocity from (m/s),velocity to (m/s),casterLength from (m),casterLength to (m)';
  assert.ok(header.startsWith(`${varied},`), header);
  assert.ok(Math.abs(Number(first.split(',')[2]) - shares[0]) < 1e-4);
  // All else that the gear has, so that anyone can make the table anew.
  const fixed = Object.fromEntries(header.split(',').map((name, i) => [name.split(' ')[0], first.split(',')[i]]).slice(varied.split(',').length));
  assert.equal(fixed.dampingConstant, '20');
  assert.equal(fixed.verticalForce, '9000');
  assert.equal(fixed['friction.moment'], '0');
  assert.equal(Object.keys(fixed).length, 11);
  const said = await page.locator('.table-out [role="status"]').boundingBox();
  const footer = await page.locator('#lens-panel footer').boundingBox();
  assert.ok(said && footer && said.y + said.height <= footer.y + 1, 'what came of it is in sight');

  await planes.last().click();
  await page.locator('shimmy-plane').waitFor();
  await untilAddress(page, /torsionalStiffness=40000.*view\.plane=velocity:0\.5:100,casterLength:0:0\.5/);
  assert.match(await page.evaluate(() => location.hash), /halfContactLength=0\.11/);
  await leave();
});

test('a case of the thesis is set by a press, and both histories are taken along as a picture', async () => {
  const { page, leave } = await opened('histories', { reducedMotion: 'reduce', acceptDownloads: true });
  assert.equal(await page.locator('.figures-table tbody tr').count(), 14);
  await page.getByRole('button', { name: /^Set v = 40 m\/s, c = 50/ }).click();
  await untilAddress(page, /velocity=40&dampingConstant=50/);
  await page.locator('.figures-table .now').waitFor();
  await untilVerdict(page, 'It dies out');
  await page.getByLabel('What is shown').selectOption('lateralDeformation');
  await untilAddress(page, /view\.histories=lateralDeformation(&|$)/);
  await page.getByText('Share', { exact: true }).click();
  const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Linear, nonlinear as SVG' }).click()]);
  const drawing = await readFile(await file.path(), 'utf8');
  assert.match(drawing, /^<svg|^<\?xml/);
  assert.match(drawing, /nonlinear/);
  assert.ok(drawing.includes('stroke-dasharray'));
  await leave();
});

test('planes side by side leave as a picture with their shares', async () => {
  const { page, leave } = await opened('beside', { reducedMotion: 'reduce', acceptDownloads: true });
  await page.waitForFunction(() => document.querySelectorAll('.figures-table tbody tr').length === 3);
  const share = (await page.locator('.figures-table tbody tr > :last-child').first().innerText()).slice(0, 5);
  await page.getByText('Share', { exact: true }).click();
  const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Stability planes side by side as SVG' }).click()]);
  const drawing = await readFile(await file.path(), 'utf8');
  assert.equal(drawing.match(/<image /g)?.length, 3);
  assert.ok(drawing.includes(`${share} %`) || drawing.includes(String(Number(share).toFixed(2))), share);
  await leave();
});

test('the sheet offers the pictures that are on the screen, and what came of the last wish does not stand there again', async () => {
  for (const [view, wanted, options] of /** @type {const} */ ([
    ['modes', ['Modes'], {}], ['routh', [], {}], ['beside', ['Stability planes side by side'], {}], ['histories', ['Linear, nonlinear'], {}],
    ['plane', ['Stability plane', 'Roots'], { viewport: { width: 1024, height: 768 } }],
  ])) {
    const { page, leave } = await site.open(start + view, { ...options, reducedMotion: 'reduce', acceptDownloads: true });
    await page.locator('.stability').waitFor();
    await page.locator('.out summary').click();
    const offered = page.locator('.out-picture > span');
    await page.waitForFunction((count) => document.querySelectorAll('.out-picture').length === count, wanted.length + 2);
    assert.deepEqual((await offered.allInnerTexts()).slice(2), wanted, view);
    if (view === 'modes') {
      for (const format of ['PNG', 'SVG']) {
        const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: `Modes as ${format}` }).click()]);
        await page.locator('.out-said', { hasText: file.suggestedFilename() }).waitFor();
      }
      await page.keyboard.press('Escape');
      await page.locator('.out summary').click();
      await page.waitForFunction(() => document.querySelector('.out-said')?.textContent === '');
    }
    await leave();
  }
});

test('what is to be guessed is hidden in every view, from readers too', async () => {
  for (const view of ['modes', 'routh', 'beside', 'histories']) {
    const { page, leave } = await opened(`${view}&predict=1`, { reducedMotion: 'reduce' });
    assert.equal(await page.locator('.panel-veil').count(), 1, view);
    assert.match(await page.locator('.panel-veil').innerText(), /Hidden until you have guessed/);
    assert.equal(await page.locator('.stability-panel :is(table, shimmy-canvas, dl, button, .panel-scroll)').count(), 0, view);
    assert.equal(await page.evaluate(() => /** @type {any} */ (document.querySelector('shimmy-gear')).eigenmode), null);
    assert.equal(await page.locator('#lens-panel footer p').innerText(), '', 'nothing is said of what is hidden');
    assert.equal(await page.locator('#lens-panel footer button').count(), view === 'histories' ? 1 : 0, 'only what has a scale is fitted');
    await leave();
  }
});

test('a table of the thesis with another gear says so, and gets its values by a press', async () => {
  const { page, leave } = await opened('beside&freeplayAngle=0.0174533', { reducedMotion: 'reduce' });
  const note = page.locator('.strangers');
  assert.match(await note.innerText(), /Not the thesis’ gear\. Other values: c, .*\. Inside the gap no spring works/);
  await note.getByRole('button').click();
  await note.waitFor({ state: 'detached' });
  await leave();
});

test('with freeplay every verdict is linear theory', async () => {
  const gap = '&freeplayAngle=0.0174533';
  for (const [view, where] of /** @type {const} */ ([['modes', '.theory'], ['routh', '.routh h2']])) {
    const { page, leave } = await opened(view + gap, { reducedMotion: 'reduce' });
    assert.match(await page.locator(where).innerText(), /linear theory/, view);
    assert.match(await page.locator('#lens-panel footer p').innerText(), /Linear theory inside the gap/, view);
    await leave();
  }
});

test('figures and tables open from the search', async () => {
  const { page, leave } = await opened('routh', { reducedMotion: 'reduce' });
  for (const [query, shown] of /** @type {const} */ ([['table 5.6', '.beside'], ['figure 5.31', 'shimmy-plane'], ['table 5.7', '.histories'], ['figure 5.79', '.both-histories'], ['table 5.1', 'shimmy-drawer']])) {
    await page.getByRole('combobox', { name: 'Presets, figures, lessons' }).fill(query);
    await page.getByRole('listbox').getByRole('option').first().click();
    await page.locator(shown).waitFor();
  }
  // Over the values of table 5.1 the way on and out of it stays.
  await page.getByRole('button', { name: 'Back to what you had' }).click({ timeout: 3000 });
  await page.locator('shimmy-drawer').waitFor({ state: 'detached' });
  await leave();
});

for (const [name, options] of /** @type {const} */ ([
  ['a desk, dark', { viewport: { width: 1440, height: 900 }, colorScheme: 'dark' }],
  ['a projector', { viewport: { width: 1024, height: 768 } }],
  ['a phone, in Turkish', { viewport: { width: 390, height: 844 }, locale: 'tr-TR', hasTouch: true }],
]))
  test(`all views can be read by everyone: ${name}`, async () => {
    for (const view of ['modes', 'routh', 'beside', 'histories']) {
      const { page, leave } = await opened(view, { ...options, reducedMotion: 'reduce' });
      await page.evaluate(axe);
      const violations = await page.evaluate(async () => (await /** @type {any} */ (window).axe.run('#lens-panel')).violations);
      assert.deepEqual(violations.map((/** @type {any} */ { id, nodes }) => [id, nodes.map((/** @type {any} */ { html }) => html)]), [], view);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth > innerWidth), false, `${view}: nothing sticks out`);
      if (view === 'histories') assert.equal(await page.locator('.figures-table').evaluate((table) => table.scrollWidth > table.clientWidth), false, 'no column is out of sight');
      await leave();
    }
  });
