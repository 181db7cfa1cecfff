import { test } from 'node:test';
import assert from 'node:assert/strict';
import { Clock } from '../../www/stage/clock.js';
import { isShownTruly, slowRateFor } from '../../www/stage/rate.js';

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
