import assert from 'node:assert/strict';
import test from 'node:test';
import { refusal, shimmy } from './module.mjs';

const GEAR = { model: 'torsional', parameters: { velocity: 80, dampingConstant: 0 }, initial: { torsionAngle: 0.01 } };
const DAMPER = { model: 'modified-bouc-wen', command: 1.2 };
const DAMPED = { ...GEAR, damper: DAMPER };
const ROLL = { model: 'torsional', parameters: { dampingConstant: 20 }, initial: { torsionAngle: 0.01 }, touchdownVelocity: 80 };

test('a damper on the gear adds its states, and the known current leaves the known swing', () => {
  const outlook = shimmy.outlook(DAMPED);
  assert.equal(outlook.verdict, 'shimmies');
  // Computed independently: 0.23971 rad at 1.2 A.
  assert.ok(Math.abs(outlook.amplitude.torsionAngle - 0.23971) < 2e-5, String(outlook.amplitude.torsionAngle));
  const motion = shimmy.simulate({ ...DAMPED, duration: 0.1, samples: 50 });
  for (const state of /** @type {const} */ (['hysteresis', 'internalDisplacement', 'effectiveCommand'])) {
    assert.equal(motion[state]?.length, 50, state);
  }
  assert.ok(motion.effectiveCommand?.every((command) => command === 1.2));
  const along = shimmy.forcesAlong(DAMPED, motion);
  assert.ok(along.damperForce.every((force, row) => Math.abs(along.damperTorque[row] + 0.1 * force) < 1e-9 * Math.abs(force) + 1e-12));
  assert.ok(Number(shimmy.energy({ ...DAMPED, duration: 0.5 })?.mrDamper) > 0);
  assert.equal(shimmy.eigenvalues(DAMPED).filter(({ re, im }) => re === 0 && im === 0).length, 1);
});

test('dotted names reach a damper wherever a parameter is named', () => {
  const live = new shimmy.Simulator(DAMPED);
  live.advance(0.2);
  live.set('damper.command', 1.5);
  live.advance(0.2);
  assert.equal(live.parameters()['damper.command'], 1.5);
  assert.ok(Math.abs(live.state()[5] - 1.5) < 1e-9);
  assert.equal(refusal(() => live.set('damper.parameters.gamma', -4e6)).field, 'damper.parameters.gamma');
  live.free();
  const { initial, ...spec } = DAMPED;
  const map = shimmy.stabilityMap({ ...spec, x: { parameter: 'velocity', from: 20, to: 120, count: 6 }, y: { parameter: 'damper.leverArm', from: 0.01, to: 0.1, count: 5 } });
  assert.equal(map.stable.length, 30);
  assert.ok(initial && map.stable.some((stable) => stable === 1) && map.stable.some((stable) => stable === 0));
  const sweep = shimmy.sweep({ ...spec, over: { parameter: 'damper.command', from: 0.5, to: 2, count: 4 } });
  assert.ok(sweep.down.amplitude.every((amplitude) => amplitude >= 0));
});

test('control laws have their tables, and command a damper', () => {
  const laws = shimmy.controls();
  assert.deepEqual(laws.map(({ name, semiActive }) => [name, semiActive]), [['passive', true], ['on-off', true], ['proportional', true], ['clipped', true], ['active', false]]);
  for (const { name, common, parameters } of laws) {
    assert.deepEqual(common.map((parameter) => parameter.name), ['lag', 'failureTime']);
    const values = Object.fromEntries(parameters.map((parameter) => [parameter.name, parameter.default]));
    const run = { ...GEAR, damper: name === 'active' ? null : DAMPER, control: { law: name, lag: 0.004, failureTime: 0.3, parameters: values }, duration: 0.5, samples: 100 };
    const { effectiveCommand } = shimmy.simulate(run);
    assert.ok(effectiveCommand && Math.abs(effectiveCommand[99]) < 1e-3 && effectiveCommand.some((command) => command !== 0), name);
  }
  assert.equal(refusal(() => shimmy.simulate({ ...GEAR, control: { law: 'on-off' } })).field, 'control.law');
  assert.equal(refusal(() => shimmy.simulate({ ...DAMPED, control: { law: 'on-of' } })).suggestion, 'on-off');
  assert.equal(refusal(() => shimmy.simulate({ ...DAMPED, control: /** @type {any} */ ({ law: 'passive', lagg: 1 }) })).suggestion, 'lag');
});

test('a landing roll slows down, and is the same in slices', () => {
  const spec = { ...ROLL, rows: 2000 };
  const landing = shimmy.landingRoll(spec);
  assert.ok(landing.time.length <= 2010 && landing.velocity.length === landing.time.length);
  assert.deepEqual([landing.velocity[0], landing.velocity.at(-1), landing.time.at(-1)], [80, 5, 25]);
  const peak = landing.torsionAngle.reduce((most, psi) => Math.max(most, Math.abs(psi)), 0);
  // SciPy's: tests/landing-reference.json.
  assert.ok(Math.abs(peak / 0.31558797 - 1) < 1e-3, String(peak));
  const job = new shimmy.Job('landingRoll', spec);
  let slices = 0;
  while (!job.advance(0).done) {
    slices += 1;
    assert.ok(/** @type {import('../../www/pkg/shimmy.js').Landing} */ (job.result()).time.length <= 2010);
  }
  assert.ok(slices > 5);
  assert.deepEqual(/** @type {import('../../www/pkg/shimmy.js').Landing} */ (job.result()).torsionAngle, landing.torsionAngle);
  job.free();
});

test('a live landing tells of its speed by the time, and what needs a constant one refuses it', () => {
  const live = new shimmy.Simulator({ ...ROLL, damper: DAMPER });
  live.advance(2);
  assert.equal(live.parameters().touchdownVelocity, 80);
  live.seek(1);
  live.free();
  for (const call of [() => shimmy.outlook(ROLL), () => shimmy.eigenvalues(ROLL), () => shimmy.limitCycle(ROLL), () => shimmy.energy(ROLL)]) {
    assert.deepEqual([refusal(call).code, refusal(call).field], ['unsuited', 'deceleration']);
  }
  assert.equal(refusal(() => shimmy.landingRoll({ ...ROLL, finalVelocity: 90 })).field, 'finalVelocity');
  assert.equal(refusal(() => shimmy.simulate({ ...GEAR, linked: { treadWidthMomentConstant: true } })).field, 'linked');
});
