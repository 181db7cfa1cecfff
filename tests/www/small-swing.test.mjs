// The linear history: a swing too small to be limited, and its envelope.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { doubling, becomes, pairInNumbers, pairReadings } from '../../www/lens/stability/say.js';
import { amplitudeOf, smallSwing } from '../../www/lens/stability/small-swing.js';
import init, * as engine from '../../www/pkg/shimmy.js';
import { linearLooks } from '../../www/run/linear-looks.js';
import { drawLinearHistory } from '../../www/view/linear-history.js';
import { voiceOf } from '../../www/words/voice.js';
import { rootsOf } from './linear-gear.mjs';
import { recordingContext, written } from './plot-recorder.mjs';
import { theme } from './theme.mjs';

await init({ module_or_path: await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)) });
const voice = voiceOf('en');
const size = { width: 300, height: 200 };

test('the swing is that of the linear gear, and lies in its envelope and touches it', () => {
  for (const values of [{ velocity: 80, dampingConstant: 20 }, { velocity: 20, dampingConstant: 20 }, { velocity: 30, dampingConstant: 40 }]) {
    const roots = rootsOf(values);
    const swing = smallSwing(linearLooks(engine, { model: 'torsional', parameters: values }), roots);
    const linear = engine.simulate({ model: 'torsional-linear', parameters: values, initial: { torsionAngle: 1 }, times: swing.time, rtol: 1e-10 });
    const most = linear.torsionAngle.reduce((sum, angle) => Math.max(sum, Math.abs(angle)), 0);
    // Its own tolerance is 1e-6 a step.
    swing.angle.forEach((angle, i) => assert.ok(Math.abs(angle - linear.torsionAngle[i]) < 1e-4 * most));
    assert.equal(swing.growthRate, roots[0].re);
    const [late] = [swing.time.findIndex((time) => time > 0.04)];
    const shares = Array.from(swing.angle).map((angle, i) => Math.abs(angle) / (swing.amplitude * Math.exp(swing.growthRate * swing.time[i]))).slice(late);
    assert.ok(Math.max(...shares) < 1.02 && Math.max(...shares) > 0.98, `${Math.max(...shares)}`);
  }
});

test('with friction it is the gear without it, which would hold it', () => {
  const values = { velocity: 80, dampingConstant: 20 };
  const of = (/** @type {Record<string, number>} */ parameters) => {
    const looks = linearLooks(engine, { model: 'torsional', parameters });
    return { isRubbed: looks.isRubbed, swing: smallSwing(looks, rootsOf(values)) };
  };
  const [without, rubbed] = [of(values), of({ ...values, 'friction.moment': 100 })];
  assert.deepEqual([without.isRubbed, rubbed.isRubbed], [false, true]);
  assert.deepEqual(rubbed.swing.angle, without.swing.angle);
});

test('with a gap it is the gear without a spring, and stays within the gap', () => {
  // Published: c = 100 inside the gap grows by 6.20 s⁻¹ at 50 m/s, and falls by 1.86 at 80.
  for (const [velocity, rate] of [[50, 6.2], [80, -1.86]]) {
    const looks = linearLooks(engine, { model: 'torsional', parameters: { velocity, dampingConstant: 100, freeplayAngle: 0.0087 } });
    assert.equal(looks.isGapped, true);
    const roots = rootsOf({ velocity, dampingConstant: 100, torsionalStiffness: 0 });
    assert.ok(Math.abs(roots[0].re - rate) < 0.005);
    const swing = smallSwing(looks, roots);
    const half = Math.floor(swing.time.length / 3);
    const peak = (/** @type {number} */ from, /** @type {number} */ to) => swing.angle.slice(from, to).reduce((most, angle) => Math.max(most, Math.abs(angle)), 0);
    assert.ok(peak(2 * half, 3 * half) > peak(half, 2 * half) === rate > 0);
  }
});

test('window and scale hold the whole swing', () => {
  /** @type {Record<string, number>[]} */
  const gears = [{ velocity: 80, dampingConstant: 20 }, { velocity: 80, dampingConstant: 0 }, { velocity: 20, dampingConstant: 20 }, { velocity: 80, dampingConstant: 47 }, { velocity: 10, dampingConstant: 0, casterLength: -0.3 }];
  for (const values of gears) {
    const { angle, limit, duration } = smallSwing(linearLooks(engine, { model: 'torsional', parameters: values }), rootsOf(values));
    const peak = angle.reduce((most, one) => Math.max(most, Math.abs(one)), 0);
    assert.ok(peak <= limit && limit < 12, `${JSON.stringify(values)}: ${peak} of ±${limit} in ${duration} s`);
  }
});

test('a swing that changes slowly is watched for some eight cycles, one that grows fast until it is three times its start', () => {
  const watched = (/** @type {Record<string, number>} */ values) => {
    const roots = rootsOf(values);
    const { duration } = smallSwing(linearLooks(engine, { model: 'torsional', parameters: values }), roots);
    return { cycles: (duration * roots[0].im) / (2 * Math.PI), growth: Math.exp(duration * roots[0].re) };
  };
  // The window is a round one: the next above what is wanted is up to a half longer.
  for (const values of [{ velocity: 80, dampingConstant: 47 }, { velocity: 20, dampingConstant: 20 }]) {
    const { cycles } = watched(values);
    assert.ok(cycles >= 8 && cycles <= 12, `${cycles}`);
  }
  const { cycles, growth } = watched({ velocity: 80, dampingConstant: 0 });
  assert.ok(cycles < 8 && growth >= 3 && growth < 6, `${cycles} ${growth}`);
  // One that turns aside is not watched for the cycles of a pair that has died out by then.
  const aside = watched({ velocity: 50, casterLength: -0.2, torsionalStiffness: 0, dampingConstant: 10 });
  assert.ok(aside.cycles === 0 && aside.growth >= 3 && aside.growth < 6, `${aside.growth}`);
});

test('the numbers of its axis are whole, however long', () => {
  for (const limit of [3, 50, 50_000, 2_000_000]) {
    const { context, named } = recordingContext();
    drawLinearHistory(context, size, { time: [0, 0.1], angle: [1, limit], growthRate: 20, amplitude: 1, duration: 0.1, limit, readings: [''] }, theme, voice);
    const numbers = named('fillText').filter(({ style }) => style.textAlign === 'right');
    assert.ok(numbers.length > 0);
    for (const { args } of numbers) assert.ok(args[1] - context.measureText(args[0]).width >= 0, `${args[0]} ends at ${args[1]}`);
  }
});

test('the amplitude of a sinusoid in an envelope is found', () => {
  const time = Float64Array.from({ length: 400 }, (_, i) => i / 2000);
  const angle = time.map((t) => 0.7 * Math.exp(9 * t) * Math.cos(320 * t + 1));
  assert.ok(Math.abs(amplitudeOf(time, angle, 9) - 0.7) < 0.01);
});

test('doubling and halving take ln 2 over the rate, and words tell growth from decay', () => {
  assert.equal(doubling(Math.LN2 / 0.081, voice), 'doubles in 81 ms');
  assert.equal(doubling(-Math.LN2 / 0.081, voice), 'halves in 81 ms');
  assert.equal(doubling(0, voice), 'neither grows nor falls');
  assert.equal(becomes([{ re: 12.34, im: 327.35 }], voice), 'grows 12.3 s⁻¹, 52.1 Hz');
  assert.equal(becomes([{ re: -0.05, im: 314.159 }], voice), 'falls 0.050 s⁻¹, 50.0 Hz');
  assert.equal(becomes([{ re: 3, im: 0 }], voice), 'turns aside, 3.00 s⁻¹');
  assert.equal(pairInNumbers([{ re: -3, im: 0 }, { re: -6, im: 8 }], voice), '1.3 Hz · −6.00 s⁻¹ · ζ 0.600');
  // A wheel that turns aside is headed by what it does so by, not by a pair that dies out beside it.
  assert.equal(pairInNumbers([{ re: 75.2, im: 0 }, { re: -129, im: 152.7 }], voice), '+75.2 s⁻¹, no swing');
  assert.deepEqual(pairReadings([{ re: 75.2, im: 0 }, { re: -129, im: 152.7 }], voice), ['+75.2 s⁻¹, no swing', '+75.2 s⁻¹']);
  assert.equal(voiceOf('tr').say('stability.share', { share: '37,2', x: 'v', y: 'c' }), 'Düzlemin %37,2 kadarı kararlı: v, c');
});

test('the envelope is dotted, above and below, and the swing ends where it has left the picture', () => {
  const time = Float64Array.from({ length: 400 }, (_, i) => i / 2000);
  const angle = time.map((t) => Math.exp(20 * t) * Math.cos(320 * t));
  const { context, named } = recordingContext();
  drawLinearHistory(context, size, { time, angle, growthRate: 20, amplitude: 1, duration: 0.2, limit: 3, readings: ['doubles in 35 ms'] }, theme, voice);
  const dotted = named('lineTo').filter(({ style }) => style.dash.length > 0 && style.strokeStyle === theme.unstable);
  assert.ok(dotted.length > 100);
  const curve = named('lineTo').filter(({ style }) => style.strokeStyle === theme.psi);
  const zero = named('moveTo').find(({ style }) => style.strokeStyle === theme.ghost);
  assert.ok(zero && curve.length > 100 && curve.length < 0.5 * time.length, `${curve.length}`);
  assert.ok(written(named('fillText')).includes('doubles in 35 ms'));
  const hidden = recordingContext();
  drawLinearHistory(hidden.context, size, { time, angle, growthRate: 20, amplitude: 1, duration: 0.2, limit: 3, readings: ['doubles in 35 ms'], veiled: true }, theme, voice);
  assert.ok(hidden.named('stroke').every(({ style }) => ![theme.psi, theme.unstable].includes(style.strokeStyle)));
  assert.ok(!written(hidden.named('fillText')).includes('doubles in 35 ms'));
});
