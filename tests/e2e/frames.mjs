// The page's frames in the test's hand: none comes by itself, and each at the time that the test says.

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {{ time: number, state: number[] }} Instant of the run, as it is drawn */

/**
 * Takes the frames over. The page's clock must be paused or just started, for wall time goes on from zero here.
 * @param {Page} page
 */
export async function takeFrames(page) {
  await page.evaluate(() => {
    /** @type {FrameRequestCallback[]} */
    let waiting = [];
    let now = performance.now();
    Object.assign(window, {
      requestAnimationFrame: (/** @type {FrameRequestCallback} */ callback) => waiting.push(callback),
      frame: (/** @type {number} */ passed) => {
        now += passed;
        const due = waiting;
        waiting = [];
        for (const callback of due) callback(now);
        const { time, state } = /** @type {any} */ (document.querySelector('shimmy-stage')).scene;
        return { time, state: [...state] };
      },
    });
  });
  // The frame that the browser has promised already.
  await page.waitForTimeout(100);
}

/**
 * Has so many frames drawn, so many a second, and tells what each has shown.
 * @param {Page} page @param {number} count @param {number} rate in Hz
 * @returns {Promise<Instant[]>}
 */
export const frames = (page, count, rate) =>
  page.evaluate(([times, passed]) => Array.from({ length: times }, () => /** @type {any} */ (window).frame(passed)), [count, 1000 / rate]);

/** What is drawn now. @param {Page} page @returns {Promise<Instant & { fan: number | null }>} */
export const shown = (page) => page.evaluate(() => {
  const { time, state, fan } = /** @type {any} */ (document.querySelector('shimmy-stage')).scene;
  return { time, state: [...state], fan: fan?.length ?? null };
});

/** Waits until what the page has been told is drawn: words follow at once, the picture with the next frame. @param {Page} page */
export const drawn = (page) => page.evaluate(() => new Promise((done) => {
  requestAnimationFrame(() => requestAnimationFrame(() => done(undefined)));
}));
