// Ghosts: other runs as dashed outlines and tracks, in the magnification of the run itself.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grabTarget } from '../../www/stage/gear/grab.js';
import { poseNow, onSheet } from '../../www/stage/gear/pose.js';
import { sheetFor } from '../../www/stage/gear/sheet.js';
import { record, sceneOf, sizes, theme } from './gear-scene.mjs';

/** @typedef {import('./gear-scene.mjs').Scene} Scene */
/** @typedef {import('../../www/stage/gear/scene.js').Ghost} Ghost */
/** @typedef {{x: number, y: number}} Point */

/** A ghost that stands as the present state of a scene. @param {Scene} scene @param {Partial<Ghost>} [more] @returns {Ghost} */
const ghostOf = ({ state, parameters, track }, more) => ({ state, parameters, track, ...more });

/** Dashed strokes in the ghosts' color. @param {Scene} scene */
const dashed = (scene) =>
  record(scene).marks.filter(({ kind, color, dash, lineWidth }) =>
    kind === 'stroke' && color === theme.ghost && dash.length > 0 && lineWidth > 1.2);

/** @param {Point} a @param {Point} b */
const apart = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);

for (const magnification of [1, 10]) {
  test(`at × ${magnification} a ghost’s outline is dashed and stands where a wheel of its state would`, () => {
    const changes = { magnification };
    const other = sceneOf({ psi: -0.12 / magnification, y: -0.02 / magnification, swing: 0.1 / magnification }, changes);
    const scene = sceneOf({ psi: 0.15 / magnification, y: 0.03 / magnification, swing: 0.1 / magnification }, changes);
    const [track, outline] = dashed({ ...scene, ghosts: [ghostOf(other)] });

    const wanted = grabTarget(sizes.desktop, other).outline;
    for (const point of wanted) {
      assert.ok(outline.paths[0].some((at) => apart(at, point) < 1e-6), `${point.x}, ${point.y}`);
    }
    assert.deepEqual(outline.dash, [6, 5]);

    const pose = poseNow(other);
    const sheet = sheetFor(sizes.desktop, other);
    const leading = onSheet(sheet, pose, pose.half, pose.deformation);
    assert.ok(apart(track.paths[0][0], leading) < 1e-6, 'the track begins at the leading point');
    assert.ok((track.paths[0].at(-1)?.x ?? NaN) < 0.1 * sheet.width, 'and goes back to the edge');
  });
}

test('a ghost has its own caster, and its own way rolled where its speed differs', () => {
  const other = sceneOf({ psi: 0.1, y: 0.01 }, { parameters: { casterLength: -0.08 }, roll: 25 });
  const scene = sceneOf({}, { roll: 40 });
  const [track, outline] = dashed({ ...scene, ghosts: [ghostOf(other, { roll: 25 })] });
  const { outline: wanted } = grabTarget(sizes.desktop, other);
  for (const point of wanted) assert.ok(outline.paths[0].some((at) => apart(at, point) < 1e-6));
  assert.ok(track.paths[0].length > 10);
});

test('a ghost leaves the wheel, the steering head and the side view as they were', () => {
  const scene = sceneOf({ psi: 0.15, y: 0.03 });
  const other = sceneOf({ psi: -0.1, y: -0.01 });
  const alone = record(scene).marks;
  const both = record({ ...scene, ghosts: [ghostOf(other)] }).marks;
  const text = (/** @type {typeof alone} */ marks) => marks.map((mark) => JSON.stringify(mark));
  const without = new Set(text(alone));
  const added = text(both).filter((mark) => !without.has(mark));
  assert.equal(both.length, alone.length + 3, 'a track, a faint body, an outline');
  assert.equal(added.length, 3);
  const wheel = both.findIndex(({ color }) => color === theme.force);
  assert.ok(both.findIndex((mark) => added.includes(JSON.stringify(mark))) < wheel, 'under the wheel');
});

test('several ghosts have dashes of their own, and labels that repeat them', () => {
  const scene = sceneOf({ psi: 0.15, y: 0.03 });
  const ghosts = [0.05, -0.05, 0.1].map((psi, i) => ghostOf(sceneOf({ psi }), { label: `c = ${40 + i}` }));
  const marks = dashed({ ...scene, ghosts });
  const closed = (/** @type {Point[]} */ path) => path.length > 10 && apart(path[0], path[path.length - 1]) < 1e-9;
  const outlines = marks.filter(({ paths }) => closed(paths[0]));
  assert.equal(new Set(outlines.map(({ dash }) => dash.join())).size, 3);
  const samples = marks.filter(({ paths }) => paths[0].length === 2);
  const { texts } = record({ ...scene, ghosts });
  samples.forEach(({ dash, paths: [[from, to]] }, i) => {
    assert.deepEqual(dash, outlines[i].dash);
    const label = texts.find(({ text, halo }) => text === `c = ${40 + i}` && !halo);
    assert.ok(label && Math.abs(label.y - to.y) < 1 && label.x > to.x && label.x - to.x < 10);
    assert.ok(from.x < to.x);
  });
  assert.equal(samples.length, 3);
});

test('a label for which there is no room is left out, its ghost is not', () => {
  const scene = sceneOf({ psi: 0.15, y: 0.03 }, { layout: 'phone' });
  const label = 'caster e = 0.25 m, damping c = 60 N m s/rad';
  const full = { ...scene, ghosts: [ghostOf(sceneOf({ psi: 0.05 }), { label })] };
  assert.ok(!record(full).texts.some(({ text }) => text === label));
  assert.equal(dashed(full).length, 2);
});

for (const layout of /** @type {const} */ (['desktop', 'phone'])) {
  test(`a mode is dashed over the wheel in the color of ψ, with its legend, on a ${layout}`, () => {
    const other = sceneOf({ psi: -0.12, y: -0.02, swing: 0.1 }, { layout });
    const scene = { ...sceneOf({ psi: 0.15, y: 0.03, swing: 0.1 }, { layout }), ghosts: [ghostOf(other, { isMode: true, label: 'mode 53.8 Hz' })] };
    const { marks, texts } = record(scene);
    assert.equal(dashed(scene).length, 0, 'not as a run that was pinned');
    const traces = (/** @type {Scene} */ one) => {
      const { outline } = grabTarget(sizes[layout], one);
      return (/** @type {typeof marks[number]} */ { paths }) => outline.every((point) => paths[0]?.some((at) => apart(at, point) < 1e-6));
    };
    const mode = marks.filter(traces(other)).findLast(({ kind, dash }) => kind === 'stroke' && dash.length > 0);
    assert.deepEqual([mode?.color, Number(mode?.lineWidth) > 2.2], [theme.psi, true]);
    const wheel = marks.findIndex(traces(scene));
    assert.ok(wheel >= 0 && marks.indexOf(/** @type {typeof marks[number]} */ (mode)) > wheel, 'over the wheel');
    assert.ok(texts.some(({ text, halo }) => text === 'mode 53.8 Hz' && !halo));
  });
}
