import assert from 'node:assert/strict';
import test from 'node:test';
import { refusal, shimmy, SHIMMY } from './module.mjs';

test('the cycle of 51.87 Hz has its peak there, and the third harmonic next', () => {
  const { time, torsionAngle } = shimmy.simulate({ ...SHIMMY, duration: 4, samples: 4001 });
  const { frequency, amplitude, peak } = shimmy.spectrum({ values: torsionAngle.subarray(2001), interval: time[1] });
  assert.ok(frequency instanceof Float64Array && amplitude instanceof Float64Array);
  assert.equal(frequency.length, 1001);
  assert.equal(amplitude.length, 1001);
  assert.ok(peak && Math.abs(peak.frequency - 51.87) < 5e-3, JSON.stringify(peak));
  assert.ok(peak.amplitude > 0.26 && peak.amplitude < 0.27);
  const beyond = amplitude.slice(100 * 2);
  const next = frequency[200 + beyond.indexOf(Math.max(...beyond))];
  assert.ok(Math.abs(next - 3 * peak.frequency) < 0.5, `${next} Hz`);
});

test('a sinusoid of amplitude 2 shows 2; a list of numbers does as well; what is still has no peak', () => {
  const values = Array.from({ length: 100 }, (_, i) => 5 + 2 * Math.cos((2 * Math.PI * i) / 10));
  const { frequency, amplitude, peak } = shimmy.spectrum({ values, interval: 0.01 });
  assert.ok(Math.abs(amplitude[10] - 2) < 1e-12 && Math.abs(frequency[10] - 10) < 1e-12);
  assert.ok(peak && Math.abs(peak.frequency - 10) < 1e-9 && Math.abs(peak.amplitude - 2) < 1e-9);
  assert.equal(shimmy.spectrum({ values: new Float64Array(64), interval: 1 }).peak, null);
});

test('what is no series is refused in words', () => {
  /** @param {any} series */
  const refused = (series) => refusal(() => shimmy.spectrum(series));
  assert.equal(refused(undefined).code, 'wrong-type');
  assert.equal(refused({ values: [1, 2] }).field, 'interval');
  assert.equal(refused({ values: [1], interval: 1 }).field, 'values');
  assert.equal(refused({ values: ['1', 2], interval: 1 }).field, 'values');
  assert.equal(refused({ values: new Float64Array(65_537), interval: 1 }).code, 'too-large');
  assert.equal(refused({ values: [1, NaN], interval: 1 }).code, 'not-finite');
  assert.equal(refused({ values: [1, 2], interval: 0 }).field, 'interval');
});
