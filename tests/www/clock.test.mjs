import { test } from 'node:test';
import assert from 'node:assert/strict';
import { Clock } from '../../www/run/clock.js';
import { isShownTruly, paceAt, slowRateFor, slowRates } from '../../www/run/rate.js';

const near = (/** @type {number} */ actual, /** @type {number} */ expected) =>
  assert.ok(Math.abs(actual - expected) < 1e-12, `${actual} is not ${expected}`);

test('model time is wall time over the rate, however it is cut into frames', () => {
  for (const frame of [1 / 144, 1 / 60, 1 / 7.3 / 2]) {
    const clock = new Clock(50);
    clock.play();
    let model = clock.elapse(10);
    let wall = 10;
    while (wall < 12) model += clock.elapse((wall = Math.min(wall + frame, 12)));
    near(model, 2 / 50);
  }
});

test('a paused clock stands still and does not make up for the pause', () => {
  const clock = new Clock(1);
  assert.equal(clock.elapse(1), 0);
  assert.equal(clock.elapse(2), 0);
  clock.play();
  assert.equal(clock.elapse(3), 0);
  near(clock.elapse(3.05), 0.05);
  clock.pause();
  assert.equal(clock.elapse(9), 0);
  clock.play();
  assert.equal(clock.elapse(20), 0);
  near(clock.elapse(20.02), 0.02);
});

test('a hidden tab does not catch up, and time never runs back', () => {
  const clock = new Clock(2);
  clock.play();
  clock.elapse(0);
  near(clock.elapse(3600), Clock.longestFrame / 2);
  assert.equal(clock.elapse(3599), 0);
  near(clock.elapse(3599.01), 0.005);
});

test('one step is a twentieth of a second of what is seen', () => {
  near(new Clock(50).step, 0.001);
  near(new Clock(25).step, 0.002);
});

test('the slow rate shows nearest to one cycle a second', () => {
  for (const [frequency, slow] of [[51.87, 50], [26.9, 25], [1.2, 1], [9, 10], [130, 100], [2000, 500], [0.01, 1]])
    assert.equal(slowRateFor(frequency), slow, `${frequency} Hz`);
  assert.equal(slowRateFor(null), 50);
  assert.equal(slowRateFor(0), 50);
});

test('a rate with fewer than twelve frames a cycle is not shown as a single pose', () => {
  assert.ok(isShownTruly(25, 51.87));
  assert.ok(!isShownTruly(10, 51.87));
  assert.ok(isShownTruly(10, 50));
  assert.ok(isShownTruly(1, null));
});

test('every rate on offer is told apart: too fast for the screen, seen, too slow to be seen', () => {
  const paces = slowRates.map((slow) => paceAt(slow, 51.87).pace);
  assert.deepEqual(paces, ['too-fast', 'too-fast', 'too-fast', 'too-fast', 'fits', 'fits', 'fits', 'too-slow', 'too-slow']);
  near(paceAt(100, 50).cycle ?? NaN, 2);
  assert.deepEqual(paceAt(500, null), { cycle: null, pace: 'fits' });
});

test('the strobe flashes once a cycle: the swing is seen at 1 Hz and grows at nearly its true pace', () => {
  const period = 1 / 51.9;
  const clock = new Clock(50);
  clock.mode = 'strobe';
  clock.period = period;
  clock.play();
  let model = clock.elapse(0);
  let phase = 0;
  for (let frame = 1; frame <= 600; frame++) {
    const passed = clock.elapse(frame / 60);
    model += passed;
    if (passed > 0) phase += passed / period - Math.round(passed / period);
  }
  assert.ok(Math.abs(model / 10 - 1.18) < 0.01, `true pace × ${model / 10}`);
  assert.ok(Math.abs(phase / 10 - 1) < 0.01, `seen at ${phase / 10} Hz`);
});

test('the strobe waits in the dark for a slow beat, flashes at most sixty times a second, and needs a beat', () => {
  const clock = new Clock(50);
  clock.mode = 'strobe';
  clock.period = 1 / 7;
  clock.play();
  clock.elapse(0);
  const flashes = Array.from({ length: 120 }, (_, i) => clock.elapse((i + 1) / 120)).filter((passed) => passed > 0);
  assert.ok(flashes.length === 7 || flashes.length === 6, `${flashes.length} flashes`);
  clock.period = 1 / 500;
  const fast = Array.from({ length: 240 }, (_, i) => clock.elapse(2 + i / 240)).filter((passed) => passed > 0);
  assert.ok(fast.length <= 61, `${fast.length} flashes in a second`);
  clock.period = null;
  clock.elapse(3.01);
  near(clock.elapse(3.02), 0.01);
});

test('life itself is too fast for the screen, a slow rate and a strobe are not', () => {
  const clock = new Clock(50);
  assert.ok(!clock.isTooFast(51.9));
  clock.mode = 'real';
  assert.ok(clock.isTooFast(51.9));
  assert.ok(!clock.isTooFast(3));
  near(clock.rate, 1);
  clock.mode = 'strobe';
  clock.period = 1 / 51.9;
  assert.ok(!clock.isTooFast(51.9));
});
