// The pen: strokes keep their place and their view, are as thick as the pen was pressed, and fade while the run goes on.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { drawStrokes } from '../../www/present/draw-strokes.js';
import { Ink } from '../../www/present/ink.js';
import { pictureOf } from '../../www/present/pen-views.js';
import { dotsOf } from '../../www/present/stroke.js';

const size = { width: 800, height: 400 };
const even = (/** @type {number} */ x, /** @type {number} */ y) => ({ x, y, pressure: 0.5 });

test('a stroke goes from its first point to its last, along the sides of its corners', () => {
  const dots = dotsOf([even(0.1, 0.5), even(0.5, 0.5), even(0.5, 0.9)], size, 1);
  const [first, last] = [dots[0], dots[dots.length - 1]];
  assert.deepEqual([first.x, first.y, last.x, last.y], [80, 200, 400, 360]);
  for (const [i, dot] of dots.entries()) {
    assert.ok(dot.x <= 400 + 1e-9 && dot.y >= 200 - 1e-9, 'it leaves the corner');
    if (i > 0) assert.ok(Math.hypot(dot.x - dots[i - 1].x, dot.y - dots[i - 1].y) <= 2 + 1e-9, 'a gap');
  }
  // The curve of three points in closed form: at its middle it is a quarter of the way between bend and chord.
  const middle = { x: 0.25 * 240 + 0.5 * 400 + 0.25 * 400, y: 0.25 * 200 + 0.5 * 200 + 0.25 * 280 };
  assert.ok(dots.some(({ x, y }) => Math.hypot(x - middle.x, y - middle.y) < 1), 'it cuts the corner as a quadratic does');
});

test('a straight line stays straight', () => {
  const dots = dotsOf([even(0.1, 0.1), even(0.2, 0.2), even(0.35, 0.35), even(0.9, 0.9)], { width: 500, height: 500 }, 1);
  assert.ok(dots.every(({ x, y }) => Math.abs(x - y) < 1e-9));
});

test('a tap is a dot; thickness follows pressure and the layout', () => {
  assert.equal(dotsOf([even(0.5, 0.5)], size, 1).length, 1);
  const thickness = (/** @type {number} */ pressure, /** @type {number} */ line) => dotsOf([{ x: 0.5, y: 0.5, pressure }], size, line)[0].radius;
  assert.ok(thickness(1, 1) > 1.5 * thickness(0.5, 1) && thickness(0.1, 1) < 0.6 * thickness(0.5, 1));
  assert.ok(Math.abs(thickness(0.5, 1.6) / thickness(0.5, 1) - 1.6) < 1e-9);
  const dots = dotsOf([{ x: 0, y: 0, pressure: 0.2 }, { x: 0.2, y: 0, pressure: 0.8 }, { x: 0.4, y: 0, pressure: 0.2 }], size, 1);
  const radii = dots.map(({ radius }) => radius);
  assert.ok(Math.max(...radii) > 1.4 * radii[0] && radii.every((radius, i) => i === 0 || Math.abs(radius - radii[i - 1]) < 0.1), 'it swells without steps');
});

test('a view that changes its size keeps its strokes in place', () => {
  const points = [even(0.2, 0.3), even(0.6, 0.7), even(0.7, 0.2)];
  const [wide, narrow] = [dotsOf(points, size, 1), dotsOf(points, { width: 400, height: 400 }, 1)];
  const end = (/** @type {typeof wide} */ dots, /** @type {number} */ width) => [dots[0].x / width, dots[dots.length - 1].x / width];
  assert.deepEqual(end(wide, 800), end(narrow, 400));
  const reach = (/** @type {typeof wide} */ dots) => Math.min(...dots.map(({ y }) => y)) / 400;
  assert.ok(Math.abs(reach(wide) - reach(narrow)) < 2e-3);
});

test('an area is filled: circles and pieces go round the same way, or they would cut each other out', () => {
  /** @type {[number, number][][]} */
  const loops = [];
  let alpha = 1;
  const alphas = new Set();
  const context = {
    beginPath() {}, closePath() {}, fill() { alphas.add(alpha); },
    moveTo: (/** @type {number} */ x, /** @type {number} */ y) => loops.push([[x, y]]),
    lineTo: (/** @type {number} */ x, /** @type {number} */ y) => loops[loops.length - 1].push([x, y]),
    arc: (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ r, /** @type {number} */ from, /** @type {number} */ to) => {
      for (let i = 1; i < 8; i++) loops[loops.length - 1].push([x + r * Math.cos(from + (i / 8) * (to - from)), y + r * Math.sin(from + (i / 8) * (to - from))]);
    },
    set globalAlpha(/** @type {number} */ value) { alpha = value; },
  };
  const points = Array.from({ length: 30 }, (_, i) => even(0.5 + 0.3 * Math.cos(i / 3), 0.5 + 0.3 * Math.sin(i / 4)));
  drawStrokes(/** @type {CanvasRenderingContext2D} */ (/** @type {unknown} */ (context)), size, [{ view: 'gear', points, strength: 0.4 }], { ink: '#000', surface: '#fff', line: 1 });
  const area = (/** @type {[number, number][]} */ loop) => loop.reduce((sum, [x, y], i) => sum + x * loop[(i + 1) % loop.length][1] - loop[(i + 1) % loop.length][0] * y, 0);
  assert.ok(loops.length > 100 && loops.every((loop) => area(loop) > 0));
  assert.deepEqual([...alphas], [0.4], 'each pass is of one strength, without seams');
});

test('a stroke stays with its view, and undo and clear take what is seen', () => {
  const ink = new Ink();
  ink.add('gear', [even(0.1, 0.1)]);
  ink.add('phase', [even(0.2, 0.2)]);
  ink.add('phase.spectrum', [even(0.3, 0.3)]);
  ink.add('phase', []);
  assert.deepEqual(ink.strokes.map(({ view }) => view), ['gear', 'phase', 'phase.spectrum']);
  ink.shown = ['phase', 'gear'];
  ink.undo();
  assert.deepEqual(ink.strokes.map(({ view }) => view), ['gear', 'phase.spectrum'], 'the last that is seen, not the last');
  assert.deepEqual(ink.of('phase.spectrum').map(({ points }) => points[0].x), [0.3]);
  ink.shown = ['forces', 'gear'];
  ink.clear();
  assert.deepEqual(ink.strokes.map(({ view }) => view), ['phase.spectrum']);
  ink.undo();
  assert.equal(ink.strokes.length, 1);
});

test('each picture of a lens has a name of its own', () => {
  const names = [pictureOf('phase', 'portrait', 0), pictureOf('phase', 'orbit', 0), pictureOf('forces', 'laws', 0), pictureOf('forces', 'laws', 1), pictureOf('compare', '', 0), pictureOf('compare', '', 2)];
  assert.deepEqual(names, ['phase.portrait', 'phase.orbit', 'forces.laws', 'forces.laws.1', 'compare', 'compare.2']);
});

test('while the run goes on ink fades away, unless it is pinned', () => {
  const ink = new Ink();
  ink.add('gear', [even(0.1, 0.1)]);
  let now = 5;
  const pass = (/** @type {number} */ seconds, /** @type {boolean} */ isPlaying) => {
    for (let frame = 0; frame < 60 * seconds; frame++) ink.elapse((now += 1 / 60), isPlaying);
  };
  pass(3, false);
  assert.equal(ink.strokes[0].strength, 1, 'a frozen picture keeps it');
  ink.isPinned = true;
  pass(3, true);
  assert.equal(ink.strokes[0].strength, 1);
  ink.isPinned = false;
  pass(0.75, true);
  assert.ok(Math.abs(ink.strokes[0].strength - 0.5) < 0.03);
  const half = ink.strokes;
  pass(1, false);
  assert.equal(ink.strokes, half, 'the same list as long as nothing changes');
  pass(1, true);
  assert.equal(ink.strokes.length, 0);
});
