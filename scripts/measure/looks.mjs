// A view looked at for the first time: the longest of its frames' scripts, and the longest task of the main thread, until it has settled.

import { ask, open } from './page.mjs';

/** So long a view is watched after it was chosen, in ms. */
const watched = 2500;

/**
 * @param {import('playwright-core').Browser} browser
 * @param {string} address
 * @param {{ lens: string }} options
 * @returns {Promise<{ view: string, script: number, task: number }[]>} in ms
 */
export async function measureLooks(browser, address, { lens }) {
  const page = await open(browser, address, 'phase');
  await page.evaluate(() => {
    /** @type {number[]} */
    const tasks = [];
    Object.assign(window, { longTasks: tasks });
    new PerformanceObserver((list) => list.getEntries().forEach(({ duration }) => tasks.push(duration))).observe({ type: 'longtask', buffered: false });
  });
  await page.waitForTimeout(2000);
  const watch = async (/** @type {string} */ view, /** @type {() => Promise<unknown>} */ choose) => {
    await ask(page, (probe) => probe.clear());
    await page.evaluate(() => { /** @type {any} */ (window).longTasks.length = 0; });
    await choose();
    await page.waitForTimeout(watched);
    const frames = await ask(page, (probe) => probe.frames);
    const tasks = /** @type {number[]} */ (await page.evaluate(() => /** @type {any} */ (window).longTasks));
    return { view, script: Math.max(...frames.map(({ script }) => script)), task: Math.max(0, ...tasks) };
  };
  const looks = [await watch('(the lens)', () => page.locator(`#tab-${lens}`).click())];
  const select = page.locator('#lens-panel select.views');
  for (const view of await select.locator('option').evaluateAll((options) => options.map((option) => /** @type {HTMLOptionElement} */ (option).value))) looks.push(await watch(view, () => select.selectOption(view)));
  await page.context().close();
  return looks;
}
