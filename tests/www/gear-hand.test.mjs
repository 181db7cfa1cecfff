// The hand on the wheel: what it can hit, and the true angle it turns the wheel to.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grabTarget, Hold, isOnWheel, turnOfKey } from '../../www/stage/gear/grab.js';
import { onSheet, poseNow } from '../../www/stage/gear/pose.js';
import { sheetFor } from '../../www/stage/gear/sheet.js';
import { DEGREE, record, sceneOf, sizes, theme } from './gear-scene.mjs';

/** @typedef {{x: number, y: number}} Point */

/** @param {number} actual @param {number} expected @param {number} [tolerance] */
const near = (actual, expected, tolerance = 1e-12) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${actual} is not ${expected}`);

/** A point turned about another, counter-clockwise as seen on the sheet. @param {Point} point @param {Point} axis @param {number} angle */
function turned(point, axis, angle) {
  const dx = point.x - axis.x;
  const dy = axis.y - point.y;
  return {
    x: axis.x + dx * Math.cos(angle) - dy * Math.sin(angle),
    y: axis.y - dx * Math.sin(angle) - dy * Math.cos(angle),
  };
}

for (const magnification of [1, 10, 50]) {
  test(`at × ${magnification} the wheel follows the hand, and ψ is the hand’s turn divided by it`, () => {
    const psi = (-7 * DEGREE) / magnification;
    const scene = sceneOf({ psi, y: 0.01 / magnification, swing: 0.1 / magnification }, { magnification });
    const { axis } = sheetFor(sizes.desktop, scene);
    for (const [l, n] of [[-0.2, 0.05], [0.24, 0], [-0.24, -0.08]]) {
      const start = onSheet(sheetFor(sizes.desktop, scene), poseNow(scene), l, n);
      const hold = new Hold(sizes.desktop, scene, start);
      assert.equal(hold.turnTo(start), psi, 'nothing jumps');
      for (const turn of [0.3, -0.2, 0.9]) {
        near(hold.turnTo(turned(start, axis, turn)), psi + turn / magnification);
      }
      // The point that was taken hold of is still under the hand.
      const now = { ...scene, state: [psi + 0.3 / magnification, 0, scene.state[2]] };
      const under = onSheet(sheetFor(sizes.desktop, now), poseNow(now), l, n);
      const hand = turned(start, axis, 0.3);
      near(under.x, hand.x, 1e-9);
      near(under.y, hand.y, 1e-9);
    }
  });
}

test('behind the axis a hand that goes down turns the wheel counter-clockwise, ahead of it clockwise', () => {
  const scene = sceneOf({ swing: 0.1 });
  const { axis } = sheetFor(sizes.desktop, scene);
  for (const [dx, sign] of [[-80, 1], [40, -1]]) {
    const hold = new Hold(sizes.desktop, scene, { x: axis.x + dx, y: axis.y });
    assert.equal(Math.sign(hold.turnTo({ x: axis.x + dx, y: axis.y + 10 })), sign);
  }
});

test('on the axis itself a hand has a lever and nothing jumps', () => {
  const scene = sceneOf({ psi: 0.1, swing: 0.1 });
  const { axis } = sheetFor(sizes.desktop, scene);
  for (const start of [axis, { x: axis.x - 3, y: axis.y + 2 }]) {
    const hold = new Hold(sizes.desktop, scene, start);
    assert.equal(hold.turnTo(start), 0.1);
    let last = 0.1;
    for (let i = 1; i <= 20; i++) {
      const now = hold.turnTo({ x: start.x, y: start.y + i });
      assert.ok(now > last && now - last < 1 / 20, `${now - last} rad for one pixel`);
      last = now;
    }
  }
});

test('a hand that goes right round does not throw the wheel to the other side', () => {
  const scene = sceneOf({ swing: 0.1 });
  const { axis } = sheetFor(sizes.desktop, scene);
  const start = { x: axis.x - 90, y: axis.y };
  const hold = new Hold(sizes.desktop, scene, start);
  let last = 0;
  for (let angle = 0; angle <= 400; angle += 10) {
    const psi = hold.turnTo(turned(start, axis, angle * DEGREE));
    assert.ok(psi >= last, `${psi} after ${last} at ${angle}°`);
    last = psi;
  }
  near(last, 75 * DEGREE);
});

test('every place of the drawn tire can be grabbed, and little beside it', () => {
  for (const layout of /** @type {const} */ (['desktop', 'projector', 'phone'])) {
    for (const psi of [-0.4, 0, 0.25]) {
      const scene = sceneOf({ psi, y: 0.1 * psi }, { layout });
      const size = sizes[layout];
      const { outline, box } = grabTarget(size, scene);
      outline.forEach((point, i) => {
        assert.ok(isOnWheel(size, scene, point), JSON.stringify([layout, psi, point]));
        near(Math.min(Math.max(point.x, box.x), box.x + box.width), point.x, 1e-9);
        near(Math.min(Math.max(point.y, box.y), box.y + box.height), point.y, 1e-9);
        const other = outline[outline.length - 1 - i];
        const width = Math.hypot(point.x - other.x, point.y - other.y);
        if (width < 0.16 * sheetFor(size, scene).scale) return;
        const pixels = Math.max(8, 25 - width / 2);
        const beside = {
          x: point.x + ((point.x - other.x) / width) * pixels,
          y: point.y + ((point.y - other.y) / width) * pixels,
        };
        assert.ok(!isOnWheel(size, scene, beside), JSON.stringify([layout, psi, beside]));
      });
    }
  }
});

test('a finger has 44 px to hit, however small the tire is drawn', () => {
  const scene = sceneOf({ swing: 0 }, { layout: 'phone' });
  const size = { width: 200, height: 140 };
  const { center, box } = grabTarget(size, scene);
  assert.ok(0.17 * sheetFor(size, scene).scale < 30, 'the tire is thinner than a finger');
  for (const [dx, dy] of [[21, 0], [-21, 0], [0, 21], [0, -21], [21, 21], [-21, -21]]) {
    assert.ok(isOnWheel(size, scene, { x: center.x + dx, y: center.y + dy }), `${dx}, ${dy}`);
  }
  assert.ok(!isOnWheel(size, scene, { x: center.x, y: center.y + 23 }));
  assert.ok(box.width >= 44 && box.height >= 44);
});

test('arrow keys turn by half a degree to their side, five times as much with Shift', () => {
  const key = (/** @type {string} */ name, shiftKey = false) => turnOfKey({ key: name, shiftKey }) / DEGREE;
  near(key('ArrowLeft'), 0.5);
  near(key('ArrowRight'), -0.5);
  near(key('ArrowLeft', true), 2.5);
  assert.equal(key('Enter'), 0);
});

test('a held wheel has a halo round the tire, a focused one a ring, and a free one neither', () => {
  const around = (/** @type {object} */ changes) => {
    const scene = sceneOf({ psi: 0.2, y: 0.01 }, changes);
    const { outline } = grabTarget(sizes.desktop, scene);
    return record(scene).marks.filter(({ kind, paths, color }) => {
      const [path] = paths;
      return kind === 'stroke' && String(color).startsWith(theme.psi) && path?.length > outline.length - 3
        && outline.every((point) => path.some((at) => Math.hypot(at.x - point.x, at.y - point.y) < 1e-6));
    });
  };
  assert.equal(around({}).length, 0);
  const halo = around({ held: true });
  assert.ok(halo.length >= 2 && halo.every(({ color }) => color !== theme.psi), 'soft: translucent layers');
  assert.ok(Math.max(...halo.map(({ lineWidth }) => lineWidth)) >= 20);
  const ring = around({ focused: true });
  assert.equal(ring.length, 1);
  assert.equal(ring[0].color, theme.psi, 'crisp: the color itself');
});
