import assert from 'node:assert/strict';
import test from 'node:test';
import { refusal, shimmy, SHIMMY, STATES } from './module.mjs';

/** A live gear, freed at the end of the test. @param {import('node:test').TestContext} t @param {object} [change] */
function live(t, change = {}) {
  const simulator = new shimmy.Simulator({ ...SHIMMY, ...change });
  t.after(() => simulator.free());
  return simulator;
}

test('it begins at 0 with the initial state and the parameters of the run', (t) => {
  const simulator = live(t);
  assert.equal(simulator.time, 0);
  assert.deepEqual(simulator.state(), new Float64Array([0.05, 0, 0]));
  const parameters = simulator.parameters();
  assert.equal(Object.getPrototypeOf(parameters), Object.prototype);
  assert.equal(parameters.velocity, 80);
  assert.equal(parameters.relaxationLength, 0.3);
});

test('it goes where simulate goes', (t) => {
  const simulator = live(t, { rtol: 1e-10 });
  simulator.advance(0.5);
  const { torsionAngle } = shimmy.simulate({ ...SHIMMY, rtol: 1e-10, times: [0.5] });
  assert.ok(Math.abs(simulator.state()[0] - torsionAngle[0]) < 1e-7);
});

test('its path does not depend on how time is cut into frames', (t) => {
  const [smooth, ragged] = [live(t), live(t)];
  smooth.advance(1);
  let left = 1;
  for (let i = 0; left > 0; i++) {
    const frame = Math.min(left, [0.0001, 0.016, 0.00033, 0.1][i % 4]);
    ragged.advance(frame);
    left -= frame;
  }
  // The times differ by rounding alone, and the state by as much as the wheel turns meanwhile.
  assert.ok(Math.abs(smooth.time - ragged.time) < 1e-12);
  for (const index of STATES.keys()) assert.ok(Math.abs(smooth.state()[index] - ragged.state()[index]) < 1e-8);
});

test('what is set and kicked acts from now on', (t) => {
  const simulator = live(t);
  simulator.advance(0.1);
  simulator.set('dampingConstant', 60);
  assert.equal(simulator.parameters().dampingConstant, 60);
  simulator.setState('torsionAngle', 0.2);
  assert.equal(simulator.state()[0], 0.2);
  const rate = simulator.state()[1];
  simulator.kick(2);
  // Angular momentum: 2 N m s on 1 kg m².
  assert.ok(Math.abs(simulator.state()[1] - rate - 2) < 1e-12);
});

test('seeking back brings back state and parameters bit for bit', (t) => {
  const simulator = live(t);
  simulator.advance(0.3);
  const then = simulator.state();
  simulator.advance(0.2);
  simulator.set('dampingConstant', 60);
  simulator.advance(0.5);
  const later = simulator.state();

  simulator.seek(0.3);
  assert.equal(simulator.time, 0.3);
  assert.deepEqual(simulator.state(), then);
  assert.equal(simulator.parameters().dampingConstant, 20);
  simulator.seek(1);
  assert.deepEqual(simulator.state(), later);
  assert.equal(simulator.parameters().dampingConstant, 60);
});

test('its range reaches 60 s back and not beyond', (t) => {
  const simulator = live(t, { parameters: { velocity: 10, dampingConstant: 60 } });
  for (let i = 0; i < 70; i++) simulator.advance(1);
  const [from, to] = simulator.range;
  assert.ok(Math.abs(to - 70) < 1e-9);
  assert.ok(to - from >= 60 && to - from < 62);
  const error = refusal(() => simulator.seek(5));
  assert.equal(error.field, 'time');
  assert.ok(Math.abs(simulator.time - 70) < 1e-9, 'it stays where it was');
});

test('a snapshot is bytes from which another instance goes on', (t) => {
  const [first, second] = [live(t), live(t, { parameters: {} })];
  first.advance(0.4);
  first.set('casterLength', 0.12);
  const bytes = first.snapshot();
  assert.ok(bytes instanceof Uint8Array);
  second.restore(bytes);
  assert.equal(second.time, first.time);
  for (const simulator of [first, second]) simulator.advance(0.4);
  assert.deepEqual(second.state(), first.state());
  assert.deepEqual(second.parameters(), first.parameters());
});

test('bytes that are no snapshot are refused, and the gear stays as it is', (t) => {
  const simulator = live(t);
  simulator.advance(0.1);
  const state = simulator.state();
  for (const bytes of [new Uint8Array(), new Uint8Array(100), simulator.snapshot().slice(0, -1)]) {
    assert.ok(refusal(() => simulator.restore(bytes)) instanceof Error);
  }
  assert.deepEqual(simulator.state(), state);
});

test('reset goes back to the beginning of the run', (t) => {
  const simulator = live(t);
  simulator.advance(0.7);
  simulator.reset();
  assert.equal(simulator.time, 0);
  assert.deepEqual(simulator.state(), new Float64Array([0.05, 0, 0]));
});

test('the trace holds the steps since the last call, thinned out to what was asked for', (t) => {
  const simulator = live(t);
  simulator.advance(0.2);
  const trace = simulator.trace(1000);
  assert.deepEqual(Object.keys(trace).sort(), ['time', ...STATES].sort());
  assert.ok(trace.time.length > 20);
  assert.ok(trace.time.every((time, index) => index === 0 || time > trace.time[index - 1]));
  simulator.advance(0.2);
  const thin = simulator.trace(16);
  assert.ok(thin.time.length > 2 && thin.time.length <= 16);
  assert.ok(thin.time[0] >= trace.time[trace.time.length - 1]);
});

test('history gives any window of the past, at equal distances', (t) => {
  const simulator = live(t, { rtol: 1e-10 });
  simulator.advance(1);
  const { time, torsionAngle } = simulator.history(0.2, 0.6, 5);
  for (const [index, at] of time.entries()) assert.ok(Math.abs(at - 0.2 - index / 10) < 1e-12);
  const expected = shimmy.simulate({ ...SHIMMY, rtol: 1e-10, times: [...time] });
  for (const index of time.keys()) assert.ok(Math.abs(torsionAngle[index] - expected.torsionAngle[index]) < 1e-6);
  assert.equal(simulator.time, 1, 'looking back does not move the gear');
});

test('the envelope bounds the past', (t) => {
  const simulator = live(t);
  simulator.advance(1);
  const { low, high } = simulator.envelope(0, 1, 10);
  assert.equal(low.length, 10);
  const { torsionAngle } = simulator.history(0, 1, 1001);
  const most = Math.max(...torsionAngle.map(Math.abs));
  assert.ok(Math.abs(Math.max(...high) - most) < 0.01 * most);
  assert.ok(low.every((value, index) => value <= high[index]));
});

test('a refusal leaves it as it was, and it lives on', (t) => {
  const simulator = live(t);
  simulator.advance(0.1);
  const state = simulator.state();
  for (const call of [
    () => simulator.advance(-1),
    () => simulator.advance(NaN),
    () => simulator.advance(1e300),
    () => simulator.set('velocity', -3),
    () => simulator.set('velocty', 3),
    () => simulator.setState('torsionAngle', Infinity),
    () => simulator.kick(NaN),
    () => simulator.seek(-1),
    () => simulator.history(0, 0.1, 1e12),
    () => simulator.trace(-1),
  ]) {
    assert.ok(refusal(call) instanceof Error, String(call));
    assert.deepEqual(simulator.state(), state, String(call));
  }
  simulator.advance(0.1);
  assert.ok(Math.abs(simulator.time - 0.2) < 1e-12);
});

test('once freed it refuses every call', () => {
  const simulator = new shimmy.Simulator(SHIMMY);
  simulator.free();
  assert.throws(() => simulator.advance(0.1));
});
