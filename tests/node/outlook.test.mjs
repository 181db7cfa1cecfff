import assert from 'node:assert/strict';
import test from 'node:test';
import { shimmy, SHIMMY } from './module.mjs';

/** @param {Record<string, number>} parameters @param {Record<string, number>} [initial] */
const outlook = (parameters, initial = { torsionAngle: 0.05 }) => shimmy.outlook({ model: 'torsional', parameters, initial });

test('at 80 m/s with a weak damper it shimmies: 0.26508 rad, 51.87 Hz', () => {
  const { verdict, amplitude, frequency, present } = shimmy.outlook(SHIMMY);
  assert.equal(verdict, 'shimmies');
  assert.ok(Math.abs(amplitude.torsionAngle - 0.26508) < 5e-6);
  assert.ok(Math.abs(Number(frequency) - 51.87) < 5e-3);
  assert.equal(present.trend, 'growing');
});

test('a stronger damper calms it', () => {
  const { verdict, frequency, orbit } = outlook({ velocity: 80, dampingConstant: 60 });
  assert.equal(verdict, 'dies-out');
  assert.equal(frequency, null);
  assert.equal(orbit.time.length, 0);
});

test('at rest it rests', () => {
  assert.equal(outlook({ velocity: 80, dampingConstant: 60 }, {}).verdict, 'rests');
});

test('with freeplay it rattles in the gap, although the linear theory calls it stable', () => {
  const { verdict, amplitude } = outlook({ velocity: 50, dampingConstant: 100, freeplayAngle: Math.PI / 360 });
  assert.equal(verdict, 'rattles');
  assert.ok(Math.abs(amplitude.torsionAngle - 0.011171) < 1e-6);
});

test('the orbit is one period of the cycle and closes', () => {
  const { orbit, frequency, amplitude } = shimmy.outlook(SHIMMY);
  const last = orbit.time.length - 1;
  assert.ok(last > 20);
  assert.ok(Math.abs((orbit.time[last] - orbit.time[0]) * Number(frequency) - 1) < 0.05);
  assert.ok(Math.abs(orbit.torsionAngle[last] - orbit.torsionAngle[0]) < 0.02 * amplitude.torsionAngle);
});

test('the envelope runs over the horizon', () => {
  const { envelope } = shimmy.outlook({ ...SHIMMY, duration: 3 });
  assert.ok(envelope.low.every((low, index) => low <= envelope.high[index]));
  assert.ok(envelope.time[envelope.time.length - 1] <= 3);
  assert.ok(envelope.time.length > 50);
});
