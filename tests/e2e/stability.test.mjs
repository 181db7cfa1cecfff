// The lens Stability: the gear as a point in a plane, the roots that walk with it, and how it is all asked for and hidden.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import init, * as engine from '../../www/pkg/shimmy.js';
import { knob, type, untilVerdict, withPage } from './chromium.mjs';

/** @typedef {import('playwright-core').Page} Page */

await init({ module_or_path: await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)) });
const axe = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

const site = withPage();

const start = '#shimmy=2&velocity=80&dampingConstant=30&initial.torsionAngle=0.05&lens=stability';

/** @param {string} [more] of the link @param {import('./chromium.mjs').Options} [options] */
async function opened(more = '', options = {}) {
  const visit = await site.open(start + more, options);
  await visit.page.locator('shimmy-stability-lens .stability').waitFor();
  return visit;
}

/** @param {Page} page */
const point = (page) => page.getByRole('slider', { name: 'The gear in the plane' });

/** What the point says of itself, once it says this. @param {Page} page @param {RegExp} words */
async function untilSaid(page, words) {
  await page.waitForFunction(([source, flags]) => new RegExp(source, flags).test(document.querySelector('.plane-point')?.getAttribute('aria-valuetext') ?? ''), [words.source, words.flags]);
  return await point(page).getAttribute('aria-valuetext') ?? '';
}

/** Where a pair of values stands on the screen. @param {Page} page @param {number} x @param {number} y */
const placeOf = (page, x, y) => page.evaluate(async ([across, up]) => {
  const plane = /** @type {import('../../www/lens/stability/plane.js').Plane} */ (document.querySelector('shimmy-plane'));
  const canvas = /** @type {HTMLElement} */ (plane.querySelector('shimmy-canvas')).getBoundingClientRect();
  const size = parseFloat(getComputedStyle(plane).getPropertyValue('--size-1')) * 16;
  const chosen = /** @type {import('../../www/lens/stability/settings.js').Plane} */ (plane.plane);
  // As view/axes.js lays out a frame with the upward name above it.
  const frame = { left: 3.6 * size, right: canvas.width - 1.6 * size, top: 2.2 * size, bottom: canvas.height - 3.3 * size };
  return {
    x: canvas.left + frame.left + ((across - chosen.x.from) / (chosen.x.to - chosen.x.from)) * (frame.right - frame.left),
    y: canvas.top + frame.bottom - ((up - chosen.y.from) / (chosen.y.to - chosen.y.from)) * (frame.bottom - frame.top),
  };
}, [x, y]);

/** The colors of the plane's picture around a place. @param {Page} page @param {{ x: number, y: number }} at */
const redness = (page, at) => page.evaluate(({ x, y }) => {
  const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('shimmy-plane shimmy-canvas canvas'));
  const box = canvas.getBoundingClientRect();
  const ratio = canvas.width / box.width;
  const copy = /** @type {OffscreenCanvasRenderingContext2D} */ (new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', { willReadFrequently: true }));
  copy.drawImage(canvas, 0, 0);
  const { data } = copy.getImageData(Math.round((x - box.left) * ratio) - 8, Math.round((y - box.top) * ratio) - 8, 16, 16);
  let red = 0;
  for (let i = 0; i < data.length; i += 4) red += data[i] - data[i + 1];
  return red / (data.length / 4);
}, at);

test('dragged across the boundary the gear calms, the crossing is told with its frequency, and one undo takes it back', async () => {
  const { page, leave } = await opened();
  await untilVerdict(page, 'It shimmies');
  const from = await untilSaid(page, /speed 80.*grows/);
  const [grip, goal] = [await placeOf(page, 80, 30), await placeOf(page, 80, 70)];
  await page.mouse.move(grip.x, grip.y);
  await page.mouse.down();
  await page.mouse.move(grip.x, goal.y, { steps: 12 });
  // The hand has not let go.
  await untilSaid(page, /falls/);
  await untilVerdict(page, 'It dies out');
  const told = await page.locator('.stability [role="status"]').innerText();
  const [, frequency] = told.match(/^Hopf, ([\d.]+) Hz: it now falls/) ?? [];
  // Linear theory: at v = 80 the pair crosses at c = 48.530; ω² = a₁ there.
  const crossing = engine.eigenvalues({ model: 'torsional', parameters: { velocity: 80, dampingConstant: 48.53 } })[0];
  assert.ok(Math.abs(crossing.re) < 1e-3 && Math.abs(Number(frequency) - crossing.im / (2 * Math.PI)) < 0.06, told);
  await page.mouse.up();
  assert.equal(Math.round(Number(await knob(page, 'dampingConstant').number.inputValue())), 70);
  assert.equal(Number(await knob(page, 'velocity').number.inputValue()), 80);
  await page.keyboard.press('Control+z');
  assert.equal(await untilSaid(page, /damping 30/), from);
  await leave();
});

test('the map is red where it shimmies; another value than the point’s own moves the boundary', async () => {
  const { page, leave } = await opened();
  await untilSaid(page, /grows/);
  const [inside, outside] = [await placeOf(page, 60, 42.5), await placeOf(page, 60, 52.5)];
  const drawn = async () => [await redness(page, inside), await redness(page, outside)].map((red) => red > 20);
  // At 60 m/s the boundary is at c = 44.0.
  assert.deepEqual(await drawn(), [true, false]);
  // A longer caster takes its share of the plane.
  await type(page, 'casterLength', '0.2');
  await page.waitForFunction(() => !document.querySelector('.share')?.textContent?.startsWith('68'));
  await page.waitForTimeout(200);
  const growth = (/** @type {number} */ dampingConstant) => engine.eigenvalues({ model: 'torsional', parameters: { velocity: 60, dampingConstant, casterLength: 0.2 } })[0].re > 0;
  assert.deepEqual(await drawn(), [growth(42.5), growth(52.5)]);
  await leave();
});

test('the share that is read and said is the engine’s own, by the exact boundary', async () => {
  const { page, leave } = await opened();
  const { stableArea } = engine.stabilityMap({
    model: 'torsional', parameters: { casterLength: 0.1 }, quantities: ['stable'],
    x: { parameter: 'velocity', from: 0.5, to: 100, count: 400 }, y: { parameter: 'dampingConstant', from: 0, to: 100, count: 300 },
  });
  await page.waitForFunction(() => document.querySelector('.share')?.textContent !== '');
  const words = `${stableArea?.toFixed(1)} % of the plane is stable: v 0.5 … 100 m/s, c 0 … 100 N m s/rad`;
  await page.waitForFunction((text) => document.querySelector('.share .full')?.textContent?.replaceAll('\u00a0', ' ') === text, words.replaceAll('\u00a0', ' '));
  assert.ok((await page.locator('shimmy-plane canvas').first().getAttribute('aria-label'))?.replaceAll('\u00a0', ' ').includes(words.replaceAll('\u00a0', ' ')));
  await leave();
});

test('axes are chosen, swapped and colored, and a link brings them back', async () => {
  const { page, leave } = await opened();
  await untilSaid(page, /grows/);
  await page.getByRole('button', { name: /the plane of caster over speed/ }).click();
  await untilSaid(page, /speed 80.*caster 0\.100/);
  await page.getByLabel('Swap the axes').click();
  await untilSaid(page, /caster 0\.100 m, speed 80/);
  await page.getByLabel('Upward').selectOption('torsionalStiffness');
  await untilSaid(page, /caster 0\.100 m, stiffness/);
  // The other side's own parameter: they change places.
  await page.getByLabel('To the right').selectOption('torsionalStiffness');
  await untilSaid(page, /stiffness 100.000 N m\/rad, caster/);
  await page.getByLabel('Color').selectOption('frequency');
  await page.waitForFunction(() => location.hash.includes('view.plane=torsionalStiffness:0:300000,casterLength:0:0.5,frequency'));
  const address = page.url();
  await leave();
  const again = await site.openAt(address);
  await again.page.locator('.plane-point').waitFor();
  await untilSaid(again.page, /stiffness 100.000 N m\/rad, caster/);
  assert.equal(await again.page.getByLabel('Color').inputValue(), 'frequency');
  assert.equal(await again.page.locator('.note').count(), 0);
  await again.leave();
});

test('by the keyboard: arrows step like a knob, Shift by ten, Alt by a tenth; a click brings the point', async () => {
  const { page, leave } = await opened();
  await untilSaid(page, /grows/);
  await page.getByRole('button', { name: 'Pause' }).click();
  await point(page).focus();
  for (const [key, values] of /** @type {const} */ ([
    ['ArrowRight', 'speed 81.0 m/s, damping 30.0'], ['Shift+ArrowUp', 'speed 81.0 m/s, damping 40.0'], ['Alt+ArrowLeft', 'speed 80.9 m/s, damping 40.0'],
    ['ArrowDown', 'speed 80.9 m/s, damping 39.0'], ['Shift+ArrowRight', 'speed 90.9 m/s, damping 39.0'], ['Shift+ArrowRight', 'speed 100.0 m/s, damping 39.0'],
  ])) {
    await page.keyboard.press(key);
    await untilSaid(page, new RegExp(values.replaceAll('.', '\\.')));
  }
  const place = await placeOf(page, 20, 80);
  await page.mouse.click(place.x, place.y);
  const said = await untilSaid(page, /falls/);
  const [, speed, damping] = said.match(/speed ([\d.]+) m\/s, damping ([\d.]+)/) ?? [];
  assert.ok(Math.abs(Number(speed) - 20) < 0.5 && Math.abs(Number(damping) - 80) < 0.5, said);
  await page.keyboard.press('?');
  assert.match(await page.locator('.menu-sheet').innerText(), /on the point of a stability plane/);
  await leave();
});

test('a finger drags the point by 44 px of it, on a phone too, and nothing is wider than the screen', async () => {
  const { page, leave } = await opened('', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await untilSaid(page, /grows/);
  const box = await point(page).boundingBox();
  assert.ok(box && box.width >= 44 && box.height >= 44);
  await page.getByRole('button', { name: 'More choices' }).click();
  for (const name of ['.plane-choices select', '.plane-choices button'])
    for (const target of await page.locator(name).all()) assert.ok(((await target.boundingBox())?.height ?? 0) >= 44, name);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  await point(page).scrollIntoViewIfNeeded();
  await point(page).evaluate((element) => {
    const { left, top } = element.getBoundingClientRect();
    const touch = (/** @type {string} */ kind, /** @type {number} */ dx) => element.dispatchEvent(new PointerEvent(kind, {
      bubbles: true, pointerId: 1, pointerType: 'touch', isPrimary: true, button: kind === 'pointermove' ? -1 : 0, clientX: left + 22 + dx, clientY: top + 22,
    }));
    element.setPointerCapture = () => {};
    touch('pointerdown', 0);
    touch('pointermove', -200);
    touch('pointerup', -200);
  });
  await untilSaid(page, /falls/);
  await leave();
});

test('veiled, neither eye nor ear learns of map, roots and swing; revealed, they do', async () => {
  const { page, leave } = await opened('&predict=1');
  await point(page).waitFor();
  const heard = () => page.evaluate(() => [...document.querySelectorAll('#lens-panel *')].flatMap((element) =>
    [element.getAttribute('aria-label'), element.getAttribute('aria-valuetext'), element.children.length === 0 ? element.textContent : '']).join(' '));
  await page.waitForFunction(() => document.querySelector('.plane-point')?.getAttribute('aria-valuetext'));
  assert.ok(!/grows|falls|stable:|Hopf|doubles|s⁻¹/.test(await heard()), await heard());
  const inside = await placeOf(page, 60, 20);
  assert.ok(await redness(page, inside) < 10);
  // The point may be moved, as the knobs may.
  await point(page).focus();
  await page.keyboard.press('Shift+ArrowUp');
  await untilSaid(page, /damping 40\.0 N m s\/rad$/);
  await page.keyboard.press('3');
  await page.keyboard.press('Enter');
  await untilSaid(page, /grows/);
  assert.match(await heard(), /doubles/);
  // What is revealed is drawn in the frames to come, and may have another place.
  let red = 0;
  for (let i = 0; i < 20 && red <= 20; i++) {
    await page.waitForTimeout(100);
    red = await redness(page, await placeOf(page, 60, 20));
  }
  assert.ok(red > 20, `${red}`);
  await leave();
});

for (const [width, height] of [[1024, 768], [720, 450], [390, 844]])
  test(`plane, roots and one row of choices are seen together at ${width} × ${height}, and that it is linear theory`, async () => {
    const { page, leave } = await opened('&freeplayAngle=0.017453292519943295', { viewport: { width, height } });
    await untilSaid(page, /grows/);
    await page.evaluate(() => {
      const edge = (/** @type {string} */ name) => /** @type {Element} */ (document.querySelector(name)).getBoundingClientRect();
      scrollBy(0, edge('shimmy-plane').bottom - edge('shimmy-dock').top);
    });
    const [choices, plane, roots, dock] = await Promise.all(['.plane-choices', 'shimmy-plane', '.stability .roots', 'shimmy-dock'].map((name) => page.locator(name).boundingBox()));
    assert.ok(choices && plane && roots && dock && choices.height < 60, `${choices?.height}`);
    assert.ok(plane.height >= 200 && roots.y === plane.y && roots.x >= plane.x + plane.width);
    assert.ok(plane.y >= 0 && plane.y + plane.height <= dock.y + 1, `${plane.y} ${plane.height} ${dock.y}`);
    assert.match(await page.locator('.share .brief').innerText(), /% stable \(linear theory, inside the gap\): v\s0\.5\s…\s100\sm\/s, c\s0\s…\s100\sN/);
    await leave();
  });

for (const [width, height] of [[1024, 768], [390, 844]])
  test(`what a narrow plane has no room for is read beside it at ${width} × ${height}; with a pen in hand, of the gear`, async () => {
    const { page, leave } = await opened('', { viewport: { width, height } });
    const read = page.locator('.plane-reading');
    await read.waitFor();
    const own = (await read.innerText()).replaceAll('\u00a0', ' ');
    assert.match(own, /^v 80\.0 m\/s, c 30\.0 N m s\/rad: grows \d/);
    const canvas = page.locator('shimmy-plane canvas').first();
    await canvas.hover({ position: { x: 90, y: 60 } });
    await page.waitForFunction((text) => document.querySelector('.plane-reading')?.textContent?.replaceAll('\u00a0', ' ') !== text, own);
    await page.keyboard.press('d');
    await page.locator('shimmy-plane shimmy-pen-layer').waitFor();
    await page.mouse.move(0, 0);
    const box = await canvas.boundingBox();
    if (box) for (let step = 0; step < 4; step++) await page.mouse.move(box.x + 80 + 10 * step, box.y + 60);
    await page.waitForFunction((text) => document.querySelector('.plane-reading')?.textContent?.replaceAll('\u00a0', ' ') === text, own);
    await leave();
  });

test('with a gap every verdict speaks of linear theory', async () => {
  const { page, leave } = await opened('&freeplayAngle=0.017453292519943295');
  const said = await untilSaid(page, /grows/);
  assert.match(said, /\(linear theory, inside the gap\)$/);
  // Inside the gap no spring works.
  const [{ re, im }] = engine.eigenvalues({ model: 'torsional', parameters: { velocity: 80, dampingConstant: 30, torsionalStiffness: 0 } });
  assert.ok(said.includes(`grows ${re.toFixed(1)} s⁻¹, ${(im / (2 * Math.PI)).toFixed(1)} Hz`), said);
  assert.match(await page.locator('.share').innerText(), /^Linear theory inside the gap, where no spring works: /);
  assert.match(await page.locator('.history canvas').getAttribute('aria-label') ?? '', /doubles in .*\(linear theory, inside the gap\)/);
  await leave();
});

test('loci are swept as chosen, and figure 5.5 is a press away', async () => {
  const { page, leave } = await opened();
  await untilSaid(page, /grows/);
  await page.getByLabel('What the lens shows').selectOption('locus');
  const label = () => page.locator('.stability[data-view="locus"] canvas').getAttribute('aria-label');
  await page.locator('.stability[data-view="locus"]').waitFor();
  assert.match(await label() ?? '', /as speed goes from 0\.5 m\/s to 100\.0 m\/s, for 6 values of caster/);
  await page.getByLabel('Swept').selectOption('casterLength');
  await page.waitForFunction(() => location.hash.includes('view.locus=casterLength:0:0.5') && location.hash.includes('view.stability=locus'));
  assert.match(await label() ?? '', /as caster goes from 0\.000 m to 0\.500 m\./);
  await page.getByLabel('Caster, to').fill('0.3');
  await page.getByLabel('Caster, to').press('Enter');
  await page.waitForFunction(() => location.hash.includes('view.locus=casterLength:0:0.3'));
  await page.getByLabel('Caster, to').fill('-1');
  await page.getByLabel('Caster, to').press('Enter');
  assert.match(await page.locator('#locus-why').innerText(), /less than the last/);
  await page.getByRole('button', { name: 'Figure 5.5' }).click();
  await page.waitForFunction(() => location.hash.includes('view.locus=velocity:0.5:100,casterLength:0:0.5:6'));
  // Its ranges alone do not make it that figure: the gear has another damping.
  const figure = page.getByRole('button', { name: 'Figure 5.5' });
  assert.equal(await figure.getAttribute('aria-pressed'), 'false');
  assert.match(await page.locator('.strangers').innerText(), /Not the thesis’ gear\. Other values: c\./);
  await page.locator('.strangers button').click();
  await page.locator('.strangers').waitFor({ state: 'detached' });
  assert.equal(await figure.getAttribute('aria-pressed'), 'true');
  await leave();
});

test('its pictures leave the page, the plane’s colors as an image in the SVG; a pen draws over the point', async () => {
  const { page, leave } = await opened('', { acceptDownloads: true });
  await untilSaid(page, /grows/);
  await page.getByText('Share', { exact: true }).click();
  const arriving = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Stability plane as SVG' }).click();
  const file = await readFile(await (await arriving).path(), 'utf8');
  assert.match(file, /<image [^>]*href="data:image\/png;base64,/);
  for (const words of ['dies out', 'shimmies', '−40']) assert.ok(file.includes(`>${words}<`), words);
  const share = String(await page.locator('.share .full').textContent());
  assert.match(share, /^\d+\.\d\s% of the plane is stable: v\s0.5\s…\s100\sm\/s, c\s0\s…\s100/);
  assert.ok(file.includes(`>${share}<`), 'the stable share with its ranges goes with the picture');
  await page.keyboard.press('Escape');
  await page.keyboard.press('d');
  await page.locator('shimmy-plane shimmy-pen-layer').waitFor();
  const before = await untilSaid(page, /grows/);
  const at = await placeOf(page, 80, 30);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x - 60, at.y - 40, { steps: 5 });
  await page.mouse.up();
  assert.equal(await untilSaid(page, /grows/), before, 'the pen does not move the gear');
  await leave();
});

test('nothing stands in the way of assistive technology', async () => {
  for (const more of ['', '&view.stability=roots', '&view.stability=locus']) {
    const { page, leave } = await opened(more);
    await page.waitForTimeout(500);
    await page.evaluate(axe);
    const found = await page.evaluate(async () => {
      const { violations } = await /** @type {any} */ (window).axe.run('#lens-panel');
      return violations.flatMap((/** @type {any} */ { id, nodes }) => nodes.map((/** @type {any} */ { target, failureSummary }) => `${id} ${target}: ${failureSummary}`));
    });
    assert.deepEqual(found, []);
    await leave();
  }
});

test('a plane has the ranges that one types, refuses what is none, and gives its share of them', async () => {
  const { page, leave } = await opened();
  await untilSaid(page, /grows/);
  await page.getByRole('button', { name: 'More choices' }).click();
  const until = page.getByLabel('Speed, to');
  await until.fill('50');
  await until.press('Enter');
  await page.waitForFunction(() => location.hash.includes('view.plane=velocity:0.5:50,dampingConstant:0:100,growthRate'));
  await page.waitForFunction(() => /83\.4\s% of the plane is stable: v\s0\.5\s…\s50\sm\/s/.test(document.querySelector('.share')?.textContent ?? ''));
  await until.fill('0.2');
  await until.press('Enter');
  assert.match(await page.locator('#plane-x-why').innerText(), /less than the last/);
  assert.ok(await page.evaluate(() => location.hash.includes('velocity:0.5:50')));
  await page.getByLabel('Damping, from').fill('-3');
  await page.getByLabel('Damping, from').press('Enter');
  assert.match(await page.locator('#plane-y-why').innerText(), /Damping/);
  await leave();
});

test('an end of a sweep that the gear cannot have is explained, and the last good one stays', async () => {
  const { page, leave } = await site.open('#shimmy=2&velocity=80&dampingConstant=20&initial.torsionAngle=0.05&lens=stability&view.stability=locus');
  await untilVerdict(page, 'It shimmies');
  const from = page.locator('.plane-choices .number').first();
  const why = page.locator('#locus-why');
  for (const [typed, said] of [['-5', /Speed must be above 0 m\/s\. It stays at 0\.5\./], ['abc', /0\.5/], ['1e400', /0\.5/], ['200', /less than the last/]]) {
    await from.fill(/** @type {string} */ (typed));
    await from.press('Enter');
    await page.waitForFunction(() => document.querySelector('#locus-why')?.textContent !== '');
    assert.match(await why.innerText(), /** @type {RegExp} */ (said), String(typed));
    assert.equal(await from.getAttribute('aria-invalid'), 'true');
    assert.doesNotMatch(page.url(), /view\.locus/);
  }
  await from.fill('2,5');
  await from.press('Enter');
  await page.waitForURL(/view\.locus=velocity:2\.5:100/);
  assert.equal(await why.innerText(), '');
  assert.equal(await from.getAttribute('aria-invalid'), 'false');
  await leave();
});
