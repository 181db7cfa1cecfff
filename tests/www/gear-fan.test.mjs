// Too fast for the screen: sixteen poses as one blur, and nothing that a single pose could be read from.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gearEn, gearTr } from '../../www/words/gear.js';
import { bladesOf, layerOpacity } from '../../www/stage/gear/fan.js';
import { headFan, headPose } from '../../www/stage/gear/head-pose.js';
import { materialsFor } from '../../www/stage/gear/materials.js';
import { onSheet, poseOf } from '../../www/stage/gear/pose.js';
import { sheetFor } from '../../www/stage/gear/sheet.js';
import { straightShape } from '../../www/stage/gear/tire-shape.js';
import { DEGREE, record, sceneOf, sizes, theme } from './gear-scene.mjs';

/** @typedef {import('./gear-scene.mjs').Scene} Scene */

const rubber = materialsFor(theme).rubber;

/** A scene whose frame lasts 0.9 of a cycle. @param {Partial<Scene>} [changes] */
function fast(changes = {}) {
  const fan = Array.from({ length: 16 }, (_, i) => {
    const phase = (2 * Math.PI * 0.9 * (i - 15)) / 15;
    return { psi: 0.2 * Math.sin(phase + 0.3), y: 0.03 * Math.sin(phase + 1) };
  });
  return sceneOf({ psi: fan[15].psi, y: fan[15].y }, { exposure: 1.3, fan, extremes: [-0.2, 0.2], ...changes });
}

test('sixteen tires stand at the sixteen poses, all of them translucent', () => {
  const scene = fast();
  const sheet = sheetFor(sizes.desktop, scene);
  const tires = record(scene).marks.filter(({ kind, color, paths }) =>
    kind === 'fill' && color === rubber && paths[0].every(({ y }) => y < sheet.band.bottom));
  assert.equal(tires.length, 16);
  tires.forEach(({ paths: [outline], opacity }, i) => {
    const { psi, y } = /** @type {{psi: number, y: number}[]} */ (scene.fan)[i];
    const pose = poseOf(scene, psi, y);
    // The front end's bend depends on the pose alone, not on the track.
    const { l, bend } = straightShape(pose);
    const front = onSheet(sheet, pose, l[30], bend[30]);
    assert.ok(outline.some((at) => Math.hypot(at.x - front.x, at.y - front.y) < 1e-6), `pose ${i}`);
    assert.equal(opacity, layerOpacity(16));
  });
  assert.ok(layerOpacity(16) < 0.2);
  assert.ok(Math.abs(1 - (1 - layerOpacity(16)) ** 16 - 0.94) < 1e-12);
  assert.equal(layerOpacity(1), 1);
});

test('each pose stands on the track as it lay at its moment', () => {
  const scene = fast({ exposure: 0.15 });
  const blades = bladesOf(scene, 1.5);
  // The newest point of each trace is that pose's leading point, the rest is the past, moved by what was rolled since.
  const [first, last] = [blades[0], blades[15]];
  const shared = first.trace.x.slice(1).filter((x, i) =>
    last.trace.x.some((at, k) => Math.abs(at - (x - 0.15)) < 1e-9 && Math.abs(last.trace.y[k] - first.trace.y[i + 1]) < 1e-9));
  assert.ok(shared.length > 20, `${shared.length} of ${first.trace.x.length} points`);
});

test('nothing that is drawn or written depends on the pose of this instant', () => {
  const changes = { parameters: { freeplayAngle: 0.5 * DEGREE }, trail: [{ psi: 0.1, y: 0.01 }] };
  const seen = (/** @type {Scene} */ scene) => {
    const { marks, texts } = record(scene);
    return JSON.stringify([marks, texts]);
  };
  const scene = fast(changes);
  const other = { ...scene, state: [-0.17, 3, 0.02], forces: { ...scene.forces, sideForce: -900, springAngle: 0.1, slipAngle: 0.2 }, trail: [] };
  assert.equal(seen(scene), seen(other));
});

test('neither forces nor ghosts are drawn, and no number of an instant', () => {
  const scene = fast();
  const ghosts = [{ ...sceneOf({ psi: 0.1 }), label: 'c = 60' }];
  const { marks, texts } = record({ ...scene, ghosts });
  assert.ok(!marks.some(({ color }) => color === theme.force));
  assert.ok(!marks.some(({ color, lineWidth, dash }) => color === theme.ghost && dash.length > 0 && lineWidth > 1.2));
  assert.ok(!texts.some(({ text }) => ['y', 'α', 'F', 'M', 'c = 60'].includes(text)));
});

test('the swing’s range stands instead of ψ, and the words that say why', () => {
  const texts = (/** @type {Scene} */ scene, words = gearEn) => record(scene, words).texts.map(({ text }) => text);
  assert.ok(texts(fast()).includes(' ±11.5°'));
  assert.ok(texts(fast({ extremes: [-0.2, 0.25] })).includes(' −11.5° … +14.3°'));
  assert.ok(texts(fast({ extremes: null })).some((text) => /^ −11\.\d° … \+11\.\d°$|^ ±11\.\d°$/.test(text)), 'of the fan');
  for (const layout of /** @type {const} */ (['desktop', 'projector', 'phone'])) {
    assert.ok(texts(fast({ layout })).includes('too fast for the screen'), layout);
    assert.ok(texts(fast({ layout, magnification: 2 }), gearTr).includes('ekran için fazla hızlı'), layout);
  }
  assert.ok(!texts(sceneOf({ psi: 0.1 })).includes('too fast for the screen'));
});

test('the protractor keeps the last cycle’s extremes', () => {
  const scene = fast();
  const triangles = (/** @type {Scene} */ one) =>
    record(one).marks.filter(({ kind, color, paths }) => kind === 'fill' && color === theme.psi && paths[0].length === 4);
  assert.equal(triangles(scene).length, 2);
  assert.equal(triangles({ ...scene, extremes: null }).length, 0);
});

test('in the steering head tooth and collar stand as they would at each pose', () => {
  const freeplayAngle = 2 * DEGREE;
  const scene = fast({ parameters: { freeplayAngle } });
  const heads = headFan(scene);
  assert.equal(heads.length, 16);
  heads.forEach((head, i) => {
    const { psi } = /** @type {{psi: number, y: number}[]} */ (scene.fan)[i];
    assert.deepEqual(head, headPose(sceneOf({ psi }, { parameters: { freeplayAngle } })));
  });
});

test('the ring of the keyboard is there in a blur, round the wheel straight ahead', () => {
  const rings = (/** @type {Scene} */ scene) =>
    record(scene).marks.filter(({ kind, color, paths }) => kind === 'stroke' && color === theme.psi && paths[0].length > 60);
  assert.equal(rings(fast({ focused: true })).length, rings(fast()).length + 1);
});

test('a fan of no poses is no fan', () => {
  const scene = sceneOf({ psi: 0.1, y: 0.02 });
  const seen = (/** @type {Scene} */ one) => JSON.stringify(record(one).marks);
  assert.equal(seen({ ...scene, fan: [] }), seen(scene));
  assert.equal(seen({ ...scene, fan: null }), seen(scene));
});
