// The steering head: the gap is drawn so that tooth and stop touch exactly when |ψ| reaches ψ_fp.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { DRAWN_GAP, headPose } from '../../www/stage/gear/head-pose.js';
import { DEGREE, record, sceneOf, theme } from './gear-scene.mjs';

const freeplayAngle = DEGREE;
const withGap = (/** @type {number} */ psi, magnification = 10) =>
  sceneOf({ psi, swing: 0.01 }, { parameters: { freeplayAngle }, magnification });

test('the tooth touches the stop exactly when |ψ| is at least ψ_fp', () => {
  for (const [share, touching] of /** @type {const} */ ([
    [0, 0], [0.5, 0], [0.999999, 0], [1, 1], [1.3, 1], [-0.999999, 0], [-1, -1], [-2, -1],
  ])) {
    const pose = headPose(withGap(share * freeplayAngle));
    assert.equal(pose.touching, touching, `at ${share} ψ_fp`);
    const free = DRAWN_GAP - Math.abs(pose.tube - pose.collar);
    assert.equal(Math.abs(free) < 1e-12, touching !== 0, `${free} rad to go at ${share} ψ_fp`);
  }
});

test('inside the gap the collar rests; beyond it both turn on', () => {
  assert.equal(headPose(withGap(0.8 * freeplayAngle)).collar, 0);
  const beyond = headPose(withGap(1.3 * freeplayAngle));
  assert.ok(Math.abs(beyond.collar - 10 * 0.3 * freeplayAngle) < 1e-12);
  assert.ok(beyond.tube > headPose(withGap(freeplayAngle)).tube);
});

test('without freeplay the slot is closed and the tube turns with the collar', () => {
  const pose = headPose(sceneOf({ psi: 0.2 }));
  assert.deepEqual(pose, { collar: 0.2, tube: 0.2, gap: 0, touching: 0 });
  const { texts, marks } = record(sceneOf({ psi: 0.2 }));
  assert.ok(!texts.some(({ text }) => text.startsWith('gap')));
  assert.ok(!marks.some(({ color }) => color === theme.freeplay));
});

test('the touched stop stands out, and the label says how large the gap is drawn', () => {
  const free = record(withGap(0.5 * freeplayAngle));
  const touched = record(withGap(-1.2 * freeplayAngle));
  const stops = (/** @type {typeof free} */ { marks }) =>
    marks.filter(({ kind, color }) => kind === 'stroke' && color === theme.freeplayText).length;
  assert.equal(stops(free), 0);
  assert.equal(stops(touched), 1);
  assert.ok(free.texts.some(({ text }) => text === 'gap ±1° (drawn ×\u200917)'));
});

test('a positive angle turns the tooth to the right, below the axis: counter-clockwise', () => {
  const { marks } = record(sceneOf({ psi: 0.3 }));
  const still = record(sceneOf({ psi: 0 })).marks;
  const tube = (/** @type {typeof marks} */ all) =>
    all.find(({ kind, color, paths }) => kind === 'stroke' && color === theme.psi && paths[0].length > 40);
  const lowest = (/** @type {typeof marks} */ all) =>
    (tube(all)?.paths[0] ?? []).reduce((low, point) => (point.y > low.y ? point : low), { x: 0, y: -Infinity });
  assert.ok(lowest(marks).x > lowest(still).x);
});
