import assert from 'node:assert/strict';
import test from 'node:test';
import { refusal, shimmy, STATES } from './module.mjs';

/** The gear with c = 20 over its speeds: theory.md has its critical speed, 27.600 m/s, and 18.057° at 40 m/s. */
const SPEC = { model: 'torsional', parameters: { dampingConstant: 20 }, parameter: 'velocity', from: 10, to: 80, probes: 0 };

/** @param {number} got @param {number} expected @param {number} error */
const near = (got, expected, error) => assert.ok(Math.abs(got - expected) <= error, `${got} for ${expected}`);

test('a diagram: rest, the branch that is born at the critical speed, and the Hopf point', () => {
  const { parameter, equilibria, cycles, points } = shimmy.bifurcation(SPEC);
  assert.equal(parameter, 'velocity');
  const count = equilibria.velocity.length;
  assert.deepEqual([equilibria.velocity[0], equilibria.velocity[count - 1]], [10, 80]);
  assert.deepEqual(Object.keys(equilibria.state), STATES);
  for (const quantity of ['growthRate', 'frequency', 'stable', 'unstable']) assert.equal(equilibria[quantity].length, count);
  assert.equal(points.length, 1);
  const [hopf] = points;
  near(hopf.velocity, 27.6, 5e-4);
  assert.deepEqual([hopf.kind, hopf.amplitude, hopf.branch, hopf.criticality, hopf.by], ['hopf', 0, 0, 'supercritical', 'lyapunov']);
  assert.equal(equilibria.velocity[hopf.index], hopf.velocity);
  for (let i = 0; i < count; i++) assert.equal(equilibria.stable[i], equilibria.velocity[i] < hopf.velocity ? 1 : 0);

  assert.equal(cycles.length, 1);
  const [branch] = cycles;
  const n = branch.velocity.length;
  assert.deepEqual([branch.ends, branch.velocity[0], branch.velocity[n - 1]], [['hopf', 'range'], hopf.velocity, 80]);
  assert.deepEqual([branch.amplitude[0], branch.stable[1], branch.symmetric[1]], [0, 1, 1]);
  assert.deepEqual(Object.keys(branch.amplitudes), STATES);
  assert.deepEqual(branch.amplitudes.torsionAngle, branch.amplitude);
  assert.equal(branch.multipliers.length, 2 * STATES.length * n);
  for (const name of STATES) assert.ok(branch.state[name] instanceof Float64Array && branch.state[name].length === n);
  for (let i = 0; i < n; i++) near(branch.multipliers[2 * STATES.length * i], 1, 1e-6);
});

test('any point of a branch is a guess for limitCycle', () => {
  const [branch] = shimmy.bifurcation(SPEC).cycles;
  for (const i of [3, 20, branch.velocity.length - 1]) {
    const state = Object.fromEntries(STATES.map((name) => [name, branch.state[name][i]]));
    near(branch.state.torsionAngle[i], 0, 1e-9);
    const run = { model: 'torsional', parameters: { dampingConstant: 20, velocity: branch.velocity[i] } };
    const cycle = shimmy.limitCycle(run, { period: branch.period[i], state });
    near(cycle.amplitude.torsionAngle / branch.amplitude[i], 1, 1e-7);
    near(Number(cycle.frequency) / branch.frequency[i], 1, 1e-7);
    assert.equal(cycle.stable, branch.stable[i] === 1);
    near(cycle.multipliers[1].re, branch.multipliers[2 * STATES.length * i + 2], 1e-6);
  }
});

test('a rattle without a Hopf point in the range is found without a guess, or from one', () => {
  const gap = { ...SPEC, parameters: { dampingConstant: 100, freeplayAngle: Math.PI / 180 }, from: 40, to: 60 };
  assert.deepEqual(shimmy.bifurcation(gap).cycles, []);
  const [found, ...others] = shimmy.bifurcation({ ...gap, probes: 4 }).cycles;
  assert.deepEqual([others, found.ends], [[], ['range', 'range']]);
  const at = found.velocity.findIndex((/** @type {number} */ v) => v > 45);
  const state = Object.fromEntries(STATES.map((name) => [name, found.state[name][at]]));
  const [again] = shimmy.bifurcation({ ...gap, cycle: { value: found.velocity[at], period: found.period[at], state } }).cycles;
  assert.deepEqual([again.velocity[0], again.velocity[again.velocity.length - 1]], [40, 60]);
  near(again.amplitude[0], found.amplitude[0], 1e-8);
});

test('a job makes the same diagram, and has what there is before it is done', () => {
  const job = new shimmy.Job('bifurcation', SPEC);
  const result = () => /** @type {import('../../www/pkg/shimmy.js').Bifurcation} */ (job.result());
  assert.deepEqual([result().cycles, result().points, result().equilibria.velocity.length], [[], [], 0]);
  let [fraction, most] = [0, 0];
  for (let steps = 0; ; steps++) {
    const progress = job.advance(0);
    assert.ok(progress.fraction >= fraction && progress.fraction <= 1, `${progress.fraction} after ${fraction}`);
    fraction = progress.fraction;
    if (progress.done) break;
    const part = result();
    most = Math.max(most, part.cycles[0]?.velocity.length ?? 0);
    assert.ok(fraction < 1 && steps < 1000);
  }
  assert.equal(fraction, 1);
  assert.deepEqual(result(), shimmy.bifurcation(SPEC));
  assert.ok(most > 10 && most < result().cycles[0].velocity.length, `${most}`);
  job.free();
});

test('a curve of folds: shimmy beside a gear that is stable at rest', () => {
  // A wheel that leads its axis, on a tire whose aligning moment goes on growing: see tests/bifurcation.rs.
  const parameters = { casterLength: -0.06, aligningMomentLimitAngle: (40 * Math.PI) / 180 };
  const [x, y] = [{ parameter: 'velocity', from: 10, to: 120 }, { parameter: 'dampingConstant', from: 0, to: 40 }];
  const curves = shimmy.foldCurve({ model: 'torsional', parameters, x, y, seeds: 2 });
  assert.equal(curves.length, 2);
  for (const { kind, closed, bounds, ...columns } of curves) {
    assert.deepEqual([kind, closed, bounds, Object.keys(columns)], ['fold', false, true, ['x', 'y', 'frequency', 'amplitude']]);
    for (const column of Object.values(columns)) assert.equal(column.length, columns.x.length);
    assert.ok(columns.y.includes(0) && columns.x.includes(120));
  }
  const job = new shimmy.Job('foldCurve', { model: 'torsional', parameters, x, y, seeds: 2 });
  assert.deepEqual(job.result(), []);
  while (!job.advance(1).done);
  assert.deepEqual(job.result(), curves);
  job.free();
  const refused = refusal(() => shimmy.foldCurve(/** @type {any} */ ({ model: 'torsional', x, y, seeds: 0 })));
  assert.deepEqual([refused.field, refused.code], ['seeds', 'out-of-range']);
});

test('what makes no sense is refused by name', () => {
  /** @param {object} change */
  const refused = (change) => refusal(() => shimmy.bifurcation(/** @type {any} */ ({ ...SPEC, ...change })));
  assert.equal(refused({ parameter: 'velocty' }).suggestion, 'velocity');
  assert.equal(refused({ parameter: null }).code, 'missing');
  assert.equal(refused({ from: -3 }).field, 'from');
  assert.deepEqual([refused({ to: 10 }).field, refused({ to: 10 }).allowed], ['to', 'another value than 10 (from)']);
  assert.equal(refused({ points: 1 }).field, 'points');
  assert.equal(refused({ points: 1e5 }).code, 'too-large');
  assert.equal(refused({ step: 1 }).field, 'step');
  assert.equal(refused({ probes: 2.5 }).field, 'probes');
  assert.equal(refused({ tolerance: '1' }).code, 'wrong-type');
  assert.equal(refused({ tolerence: 1 }).suggestion, 'tolerance');
  assert.equal(refused({ cycle: { period: 0, state: {} } }).field, 'cycle.period');
  assert.equal(refused({ cycle: { period: 0.02, state: {}, value: 5 } }).field, 'cycle.value');
  assert.equal(refused({ cycle: { period: 0.02, state: { torsionAngel: 1 } } }).suggestion, 'torsionAngle');
  assert.equal(refused({ cycle: [1] }).field, 'cycle');
});
