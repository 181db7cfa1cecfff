// A gear that lands on the stage: its speed falls as it rolls, and what is known of a constant speed is asked of it as it is now.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { plain } from '../../www/engine/fitted.js';
import { modelsOf } from '../../www/engine/models.js';
import { gearAt, landingFrom, lands, slowingTime } from '../../www/run/landing.js';
import { wanted } from './opened-session.mjs';
import { engine, openedApp, sessionOf } from './stories.mjs';

/** @param {number} got @param {number} expected @param {number} error */
const near = (got, expected, error) => assert.ok(Math.abs(got - expected) <= error, `${got} for ${expected}`);

const landing = '#shimmy=2&model=torsional.none.none.landing&dampingConstant=20&initial.torsionAngle=0.01&lens=landing&clock=strobe';

test('every gear with a torsion angle can land, with any damper on it', () => {
  const landings = modelsOf(engine).filter(({ name }) => lands(name));
  assert.ok(landings.some(({ name }) => name === 'torsional.none.none.landing') && landings.some(({ name }) => name === 'torsional.current-dependent-bouc-wen.none.landing'));
  for (const { name, parameters } of landings) assert.ok(parameters.some((one) => one.name === 'touchdownVelocity' && one.default === 80), name);
  assert.ok(!lands('torsional.bouc-wen'));
});

test('the gear is asked at the speed and under the weight that it has: v₀ − bt down to its end, F_z[1 − λ(v/v₀)²]', () => {
  const values = { velocity: 33, verticalForce: 9000, touchdownVelocity: 80, deceleration: 3, finalVelocity: 5, liftFraction: 0.5 };
  assert.equal(slowingTime(values), 25);
  const { object, parameters } = gearAt('torsional.none.none.landing', values, 10);
  assert.deepEqual([object, parameters.velocity], ['torsional', 50]);
  near(parameters.verticalForce, 9000 * (1 - 0.5 * (50 / 80) ** 2), 1e-9);
  assert.equal(gearAt('torsional.none.none.landing', values, 99).parameters.velocity, 5);
  assert.deepEqual(gearAt('torsional', values, 10), { object: 'torsional', parameters: values });
  // From then on it is a landing of its own, under the same weight.
  const later = landingFrom(values, 10);
  near(gearAt('torsional.none.none.landing', later, 4).parameters.verticalForce, gearAt('torsional.none.none.landing', values, 14).parameters.verticalForce, 1e-9);
});

test('a run takes the landing, what takes a constant speed the gear alone', () => {
  const asked = { model: 'torsional.bouc-wen.none.landing', parameters: { velocity: 50, 'damper.command': 1, touchdownVelocity: 70, liftFraction: 0.2 } };
  assert.deepEqual(plain(asked), { model: 'torsional', parameters: { velocity: 50 }, damper: { command: 1, model: 'bouc-wen' }, touchdownVelocity: 70, liftFraction: 0.2 });
  assert.deepEqual(plain(asked, false), { model: 'torsional', parameters: { velocity: 50 }, damper: { command: 1, model: 'bouc-wen' } });
  assert.equal(engine.outlook({ ...asked, initial: { torsionAngle: 0.01 } }).verdict, engine.outlook({ model: 'torsional.bouc-wen', parameters: { velocity: 50, 'damper.command': 1 }, initial: { torsionAngle: 0.01 } }).verdict);
});

test('on the stage it slows down: the scene has the speed of now, the state what was set, and the motion is the engine’s landing', () => {
  const app = openedApp(landing);
  const session = sessionOf(app);
  assert.ok(session.isLanding);
  session.seek(12);
  const scene = session.scene(wanted);
  assert.deepEqual([scene.object, scene.parameters.velocity, scene.landing?.touchdownVelocity], ['torsional', 44, 80]);
  const whole = engine.landingRoll({ model: 'torsional', parameters: { dampingConstant: 20 }, initial: { torsionAngle: 0.01 }, touchdownVelocity: 80, times: [12] });
  near(scene.state[0], whole.torsionAngle[0], 2e-3);
  near(scene.parameters.velocity, whole.velocity[0], 1e-9);
  assert.equal(session.outlook.verdict, 'shimmies');
  // theory.md 2: with c = 20 it is calm below 27.6 m/s.
  session.seek(24);
  session.refresh();
  assert.equal(session.outlook.verdict, 'dies-out');
  assert.ok(!app.settable.some(({ name }) => name === 'velocity') && app.knobs.includes('touchdownVelocity'));
  assert.equal(app.duration, 25);
  // theory.md 2: as it touches down at 80 m/s the critical damping is 48.530.
  near(app.unstable('dampingConstant')?.intervals[0].to ?? NaN, 48.53, 1e-3);
});

test('what is taken along goes on from its last change as the landing that it is', () => {
  const session = sessionOf(openedApp(landing));
  session.seek(5);
  session.set('dampingConstant', 30, null);
  session.seek(6);
  const { model, parameters, initial, duration } = session.sinceChange(25);
  assert.deepEqual([model, parameters.touchdownVelocity, parameters.dampingConstant], ['torsional.none.none.landing', 65, 30]);
  const taken = engine.simulate({ model, parameters, initial, duration: Math.min(duration, 1), samples: 2 });
  near(taken.torsionAngle[1], session.scene(wanted).state[0], 1e-3);
});

test('undo, a link and the command bring a landing back as it was', () => {
  const app = openedApp('#shimmy=2&velocity=60&dampingConstant=40&initial.torsionAngle=0.05');
  app.run('land', undefined);
  assert.equal(app.state.object, 'torsional.none.none.landing');
  assert.deepEqual([app.state.lens, app.state.clock.mode, app.state.parameters.dampingConstant, app.state.run.initial], ['landing', 'strobe', 40, { torsionAngle: 0.01 }]);
  app.run('landing', { touchdownVelocity: 70, deceleration: 2, finalVelocity: 10, liftFraction: 0.1, torsionAngle: 0.02 });
  assert.deepEqual([app.state.parameters.touchdownVelocity, app.state.parameters.deceleration, app.state.views.landingRoll], [70, 2, '70,2,10,0.1,0.02']);
  const again = openedApp(app.link);
  assert.deepEqual([again.state.object, again.state.parameters], [app.state.object, app.state.parameters]);
  app.run('land', { dampingConstant: 20, current: 0.5 });
  assert.deepEqual([app.state.object, app.state.parameters['damper.command'], app.state.parameters.touchdownVelocity], ['torsional.current-dependent-bouc-wen.none.landing', 0.5, 70]);
  for (let i = 0; i < 3; i++) app.run('undo');
  assert.deepEqual([app.state.object, app.state.parameters.velocity, app.state.lens], ['torsional', 60, 'phase']);
});
