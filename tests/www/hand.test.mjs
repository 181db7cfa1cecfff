// The hand from press to lift, on a wheel as it is drawn: which pointer, how far, twist or tap.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { grabTarget } from '../../www/stage/gear/grab.js';
import { Hand } from '../../www/stage/hand.js';
import { DEGREE, sceneOf, sizes } from './gear-scene.mjs';

const size = sizes.desktop;
const scene = sceneOf({ psi: 3 * DEGREE });
const { axis, center } = grabTarget(size, scene);

/** The point at which the drawn wheel's center is after it has turned by so much. @param {number} turn counter-clockwise, in rad */
function turned(turn, from = center, about = axis) {
  const [x, y] = [from.x - about.x, about.y - from.y];
  return { x: about.x + x * Math.cos(turn) - y * Math.sin(turn), y: about.y - (x * Math.sin(turn) + y * Math.cos(turn)) };
}

const near = (/** @type {number | null} */ actual, /** @type {number} */ expected) =>
  assert.ok(actual !== null && Math.abs(actual - expected) < 1e-9, `${actual} is not ${expected}`);

test('a press on the wheel takes hold, one beside it does not', () => {
  assert.ok(new Hand().press(1, center, 0, size, scene));
  const hand = new Hand();
  assert.ok(!hand.press(1, { x: axis.x + 160, y: axis.y - 70 }, 0, size, scene));
  assert.ok(!hand.isHolding);
  assert.equal(hand.move(1, center, size, scene), null);
  assert.equal(hand.lift(1, 10), null);
});

test('the wheel follows the hand about its axis, and stays where the hand stays', () => {
  const hand = new Hand();
  hand.press(1, center, 0, size, scene);
  near(hand.move(1, center, size, scene), 3 * DEGREE);
  near(hand.move(1, turned(8 * DEGREE), size, scene), 11 * DEGREE);
  near(hand.move(1, turned(-8 * DEGREE), size, scene), -5 * DEGREE);
  assert.equal(hand.lift(1, 100), 'twist');
});

test('the hand turns the drawn wheel: in truth it turns by that over the magnification', () => {
  const larger = sceneOf({ psi: 0.3 * DEGREE }, { magnification: 10 });
  const target = grabTarget(size, larger);
  const hand = new Hand();
  hand.press(1, target.center, 0, size, larger);
  near(hand.move(1, turned(8 * DEGREE, target.center), size, larger), 1.1 * DEGREE);
});

test('a second finger changes nothing', () => {
  const hand = new Hand();
  hand.press(1, center, 0, size, scene);
  assert.ok(!hand.press(2, center, 5, size, scene));
  assert.equal(hand.move(2, turned(1), size, scene), null);
  assert.equal(hand.lift(2, 10), null);
  assert.ok(hand.isHolding);
});

test('a short press that does not move is a tap; a long one, or one that moves, is a twist', () => {
  const pressed = () => {
    const hand = new Hand();
    hand.press(1, center, 1000, size, scene);
    return hand;
  };
  assert.equal(pressed().lift(1, 1100), 'tap');
  assert.equal(pressed().lift(1, 1400), 'twist');
  const moved = pressed();
  moved.move(1, { x: center.x + 9, y: center.y }, size, scene);
  moved.move(1, center, size, scene);
  assert.equal(moved.lift(1, 1100), 'twist');
});

test('a drawing that changes its size under the hand does not turn the wheel', () => {
  const hand = new Hand();
  hand.press(1, center, 0, size, scene);
  const point = turned(8 * DEGREE);
  hand.move(1, point, size, scene);
  const held = sceneOf({ psi: 11 * DEGREE });
  near(hand.move(1, point, { width: 700, height: 450 }, held), 11 * DEGREE);
});

test('a wheel that is dropped is out of the hand, whatever the pointer does', () => {
  const hand = new Hand();
  hand.press(1, center, 0, size, scene);
  hand.drop();
  assert.equal(hand.move(1, turned(0.1), size, scene), null);
  assert.equal(hand.lift(1, 10), null);
});
