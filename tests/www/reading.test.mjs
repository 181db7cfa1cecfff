import { test } from 'node:test';
import assert from 'node:assert/strict';
import { differenceOf, readingAt } from '../../www/view/reading.js';

/** As fine as the page's own lane: 240 samples in 100 ms. @param {(t: number) => number} f */
const lane = (f) => {
  const time = Float64Array.from({ length: 240 }, (_, i) => -0.1 + (0.1 * i) / 239);
  return { time, values: time.map(f) };
};
const near = (/** @type {number | null | undefined} */ value, /** @type {number} */ wanted, /** @type {number} */ share) =>
  assert.ok(value != null && Math.abs(value / wanted - 1) < share, `${value}, not ${wanted}`);

test('a sinusoid is read as it is, wherever the cursor stands', () => {
  const { time, values } = lane((t) => 0.236 * Math.sin(2 * Math.PI * 51.87 * t + 1));
  for (const at of [-0.1, -0.0871, -0.05, -0.012, 0]) {
    const reading = readingAt(time, values, at);
    // Straight lines between 46 samples a cycle are off by up to (π/46)²/2 of the amplitude.
    assert.ok(Math.abs((reading?.value ?? NaN) - 0.236 * Math.sin(2 * Math.PI * 51.87 * at + 1)) < 0.236 * 2.4e-3);
    // Near its zeros a sinusoid is straight to third order, and its top is a parabola to fourth.
    near(reading?.frequency, 51.87, 2e-4);
    near(reading?.peakToPeak, 0.472, 1e-4);
  }
});

test('a growing sinusoid is read about the cursor: larger later, its beat unchanged', () => {
  const [growth, omega] = [16, 2 * Math.PI * 50];
  const { time, values } = lane((t) => 0.1 * Math.exp(growth * t) * Math.sin(omega * t));
  // Zeros at whole half periods; extremes where tan ωt = −ω/growth, there |sin| = ω/√(ω² + growth²).
  const lag = Math.PI - Math.atan(omega / growth);
  const peak = (/** @type {number} */ half) => 0.1 * Math.exp((growth * (lag + half * Math.PI)) / omega) * (omega / Math.hypot(omega, growth));
  for (const [at, half] of [[-0.09, -10], [-0.05, -6], [-0.03, -4]]) {
    const reading = readingAt(time, values, at);
    near(reading?.frequency, 50, 2e-4);
    // The cycle whose middle is nearest to the cursor: half periods `half` and the next.
    near(reading?.peakToPeak, peak(half) + peak(half + 1), 2e-4);
  }
});

test('near the end the last whole cycle is read, and without a cycle none', () => {
  const { time, values } = lane((t) => Math.exp(10 * t) * Math.sin(100 * Math.PI * t));
  assert.deepEqual(readingAt(time, values, 0)?.frequency, readingAt(time, values, -0.008)?.frequency);
  const slow = lane((t) => t + 0.05);
  assert.deepEqual(readingAt(slow.time, slow.values, -0.02), { time: -0.02, value: readingAt(slow.time, slow.values, -0.02)?.value, peakToPeak: null, frequency: null });
  near(readingAt(slow.time, slow.values, -0.02)?.value, 0.03, 1e-9);
  const rest = lane(() => 0);
  assert.deepEqual(readingAt(rest.time, rest.values, -0.02), { time: -0.02, value: 0, peakToPeak: null, frequency: null });
});

test('outside the history nothing is read', () => {
  const { time, values } = lane(Math.sin);
  for (const at of [-0.101, 0.001, NaN]) assert.equal(readingAt(time, values, at), null);
  assert.equal(readingAt([], [], 0), null);
});

test('two cursors give differences and the frequency of their distance', () => {
  const reading = (/** @type {number} */ time, /** @type {number} */ value) => ({ time, value, peakToPeak: null, frequency: null });
  const difference = differenceOf(reading(-0.05, 0.2), reading(-0.03, 0.23));
  near(difference.time, 0.02, 1e-12);
  near(difference.frequency, 50, 1e-12);
  near(difference.value, 0.03, 1e-9);
  near(differenceOf(reading(-0.03, 0), reading(-0.05, 0)).frequency, 50, 1e-12);
  assert.equal(differenceOf(reading(1, 0), reading(1, 0)).frequency, null);
});
