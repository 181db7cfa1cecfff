import { test } from 'node:test';
import assert from 'node:assert/strict';
import { ReadingCursors } from '../../www/stage/reading-cursors.js';

/** @type {[number, number]} */
const window = [-0.08, 0.02];
const near = (/** @type {number[]} */ actual, /** @type {number[]} */ expected) => {
  assert.equal(actual.length, expected.length, `${actual} instead of ${expected}`);
  actual.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) < 1e-12, `${actual} instead of ${expected}`));
};

test('the loose cursor follows the mouse, within what can be read, and goes with it', () => {
  const cursors = new ReadingCursors();
  assert.ok(cursors.isEmpty);
  cursors.put(-0.03, window);
  near(cursors.at(1, window), [-0.03]);
  near(cursors.at(1.5, window), [-0.03]);
  cursors.put(-0.5, window);
  near(cursors.at(1, window), [-0.08]);
  cursors.put(0.015, [-0.08, 0]);
  near(cursors.at(1, [-0.08, 0]), [0]);
  cursors.takeLoose();
  near(cursors.at(1, window), []);
});

test('a pinned cursor stays at its instant of the run, and leaves with it', () => {
  const cursors = new ReadingCursors();
  cursors.pin(-0.01, 1, window);
  near(cursors.at(1.02, window), [-0.03]);
  near(cursors.at(1.2, window), []);
  near(cursors.at(1, window), [-0.01]);
});

test('one pinned and the mouse give a difference, a second click holds it, a third begins anew', () => {
  const cursors = new ReadingCursors();
  cursors.pin(-0.06, 1, window);
  cursors.put(-0.02, window);
  near(cursors.at(1, window), [-0.06, -0.02]);
  cursors.pinLoose(1, window);
  cursors.put(0.01, window);
  near(cursors.at(1, window), [-0.06, -0.02]);
  cursors.pin(-0.05, 1, window);
  near(cursors.at(1, window), [-0.05, 0.01]);
  cursors.clear();
  assert.ok(cursors.isEmpty);
});

test('cursors out of sight do not count when the next is pinned', () => {
  const cursors = new ReadingCursors();
  cursors.pin(-0.06, 1, window);
  cursors.pin(-0.01, 2, window);
  cursors.pin(-0.02, 2, window);
  near(cursors.at(2, window), [-0.01, -0.02]);
});

test('keys move it from where it is, or from now', () => {
  const cursors = new ReadingCursors();
  cursors.move(-0.001, window);
  cursors.move(-0.001, window);
  near(cursors.at(1, window), [-0.002]);
  cursors.move(-Infinity, window);
  near(cursors.at(1, window), [-0.08]);
});
