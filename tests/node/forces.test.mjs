import assert from 'node:assert/strict';
import test from 'node:test';
import { shimmy } from './module.mjs';

const DEGREE = Math.PI / 180;

/** Forces of the default gear at a lateral deformation that gives this slip angle. @param {number} slip @param {object} [more] */
const at = (slip, more = {}) => shimmy.forces({ ...more }, [0.02, 0, 0.3 * Math.tan(slip)]);

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
