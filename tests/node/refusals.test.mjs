import assert from 'node:assert/strict';
import test from 'node:test';
import { refusal, shimmy, SHIMMY } from './module.mjs';

/** @param {object} change */
const refused = (change) => refusal(() => shimmy.simulate({ ...SHIMMY, ...change }));

test('a refusal is an Error that says which field, what it was and what is allowed', () => {
  const error = refused({ parameters: { velocity: -3 } });
  assert.equal(Object.prototype.toString.call(error), '[object Error]');
  assert.match(error.message, /velocity must be > 0 m\/s, got -3/);
  assert.equal(error.code, 'out-of-range');
  assert.equal(error.field, 'velocity');
  assert.equal(error.value, '-3');
  assert.equal(error.allowed, '> 0 m/s');
});

test('NaN and the infinities are not numbers to run with', () => {
  for (const value of [NaN, Infinity, -Infinity]) {
    assert.equal(refused({ parameters: { casterLength: value } }).field, 'casterLength');
    assert.equal(refused({ initial: { torsionAngle: value } }).field, 'torsionAngle');
    for (const field of ['duration', 'rtol', 'atol']) assert.equal(refused({ [field]: value }).field, field);
  }
});

test('a value of another type is refused, a string of digits and a big integer too', () => {
  for (const value of ['80', true, {}, [], () => 80, Symbol('80'), 80n]) {
    const error = refused({ parameters: { velocity: value } });
    assert.equal(error.code, 'wrong-type');
    assert.equal(error.field, 'velocity');
  }
  for (const run of [undefined, null, 1, 'torsional', [], () => {}]) {
    assert.ok(refusal(() => shimmy.simulate(/** @type {any} */ (run))) instanceof Error);
  }
});

test('an unknown name is answered with the nearest known one, at every level', () => {
  for (const [change, unknown, suggestion] of /** @type {[object, string, string][]} */ ([
    [{ model: 'torsionl' }, 'torsionl', 'torsional'],
    [{ method: 'dop835' }, 'dop835', 'dop853'],
    [{ parametres: {} }, 'parametres', 'parameters'],
    [{ parameters: { velocty: 80 } }, 'velocty', 'velocity'],
    [{ initial: { torsionangle: 0.1 } }, 'torsionangle', 'torsionAngle'],
  ])) {
    const error = refused(change);
    assert.match(error.code, /^unknown-(key|name)$/);
    assert.equal(error.suggestion, suggestion);
    assert.ok(error.message.includes(unknown) && error.message.includes(suggestion), error.message);
  }
});

test('absurd sizes are refused and not attempted', () => {
  const began = performance.now();
  for (const samples of [0, 1, 2.5, -5, 1e7 + 1, 1e12, Number.MAX_VALUE]) {
    assert.equal(refused({ samples }).field, 'samples');
  }
  assert.ok(performance.now() - began < 100);
});

test('times must ascend from 0 or later', () => {
  for (const times of [[], [0.2, 0.1], [-0.1, 0.2], [0, NaN], [0, '0.1'], {}, 'now']) {
    assert.equal(refused({ times }).field.split('[')[0], 'times');
  }
});

test('times and samples together contradict each other', () => {
  assert.ok(refused({ times: [0.1], samples: 5 }) instanceof Error);
});

test('a run that needs too many steps says how far it came', () => {
  const error = refused({ maxSteps: 10 });
  assert.equal(error.code, 'step-limit');
  assert.match(error.message, /\d s/);
});

test('what belongs to a later part of the contract is refused and not ignored', () => {
  for (const field of ['tire', 'friction', 'control', 'disturbance']) {
    assert.ok(refused({ [field]: { model: 'bouc-wen' } }) instanceof Error, field);
  }
});

test('the module goes on as if nothing had happened', () => {
  const before = shimmy.simulate({ ...SHIMMY, samples: 51 });
  for (let i = 0; i < 100; i++) refused({ parameters: { velocity: -i } });
  assert.deepEqual(shimmy.simulate({ ...SHIMMY, samples: 51 }), before);
});

test('a number is shown as JavaScript writes it, without a plus in its exponent', () => {
  const value = (/** @type {number} */ velocity) => refused({ parameters: { velocity } }).value;
  assert.deepEqual([-3, -0.1, -1e300, -1.5e-300, -2e15, -123456.789, 1e13, NaN, -Infinity].map(value),
    ['-3', '-0.1', '-1e300', '-1.5e-300', '-2e15', '-123456.789', '10000000000000', 'NaN', '-Infinity']);
  const step = refusal(() => shimmy.simulate({ ...SHIMMY, method: 'rk4', step: 0.1 }));
  assert.match(step.allowed, /^at most \d\.\d{3}e-\d s for rk4/);
});
