// The wheel from above: one factor for angle and tire, and a contact line that lies on its track.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bendAt, contactLine, traceBehind } from '../../www/stage/gear/contact-line.js';
import { sheetFor, trackLength } from '../../www/stage/gear/sheet.js';
import { grabTarget } from '../../www/stage/gear/grab.js';
import { onSheet, poseNow } from '../../www/stage/gear/pose.js';
import { DEGREE, record, sceneOf, sizes, theme } from './gear-scene.mjs';

/** @param {{x: number, y: number}} from @param {{x: number, y: number}} to */
const direction = (from, to) => Math.atan2(from.y - to.y, to.x - from.x);

/** @param {number} actual @param {number} expected @param {number} [tolerance] */
const near = (actual, expected, tolerance = 1e-9) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${actual} is not ${expected}`);

for (const magnification of [1, 5, 50]) {
  test(`the wheel is drawn at ${magnification} ψ and the leading point at ${magnification} y`, () => {
    const psi = (12 * DEGREE) / magnification;
    const y = 0.03 / magnification;
    const scene = sceneOf({ psi, y, swing: 0.2 / magnification }, { magnification });
    const sheet = sheetFor(sizes.desktop, scene);
    const context = record(scene);

    const plane = context.marks.find((mark) => mark.color === theme.psi && mark.dash.length > 0);
    assert.ok(plane);
    const [tail, tip] = plane.paths[0];
    near(direction(tail, tip), magnification * psi);

    const rings = context.marks.filter((mark) => mark.kind === 'stroke' && mark.color === theme.y);
    const contact = rings.reduce((thickest, mark) => (mark.lineWidth > thickest.lineWidth ? mark : thickest));
    const leading = contact.paths[0][0];
    const dx = (leading.x - sheet.axis.x) / sheet.scale;
    const dy = (sheet.axis.y - leading.y) / sheet.scale;
    const angle = magnification * psi;
    near(dx * Math.cos(angle) + dy * Math.sin(angle), 0);
    near(-dx * Math.sin(angle) + dy * Math.cos(angle), magnification * y);
  });
}

test('inside the contact the tire lies on its track, beyond it decays with the relaxation length', () => {
  const scene = sceneOf({ psi: 0.1, y: 0.02 }, { parameters: { casterLength: 0.04 } });
  const pose = poseNow(scene);
  const trace = traceBehind(scene, pose, 1);
  const line = contactLine(trace, pose);

  near(line.l[0], 0.1);
  near(line.l.at(-1) ?? NaN, -0.1);
  for (let i = 1; i < line.l.length - 1; i++) {
    const x = (line.l[i] - 0.04) * pose.cos - line.n[i] * pose.sin;
    const y = (line.l[i] - 0.04) * pose.sin + line.n[i] * pose.cos;
    const onTrack = trace.x.some((at, k) => Math.hypot(at - x, trace.y[k] - y) < 1e-12);
    assert.ok(onTrack, `(${x}, ${y}) is not on the track`);
  }
  near(bendAt(line, pose, 0.2), 0.02 * Math.exp(-0.1 / 0.3));
  near(bendAt(line, pose, -0.2), (line.n.at(-1) ?? NaN) * Math.exp(-0.1 / 0.3));
  near(bendAt(line, pose, 0.1), 0.02);
});

test('the track leaves the wheel along the string’s tangent where the contact does not slip', () => {
  // A steady turn of the wheel plane against the road: y = σψ keeps the track straight ahead.
  const psi = 0.05;
  const y = 0.3 * psi;
  const scene = sceneOf({ psi, y, swing: 0 });
  const { x, y: aside } = traceBehind(scene, poseNow(scene), 1);
  near(aside[5], aside[0], 1e-12);
  assert.ok(x[5] < x[0]);
});

test('without a past the tire still stands', () => {
  const none = new Float64Array();
  const track = { distance: none, torsionAngle: none, lateralDeformation: none };
  const scene = sceneOf({ psi: 0.1, y: 0.02 }, { track });
  const pose = poseNow(scene);
  const line = contactLine(traceBehind(scene, pose, 1), pose);
  assert.deepEqual(line, { l: [0.1], n: [0.02] });
  record(scene);
});

test('the track that is asked for reaches the left edge', () => {
  const scene = sceneOf({});
  const sheet = sheetFor(sizes.desktop, scene);
  const length = trackLength(sizes.desktop, scene);
  const leading = sheet.axis.x / sheet.scale + scene.parameters.halfContactLength - scene.parameters.casterLength;
  near(length, leading);
});

test('the wheel can be grabbed where it is drawn', () => {
  const scene = sceneOf({ psi: 0.2, y: 0.03 });
  const { outline, center, axis } = grabTarget(sizes.desktop, scene);
  const sheet = sheetFor(sizes.desktop, scene);
  assert.deepEqual(axis, sheet.axis);
  assert.deepEqual(center, onSheet(sheet, poseNow(scene), 0, 0));
  const length = Math.max(...outline.map((a) => Math.max(...outline.map((b) => Math.hypot(a.x - b.x, a.y - b.y)))));
  assert.ok(length > 0.48 * sheet.scale && length < 0.56 * sheet.scale);
});
