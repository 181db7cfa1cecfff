// Script time a frame while the page plays, by its parts on the main thread.

import { ask, open } from './page.mjs';
import { mean, percentile } from './statistics.mjs';

/**
 * @param {import('playwright-core').Browser} browser
 * @param {string} address
 * @param {{ lens: string, seconds: number }} options
 */
export async function measureFrames(browser, address, { lens, seconds }) {
  const page = await open(browser, address, lens);
  const devtools = await page.context().newCDPSession(page);
  // Processor time, which other programs of a busy machine do not lengthen.
  await devtools.send('Performance.enable', { timeDomain: 'threadTicks' });
  const metrics = async () => Object.fromEntries((await devtools.send('Performance.getMetrics')).metrics.map(({ name, value }) => [name, value]));
  await page.waitForTimeout(2000);
  await ask(page, (probe) => probe.clear());
  const before = await metrics();
  await page.waitForTimeout(1000 * seconds);
  const after = await metrics();
  const frames = await ask(page, (probe) => probe.frames);
  await page.context().close();
  const scripts = frames.map(({ script }) => script);
  const each = (/** @type {string} */ name) => (1000 * (after[name] - before[name])) / frames.length;
  return {
    mean: mean(scripts), p95: percentile(scripts, 95), max: Math.max(...scripts),
    perSecond: frames.length / seconds,
    /** Processor time in ms a frame, by Chromium's own count: scripts, style and layout, all tasks of the main thread. */
    parts: { scripts: each('ScriptDuration'), layout: each('LayoutDuration') + each('RecalcStyleDuration'), tasks: each('TaskDuration') },
  };
}
