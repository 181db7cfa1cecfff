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

test('where there is friction a shoe rubs on the tube, with its torque as an arc the way it turns the wheel', () => {
  const rubbing = (/** @type {number} */ frictionTorque, changes = {}) => {
    const parameters = { 'friction.moment': 200 };
    return record(sceneOf({ psi: 0.1 }, { parameters, forces: { ...sceneOf({ psi: 0.1 }).forces, frictionTorque }, ...changes }));
  };
  const arcs = (/** @type {ReturnType<typeof record>} */ { marks }) => marks.filter(({ kind, color }) => kind === 'stroke' && color === theme.stable).map(({ paths }) => paths[0]);
  const none = record(sceneOf({ psi: 0.1 }));
  assert.deepEqual([arcs(none).length, none.texts.some(({ text }) => text === 'friction')], [0, false]);
  const [against, along] = [rubbing(-200), rubbing(200)];
  assert.ok(against.texts.some(({ text }) => text === 'friction'));
  // On the left of the axis counter-clockwise is downward on the screen.
  const fall = (/** @type {ReturnType<typeof record>} */ drawn) => {
    const [arc] = arcs(drawn);
    return arc[arc.length - 1].y - arc[0].y;
  };
  assert.ok(fall(along) > 5 && fall(against) < -5, `${fall(along)} ${fall(against)}`);
  assert.ok(Math.abs(fall(rubbing(100))) < Math.abs(fall(along)), 'half of the torque is a shorter arc');
  assert.equal(arcs(rubbing(0)).length, 0);
  const fan = Array.from({ length: 16 }, (_, i) => ({ psi: 0.01 * i, y: 0 }));
  assert.equal(arcs(rubbing(200, { fan })).length, 0, 'of many poses there is not one torque');
});

test('a magnetorheological damper has a coil, filled as far as there is current', () => {
  const filled = (/** @type {{ 'damper.command'?: number }} */ { ...parameters }) =>
    record(sceneOf({ psi: 0.05 }, { parameters: /** @type {Record<string, number>} */ (parameters) })).marks.filter(({ kind, color, opacity }) => kind === 'fill' && color === theme.force && opacity > 0).length;
  const [none, empty, half, full] = [{}, { 'damper.command': 0 }, { 'damper.command': 0.75 }, { 'damper.command': 1.5 }].map(filled);
  assert.equal(empty, none, 'without current no winding is filled');
  assert.equal(half - empty, 4);
  assert.equal(full - empty, 8);
});
