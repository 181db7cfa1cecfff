// The lens Cycles: the gear's cycle, its branches that a hand meets, live tables that can be taken along, and how it is hidden.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import init, * as engine from '../../www/pkg/shimmy.js';
import { viewNames } from '../../www/lens/cycles/settings.js';
import { knob, type, untilVerdict, withPage } from './chromium.mjs';

await init({ module_or_path: await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)) });
const axe = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

const site = withPage();

/** @typedef {import('playwright-core').Page} Page */

const gear = '#shimmy=2&velocity=80&dampingConstant=20&initial.torsionAngle=0.05&lens=cycles';

/** @param {string} [more] @param {import('./chromium.mjs').Options} [options] */
const opened = async (more = '', options) => {
  const visit = await site.open(gear + more, options);
  await visit.page.locator('shimmy-cycles-lens .cycles').waitFor();
  return visit;
};

/** Waits until an element says so. @param {Page} page @param {string} selector @param {RegExp} words */
const untilSaid = (page, selector, words) => page.locator(selector).filter({ hasText: words }).first().waitFor({ timeout: 5000 });

test('the tab opens the lens, which comes then; the cycle follows the values, and is said to be none where there is none', async () => {
  const { page, leave, requests } = await site.open();
  await untilVerdict(page, 'It shimmies');
  assert.ok(!requests.some((url) => url.includes('cycles')), 'the page does not wait for it');
  await page.getByRole('tab', { name: 'Cycles' }).click();
  await untilSaid(page, '.cycle-facts h2', /^A stable limit cycle$/);
  // theory.md 3 and reference.json: 0.26508 rad at 51.867 Hz; with c = 30 0.20632 rad.
  await untilSaid(page, '.cycle-facts', /±15\.19°.*0\.26508 rad/s);
  await untilSaid(page, '.cycle-facts', /51\.867 Hz/);
  await type(page, 'dampingConstant', '30');
  await untilSaid(page, '.cycle-facts', /0\.20632 rad/);
  assert.match(await page.locator('.multipliers canvas').getAttribute('aria-label') ?? '', /0\.696; 0\.00475/);
  await type(page, 'dampingConstant', '60');
  await untilSaid(page, '.cycle-facts h2', /^No limit cycle here/);
  await page.getByRole('button', { name: 'Undo' }).click();
  await untilSaid(page, '.cycle-facts', /0\.20632 rad/);
  await page.waitForURL(/lens=cycles/);
  await leave();
});

test('in space the orbit is turned by a hand and by keys, and a link opens it as it was', async () => {
  const { page, leave } = await opened('&view.cycleOrbit=space');
  await page.locator('.turntable').focus();
  await page.keyboard.press('ArrowLeft');
  await page.waitForURL(/view\.cycleOrbit=space,100,20/);
  const link = page.url();
  await leave();
  const again = await site.openAt(link);
  await again.page.locator('.turntable').waitFor();
  assert.equal(await again.page.getByRole('combobox', { name: 'How the cycle is drawn' }).inputValue(), 'space');
  await again.leave();
});

/** The branch of the gear over the speed, as the engine has it. */
const branch = engine.bifurcation({ model: 'torsional', parameters: { velocity: 80, dampingConstant: 20 }, parameter: 'velocity', from: 1, to: 120 }).cycles[0];

/** Waits until the branches are there. @param {Page} page */
const untilBranches = (page) => page.waitForFunction(() => /Branches of cycles: 1\./.test(document.querySelector('.branch-plane canvas')?.getAttribute('aria-label') ?? ''));

test('a press on a branch puts the gear on that very cycle, and one undo takes value and motion back', async () => {
  const { page, leave } = await opened('&view.cycles=branch&time=0.2');
  await page.getByRole('button', { name: 'Pause' }).click();
  await untilBranches(page);
  const box = await page.locator('.branch-plane canvas').boundingBox();
  assert.ok(box);
  await page.mouse.click(box.x + box.width * 0.45, box.y + box.height * 0.2);
  await page.waitForFunction(() => /** @type {HTMLInputElement} */ (document.querySelector('shimmy-dock [data-name="velocity"] .number')).value !== '80.0');
  const velocity = Number(await knob(page, 'velocity').number.inputValue());
  const at = branch.velocity.findIndex((/** @type {number} */ v) => Math.abs(v - velocity) < 0.06);
  assert.ok(at >= 0, `${velocity} is on the branch`);
  const degrees = (branch.amplitude[at] * 180) / Math.PI;
  // In the field it has no more digits than one reads, and in the link no more than six.
  assert.match(await knob(page, 'velocity').number.inputValue(), /^\d{2,3}\.\d{1,4}$/);
  await untilSaid(page, '.branch-facts', new RegExp(`±${degrees.toFixed(2).replace('.', '\\.').slice(0, -1)}`));
  await untilSaid(page, 'shimmy-verdict', /settled/);
  await page.keyboard.press('Control+z');
  assert.equal(await knob(page, 'velocity').number.inputValue(), '80.0');
  await untilSaid(page, 'shimmy-verdict', /growing/);
  await leave();
});

test('keys walk along the branch and are told where they are; Enter goes there', async () => {
  const { page, leave } = await opened('&view.cycles=branch');
  await untilBranches(page);
  await page.locator('.branch-plane').focus();
  await page.keyboard.press('ArrowLeft');
  const heard = page.locator('.branch [role="status"]').first();
  await heard.filter({ hasText: /^v 80\.\d m\/s: 15\.\d+°, stable cycle/ }).waitFor();
  await page.keyboard.press('ArrowLeft');
  await heard.filter({ hasText: /^v 7\d\.\d m\/s/ }).waitFor();
  const told = Number((await heard.innerText()).match(/v ([\d.]+)/)?.[1]);
  await page.keyboard.press('Enter');
  await page.waitForFunction((value) => Math.abs(Number(/** @type {HTMLInputElement} */ (document.querySelector('shimmy-dock [data-name="velocity"] .number')).value) - value) < 0.11, told);
  await leave();
});

test('from either side of an unstable cycle it goes another way', async () => {
  const folded = '#shimmy=2&velocity=40&dampingConstant=10&casterLength=-0.05&sideForceLimitAngle=0.05235987755982988&aligningMomentLimitAngle=0.3490658503988659&initial.torsionAngle=0.3&lens=cycles&view.cycles=branch&view.branch=velocity:20:80,torsionAngle';
  const { page, leave } = await site.open(folded);
  await page.waitForFunction(() => /fold 36\.5 m\/s/.test(document.querySelector('.branch-plane canvas')?.getAttribute('aria-label') ?? ''));
  await page.locator('.branch-plane').focus();
  // Along the branch from where the gear is, down to its unstable part.
  const heard = page.locator('.branch [role="status"]').first();
  for (let i = 0; i < 60 && !/unstable/.test(await heard.innerText()); i++) await page.keyboard.press('ArrowLeft');
  assert.match(await heard.innerText(), /unstable cycle/);
  await page.keyboard.press('Enter');
  await untilSaid(page, '.branch-facts b', /^An unstable limit cycle$/);
  await page.getByRole('button', { name: 'Just inside' }).click();
  await untilVerdict(page, 'It dies out');
  await page.getByRole('button', { name: 'Just outside' }).click();
  await untilVerdict(page, 'It shimmies');
  await leave();
});

test('at a Hopf point is said which way its cycles go, and by which test, on the diagram and beneath it', async () => {
  const { page, leave } = await opened('&view.cycles=branch');
  await untilSaid(page, '.branch-reads', /^Hopf 27\.6 m\/s, supercritical: small cycles begin where rest is unstable \(first Lyapunov coefficient −2\d\.\d s⁻¹ rad⁻²\)\./);
  assert.match(await page.locator('.branch-plane canvas').getAttribute('aria-label') ?? '', /Hopf 27\.6 m\/s, supercritical/);
  await leave();
});

test('in the plane of folds either of two motions is started, and the gear goes to where it is dragged or pressed', async () => {
  const folded = '#shimmy=2&velocity=40&dampingConstant=10&casterLength=-0.05&sideForceLimitAngle=0.05235987755982988&aligningMomentLimitAngle=0.3490658503988659&initial.torsionAngle=0.3&lens=cycles&view.cycles=folds&view.folds=velocity:20:80,dampingConstant:0:30';
  const { page, leave } = await site.open(folded);
  await page.getByRole('button', { name: 'From a touch' }).click({ timeout: 20_000 });
  await untilVerdict(page, 'It dies out');
  await page.getByRole('button', { name: 'From a push' }).click();
  await untilVerdict(page, 'It shimmies');
  const point = page.getByRole('slider', { name: 'The gear in the plane' });
  await page.waitForFunction(() => /rest or ±1\d/.test(document.querySelector('.folds .plane-point')?.getAttribute('aria-valuetext') ?? ''), null, { timeout: 15_000 });
  const box = await point.boundingBox();
  assert.ok(box);
  await page.mouse.click(box.x + 160, box.y + 22);
  await page.waitForFunction(() => Number(/** @type {HTMLInputElement} */ (document.querySelector('shimmy-dock [data-name="velocity"] .number')).value) > 50);
  await untilSaid(page, '.branch-facts', /^One motion here/);
  await page.keyboard.press('Control+z');
  assert.equal(await knob(page, 'velocity').number.inputValue(), '40.0');
  // Any two values: one takes the place of the other side's.
  await page.getByRole('combobox', { name: 'Upward' }).selectOption('casterLength');
  await page.waitForURL(/view\.folds=velocity:20:80,casterLength:/);
  await leave();
});

test('over the gap the gear is dragged as a point, and moved by keys', async () => {
  const { page, leave } = await site.open('#shimmy=2&velocity=50&dampingConstant=100&freeplayAngle=0.017453292519943295&initial.torsionAngle=0.05&lens=cycles&view.cycles=freeplay');
  const point = page.getByRole('slider', { name: 'The gear in the plane' });
  await page.waitForFunction(() => /±1\.2\d°/.test(document.querySelector('.swing-map .plane-point')?.getAttribute('aria-valuetext') ?? ''), null, { timeout: 15_000 });
  await point.focus();
  await page.keyboard.press('ArrowUp');
  await page.waitForFunction(() => /** @type {HTMLInputElement} */ (document.querySelector('shimmy-dock [data-name="freeplayAngle"] .number')).value !== '1.00');
  const box = await point.boundingBox();
  assert.ok(box);
  await page.mouse.move(box.x + 22, box.y + 22);
  await page.mouse.down();
  await page.mouse.move(box.x + 140, box.y + 22, { steps: 5 });
  await page.mouse.up();
  await untilVerdict(page, 'It dies out');
  assert.ok(Number(await knob(page, 'velocity').number.inputValue()) > 70);
  await page.keyboard.press('Control+z');
  assert.equal(await knob(page, 'velocity').number.inputValue(), '50.0');
  await leave();
});

test('over its basins the start is dragged from one ending to another', async () => {
  const folded = '#shimmy=2&velocity=42&dampingConstant=10&casterLength=-0.05&sideForceLimitAngle=0.05235987755982988&aligningMomentLimitAngle=0.3490658503988659&initial.torsionAngle=0.3&lens=cycles&view.cycles=basins';
  const { page, leave } = await site.open(folded);
  await untilSaid(page, '.endings', /dies out.*shimmies, ±17/s);
  await untilVerdict(page, 'It shimmies');
  const box = await page.locator('.basins-plane canvas').boundingBox();
  const point = await page.getByRole('slider', { name: 'Where the run starts' }).boundingBox();
  assert.ok(box && point);
  await page.mouse.move(point.x + 22, point.y + 22);
  await page.mouse.down();
  // The middle of the frame, left of which are the numbers.
  await page.mouse.move(box.x + box.width * 0.55, box.y + box.height * 0.5, { steps: 6 });
  await page.mouse.up();
  await untilVerdict(page, 'It dies out');
  // That is where the run starts now: no change on record, and the start in the link.
  await page.waitForURL((url) => /initial\.torsionAngle=0\.0\d+/.test(url.hash) && !/do=/.test(url.hash));
  await page.keyboard.press('Control+z');
  await untilVerdict(page, 'It shimmies');
  assert.equal(await page.getByRole('slider', { name: 'Where the run starts' }).getAttribute('aria-valuetext'), '17.19°, 0.0 rad/s');
  await leave();
});

test('where every start ends alike a gear with two endings is offered, and one undo takes it back', async () => {
  const { page, leave } = await opened('&view.cycles=basins');
  await page.getByRole('button', { name: 'Show a gear with two endings' }).click({ timeout: 15_000 });
  await untilSaid(page, '.endings', /dies out.*shimmies, ±16/s);
  assert.equal(await knob(page, 'velocity').number.inputValue(), '40.0');
  await page.keyboard.press('Control+z');
  assert.equal(await knob(page, 'velocity').number.inputValue(), '80.0');
  await leave();
});

test('three methods side by side for the gear and over the speed, and the table as a file', async () => {
  const { page, leave } = await opened('&view.cycles=methods');
  await page.locator('.methods-plot canvas').waitFor();
  await page.getByRole('combobox', { name: 'What is beneath' }).selectOption('table');
  await page.waitForURL(/view\.methodsBelow=table/);
  await page.waitForFunction(() => document.querySelectorAll('.methods .figures-table tbody tr:not(.old)').length >= 11);
  await page.locator('.three').waitFor();
  const here = await page.locator('.three').innerText();
  assert.match(here, /±15\.05°\s*−0\.89\s%\s*±15\.19°\s*±15\.19°/);
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'CSV' }).click()]);
  const lines = (await readFile(await download.path(), 'utf8')).trim().split('\r\n');
  assert.match(lines[0], /^velocity \(m\/s\),shooting \(rad\),describing \(rad\),describingOff \(%\),simulation \(rad\)/);
  assert.deepEqual(lines.slice(1).map((line) => line.split(',')[0]), ['30', '40', '50', '60', '70', '80', '90', '100']);
  // theory.md: v = 40, c = 20: 18.057°.
  assert.ok(Math.abs(Number(lines[2].split(',')[1]) - (18.057 * Math.PI) / 180) < 1e-5);
  await leave();
});

test('a table opens in one click from its number, is sorted by a press, and leaves as a picture', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  await page.keyboard.press('/');
  await page.keyboard.type('table 6.1');
  await page.keyboard.press('Enter');
  const rows = page.locator('.cycle-tables tbody tr');
  await untilSaid(page, '.cycle-tables', /26\.839/);
  await untilVerdict(page, 'It rattles in the gap');
  assert.deepEqual(await rows.locator('td:nth-child(2)').allInnerTexts(), ['dies out', 'rattles', 'rattles', 'rattles']);
  // theory.md 4: 0.011171, 0.022268, 0.033219 rad.
  assert.deepEqual((await rows.locator('td:nth-child(3)').allInnerTexts()).slice(1), ['0.6401', '1.2759', '1.9033']);
  await page.locator('.cycle-tables thead button').nth(2).click();
  await page.locator('.cycle-tables thead button').nth(2).click();
  await page.waitForURL(/view\.cycleTableSort=torsionAngle,down/);
  assert.deepEqual((await rows.locator('td:nth-child(3)').allInnerTexts())[0], '1.9033');
  // Step from table to table: rows of one are none of the next.
  for (const number of ['6.2', '5.13', '6.1']) await page.getByRole('combobox', { name: 'Which table' }).selectOption(number);
  await untilSaid(page, '.cycle-tables', /26\.839/);
  for (const format of ['PNG', 'SVG']) {
    const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: format, exact: true }).click()]);
    assert.equal(download.suggestedFilename(), `shimmy-table-6.1.${format.toLowerCase()}`);
    const bytes = await readFile(await download.path());
    if (format === 'PNG') assert.equal(bytes.subarray(1, 4).toString(), 'PNG');
    else assert.match(bytes.toString(), /26\.839/);
  }
  await rows.getByRole('button').first().click();
  await page.waitForFunction(() => /** @type {HTMLInputElement} */ (document.querySelector('shimmy-dock [data-name="freeplayAngle"] .number')).value === '1.50');
  await leave();
});

test('while it is to be guessed nothing of a cycle is seen or heard, on any view or slider', async () => {
  for (const view of viewNames) {
    const { page, leave } = await opened(`&view.cycles=${view}&view.folds=velocity:1:120,dampingConstant:0:100&predict=1`);
    await page.locator('.panel-veil').first().waitFor();
    const heard = await page.locator('shimmy-cycles-lens .cycles').evaluate((lens) => [lens.textContent, ...[...lens.querySelectorAll('[aria-label], [title]')].map((one) => `${one.getAttribute('aria-label')} ${one.getAttribute('title')}`)].join(' '));
    assert.doesNotMatch(heard, /\d+\.\d|stable limit cycle|dies out|Hopf|two motions|critical|beyond/i, view);
    assert.equal(await page.locator('.sparkline').count(), 0);
    await leave();
  }
});

test('each slider foretells how widely the gear will swing, once it stands still', async () => {
  const { page, leave } = await opened();
  await page.locator('shimmy-dock [data-name="velocity"] .sparkline').waitFor({ timeout: 10_000 });
  assert.match(await knob(page, 'velocity').slider.getAttribute('aria-description') ?? '', /shimmies above 27\.6.*Swings up to ±18°, at \d\d\.\d m\/s/);
  await leave();
});

test('the page as one file has the lens inside', async () => {
  const { fileAddress } = await import('./site.mjs');
  const { page, leave } = await site.openAt(`${fileAddress}${gear}&view.cycles=branch`);
  await untilBranches(page);
  await untilSaid(page, '.branch-facts', /±15\.19°/);
  await leave();
});

test('figures of cycles and of the gap open in one click: on the settled orbit, beside a branch, on the law of the gap', async () => {
  const { page, leave } = await site.open();
  await untilVerdict(page, 'It shimmies');
  for (const [number, selector] of [['5.102a', '.cycle .turntable'], ['5.102b', '.cycle-orbit'], ['5.102c', '.branch-plane'], ['6.8', '.gap-branch'], ['6.1', '.gap-law']]) {
    await page.keyboard.press('/');
    await page.keyboard.type(`figure ${number}`);
    await page.keyboard.press('Enter');
    await page.locator(selector).waitFor();
    await page.waitForURL((url) => url.hash.includes('lens=cycles') && url.hash.endsWith(`story=figure-${number}`));
  }
  await leave();
});

test('on a projector letters of tables are as large as elsewhere, and there is one picture at a time', async () => {
  const { page, leave } = await opened('&view.cycles=tables', { viewport: { width: 1024, height: 768 } });
  const sizes = () => page.locator('.cycles :is(th, td, .theory)').evaluateAll((all) => all.filter((one) => /** @type {HTMLElement} */ (one).offsetWidth > 0).map((one) => parseFloat(getComputedStyle(one).fontSize)));
  await untilSaid(page, '.cycle-tables', /144\.07/);
  assert.ok((await sizes()).every((size) => size >= 17), String(await sizes()));
  assert.match(await page.locator('.units').innerText(), /^v.m\/s · c.N m s\/rad · ψ.° /);
  await page.locator('#lens-panel select.views').selectOption('methods');
  await page.getByRole('combobox', { name: 'What is beneath' }).selectOption('table');
  await page.locator('.methods .figures-table:not(.three) tbody').waitFor();
  assert.ok((await sizes()).every((size) => size >= 17), String(await sizes()));
  await page.locator('#lens-panel select.views').selectOption('cycle');
  await page.getByRole('combobox', { name: 'How the cycle is drawn' }).selectOption('multipliers');
  assert.match(await page.locator('.cycle-orbit canvas').getAttribute('aria-label') ?? '', /^Floquet multipliers/);
  const { height = 0 } = await page.locator('.cycle-orbit canvas').boundingBox() ?? {};
  assert.ok(height >= 240, `${height}`);
  await leave();
});

test('on a phone a view that is chosen comes in sight with what it shows', async () => {
  const { page, leave } = await opened('&view.cycles=branch', { viewport: { width: 390, height: 844 }, hasTouch: true });
  await page.locator('#lens-panel select.views').selectOption('basins');
  await page.waitForFunction(() => scrollY > 60);
  const [picture, stage, dock] = await Promise.all(['.basins-plane canvas', 'shimmy-stage', 'shimmy-dock'].map((selector) => page.locator(selector).boundingBox()));
  assert.ok(picture && stage && dock);
  assert.ok(picture.y >= stage.y + stage.height - 1 && picture.y + picture.height <= dock.y + 1, JSON.stringify([picture, stage, dock]));
  await leave();
});

test('in Turkish', async () => {
  const { page, leave } = await opened('', { locale: 'tr-TR' });
  await untilSaid(page, '.cycle-facts h2', /^Kararlı bir limit çevrim$/);
  await untilSaid(page, '.cycle-facts', /±15,19°/);
  await leave();
});

for (const [width, height] of [[1440, 900], [1024, 768], [390, 844]])
  for (const colorScheme of /** @type {const} */ (['light', 'dark']))
    test(`axe-core finds nothing in any view at ${width} × ${height}, ${colorScheme}`, async () => {
      const { page, leave } = await opened('', { viewport: { width, height }, colorScheme });
      await page.evaluate(axe);
      for (const view of viewNames) {
        await page.locator('#lens-panel select.views').selectOption(view);
        await page.locator(`.cycles[data-view="${view}"]`).waitFor();
        await page.waitForTimeout(400);
        const violations = await page.evaluate(async () => {
          const { violations } = await /** @type {any} */ (window).axe.run();
          return violations.flatMap((/** @type {any} */ { id, nodes }) => nodes.map((/** @type {any} */ { target, failureSummary }) => `${id} ${target}: ${failureSummary}`));
        });
        assert.deepEqual(violations, [], view);
        assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width, `${view} is wider than the screen`);
      }
      await leave();
    });
