// A slider dragged: from the slider's input event to the end of the frame's scripts, in which all is drawn; and from when the
// hand had moved, with the browser's wait for that frame: by itself it is spread evenly over 0 … 16.7 ms.

import { ask, open, places } from './page.mjs';
import { percentile } from './statistics.mjs';

/**
 * @param {import('playwright-core').Browser} browser
 * @param {string} address
 * @param {{ lens: string, seconds: number }} options
 */
export async function measureDrag(browser, address, { lens, seconds }) {
  const page = await open(browser, address, lens);
  await page.waitForTimeout(1000);
  const box = await page.locator(places.slider).boundingBox();
  if (!box) throw new Error('no slider to drag');
  const [left, width, y] = [box.x + places.thumb, box.width - 2 * places.thumb, box.y + box.height / 2];
  await page.mouse.move(left + 0.1 * width, y);
  await page.mouse.down();
  await ask(page, (probe) => probe.clear());
  const end = Date.now() + 1000 * seconds;
  // To and fro over most of the track, a pixel or two at a time.
  for (let step = 0; Date.now() < end; step++) {
    await page.mouse.move(left + (0.5 - 0.4 * Math.cos(step / 30)) * width, y);
    await page.waitForTimeout(8);
  }
  const answers = await ask(page, (probe) => probe.answers);
  await page.mouse.up();
  await page.context().close();
  const [fromInput, fromHand] = [answers.map(({ input }) => input), answers.map(({ hand }) => hand)].map((times) => ({ p50: percentile(times, 50), p95: percentile(times, 95), max: Math.max(...times) }));
  return { count: answers.length, fromInput, fromHand };
}
