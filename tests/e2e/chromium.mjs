// The page in the system's Chromium, watched: what it logs, what it throws, what it asks the network for.

import assert from 'node:assert/strict';
import { after, before } from 'node:test';
import { chromium } from 'playwright-core';
import { chromiumArguments } from '../../scripts/setup/webdriver.mjs';
import { serve } from './site.mjs';

/** @typedef {import('playwright-core').Browser} Browser */
/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('playwright-core').BrowserContextOptions} Options */

/**
 * A browser for the tests of a file, and what serves them the page: started before the first of them, ended after the last.
 * @param {(() => Promise<{ address: string, close: () => unknown }>) | null} [start] dist/ unless said; null where tests serve
 *   for themselves
 */
export function withPage(start = serve) {
  /** @type {Browser} */
  let browser;
  /** @type {{ address: string, close: () => unknown } | null} */
  let server = null;
  before(async () => {
    server = await start?.() ?? null;
    browser = await launch();
  });
  after(async () => {
    await browser.close();
    await server?.close();
  });
  return {
    get browser() {
      return browser;
    },
    get address() {
      return server?.address ?? '';
    },
    /** Opens the page with a link of its own. @param {string} [link] @param {Options} [options] @param {(page: Page) => Promise<void>} [prepare] */
    open: (link = '', options, prepare) => open(browser, (server?.address ?? '') + link, options, prepare),
    /** Opens another address. @param {string} address @param {Options} [options] @param {(page: Page) => Promise<void>} [prepare] */
    openAt: (address, options, prepare) => open(browser, address, options, prepare),
  };
}

/** @returns {Promise<Browser>} */
export function launch() {
  return chromium.launch({ executablePath: process.env.SHIMMY_CHROMIUM ?? '/usr/bin/chromium', args: chromiumArguments() });
}

/**
 * Opens an address in a fresh profile, the only one of this browser: a visit that a failed test did not end would go on
 * drawing and slow down the next.
 * @param {Browser} browser
 * @param {string} address
 * @param {Options} [options]
 * @param {(page: Page) => Promise<void>} [prepare] before the address is opened
 */
export async function open(browser, address, options = {}, prepare = async () => {}) {
  for (const left of browser.contexts()) await left.close();
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, locale: 'en-US', ...options });
  const page = await context.newPage();
  /** @type {string[]} */
  const complaints = [];
  /** @type {string[]} */
  const requests = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (request) => requests.push(request.url()));
  await prepare(page);
  await page.goto(address);
  const base = new URL('.', address).href;
  return {
    page,
    requests,
    /** Ends the visit: nothing may have been logged, nothing asked for but the page's own files. */
    leave: async () => {
      await context.close();
      assert.deepEqual(complaints, []);
      const outside = requests.filter((url) => !url.startsWith(base) && !/^(data|blob):/.test(url));
      assert.deepEqual(outside, []);
    },
  };
}

/** The verdict in words. @param {Page} page */
export const verdict = (page) => page.locator('shimmy-verdict h1').innerText();

/** Waits for a verdict. @param {Page} page @param {string} words */
export const untilVerdict = (page, words) =>
  page.locator('shimmy-verdict h1', { hasText: words }).waitFor({ timeout: 5000 });

/** A field's number, its slider and what was refused, by the parameter's name. @param {Page} page @param {string} name */
export function knob(page, name) {
  const place = page.locator(`shimmy-dock shimmy-knob[data-name="${name}"]`);
  return { number: place.locator('.number'), slider: place.locator('.slider'), refusal: place.locator('.refusal'), reset: place.locator('.reset') };
}

/** Types a number as a person does. @param {Page} page @param {string} name @param {string} text */
export async function type(page, name, text) {
  const { number } = knob(page, name);
  await number.click();
  await page.keyboard.press('Control+A');
  await page.keyboard.type(text);
  await page.keyboard.press('Enter');
}

/**
 * The drawn pixels of the gear, as one number for each of a grid of places: it changes as the wheel turns.
 * @param {Page} page
 * @returns {Promise<number[]>}
 */
export function gearPixels(page) {
  return page.locator('.gear canvas').evaluate((/** @type {HTMLCanvasElement} */ canvas) => {
    const { width, height } = canvas;
    // Read from a copy, or Chromium warns of a canvas that is drawn and read in turn.
    const copy = /** @type {OffscreenCanvasRenderingContext2D} */ (new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true }));
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(0, 0, width, height);
    const sums = new Array(64).fill(0);
    for (let y = 0; y < height; y++)
      for (let x = 0; x < width; x++) {
        const at = 4 * (y * width + x);
        sums[8 * Math.floor((8 * y) / height) + Math.floor((8 * x) / width)] += data[at] + data[at + 1] + data[at + 2];
      }
    return sums;
  });
}
