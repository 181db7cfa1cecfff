// The page without a network: as a site that was visited once, as an app, and as one file.

import assert from 'node:assert/strict';
import { cpSync, mkdtempSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { listRelease } from '../../scripts/bundle/offline.js';
import { gearPixels, untilVerdict, withPage } from './chromium.mjs';
import { dist, fileAddress, serve } from './site.mjs';

/** @typedef {import('playwright-core').Page} Page */

// Each test has a server of its own, to be stopped.
const site = withPage(null);
const folder = mkdtempSync(join(tmpdir(), 'shimmy-builds-'));
after(() => rmSync(folder, { recursive: true, force: true }));

/** Waits until the site's worker serves. @param {Page} page */
const untilKept = (page) => page.evaluate(() => navigator.serviceWorker.ready.then(({ active }) => `${active?.state}`));

/** @param {Page} page */
async function assertMoving(page) {
  await untilVerdict(page, 'It shimmies');
  const one = await gearPixels(page);
  await page.waitForTimeout(150);
  const other = await gearPixels(page);
  assert.ok(one.filter((sum, i) => sum !== other[i]).length > 8, 'the drawing stands still');
}

/** @param {Page} page @returns {Promise<string[]>} the versions that lie on shelves */
const shelves = (page) => page.evaluate(async () => (await caches.keys()).map((name) => name.split(' ').at(-1) ?? ''));

/**
 * Another build of the same page, as the bundler would name its files, under a title of its own.
 * @param {string} title
 */
function buildOf(title) {
  const build = join(folder, title);
  cpSync(dist, build, { recursive: true });
  const script = readdirSync(join(build, 'assets')).find((name) => /^index-.*\.js$/.test(name)) ?? '';
  const renamed = `index-${title.padEnd(8, '0')}.js`;
  renameSync(join(build, 'assets', script), join(build, 'assets', renamed));
  const html = join(build, 'index.html');
  writeFileSync(html, readFileSync(html, 'utf8').replace(script, renamed).replace('<body>', `<body data-build="${title}">`));
  listRelease(build);
  return build;
}

/** @param {Page} page */
const buildShown = (page) => page.locator('body').getAttribute('data-build');

test('after one visit it opens without a network, under a sub-path, with any link, and shimmies', async (t) => {
  const server = await serve();
  t.after(server.close);
  const { page, leave } = await site.openAt(server.address);
  assert.match(await untilKept(page), /^activat/);
  server.close();
  await page.context().setOffline(true);
  await page.reload();
  await assertMoving(page);
  for (const address of [`${server.address}index.html`, `${server.address}?from=home#shimmy=1&velocity=80&dampingConstant=60&initial.torsionAngle=0.05`]) {
    await page.goto(address);
    await untilVerdict(page, address.includes('#') ? 'It dies out' : 'It shimmies');
  }
  // Fonts, icons, licenses: all that belongs to the site.
  const { files } = JSON.parse(readFileSync(join(dist, 'release.json'), 'utf8'));
  const wanted = readdirSync(dist, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile()).map(({ name }) => name)
    .filter((name) => !['release.json', 'service-worker.js', 'shimmy.html'].includes(name));
  assert.equal(Object.keys(files).length, wanted.length);
  const statuses = await page.evaluate((paths) => Promise.all(paths.map((path) => fetch(path).then(({ status }) => status))), Object.keys(files));
  assert.deepEqual(statuses.filter((status) => status !== 200), []);
  await leave();
});

test('a new build is stocked in the background and serves the next visit, whole; the one before the last goes', async (t) => {
  const server = await serve(buildOf('one'));
  t.after(server.close);
  const { page, leave } = await site.openAt(server.address);
  await untilKept(page);
  await page.reload();
  assert.equal(await buildShown(page), 'one');
  const first = (await shelves(page))[0] ?? '';

  server.show(buildOf('two'));
  await page.reload();
  assert.equal(await buildShown(page), 'one', 'this visit is still the old build');
  await page.waitForFunction(async () => (await caches.keys()).length === 2);
  // The page that is open may still ask for a file that the server no longer has.
  const script = await page.evaluate(() => document.querySelector('script[src]')?.getAttribute('src') ?? '');
  assert.match(script, /index-one/);
  assert.equal(await page.evaluate((address) => fetch(address).then(({ status }) => status), script), 200);
  await untilBuild(page, 'two');
  await assertMoving(page);

  server.show(buildOf('three'));
  await untilBuild(page, 'three');
  assert.equal((await shelves(page)).length, 2);
  assert.ok(!(await shelves(page)).includes(first), 'the first build is still kept');
  server.close();
  await page.context().setOffline(true);
  await page.reload();
  assert.equal(await buildShown(page), 'three');
  await assertMoving(page);
  await leave();
});

/** Visits again until a build is shown. @param {Page} page @param {string} title */
async function untilBuild(page, title) {
  for (let visits = 0; visits < 10; visits++) {
    await page.reload();
    if ((await buildShown(page)) === title) return;
    await page.waitForTimeout(300);
  }
  assert.fail(`build ${title} does not come`);
}

test('a build that is not there in full changes nothing', async (t) => {
  const [old, half] = [buildOf('old'), buildOf('half')];
  const server = await serve(old);
  t.after(server.close);
  const { page } = await site.openAt(server.address);
  await untilKept(page);
  await page.reload();
  const kept = await shelves(page);
  // A server in the middle of a change: the new list, and the page as it was.
  cpSync(join(old, 'index.html'), join(half, 'index.html'));
  server.show(half);
  const asked = page.context().waitForEvent('request', (request) => request.url().includes('index-half') && request.serviceWorker() !== null);
  await page.reload();
  await asked;
  // The shelf for the new build is put up and, as the build is not there in full, taken down: one may look in between.
  let now = await shelves(page);
  for (let i = 0; i < 50 && JSON.stringify(now) !== JSON.stringify(kept); i++) {
    await page.waitForTimeout(100);
    now = await shelves(page);
  }
  assert.deepEqual(now, kept);
  server.close();
  await page.context().setOffline(true);
  await page.reload();
  assert.equal(await buildShown(page), 'old');
  await assertMoving(page);
  await page.context().close();
});

test('shimmy.html is whole by itself: no network, no request, no worker to keep it', async () => {
  const context = await site.browser.newContext({ viewport: { width: 1440, height: 900 }, locale: 'en-US', offline: true });
  const page = await context.newPage();
  /** @type {string[]} */
  const complaints = [];
  page.on('console', (message) => complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(error.message));
  /** @type {string[]} */
  const requests = [];
  page.on('request', (request) => requests.push(request.url()));
  await page.goto(fileAddress);
  await assertMoving(page);
  await page.waitForTimeout(1500);
  assert.deepEqual(requests.filter((url) => url !== fileAddress && !/^(data|blob):/.test(url)), []);
  assert.deepEqual(complaints, []);
  assert.equal(await page.locator('link[rel="manifest"]').count(), 0);
  assert.ok(!readFileSync(join(dist, 'shimmy.html'), 'utf8').includes('service-worker'));
  await context.close();
});

test('it is an app to install: the manifest is read, its icons are there, of their sizes and up to date', async (t) => {
  const server = await serve();
  t.after(server.close);
  const { page, leave } = await site.openAt(server.address);
  await untilKept(page);
  const devtools = await page.context().newCDPSession(page);
  const { url, errors } = await devtools.send('Page.getAppManifest');
  assert.equal(url, `${server.address}manifest.webmanifest`);
  assert.deepEqual(errors, []);
  const { installabilityErrors } = await devtools.send('Page.getInstallabilityErrors');
  // A test's window is a private one, which no browser installs from.
  assert.deepEqual(installabilityErrors.map(({ errorId }) => errorId).filter((error) => error !== 'in-incognito'), []);

  const manifest = await (await fetch(url)).json();
  assert.equal(new URL(manifest.start_url, url).href, server.address);
  assert.equal(new URL(manifest.scope, url).href, server.address);
  /** @type {[string, string][]} */
  const icons = [...manifest.icons.map((/** @type {{ src: string, sizes: string }} */ { src, sizes }) => [src, sizes]), ['apple-touch-icon.png', '180x180']];
  assert.ok(['192x192', '512x512'].every((size) => icons.filter(([, sizes]) => sizes === size).length === 2), 'plain and maskable');
  for (const [src, sizes] of icons) {
    const [width, apart] = await page.evaluate(compareWithDrawing, src);
    if (sizes !== 'any') assert.equal(`${width}x${width}`, sizes, src);
    assert.ok(apart < 0.01, `${src} is not icon.svg: npm run icons`);
  }
  await leave();
});

/**
 * An icon's width, and the share of pixels in which it differs from icon.svg, the corners apart.
 * @param {string} src
 */
async function compareWithDrawing(src) {
  const [icon, drawing] = await Promise.all([src, 'icon.svg'].map(async (address) => {
    const image = new Image();
    image.src = address;
    await image.decode();
    return image;
  }));
  const size = 96;
  const [one, other] = [icon, drawing].map((image) => {
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (new OffscreenCanvas(size, size).getContext('2d'));
    context.imageSmoothingQuality = 'high';
    context.fillStyle = '#e6e3da';
    context.fillRect(0, 0, size, size);
    context.drawImage(image, 0, 0, size, size);
    return context.getImageData(0, 0, size, size).data;
  });
  return [icon.naturalWidth, one.filter((value, at) => Math.abs(value - other[at]) > 48).length / one.length];
}
