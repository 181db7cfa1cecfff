// What stays is drawn once and stamped from then on; without a cache the drawing is paths and text alone.

import assert from 'node:assert/strict';
import { afterEach, beforeEach, test } from 'node:test';
import { gearEn } from '../../www/words/gear.js';
import { drawGear } from '../../www/stage/gear/draw.js';
import { sheetFor, trackLength } from '../../www/stage/gear/sheet.js';
import { RecordingContext } from './recording-context.mjs';
import { sceneOf, sizes, theme } from './gear-scene.mjs';

/** @typedef {import('./gear-scene.mjs').Scene} Scene */

/** The bitmaps made so far. @type {FakeOffscreenCanvas[]} */
let made = [];

class FakeOffscreenCanvas {
  /** @param {number} width @param {number} height */
  constructor(width, height) {
    this.width = width;
    this.height = height;
    this.context = Object.assign(new RecordingContext(), { setTransform: () => {} });
    made.push(this);
  }

  getContext() {
    return this.context;
  }

  transferToImageBitmap() {
    return this;
  }
}

class StampingContext extends RecordingContext {
  /** @type {{bitmap: FakeOffscreenCanvas, x: number, y: number, width: number, height: number}[]} */
  stamps = [];

  getTransform() {
    return { a: 2 };
  }

  /** @param {FakeOffscreenCanvas} bitmap @param {number} x @param {number} y @param {number} width @param {number} height */
  drawImage(bitmap, x, y, width, height) {
    this.stamps.push({ bitmap, x, y, width, height });
  }
}

const real = Reflect.get(globalThis, 'OffscreenCanvas');
beforeEach(() => {
  made = [];
  Reflect.set(globalThis, 'OffscreenCanvas', FakeOffscreenCanvas);
});
afterEach(() => {
  if (real) Reflect.set(globalThis, 'OffscreenCanvas', real);
  else Reflect.deleteProperty(globalThis, 'OffscreenCanvas');
});

/** @param {Scene} scene @param {typeof theme} tokens @param {{cache?: boolean}} [options] */
function draw(scene, tokens, options) {
  const context = new StampingContext();
  drawGear(context.asContext, sizes[scene.layout], scene, tokens, gearEn, options);
  return context;
}

test('a second frame makes no bitmap and stamps the first one’s at the same places', () => {
  const tokens = { ...theme };
  const first = draw(sceneOf({ psi: 0.1, y: 0.01 }), tokens);
  const count = made.length;
  assert.ok(count > 8, `${count} bitmaps`);
  const second = draw(sceneOf({ psi: 0.12, y: 0.012 }), tokens);
  assert.equal(made.length, count);
  assert.deepEqual(second.stamps, first.stamps);
});

test('a stamp is cut to device pixels and holds all of what it shows', () => {
  const { stamps } = draw(sceneOf({ psi: 0.1, y: 0.01 }), { ...theme });
  for (const { bitmap, x, y, width, height } of stamps) {
    for (const side of [x, y, width, height]) assert.equal(2 * side, Math.round(2 * side));
    assert.deepEqual([bitmap.width, bitmap.height], [2 * width, 2 * height]);
    for (const written of bitmap.context.texts) {
      assert.ok(written.x >= x && written.x + written.width <= x + width, written.text);
      assert.ok(written.y - 0.6 * written.size >= y && written.y + 0.6 * written.size <= y + height, written.text);
    }
    for (const { paths } of bitmap.context.marks) {
      for (const at of paths.flat()) assert.ok(at.x >= x && at.x <= x + width && at.y >= y && at.y <= y + height);
    }
  }
});

test('another magnification, speed or theme makes new bitmaps', () => {
  const tokens = { ...theme };
  const scene = sceneOf({ psi: 0.01, y: 0.001, swing: 0.01 }, { magnification: 10 });
  draw(scene, tokens);
  const count = made.length;
  draw({ ...scene, magnification: 20 }, tokens);
  assert.equal(made.length, count + 2, 'the scale and the line that names it');
  draw({ ...scene, magnification: 20, parameters: { ...scene.parameters, velocity: 81 } }, tokens);
  assert.equal(made.length, count + 3);
  draw(scene, { ...theme });
  assert.equal(made.length, 2 * count + 3);
});

test('while a slider moves, old bitmaps are let go', () => {
  const tokens = { ...theme };
  const scene = sceneOf({ psi: 0.1, y: 0.01 });
  const at = (/** @type {number} */ velocity) => {
    const before = made.length;
    draw({ ...scene, parameters: { ...scene.parameters, velocity } }, tokens);
    return made.length - before;
  };
  at(1);
  assert.equal(at(1), 0);
  for (let velocity = 2; velocity <= 120; velocity++) at(velocity);
  assert.ok(at(1) > 0, 'the first speed was kept');
});

test('without a cache nothing is stamped, and the same is drawn as where bitmaps are unknown', () => {
  const scene = sceneOf({ psi: 0.1, y: 0.01 }, { parameters: { freeplayAngle: 0.01 } });
  const plain = draw(scene, { ...theme }, { cache: false });
  assert.deepEqual([made.length, plain.stamps.length], [0, 0]);
  Reflect.deleteProperty(globalThis, 'OffscreenCanvas');
  const bare = new RecordingContext();
  drawGear(bare.asContext, sizes.desktop, scene, { ...theme }, gearEn);
  assert.deepEqual(plain.marks, bare.marks);
  assert.deepEqual(plain.texts, bare.texts);
});

test('however far the wheel trails, the sheet keeps an arc to read angles off, and its track is of the past', () => {
  for (const size of Object.values(sizes))
    for (const casterLength of [-50, -5, 0, 1.5, 4, 5, 50]) {
      const scene = { layout: /** @type {const} */ ('desktop'), parameters: { casterLength } };
      assert.ok(sheetFor(size, scene).protractor > 0, `e = ${casterLength}`);
      assert.ok(trackLength(size, scene) >= 0, `no track from the future, e = ${casterLength}`);
    }
});
