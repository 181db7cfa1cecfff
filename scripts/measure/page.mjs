// The page under measurement: how it is opened, and where on it things are. What depends on the page's markup is here.

import { chromium } from 'playwright-core';
import { chromiumArguments } from '../setup/webdriver.mjs';
import { probe } from './probe.mjs';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {import('./probe.mjs').Probe} Probe */

export const places = {
  gear: '.gear canvas',
  verdict: 'shimmy-verdict h1',
  /** The slider that is dragged, and how much of its ends the thumb takes. */
  slider: 'shimmy-dock shimmy-knob[data-name="dampingConstant"] .slider',
  thumb: 14,
};

/** The opening run under another lens. @param {string} lens */
const withLens = (lens) => (lens ? `#shimmy=1&velocity=80&dampingConstant=20&initial.torsionAngle=0.05&lens=${lens}` : '');

/** @param {string} executablePath */
export const launch = (executablePath) => chromium.launch({ executablePath, args: chromiumArguments() });

/**
 * Opens the page, playing, with the probe in it, and waits until it shimmies.
 * @param {import('playwright-core').BrowserContext | import('playwright-core').Browser} where a browser gives a fresh profile
 * @param {string} address
 * @param {string} [lens]
 */
export async function open(where, address, lens = '') {
  const context = 'newContext' in where ? await where.newContext({ viewport: { width: 1440, height: 900 }, locale: 'en-US' }) : where;
  const page = await context.newPage();
  await page.addInitScript(probe, places.gear);
  await page.goto(address + withLens(lens));
  await page.locator(places.verdict, { hasText: /./ }).waitFor();
  return page;
}

/** A number of the probe's own making. @template Result @param {Page} page @param {(probe: Probe) => Result} read @returns {Promise<Result>} */
export const ask = (page, read) => /** @type {Promise<Result>} */ (page.evaluate(`(${read})(window.shimmyProbe)`));
