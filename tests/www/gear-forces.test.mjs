// Arrows point where the forces do, and are absent where there is none.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { contactLine, traceBehind } from '../../www/stage/gear/contact-line.js';
import { forceArrows } from '../../www/stage/gear/forces.js';
import { poseNow } from '../../www/stage/gear/pose.js';
import { sheetFor } from '../../www/stage/gear/sheet.js';
import { SCALE_AT } from '../../www/stage/gear/top-notes.js';
import { DEGREE, record, sceneOf, sizes, theme } from './gear-scene.mjs';

/** @param {import('./gear-scene.mjs').Scene} scene */
function arrowsOf(scene) {
  const sheet = sheetFor(sizes.desktop, scene);
  const pose = poseNow(scene);
  return forceArrows(sheet, scene, pose, contactLine(traceBehind(scene, pose, 1), pose));
}

test('a side force to the left points up the sheet, across the wheel', () => {
  for (const sign of [1, -1]) {
    const scene = sceneOf({ psi: 0.2, y: sign * 0.03 });
    const { side } = arrowsOf(scene);
    assert.equal(Math.sign(side.from.y - side.to.y), sign);
    const along = (side.to.x - side.from.x) * Math.cos(0.2) - (side.to.y - side.from.y) * Math.sin(0.2);
    assert.ok(Math.abs(along) < 1e-9, 'across the wheel plane');
  }
});

test('an aligning moment that is negative turns clockwise: up, behind the wheel', () => {
  for (const sign of [1, -1]) {
    const { moment } = arrowsOf(sceneOf({ y: sign * 0.03 }));
    const at = (/** @type {number} */ angle) => moment.y + moment.radius * Math.sin(angle);
    assert.equal(Math.sign(at(moment.start) - at(moment.end)), sign);
  }
});

test('lengths are in proportion to the full scale', () => {
  const half = sceneOf({ y: 0.02 });
  half.forces = { ...half.forces, sideForce: 2500, aligningMoment: -500 };
  const whole = { ...half, forces: { ...half.forces, sideForce: 5000, aligningMoment: -1000 } };
  assert.ok(Math.abs(arrowsOf(whole).side.length / arrowsOf(half).side.length - 2) < 1e-9);
  const turn = (/** @type {typeof half} */ scene) => arrowsOf(scene).moment.end - arrowsOf(scene).moment.start;
  assert.ok(Math.abs(turn(whole) / turn(half) - 2) < 1e-9);
});

test('beyond its limit angle there is no moment and no arrow of it', () => {
  const scene = sceneOf({ y: 0.08 });
  scene.forces = { ...scene.forces, aligningMoment: 0 };
  const { marks, texts } = record(scene);
  assert.ok(!texts.some(({ text }) => text === 'M'));
  const arrows = marks.filter(({ kind, color }) => kind === 'stroke' && color === theme.force);
  assert.equal(arrows.length, 1, 'the side force alone');
});

test('a side force at its limit says so', () => {
  const limited = sceneOf({ psi: -0.15, y: -0.06 });
  limited.forces = { ...limited.forces, aligningMoment: 250, sideForce: -4500 };
  assert.ok(record(limited).texts.some(({ text }) => text.endsWith('kN, at its limit')));
  assert.ok(!record(sceneOf({ y: 0.02 })).texts.some(({ text }) => text.includes('limit')));
});

// The tire follows a swing at ω as ẏ = vψ − (v/σ)y says: y = vψ/(iω + v/σ). Here v = 80 m/s, σ = 0.3 m and 51.9 Hz.
const omega = 2 * Math.PI * 51.9;
const ratio = 80 / Math.hypot(omega, 80 / 0.3);
const lag = Math.atan2(omega, 80 / 0.3);

test('through a whole cycle of ±15° the side force’s arrow ends on the band and crosses no note at its foot', () => {
  for (const layout of /** @type {const} */ (['desktop', 'projector', 'phone'])) {
    for (const magnification of [1, 10]) {
      for (let phase = 0; phase < 2 * Math.PI; phase += 0.1) {
        const psi = (15 * DEGREE * Math.sin(phase)) / magnification;
        const y = (15 * DEGREE * ratio * Math.sin(phase - lag)) / magnification;
        const scene = sceneOf({ psi, y, swing: 0 }, { magnification, layout, forceScale: { force: 20_000, moment: 1000 } });
        scene.forces = { ...scene.forces, sideForce: 15_700 * Math.max(-1, Math.min(1, (y * magnification) / 0.026)) };
        const sheet = sheetFor(sizes[layout], scene);
        const pose = poseNow(scene);
        const { from, to } = forceArrows(sheet, scene, pose, contactLine(traceBehind(scene, pose, 1), pose)).side;
        const where = JSON.stringify([layout, magnification, phase, from, to]);
        assert.ok(to.y > sheet.band.top + 2 && to.y < sheet.band.bottom - 2, where);
        const notes = record(scene).texts.filter(({ x, y: at, halo }) => !halo && x === SCALE_AT && at > sheet.axis.y && at < sheet.band.bottom);
        assert.ok(notes.length > 0);
        for (const { text, x, y: at, width, size } of notes) {
          const isBeside = Math.min(from.x, to.x) - 8 * sheet.line > x + width;
          assert.ok(isBeside || to.y < at - 0.6 * size, `${text} at ${where}`);
        }
      }
    }
  }
});

test('at rest there are no arrows and nothing is said of forces', () => {
  const { marks, texts } = record(sceneOf({ swing: 0 }));
  assert.ok(!marks.some(({ color }) => color === theme.force));
  assert.ok(!texts.some(({ text }) => ['F', 'M', 'α', 'y'].includes(text)));
});
