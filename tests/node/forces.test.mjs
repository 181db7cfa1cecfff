import assert from 'node:assert/strict';
import test from 'node:test';
import { refusal, shimmy, SHIMMY, STATES } from './module.mjs';

const DEGREE = Math.PI / 180;

/** Forces of the default gear at a lateral deformation that gives this slip angle. @param {number} slip @param {object} [more] */
const at = (slip, more = {}) => shimmy.forces({ model: 'torsional', parameters: { ...more } }, [0.02, 0, 0.3 * Math.tan(slip)]);

test('below both limits the side force is linear and the aligning moment follows its sine', () => {
  const { slipAngle, sideForce, aligningMoment, sideForceLimited } = at(3 * DEGREE);
  assert.ok(Math.abs(slipAngle - 3 * DEGREE) < 1e-12);
  assert.ok(Math.abs(sideForce - 20 * 9000 * 3 * DEGREE) < 1e-6);
  const moment = -2 * 9000 * (10 / 180) * Math.sin(0.3 * Math.PI);
  assert.ok(Math.abs(aligningMoment - moment) < 1e-6);
  assert.equal(sideForceLimited, false);
});

test('beyond them the side force stays and the moment is none', () => {
  const { sideForce, aligningMoment, sideForceLimited } = at(-12 * DEGREE);
  assert.ok(Math.abs(sideForce + 20 * 9000 * 5 * DEGREE) < 1e-6);
  assert.ok(Math.abs(aligningMoment) < 1e-9);
  assert.equal(sideForceLimited, true);
});

test('the spring turns by what exceeds the gap', () => {
  assert.equal(at(0).springAngle, 0.02);
  assert.equal(at(0, { freeplayAngle: 0.03 }).springAngle, 0);
  const { springAngle, springTorque } = at(0, { freeplayAngle: 0.005 });
  assert.ok(Math.abs(springAngle - 0.015) < 1e-15);
  assert.ok(Math.abs(Math.abs(springTorque) - 1500) < 1e-9);
});

test('the linear gear has straight laws and no limit', () => {
  const { slipAngle, sideForce, aligningMoment, sideForceLimited, springAngle } =
    shimmy.forces({ model: 'torsional-linear' }, [0.02, 0, 0.15]);
  assert.equal(slipAngle, 0.5);
  assert.ok(Math.abs(sideForce - 90_000) < 1e-9 && Math.abs(aligningMoment + 9000) < 1e-9);
  assert.equal(sideForceLimited, false);
  assert.equal(springAngle, 0.02);
});

test('along a motion they are the same, row by row', () => {
  const motion = shimmy.simulate({ ...SHIMMY, duration: 0.1, samples: 20 });
  const columns = shimmy.forcesAlong(SHIMMY, motion);
  assert.deepEqual(Object.keys(columns), ['slipAngle', 'sideForce', 'aligningMoment', 'springTorque', 'frictionTorque', 'damperForce', 'damperTorque']);
  for (let row = 0; row < 20; row++) {
    const forces = shimmy.forces(SHIMMY, STATES.map((state) => motion[state][row]));
    for (const name of /** @type {(keyof typeof columns)[]} */ (Object.keys(columns))) assert.equal(columns[name][row], forces[name]);
  }
  assert.equal(shimmy.forcesAlong(SHIMMY, shimmy.outlook(SHIMMY).orbit).sideForce.length, 129);
});

test('what is no state is refused in words', () => {
  /** @param {any} state */
  const refused = (state) => refusal(() => shimmy.forces(SHIMMY, state));
  assert.match(refused([1, 2]).message, /3 numbers: torsionAngle/);
  assert.equal(refused([1, NaN, 2]).field, 'torsionRate');
  assert.equal(refused(null).field, 'state');
  /** @param {any} columns */
  const along = (columns) => refusal(() => shimmy.forcesAlong(SHIMMY, columns));
  assert.equal(along({ torsionAngle: [1], torsionRate: [1] }).field, 'lateralDeformation');
  assert.equal(along({ torsionAngle: [1], torsionRate: [1], lateralDeformation: [1, 2] }).field, 'lateralDeformation');
  assert.equal(along({ torsionAngle: [1], torsionRate: [Infinity], lateralDeformation: [1] }).field, 'torsionRate');
  assert.equal(along({ torsionangle: [1] }).suggestion, 'torsionAngle');
});
