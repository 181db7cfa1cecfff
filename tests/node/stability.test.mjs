import assert from 'node:assert/strict';
import test from 'node:test';
import { refusal, shimmy, SHIMMY } from './module.mjs';

/** @param {Record<string, number>} parameters */
const gear = (parameters) => ({ model: 'torsional', parameters });

/** @param {number[]} got @param {number[]} expected @param {number} digit half a unit of the last digit given */
function assertNear(got, expected, digit) {
  assert.equal(got.length, expected.length, `${got}`);
  got.forEach((value, index) => assert.ok(Math.abs(value - expected[index]) <= digit, `${value} is not ${expected[index]}`));
}

test('the critical speeds and dampings are the known ones', () => {
  const speeds = (/** @type {number} */ c) => shimmy.routhHurwitz(gear({ dampingConstant: c })).criticalVelocities;
  assertNear(speeds(0), [15.2593], 5e-5);
  assertNear(speeds(10), [20.511, 1040.97], 5e-3);
  assertNear(speeds(40), [51.881, 205.13], 5e-3);
  assert.deepEqual(speeds(50), []);
  assertNear([Number(shimmy.routhHurwitz(gear({ velocity: 80 })).criticalDamping)], [48.53], 5e-4);
  assert.equal(shimmy.routhHurwitz(gear({ verticalForce: 0 })).criticalDamping, null);
});

test('stable is what the column says, and both models agree without freeplay', () => {
  for (const dampingConstant of [20, 48.5, 48.6, 60]) {
    const answer = shimmy.routhHurwitz(gear({ velocity: 80, dampingConstant }));
    assert.deepEqual(Object.keys(answer), ['stable', 'column', 'criticalVelocities', 'criticalDamping']);
    assert.equal(answer.column.length, 4);
    assert.equal(answer.stable, answer.column.every((entry) => entry > 0));
    assert.equal(answer.stable, dampingConstant > 48.53);
    assert.deepEqual(shimmy.routhHurwitz({ model: 'torsional-linear', parameters: { velocity: 80, dampingConstant } }), answer);
  }
});

test('the hatched part of a slider: from the range to the boundary', () => {
  const of = (/** @type {string} */ parameter, /** @type {number} */ from, /** @type {number} */ to) =>
    shimmy.unstableIntervals(SHIMMY, { parameter, from, to });
  const [damping] = of('dampingConstant', 0, 200);
  assert.deepEqual(Object.keys(damping), ['from', 'to', 'fromKind', 'toKind']);
  assert.equal(damping.from, 0);
  assert.equal(damping.fromKind, 'range');
  assert.equal(damping.to, shimmy.routhHurwitz(SHIMMY).criticalDamping);
  assert.equal(damping.toKind, 'hopf');
  assert.deepEqual(of('velocity', 1, 20), []);
  assert.deepEqual(of('sideForceLimitAngle', 0.05, 0.1), [{ from: 0.05, to: 0.1, fromKind: 'range', toKind: 'range' }]);
  assert.equal(of('casterLength', -0.9, 0.5)[0].toKind, 'divergence');
});

test('what is linked follows', () => {
  const range = { parameter: 'halfContactLength', from: 0.01, to: 0.3 };
  const alone = shimmy.unstableIntervals(SHIMMY, range);
  const linked = shimmy.unstableIntervals(SHIMMY, { ...range, linked: { relaxationLength: true, treadWidthMomentConstant: true } });
  assert.notDeepEqual(linked, alone);
  assert.deepEqual(shimmy.unstableIntervals(SHIMMY, { ...range, linked: { relaxationLength: false } }), alone);
  for (const { from, to } of linked) {
    const middle = (from + to) / 2;
    const follow = shimmy.linkedParameters(gear({ halfContactLength: middle }));
    assert.equal(shimmy.routhHurwitz(gear({ ...SHIMMY.parameters, halfContactLength: middle, ...follow })).stable, false);
  }
});

test('a bad range is refused in words', () => {
  /** @param {any} variation */
  const refused = (variation) => refusal(() => shimmy.unstableIntervals(SHIMMY, variation));
  assert.equal(refused({ parameter: 'velocty', from: 1, to: 2 }).suggestion, 'velocity');
  assert.equal(refused({ parameter: 'velocity', from: 0, to: 2 }).field, 'from');
  assert.equal(refused({ parameter: 'velocity', from: 3, to: 2 }).code, 'not-ascending');
  assert.equal(refused({ parameter: 'velocity', from: 3 }).code, 'missing');
  assert.equal(refused({ parameter: 'velocity', from: 1, to: 2, step: 1 }).code, 'unknown-key');
  assert.equal(refused({ parameter: 'velocity', from: 1, to: 2, linked: { relaxationLength: 1 } }).field, 'linked.relaxationLength');
  assert.equal(refused(null).code, 'wrong-type');
});
