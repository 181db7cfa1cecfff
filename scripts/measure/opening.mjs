// From the start of the navigation to the first moving wheel, and what was asked of the server until then.

import { ask, open } from './page.mjs';

/**
 * A first visit and the next one, in a fresh profile.
 * @param {import('playwright-core').Browser} browser
 * @param {string} address
 */
async function visitTwice(browser, address) {
  const first = await open(browser, address);
  const cold = await untilMoving(first);
  const isSite = address.startsWith('http');
  // The next visit is that of a site that the browser keeps.
  if (isSite) await first.evaluate(() => navigator.serviceWorker.ready);
  const requests = await first.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name));
  const context = first.context();
  await first.close();
  const warm = await untilMoving(await open(context, address));
  await context.close();
  return { cold, warm, requests: [address, ...requests] };
}

/** @param {import('playwright-core').Page} page @returns {Promise<number>} ms */
async function untilMoving(page) {
  await page.waitForFunction(() => /** @type {any} */ (window).shimmyProbe.movingAt !== null, null, { timeout: 20_000 });
  return /** @type {number} */ (await ask(page, (probe) => probe.movingAt));
}

/**
 * @param {import('playwright-core').Browser} browser
 * @param {string} address
 * @param {number} times
 */
export async function measureOpening(browser, address, times) {
  const visits = [];
  for (let i = 0; i < times; i++) visits.push(await visitTwice(browser, address));
  return { cold: visits.map(({ cold }) => cold), warm: visits.map(({ warm }) => warm), requests: visits[0].requests };
}
