import assert from 'node:assert/strict';
import test from 'node:test';
import { refusal, shimmy, SHIMMY, STATES } from './module.mjs';

/** @param {Record<string, number>} parameters */
const gear = (parameters = {}) => ({ model: 'torsional', parameters });

test('the gear rests at zero, and its Jacobian is the one of the equations', () => {
  assert.deepEqual(shimmy.equilibrium(SHIMMY), { torsionAngle: 0, torsionRate: 0, lateralDeformation: 0 });
  const jacobian = shimmy.jacobian(gear());
  assert.ok(jacobian instanceof Float64Array);
  // Defaults: k/I_z, (c + κ/v)/I_z and B = (c_Mα + e c_Fα) F_z/(σ I_z); v, e − a, v/σ. Rounding of a product or two.
  const expected = [0, 1, 0, -1e5, -(10 + 270 / 50), -(2 + 0.1 * 20) * 9000 / 0.3, 50, 0, -50 / 0.3];
  jacobian.forEach((entry, i) => assert.ok(Math.abs(entry - expected[i]) <= 1e-15 * Math.abs(expected[i]) + 1e-15, `${i}: ${entry}`));
  assert.equal(shimmy.jacobian(gear({ freeplayAngle: 0.01 }))[3], 0, 'in the gap no spring acts');
});

test('eigenvalues by falling real part, of a pair the positive one first', () => {
  const values = shimmy.eigenvalues(gear({ velocity: 80, dampingConstant: 20 }));
  // NumPy 2.4.6
  assert.ok(Math.abs(values[0].re - 13.214435369916128) < 1e-9 && Math.abs(values[0].im - 338.26420289068307) < 1e-9);
  assert.deepEqual(values[1], { re: values[0].re, im: -values[0].im });
  assert.ok(Math.abs(values[2].re + 316.4705374064989) < 1e-9);
  assert.equal(values[2].im, 0);
});

test('the polynomial, its array and its roots tell the same', () => {
  for (const dampingConstant of [20, 60]) {
    const run = gear({ velocity: 80, dampingConstant });
    const polynomial = shimmy.characteristicPolynomial(run);
    assert.ok(polynomial instanceof Float64Array && polynomial[0] === 1 && polynomial.length === 4);
    const [{ re, im }, , real] = shimmy.eigenvalues(run);
    const product = [1, -2 * re - real.re, re * re + im * im + 2 * re * real.re, -(re * re + im * im) * real.re];
    polynomial.forEach((coefficient, i) => assert.ok(Math.abs(coefficient / product[i] - 1) < 1e-12));
    const array = shimmy.routhArray(run);
    array.coefficients.forEach((coefficient, i) => assert.ok(Math.abs(coefficient / polynomial[i] - 1) < 1e-14, 'but for the last digit'));
    assert.deepEqual(array.rows.map((row) => row.length), [2, 2, 1, 1]);
    assert.deepEqual(array.special, [null, null, null, null]);
    assert.deepEqual(array.replaced, [null, null, null, null]);
    assert.equal(array.unstableRoots, dampingConstant === 20 ? 2 : 0);
    assert.equal(array.neutralRoots, 0);
    const { column, stable } = shimmy.routhHurwitz(run);
    assert.equal(array.stable, stable);
    array.rows.forEach(([first], i) => assert.ok(Math.abs(first / column[i] - 1) < 1e-12));
  }
  const swinging = gear({ verticalForce: 0, dampingConstant: 0, treadWidthMomentConstant: 0 });
  const { special, replaced, neutralRoots } = shimmy.routhArray(swinging);
  assert.deepEqual([special[2], replaced[2], neutralRoots], ['zero-row', [0], 2]);
});

test('crossings along any parameter, with their frequency', () => {
  const [hopf, ...none] = shimmy.crossings(SHIMMY, { parameter: 'dampingConstant', from: 0, to: 200 });
  assert.deepEqual(none, []);
  assert.equal(hopf.kind, 'hopf');
  const { criticalDamping } = shimmy.routhHurwitz(SHIMMY);
  assert.ok(Math.abs(hopf.value / Number(criticalDamping) - 1) < 1e-9);
  const [pair] = shimmy.eigenvalues(gear({ velocity: 80, dampingConstant: hopf.value }));
  assert.ok(Math.abs(pair.re) < 1e-9 && Math.abs(pair.im / (2 * Math.PI) - hopf.frequency) < 1e-9);
  const kinds = shimmy.crossings(gear(), { parameter: 'casterLength', from: -0.9, to: 0.5 }).map(({ kind }) => kind);
  assert.ok(kinds.includes('divergence') && kinds.includes('hopf'), `${kinds}`);
  assert.equal(refusal(() => shimmy.crossings(SHIMMY, { parameter: 'velocty', from: 1, to: 2 })).suggestion, 'velocity');
});

test('modes: shapes beside the torsion angle, and energy that adds up to the growth rate', () => {
  const modes = shimmy.eigenmodes(SHIMMY);
  assert.deepEqual(modes.map(({ eigenvalue }) => eigenvalue), shimmy.eigenvalues(SHIMMY));
  const [growing, , fading] = modes;
  assert.deepEqual(Object.keys(growing.shape), STATES);
  assert.deepEqual(growing.shape.torsionAngle, { re: 1, im: 0, amplitude: 1, lag: -0 });
  // ψ̇ = λψ: it leads by nearly a quarter of a cycle.
  const { re, im } = growing.eigenvalue;
  const { amplitude, lag } = growing.shape.torsionRate;
  assert.ok(Math.abs(amplitude - Math.hypot(re, im)) < 1e-9 && Math.abs(lag + Math.atan2(im, re)) < 1e-12);
  assert.ok(Math.abs(Number(growing.timeToDouble) - Math.LN2 / re) < 1e-12 && growing.timeToHalf === null);
  assert.ok(growing.dampingRatio !== null && Math.abs(growing.dampingRatio + re / Math.hypot(re, im)) < 1e-12);
  assert.ok(fading.timeToDouble === null && fading.dampingRatio === 1 && growing.reference === 'torsionAngle');
  for (const { energyFlow, eigenvalue } of modes) {
    assert.ok(energyFlow);
    const { tire, damper, treadWidth, stored } = energyFlow;
    assert.ok(Math.abs(tire - damper - treadWidth - eigenvalue.re) < 1e-9 && Math.abs(stored - eigenvalue.re) < 1e-12);
    assert.ok(damper > 0 && treadWidth > 0);
  }
});

test('what leaves the numbers is refused in words', () => {
  const extreme = gear({ momentOfInertia: 1e-310 });
  for (const ask of [shimmy.equilibrium, shimmy.jacobian, shimmy.eigenvalues, shimmy.characteristicPolynomial, shimmy.routhArray, shimmy.eigenmodes]) {
    assert.match(refusal(() => ask(extreme)).message, /less extreme/);
    assert.equal(refusal(() => ask(/** @type {any} */ ({ model: 'torsionl' }))).suggestion, 'torsional');
  }
});
