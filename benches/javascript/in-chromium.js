// Our module in headless Chromium: one line of JSON for each measurement. SHIMMY_CHROMIUM names the browser.

import { readFile } from 'node:fs/promises';
import { extname } from 'node:path';

import { chromium } from 'playwright-core';

import { theCase } from './case.js';

// An address that counts as secure, as the clock below asks for; nothing is sent to it.
const ORIGIN = 'http://localhost';
const ROOT = new URL('../../', import.meta.url);
/** @type {Record<string, string>} */
const TYPES = { '.js': 'text/javascript', '.wasm': 'application/wasm', '.html': 'text/html' };
// With these two a page may read the clock in steps of 5 microseconds instead of 100.
const ISOLATED = { 'Cross-Origin-Opener-Policy': 'same-origin', 'Cross-Origin-Embedder-Policy': 'require-corp' };

const browser = await chromium.launch({
  executablePath: process.env.SHIMMY_CHROMIUM || undefined,
  args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking'],
});
try {
  const page = await browser.newPage();
  await page.route(`${ORIGIN}/**`, async (route) => {
    const path = new URL(route.request().url()).pathname.slice(1);
    const body = path ? await readFile(new URL(path, ROOT)) : Buffer.from('<!doctype html><title>bench</title>');
    const type = TYPES[extname(path) || '.html'];
    await route.fulfill({ body, contentType: type, headers: ISOLATED });
  });
  await page.goto(`${ORIGIN}/`);
  const measured = await page.evaluate(async ({ theCase, place, modules }) => {
    const [shimmy, ours] = await Promise.all(modules.map((path) => import(path)));
    await shimmy.default({ module_or_path: fetch('/www/pkg/shimmy_bg.wasm') });
    return { warmUp: { place, ...ours.warmUp(shimmy, theCase) }, entry: ours.ourEntry(shimmy, theCase, place) };
  }, {
    theCase,
    place: `Chromium ${browser.version().split('.')[0]}`,
    modules: ['/www/pkg/shimmy.js', '/benches/javascript/ours.js'],
  });
  console.log(JSON.stringify({ warmUp: measured.warmUp }));
  console.log(JSON.stringify(measured.entry));
} finally {
  await browser.close();
}
