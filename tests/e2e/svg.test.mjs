// A view as SVG is the view on its canvas: both are drawn by the browser and held side by side.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { withPage } from './chromium.mjs';
import { openWorkshop } from './workshop.mjs';

const site = withPage(openWorkshop);

/** @type {[string, 'light' | 'dark', string][]} */
const scenes = [
  ['the opening run, light', 'light', ''],
  ['a rattle in the gap, dark', 'dark', '#shimmy=1&velocity=50&dampingConstant=100&freeplayAngle=0.017453292519943295&initial.torsionAngle=0.05'],
  ['a stability plane with roots and history, light', 'light', '#shimmy=2&velocity=80&dampingConstant=30&initial.torsionAngle=0.05&lens=stability'],
];

for (const [name, colorScheme, link] of scenes) {
  test(`every view on screen looks the same as SVG: ${name}`, async () => {
    // Paused by reduced motion, so that both drawings are of one instant.
    const context = await site.browser.newContext({ viewport: { width: 1440, height: 900 }, colorScheme, reducedMotion: 'reduce' });
    const page = await context.newPage();
    await page.goto(site.address + link);
    await page.getByRole('button', { name: 'Play', exact: true }).waitFor();
    await page.waitForFunction(() => document.fonts.status === 'loaded' && document.querySelector('shimmy-verdict h1')?.textContent);
    await page.waitForTimeout(500);
    const views = await page.evaluate(drawBoth);
    assert.ok(views.length >= 6, `${views.length} drawings`);
    for (const { width, height, svg, hasWords } of views) {
      await page.evaluate(lay, { svg });
      const drawn = await page.screenshot({ clip: { x: 0, y: 0, width, height } });
      await page.evaluate(lay, { svg: '' });
      const painted = await page.screenshot({ clip: { x: 0, y: 0, width, height } });
      await page.evaluate(() => document.querySelector('#both div')?.remove());
      const { apart, inked } = await page.evaluate(compare, [drawn, painted].map((shot) => `data:image/png;base64,${shot.toString('base64')}`));
      assert.ok(inked > 0.005, `the view is blank: ${inked}`);
      // Letters are placed on fractions of a pixel by one and not by the other; lines are the same but for their edges. Of a
      // small picture words are a larger part.
      const allowed = hasWords ? (width < 400 ? 0.02 : 0.01) : 0.0006;
      assert.ok(apart < allowed, `${apart} of ${width} × ${height} pixels differ ${hasWords ? 'with' : 'without'} words`);
    }
    await context.close();
  });
}

/**
 * Each view's SVG, with its words and without; its canvases wait, drawn at the same whole size and one to one, in #both.
 * @returns {Promise<{ width: number, height: number, svg: string, hasWords: boolean }[]>}
 */
async function drawBoth() {
  const path = '/out/svg.js';
  const { svgOf } = /** @type {typeof import('../../www/out/svg.js')} */ (await import(path));
  // Without it the drawings keep no bitmaps, in which words could not be left out.
  const { OffscreenCanvas } = window;
  Object.assign(window, { OffscreenCanvas: undefined });
  const both = document.body.appendChild(document.createElement('div'));
  both.id = 'both';
  both.style.cssText = 'position: fixed; inset: 0; z-index: 99; background: var(--surface)';
  const views = /** @type {import('../../www/view/canvas.js').Canvas[]} */ ([...document.querySelectorAll('shimmy-canvas')]);
  const drawn = views.flatMap((view) => [{ view, hasWords: true }, { view, hasWords: false }]).map(({ view: { paint: all, size }, hasWords }) => {
    /** @type {import('../../www/view/canvas.js').Paint} */
    const paint = (context, within) => {
      if (!hasWords) Object.assign(context, { fillText() {}, strokeText() {} });
      all?.(context, within);
    };
    const [width, height] = [Math.floor(size.width), Math.floor(size.height)];
    const frame = both.appendChild(document.createElement('div'));
    const canvas = frame.appendChild(Object.assign(document.createElement('canvas'), { width, height }));
    canvas.style.cssText = `width: ${width}px; height: ${height}px`;
    frame.hidden = true;
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    paint(context, { width, height });
    const ruler = /** @type {CanvasRenderingContext2D} */ (document.createElement('canvas').getContext('2d'));
    return { width, height, hasWords, svg: svgOf({ size: { width, height }, paint }, 'a view', ruler) };
  });
  Object.assign(window, { OffscreenCanvas });
  return drawn;
}

/** Shows the SVG in place of the first canvas that waits, or that canvas. @param {{ svg: string }} what */
function lay({ svg }) {
  const both = /** @type {HTMLElement} */ (document.querySelector('#both'));
  both.querySelector('svg')?.remove();
  const frame = /** @type {HTMLElement} */ (both.querySelector('div'));
  frame.hidden = svg !== '';
  if (svg) both.insertAdjacentHTML('afterbegin', svg);
}

/**
 * The share of pixels of which a channel differs by more than a quarter, and of those that are not the most frequent color.
 * @param {string[]} shots
 */
async function compare(shots) {
  const [one, other] = await Promise.all(shots.map(async (address) => {
    const image = new Image();
    image.src = address;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d'));
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, image.width, image.height).data;
  }));
  let apart = 0;
  /** @type {Map<number, number>} */
  const colors = new Map();
  for (let at = 0; at < one.length; at += 4) {
    if ([0, 1, 2].some((channel) => Math.abs(one[at + channel] - other[at + channel]) > 64)) apart++;
    const color = (one[at] << 16) | (one[at + 1] << 8) | one[at + 2];
    colors.set(color, (colors.get(color) ?? 0) + 1);
  }
  const pixels = one.length / 4;
  return { apart: apart / pixels, inked: 1 - Math.max(...colors.values()) / pixels };
}
