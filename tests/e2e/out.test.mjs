// What leaves the page: the sheet under Share in the hand, and files that arrive on the disk.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { shimmy } from '../node/module.mjs';
import { untilVerdict, withPage } from './chromium.mjs';
import { fileAddress } from './site.mjs';
import { openWorkshop } from './workshop.mjs';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('../../www/out/sheet.js').OutSheet} OutSheet */

const site = withPage(openWorkshop);

const axe = await readFile(new URL('../../node_modules/axe-core/axe.min.js', import.meta.url), 'utf8');

/**
 * The page with the sheet alone in its header; what it asks for gathers in `heard`.
 * @param {import('playwright-core').BrowserContextOptions} options
 * @param {'en' | 'tr'} language
 */
async function openSheet(options, language) {
  const context = await site.browser.newContext({ reducedMotion: 'reduce', locale: 'en-US', ...options });
  const page = await context.newPage();
  await page.goto(site.address);
  await untilVerdict(page, 'It shimmies');
  await page.evaluate(mount, language);
  return { page, context, heard: () => page.evaluate(() => /** @type {any} */ (window).heard) };
}

/** @param {'en' | 'tr'} language */
async function mount(language) {
  const paths = ['/out/sheet.js', '/words/voice.js'];
  await import(paths[0]);
  const { voiceOf } = /** @type {typeof import('../../www/words/voice.js')} */ (await import(paths[1]));
  const voice = voiceOf(language);
  document.documentElement.lang = language;
  const sheet = /** @type {OutSheet} */ (document.createElement('shimmy-out-sheet'));
  const views = [
    { name: 'gear', title: voice.say('stage.name'), element: '.gear shimmy-canvas', hasLines: true },
    { name: 'map', title: voice.say('lens.stability'), element: '#lens-panel shimmy-canvas', hasLines: false },
    { name: 'hidden', title: 'what is not on the screen', element: '#no-such-element', hasLines: true },
  ];
  Object.assign(sheet, { voice, views, isReady: true, link: 'https://example.org/#shimmy=1' });
  /** @type {unknown[]} */
  const heard = (/** @type {any} */ (window).heard = []);
  // The page is not to carry out what the test only listens to.
  sheet.addEventListener('command', (event) => {
    event.stopPropagation();
    heard.push(/** @type {CustomEvent} */ (event).detail);
  });
  document.querySelector('shimmy-header')?.replaceChildren(sheet);
  await sheet.updateComplete;
}

test('the sheet offers the link, the run and each view, and says what is wished for', async () => {
  const { page, context, heard } = await openSheet({ viewport: { width: 1440, height: 900 } }, 'en');
  await page.getByText('Share', { exact: true }).click();
  for (const name of ['Copy link', /^CSV/, /^JSON/, /^Python/, 'The gear as PNG', 'The gear as SVG', 'Stability as PNG'])
    await page.getByRole('button', { name }).click();
  assert.deepEqual(await heard(), [
    ['link', ''], ['csv', ''], ['json', ''], ['python', ''], ['png', 'gear'], ['svg', 'gear'], ['png', 'map'],
  ].map(([what, view]) => ({ name: 'out', value: { what, view } })));
  assert.equal(await page.getByRole('button', { name: 'Stability as SVG' }).count(), 0, 'a map has no lines');
  await page.evaluate(() => Object.assign(/** @type {OutSheet} */ (document.querySelector('shimmy-out-sheet')), { hasPython: false, said: 'Saved as x.csv.' }));
  assert.equal(await page.getByRole('button', { name: /^Python/ }).count(), 0);
  assert.equal(await page.getByRole('status').filter({ hasText: 'Saved as x.csv.' }).count(), 1);
  await page.mouse.click(300, 500);
  assert.equal(await page.locator('.out-sheet').isVisible(), false, 'a press elsewhere closes it');
  await context.close();
});

test('it goes by the keyboard alone, and Escape leads back', async () => {
  const { page, context, heard } = await openSheet({ viewport: { width: 1440, height: 900 } }, 'en');
  await page.locator('.out summary').focus();
  await page.keyboard.press('Enter');
  const way = [];
  for (let i = 0; i < 9; i++) {
    await page.keyboard.press('Tab');
    way.push(await page.evaluate(() => document.activeElement?.getAttribute('aria-label') ?? document.activeElement?.textContent?.trim().split(/\s/)[0]));
  }
  assert.deepEqual(way, ['Link', 'Copy', 'CSV', 'JSON', 'Python', 'The gear as PNG', 'The gear as SVG', 'Stability as PNG', '']);
  await page.keyboard.press('Shift+Tab');
  await page.keyboard.press('Enter');
  assert.deepEqual(await heard(), [{ name: 'out', value: { what: 'png', view: 'map' } }]);
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('.out-sheet').isVisible(), false);
  assert.equal(await page.evaluate(() => document.activeElement?.tagName), 'SUMMARY');
  await context.close();
});

test('a saved run is read and handed on, the same one twice if it must be', async () => {
  const { page, context, heard } = await openSheet({ viewport: { width: 1440, height: 900 } }, 'en');
  await page.locator('.out summary').click();
  const file = { name: 'run.json', mimeType: 'application/json', buffer: Buffer.from('{"model": "torsional"}') };
  for (const count of [1, 2]) {
    await page.getByLabel('Open a saved run').setInputFiles(file);
    await page.waitForFunction((wanted) => /** @type {any} */ (window).heard.length === wanted, count);
  }
  assert.deepEqual((await heard())[1], { name: 'openFile', value: { name: 'run.json', text: '{"model": "torsional"}' } });
  await context.close();
});

for (const [device, viewport] of /** @type {const} */ ([['desktop', { width: 1440, height: 900 }], ['projector', { width: 1024, height: 768 }], ['phone', { width: 390, height: 844 }]]))
  for (const [language, colorScheme] of /** @type {const} */ ([['en', 'light'], ['tr', 'dark']]))
    test(`it can be read and reached by everybody: ${device}, ${language}, ${colorScheme}`, async () => {
      const { page, context } = await openSheet({ viewport, colorScheme }, language);
      await page.locator('.out summary').click();
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => /** @type {any} */ (window).axe.run('shimmy-out-sheet'));
      assert.deepEqual(violations.map((/** @type {any} */ { id, nodes }) => [id, nodes.map((/** @type {any} */ node) => node.html)]), []);
      const boxes = await page.locator('shimmy-out-sheet').locator('summary, button, label, input[type="text"]').evaluateAll(
        (elements) => elements.map((element) => element.getBoundingClientRect().toJSON()));
      for (const { left, right, width, height } of boxes) {
        assert.ok(left >= 0 && right <= viewport.width, `${left} … ${right} of ${viewport.width}`);
        if (device === 'phone') assert.ok(width >= 44 && height >= 44, `a target of ${width} × ${height}`);
      }
      await context.close();
    });

test('the CSV on the disk is what simulate gives, the JSON runs, the pictures are what they say', async () => {
  const context = await site.browser.newContext({ viewport: { width: 1440, height: 900 }, reducedMotion: 'reduce', locale: 'en-US' });
  const page = await context.newPage();
  await page.goto(site.address);
  await untilVerdict(page, 'It shimmies');

  const files = /** @type {Record<string, Buffer>} */ ({});
  for (const format of ['csv', 'json', 'python', 'png', 'svg']) {
    const arriving = page.waitForEvent('download');
    const said = await page.evaluate(wishFor, format);
    const arrived = await arriving;
    assert.equal(said, `Saved as ${arrived.suggestedFilename()}.`);
    files[arrived.suggestedFilename()] = await readFile(await arrived.path());
  }
  assert.deepEqual(Object.keys(files), ['csv', 'json', 'py', '-phase.png', '-phase.svg'].map((end) => `shimmy-v80-c20${end.startsWith('-') ? end : `.${end}`}`));

  const run = JSON.parse(files['shimmy-v80-c20.json'].toString());
  const motion = shimmy.simulate(run);
  const rows = files['shimmy-v80-c20.csv'].toString().trimEnd().split('\r\n').slice(1).map((row) => row.split(',').map(Number));
  assert.deepEqual(rows.map(([time]) => time), [...motion.time]);
  assert.deepEqual(rows.map(([, angle]) => angle), [...motion.torsionAngle]);
  assert.deepEqual(rows.map(([, , , deformation]) => deformation), [...motion.lateralDeformation]);
  assert.match(files['shimmy-v80-c20.py'].toString(), /python3 shimmy-v80-c20\.py --plot/);

  const png = files['shimmy-v80-c20-phase.png'];
  assert.equal(png.subarray(1, 4).toString(), 'PNG');
  const view = await page.locator('shimmy-phase-lens shimmy-canvas').boundingBox();
  assert.ok(view);
  assert.equal(png.readUInt32BE(16), 2 * (Math.ceil(view.width) + 40), 'twice the view with its margins');
  assert.ok(png.readUInt32BE(20) > 2 * (view.height + 80), 'a title above and the address below');
  const svg = files['shimmy-v80-c20-phase.svg'].toString();
  for (const words of ['Nose gear · Phase', 'Speed\u00a080.0\u00a0m/s · Damping\u00a020.0\u00a0N\u00a0m\u00a0s/rad', 'torsion angle', 'shimmy=1&amp;'])
    assert.ok(svg.includes(words), words);
  await context.close();
});

/** @param {string} format */
async function wishFor(format) {
  const load = (/** @type {string} */ path) => import(path);
  const { grant } = /** @type {typeof import('../../www/out/grant.js')} */ (await load('/out/grant.js'));
  const { valuesLine } = /** @type {typeof import('../../www/out/values-line.js')} */ (await load('/out/values-line.js'));
  const { loadEngine } = /** @type {typeof import('../../www/engine/engine.js')} */ (await load('/engine/engine.js'));
  const { Quantity } = /** @type {typeof import('../../www/controls/quantity.js')} */ (await load('/controls/quantity.js'));
  const { readTheme } = /** @type {typeof import('../../www/style/theme.js')} */ (await load('/style/theme.js'));
  const { voiceOf } = /** @type {typeof import('../../www/words/voice.js')} */ (await load('/words/voice.js'));
  const engine = await loadEngine();
  const table = /** @type {import('../../www/engine/engine.js').Model} */ (engine.models().find(({ name }) => name === 'torsional'));
  const parameters = { velocity: 80, dampingConstant: 20 };
  const view = /** @type {import('../../www/view/canvas.js').Canvas} */ (document.querySelector('shimmy-phase-lens shimmy-canvas'));
  const link = `${location.href}#shimmy=1&velocity=80`;
  const voice = voiceOf('en');
  const values = valuesLine(table.parameters.map((parameter) => new Quantity(parameter)), parameters, voice);
  return grant({ what: /** @type {any} */ (format), view: 'phase' }, {
    engine, table, link, duration: 2,
    experiment: { object: 'torsional', parameters, run: { initial: { torsionAngle: 0.05 } } },
    picture: { size: view.size, paint: /** @type {import('../../www/view/canvas.js').Paint} */ (view.paint) },
    caption: { title: 'Nose gear · Phase', values, link },
    theme: readTheme(document.body),
  }, voice);
}

/** The function alone, to be put into a page that has its own modules. */
const downloadAlone = (await readFile(new URL('../../www/out/download.js', import.meta.url), 'utf8')).replaceAll('export ', '');

test('a file is saved from a page that is a file itself, under its Content-Security-Policy', async () => {
  const { page, leave } = await site.openAt(fileAddress);
  const arriving = page.waitForEvent('download');
  await page.evaluate(`${downloadAlone}; download(new Blob(['a,b'], { type: 'text/csv' }), 'a.csv')`);
  const arrived = await arriving;
  assert.equal(arrived.suggestedFilename(), 'a.csv');
  assert.equal((await readFile(await arrived.path())).toString(), 'a,b');
  await leave();
});

test('where the page can save nothing, the system’s own sheet takes the file', async () => {
  const { page, leave } = await site.openAt(fileAddress);
  const share = (/** @type {string} */ ending) => page.evaluate(`(async () => { ${downloadAlone}
    const passed = [];
    const navigator = { standalone: true, canShare: () => true, share: async (what) => { passed.push(what.files[0].name); ${ending} } };
    return [await download(new Blob(['x']), 'b.csv', { document, navigator }).catch((error) => error.message), ...passed];
  })()`);
  assert.deepEqual(await share(''), ['shared', 'b.csv']);
  assert.deepEqual(await share("throw new DOMException('', 'AbortError')"), ['cancelled', 'b.csv']);
  assert.deepEqual(await share("throw new Error('no room')"), ['no room', 'b.csv']);
  await leave();
});
