import assert from 'node:assert/strict';
import test from 'node:test';
import { refusal, shimmy } from './module.mjs';

const RUN = { model: 'torsional', parameters: { velocity: 80, dampingConstant: 30 }, initial: { torsionAngle: 0.05 }, duration: 3 };

test('a section has the passages of a motion and how far it goes between them', () => {
  const section = shimmy.poincare(RUN);
  assert.deepEqual(Object.keys(section), ['time', 'torsionAngle', 'torsionRate', 'lateralDeformation', 'amplitude']);
  assert.equal(section.amplitude.length, section.time.length - 1);
  // theory.md 3: 52.517 Hz and 0.20632 rad.
  assert.ok(Math.abs(section.time.length / 3 - 52.5) < 1);
  assert.ok(Math.abs(section.amplitude[section.amplitude.length - 1] - 0.20632) < 5e-6);
  assert.ok(section.torsionAngle.every((angle) => Math.abs(angle) < 1e-9) && section.torsionRate.every((rate) => rate > 0));
  const falling = shimmy.poincare(RUN, { state: 'torsionRate', level: 10, rising: false, after: 2 });
  assert.ok(falling.time[0] >= 2 && falling.torsionRate.every((rate) => Math.abs(rate - 10) < 1e-6));
  assert.deepEqual(shimmy.poincare(RUN, null), section);
  assert.equal(shimmy.poincare({ model: 'torsional' }).time.length, 0);
});

test('a section that makes no sense is refused in words', () => {
  const refused = (/** @type {any} */ section, /** @type {any} */ run = RUN) => refusal(() => shimmy.poincare(run, section));
  assert.equal(refused({ state: 'torsionAngel' }).suggestion, 'torsionAngle');
  assert.equal(refused({ levl: 1 }).suggestion, 'level');
  assert.equal(refused({ level: NaN }).code, 'not-finite');
  assert.equal(refused({ rising: 1 }).field, 'rising');
  assert.equal(refused({ after: -1 }).message, 'after must be ≥ 0 s, got -1');
  assert.equal(refused([]).field, 'section');
  assert.equal(refused(null, { ...RUN, maxSteps: 10 }).code, 'step-limit');
});
