// A tire bends as far as one could: however far a hand twists it, its outline stays one that does not cross itself, up to
// there it is drawn as it is, and the sheet says where it is not.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bendsFurther, heldDeformation } from '../../www/stage/gear/bend.js';
import { contactLine, restingLine, traceBehind } from '../../www/stage/gear/contact-line.js';
import { forceArrows } from '../../www/stage/gear/forces.js';
import { grabTarget } from '../../www/stage/gear/grab.js';
import { poseNow } from '../../www/stage/gear/pose.js';
import { sheetFor } from '../../www/stage/gear/sheet.js';
import { gearEn, gearTr } from '../../www/words/gear.js';
import { DEGREE, record, sceneOf, sizes } from './gear-scene.mjs';

/**
 * A wheel that stood straight and was twisted within a few rolled centimeters, or has long been held there.
 * @param {number} degrees @param {{ y?: number, rolled?: number, magnification?: number, caster?: number }} [how]
 */
function twisted(degrees, { y = 0.3 * degrees * DEGREE, rolled = 0.1, magnification = 1, caster = 0.1 } = {}) {
  const psi = (degrees * DEGREE) / magnification;
  const scene = sceneOf({ psi, y: y / magnification, swing: 0 }, { magnification, parameters: { casterLength: caster }, forceScale: { force: 15_700, moment: 1000 } });
  const { distance } = scene.track;
  const share = Float64Array.from(distance, (at) => Math.max(0, 1 - (scene.roll - at) / rolled));
  scene.track = { distance, torsionAngle: share.map((part) => part * psi), lateralDeformation: share.map((part) => (part * y) / magnification) };
  scene.forces = { ...scene.forces, sideForce: Math.sign(y) * 15_700, sideForceLimited: true };
  return scene;
}

/** How often a closed outline crosses itself. @param {{ x: number, y: number }[]} outline */
function crossings(outline) {
  const turn = (/** @type {{x: number, y: number}} */ a, /** @type {{x: number, y: number}} */ b, /** @type {{x: number, y: number}} */ c) =>
    Math.sign((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  const count = outline.length;
  let found = 0;
  for (let i = 0; i < count; i++)
    for (let j = i + 2; j < count - (i === 0 ? 1 : 0); j++) {
      const [a, b, c, d] = [outline[i], outline[i + 1], outline[j], outline[(j + 1) % count]];
      if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) found++;
    }
  return found;
}

const wild = [-75, -45, -31, 31, 45, 60, 75].flatMap((degrees) => [0.02, 0.2, 5].flatMap((rolled) => [
  twisted(degrees, { rolled }), twisted(degrees, { rolled, y: -0.3 }), twisted(degrees, { rolled, magnification: 5 }), twisted(degrees, { rolled, y: 8 }),
]));

test('however far it is twisted, the tire’s outline does not cross itself and stays about its rim', () => {
  for (const scene of wild) {
    const { outline } = grabTarget(sizes.desktop, scene);
    assert.equal(crossings(outline), 0, JSON.stringify(scene.state));
    const { scale } = sheetFor(sizes.desktop, scene);
    const length = Math.max(...outline.map((a) => Math.max(...outline.map((b) => Math.hypot(a.x - b.x, a.y - b.y)))));
    assert.ok(length < 0.72 * scale, `${length / scale} m from end to end`);
  }
});

test('its center line bends aside by 42° at most', () => {
  for (const scene of wild) {
    const pose = poseNow(scene);
    const { l, n } = contactLine(traceBehind(scene, pose, 1), pose);
    n.forEach((aside, i) => assert.ok(i === 0 || Math.abs(aside - n[i - 1]) <= 0.9 * (l[i - 1] - l[i]) + 1e-12, JSON.stringify(scene.state)));
  }
});

test('a deformation is drawn as it is, then less and less beyond, and grows all the way', () => {
  for (const y of [0, 0.05, -0.13]) assert.equal(heldDeformation(y), y);
  let last = 0.13;
  for (let y = 0.14; y < 0.4; y += 0.01) {
    const drawn = heldDeformation(y);
    assert.ok(drawn > last && drawn < y && drawn < 0.18, `${y} → ${drawn}`);
    assert.equal(heldDeformation(-y), -drawn);
    last = drawn;
  }
  // No corner: right behind the knee it follows as it did before.
  assert.ok(Math.abs((heldDeformation(0.1301) - 0.13) / 1e-4 - 1) < 1e-3);
});

test('in an ordinary swing the contact lies on its track and nothing is said', () => {
  for (let phase = 0; phase < 2 * Math.PI; phase += 0.2) {
    const scene = sceneOf({ psi: 15 * DEGREE * Math.sin(phase), y: 0.06 * Math.sin(phase - 0.9), swing: 0 });
    const pose = poseNow(scene);
    const trace = traceBehind(scene, pose, 1);
    const [resting, drawn] = [restingLine(trace, pose), contactLine(trace, pose)];
    resting.n.forEach((aside, i) => assert.ok(Math.abs(aside - drawn.n[i]) < 1e-12));
    assert.equal(bendsFurther(scene, resting), false);
    assert.ok(!record(scene).texts.some(({ text }) => text.includes('further')));
  }
});

test('where the tire bends further than it is drawn the sheet says so, in both languages', () => {
  for (const [words, said] of /** @type {const} */ ([[gearEn, 'bends further'], [gearTr, 'daha çok bükülü']]))
    for (const scene of [twisted(60), twisted(5, { y: 0.3 }), twisted(40, { magnification: 5 })]) {
      const texts = record(scene, words).texts.map(({ text }) => text).join(' ');
      assert.ok(texts.includes(said), texts);
      if (scene.magnification > 1) assert.match(texts, /×\u20095|5 kat/);
    }
});

test('numbers tell the state, however it is drawn', () => {
  const texts = record(twisted(40, { y: 0.25 })).texts.map(({ text }) => text).join('');
  // arctan(0.25 m / 0.3 m).
  assert.match(texts, /\+40\.0°.*39\.8°/);
});

test('the side force’s arrow is as long as ever, across the wheel, and ends on the band', () => {
  for (const scene of wild) {
    const sheet = sheetFor(sizes.desktop, scene);
    const pose = poseNow(scene);
    const { from, to, length } = forceArrows(sheet, scene, pose, contactLine(traceBehind(scene, pose, 1), pose)).side;
    const where = JSON.stringify([scene.state, from, to]);
    assert.ok(to.y >= sheet.band.top + 5 && to.y <= sheet.band.bottom - 5 && to.x >= 5 && to.x <= sheet.width - 5, where);
    assert.ok(Math.abs(Math.hypot(to.x - from.x, to.y - from.y) - length) < 1e-9, where);
    const along = (to.x - from.x) * pose.cos - (to.y - from.y) * pose.sin;
    assert.ok(Math.abs(along) < 1e-9, where);
  }
});
