import assert from 'node:assert/strict';
import test from 'node:test';
import { refusal, shimmy } from './module.mjs';

const DEGREE = Math.PI / 180;
const gear = { model: 'torsional', parameters: { freeplayAngle: DEGREE } };

test('the force laws come as curves, with their kinks among the points', () => {
  const laws = shimmy.forceLaws(gear, { slipAngle: 20 * DEGREE, torsionAngle: 3 * DEGREE, samples: 81 });
  assert.deepEqual(Object.keys(laws), ['slipAngle', 'sideForce', 'aligningMoment', 'torsionAngle', 'restoringMoment', 'kinks']);
  const { kinks, ...columns } = laws;
  assert.ok(Object.values(columns).every((column) => column instanceof Float64Array));
  assert.deepEqual(kinks, { sideForceLimitAngle: 5 * DEGREE, aligningMomentLimitAngle: 10 * DEGREE, freeplayAngle: DEGREE });
  const at = laws.slipAngle.indexOf(5 * DEGREE);
  assert.ok(Math.abs(laws.sideForce[at] - 180_000 * 5 * DEGREE) < 1e-9);
  const edge = laws.torsionAngle.indexOf(DEGREE);
  assert.equal(laws.restoringMoment[edge], 0);
  assert.ok(laws.restoringMoment[edge + 1] < 0);
});

test('without a word it is ±20° and 201 points; the linear gear has no kinks', () => {
  const { slipAngle, sideForce, torsionAngle, kinks } = shimmy.forceLaws({ model: 'torsional-linear' });
  assert.equal(slipAngle.length, 201);
  assert.equal(torsionAngle.length, 201);
  assert.ok(Math.abs(slipAngle[200] - 20 * DEGREE) < 1e-15);
  assert.ok(Math.abs(sideForce[200] - 180_000 * slipAngle[200]) < 1e-8);
  assert.deepEqual(kinks, { sideForceLimitAngle: null, aligningMomentLimitAngle: null, freeplayAngle: null });
});

test('what cannot be drawn is refused in words', () => {
  /** @param {any} curves */
  const refused = (curves) => refusal(() => shimmy.forceLaws(gear, curves));
  assert.equal(refused({ slipAngle: 2 }).field, 'slipAngle');
  assert.equal(refused({ samples: 1e9 }).code, 'too-large');
  assert.equal(refused({ slipangle: 1 }).suggestion, 'slipAngle');
});
