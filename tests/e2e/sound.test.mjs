// The swing to be heard: nothing before a hand asks for it, then the very beat of the run, silent where it stands still.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { type, untilVerdict, withPage } from './chromium.mjs';

const site = withPage();

/** @typedef {import('playwright-core').Page} Page */

/** What goes to the loudspeaker is also measured. @param {Page} page */
const listening = async (page) => void await page.addInitScript(() => {
  const own = /** @type {any} */ (window);
  own.contexts = [];
  const AudioContext = /** @type {typeof window.AudioContext} */ (own.AudioContext);
  const { AudioNode } = own;
  own.AudioContext = class extends AudioContext {
    constructor() {
      super();
      own.contexts.push(this);
      own.ear = new AnalyserNode(this, { fftSize: 32768, smoothingTimeConstant: 0 });
    }
  };
  const { connect } = AudioNode.prototype;
  AudioNode.prototype.connect = function (/** @type {any[]} */ ...args) {
    if (args[0] === this.context.destination) connect.call(this, own.ear);
    return connect.apply(this, args);
  };
});

/**
 * What is heard: its loudness, its pitch from how often it repeats itself, and the power above 120 Hz as a share of all.
 * @param {Page} page
 */
const heard = (page) => page.evaluate(() => {
  const { ear } = /** @type {any} */ (window);
  const wave = new Float32Array(ear.fftSize);
  ear.getFloatTimeDomainData(wave);
  const rate = ear.context.sampleRate;
  const loudness = Math.max(...wave.map(Math.abs));
  // The pitch: where the wave is most like itself a little later, read between samples.
  const like = (/** @type {number} */ lag) => {
    let sum = 0;
    for (let i = 0; i + lag < wave.length; i++) sum += wave[i] * wave[i + lag];
    return sum / (wave.length - lag);
  };
  let best = Math.round(rate / 90);
  for (let lag = best; lag < rate / 35; lag++) if (like(lag) > like(best)) best = lag;
  const [left, middle, right] = [best - 1, best, best + 1].map(like);
  const pitch = rate / (best + (0.5 * (left - right)) / (left - 2 * middle + right));
  const decibels = new Float32Array(ear.frequencyBinCount);
  ear.getFloatFrequencyData(decibels);
  const power = (/** @type {number} */ from) => decibels.reduce((sum, value, i) => ((i * rate) / ear.fftSize >= from ? sum + 10 ** (value / 10) : sum), 0);
  return { loudness, pitch, share: power(120) / power(20) };
});

/** @param {Page} page @param {boolean} isLoud */
const untilHeard = (page, isLoud) => page.waitForFunction((loud) => {
  const { ear } = /** @type {any} */ (window);
  // One that rests sends nothing out, whatever was measured last.
  if (ear.context.state === 'suspended') return !loud;
  const wave = new Float32Array(2048);
  ear.getFloatTimeDomainData(wave);
  const loudness = Math.max(...wave.map(Math.abs));
  return loud ? loudness > 0.05 : loudness < 1e-3;
}, isLoud, { timeout: 5000 });

test('no sound is made before a hand asks for it, and what is heard then beats as the run does', async () => {
  const { page, leave } = await site.open('#shimmy=2&velocity=80&dampingConstant=20&initial.torsionAngle=0.05&time=1.5', {}, listening);
  await untilVerdict(page, 'It shimmies');
  assert.equal(await page.evaluate(() => /** @type {any} */ (window).contexts.length), 0);
  const button = page.getByRole('button', { name: 'Hear it' });
  assert.equal(await button.getAttribute('aria-pressed'), 'false');
  await button.click();
  assert.equal(await button.getAttribute('aria-pressed'), 'true');
  await page.getByText('You hear the wheel’s angular acceleration').waitFor();
  await untilHeard(page, true);
  await page.waitForTimeout(1200);
  const tone = await heard(page);
  // reference.json: the limit cycle of this gear beats at 51.867 Hz, and is shown at 1/50.
  assert.ok(Math.abs(tone.pitch / 51.867 - 1) < 0.01, `${tone.pitch} Hz`);
  assert.ok(tone.share > 0.05, `a small loudspeaker gets ${tone.share}`);

  await page.getByRole('button', { name: 'Pause' }).click();
  await untilHeard(page, false);
  await page.keyboard.press(' ');
  await untilHeard(page, true);
  await page.keyboard.press('m');
  assert.equal(await button.getAttribute('aria-pressed'), 'false');
  await untilHeard(page, false);
  await leave();
});

test('under the strobe it is the true beat all the same; what dies out falls silent, what is to be guessed is not heard', async () => {
  const { page, leave } = await site.open('#shimmy=2&velocity=40&dampingConstant=20&initial.torsionAngle=0.3&time=1&clock=strobe', {}, listening);
  await untilVerdict(page, 'It shimmies');
  await page.locator('body').click({ position: { x: 5, y: 5 } });
  await page.keyboard.press('m');
  await untilHeard(page, true);
  await page.waitForTimeout(1200);
  const { pitch } = await heard(page);
  const beat = Number((await page.locator('shimmy-verdict').innerText()).match(/([\d.]+) Hz/)?.[1]);
  assert.ok(Math.abs(pitch / beat - 1) < 0.01, `${pitch} Hz is heard, ${beat} Hz is told`);
  await page.keyboard.press('p');
  await untilHeard(page, false);
  await page.keyboard.press('p');
  await untilHeard(page, true);
  await type(page, 'dampingConstant', '100');
  await untilHeard(page, false);
  await leave();
});
