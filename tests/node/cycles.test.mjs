import assert from 'node:assert/strict';
import test from 'node:test';
import { refusal, shimmy, SHIMMY, STATES } from './module.mjs';

/** @param {Record<string, number>} parameters @param {Record<string, number>} [initial] */
const gear = (parameters, initial) => ({ model: 'torsional', parameters, initial });

/** @param {number} got @param {number} expected @param {number} error */
const near = (got, expected, error) => assert.ok(Math.abs(got - expected) <= error, `${got} for ${expected}`);

test('a limit cycle: 0.26508 rad and 51.87 Hz, its orbit, and multipliers with the trivial one', () => {
  const cycle = shimmy.limitCycle(SHIMMY);
  assert.equal(cycle.found, true);
  near(cycle.amplitude.torsionAngle, 0.26508, 5e-6);
  near(Number(cycle.frequency), 51.87, 5e-3);
  near(Number(cycle.frequency) * Number(cycle.period), 1, 1e-12);
  assert.deepEqual([cycle.stable, cycle.symmetric], [true, true]);
  assert.deepEqual(Object.keys(cycle.amplitude), STATES);
  assert.equal(cycle.multipliers.length, 3);
  near(cycle.multipliers[0].re, 1, 1e-6);
  assert.ok(cycle.multipliers[1].re < 1 && cycle.multipliers[0].im === 0);
  const { orbit } = cycle;
  assert.ok(orbit.torsionAngle instanceof Float64Array && orbit.time.length > 100);
  assert.equal(orbit.time[orbit.time.length - 1], cycle.period);
  for (const state of STATES) near(orbit[state][orbit.time.length - 1], orbit[state][0], 1e-7 * cycle.amplitude[state]);
});

test('from rest, from a start and from a guess the same one', () => {
  const parameters = { velocity: 80, dampingConstant: 20 };
  const { orbit, period, amplitude } = shimmy.limitCycle(gear(parameters));
  near(amplitude.torsionAngle, shimmy.limitCycle(SHIMMY).amplitude.torsionAngle, 1e-9);
  const state = Object.fromEntries(STATES.map((name) => [name, orbit[name][0]]));
  const guess = { period: Number(period), state };
  const next = shimmy.limitCycle(gear({ velocity: 80, dampingConstant: 22 }), guess);
  near(next.amplitude.torsionAngle, shimmy.limitCycle(gear({ velocity: 80, dampingConstant: 22 })).amplitude.torsionAngle, 1e-9);
  assert.ok(next.amplitude.torsionAngle < amplitude.torsionAngle);
  assert.deepEqual(shimmy.limitCycle(SHIMMY, null), shimmy.limitCycle(SHIMMY));
});

test('none: numbers null, lists empty', () => {
  const none = shimmy.limitCycle(gear({ velocity: 80, dampingConstant: 60 }, { torsionAngle: 0.1 }));
  assert.deepEqual([none.found, none.period, none.frequency, none.stable, none.symmetric], [false, null, null, null, null]);
  assert.deepEqual([none.amplitude, none.multipliers], [{}, []]);
  assert.deepEqual(Object.keys(none.orbit), ['time', ...STATES]);
  assert.equal(none.orbit.time.length + none.orbit.torsionAngle.length, 0);
});

test('a guess that makes no sense is refused by name', () => {
  /** @param {unknown} guess */
  const refused = (guess) => refusal(() => shimmy.limitCycle(SHIMMY, /** @type {any} */ (guess)));
  assert.equal(refused({ period: 0, state: {} }).field, 'period');
  assert.equal(refused({ state: {} }).code, 'missing');
  assert.equal(refused({ period: 0.02 }).field, 'state');
  assert.equal(refused({ period: 0.02, state: { torsionAngel: 1 } }).suggestion, 'torsionAngle');
  assert.equal(refused({ period: 0.02, state: { torsionAngle: NaN } }).code, 'not-finite');
  assert.equal(refused({ perido: 1 }).suggestion, 'period');
  assert.match(refused(7).message, /guess must be a record/);
});

test('describing functions: 0.20525 rad and 52.521 Hz where the cycle has 0.20632 and 52.517', () => {
  const [cycle, ...others] = shimmy.describingFunction(gear({ velocity: 80, dampingConstant: 30 }));
  assert.deepEqual(others, []);
  near(cycle.amplitude.torsionAngle, 0.20525, 6e-6);
  near(cycle.amplitude.slipAngle, 0.129005, 6e-7);
  near(cycle.amplitude.lateralDeformation, 0.3 * cycle.amplitude.slipAngle, 1e-15);
  near(cycle.frequency, 52.521, 6e-4);
  assert.equal(cycle.stable, true);
  assert.deepEqual(shimmy.describingFunction(gear({ velocity: 80, dampingConstant: 100, freeplayAngle: 0.01 })), []);
  assert.equal(refusal(() => shimmy.describingFunction(/** @type {any} */ ({ model: 'torsionl' }))).suggestion, 'torsional');
});
