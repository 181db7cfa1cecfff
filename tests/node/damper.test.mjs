import assert from 'node:assert/strict';
import test from 'node:test';
import { refusal, shimmy } from './module.mjs';

test('every damper has its tables', () => {
  const dampers = shimmy.dampers();
  assert.deepEqual(dampers.map((damper) => damper.name), ['bouc-wen', 'modified-bouc-wen', 'modified-bouc-wen-cubic', 'current-dependent-bouc-wen']);
  const [simple, modified, cubic] = dampers;
  assert.deepEqual(simple.parameters.map((parameter) => parameter.name), ['viscousDamping', 'stiffness', 'offset', 'hysteresisGain', 'gamma', 'beta', 'exponent', 'amplitude']);
  assert.deepEqual(modified.state.map((state) => state.name), ['hysteresis', 'internalDisplacement', 'effectiveCommand']);
  assert.deepEqual(cubic.onGear, { offset: 0, forceScale: 0.01 });
  assert.equal(cubic.command.max, 2.5);
});

test('a damper answers the motion of its piston', () => {
  const damper = { model: 'modified-bouc-wen', command: 1.5 };
  const loop = shimmy.damperResponse({ damper, excitation: { amplitude: 0.015, frequency: 2.5 }, cycles: 1.5, samples: 24 });
  assert.ok(Object.values(loop).every((column) => column instanceof Float64Array && column.length === 24));
  assert.ok(Math.abs(loop.time[2] - 0.05) < 1e-15);
  // SciPy's, from tests/damper-reference.json.
  assert.ok(Math.abs(loop.force[5] - -933.1657800199914) < 1e-5);
  assert.ok(Math.abs(loop.internalDisplacement[5] - 0.0031601797069228314) < 1e-11);
  assert.equal(shimmy.damperResponse({ damper }).force.length, 1000);
});

test('what cannot be is refused in words', () => {
  /** @param {any} spec */
  const refused = (spec) => refusal(() => shimmy.damperResponse(spec));
  assert.equal(refused({}).field, 'damper');
  assert.equal(refused({ damper: { model: 'bouc-ven' } }).suggestion, 'bouc-wen');
  assert.equal(refused({ damper: { model: 'modified-bouc-wen-cubic', command: 0 } }).field, 'damper.command');
  assert.equal(refused({ damper: { model: 'bouc-wen', parameters: { gamma: -1 } } }).field, 'damper.parameters.gamma');
  assert.equal(refused({ damper: { model: 'bouc-wen', parameters: { gama: 1 } } }).suggestion, 'gamma');
  assert.equal(refused({ damper: { model: 'bouc-wen' }, excitation: { frequency: Infinity } }).code, 'not-finite');
});
