// Predict and reveal, over the real engine: nothing tells what comes before it is guessed, and the truth is the engine's.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import init, * as engine from '../../www/pkg/shimmy.js';
import { App } from '../../www/app.js';
import { shortcutOf } from '../../www/keys.js';
import { outcomeOf } from '../../www/present/outcome.js';
import { said } from '../../www/present/said.js';
import { voiceOf } from '../../www/words/voice.js';

await init({ module_or_path: await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)) });
const wanted = { moment: /** @type {[number, number]} */ ([-0.08, 0.02]), trackLength: 1.2, stretches: 200, exposure: 0 };

/** A page some seconds after it opened. @param {number} [seconds] of the run */
function opened(seconds = 0.12, address = '') {
  const app = new App();
  app.open(engine, [address], { isStill: false });
  const session = /** @type {import('../../www/run/session.js').Session} */ (app.session);
  session.advance(seconds);
  session.refresh();
  return { app, session };
}

/** @param {string} verdict @param {number} goal */
const outlook = (verdict, goal) => /** @type {import('../../www/engine/engine.js').Outlook} */ (/** @type {unknown} */ ({ verdict, amplitude: { torsionAngle: goal } }));

test('a swing dies out, holds or grows, by a rule', () => {
  for (const [verdict, goal, now, truth, becomes] of /** @type {const} */ ([
    ['dies-out', 0, 0.1, 'dies-out', 'dies-out'],
    ['rests', 0, 0, 'dies-out', 'rests'],
    ['rests', 0.01, 0.2, 'dies-out', 'rests'],
    ['shimmies', 0.2, 0.2, 'holds', 'holds'],
    ['shimmies', 0.2, 0.182, 'holds', 'holds'],
    ['shimmies', 0.2, 0.22, 'holds', 'holds'],
    ['shimmies', 0.2, 0.1818, 'grows', 'grows'],
    ['shimmies', 0.2, 0.2223, 'holds', 'falls'],
    ['rattles', 0.02, 0.2, 'holds', 'falls'],
    ['rattles', 0.02, 0.01, 'grows', 'grows'],
    ['grows', 0.6, 0.1, 'grows', 'beyond'],
  ])) {
    const outcome = outcomeOf(outlook(verdict, goal), now);
    assert.deepEqual([outcome.truth, outcome.becomes], [truth, becomes], `${verdict} ${now} → ${goal}`);
  }
});

test('what was said is held against what came', () => {
  const en = voiceOf('en');
  const tr = voiceOf('tr');
  const grown = outcomeOf(outlook('shimmies', 0.684), 0.2);
  const fallen = outcomeOf(outlook('shimmies', 0.1), 0.2);
  assert.equal(said({ guess: 'grows', outcome: grown }, en), 'You said 3, it grows. Right.');
  assert.equal(said({ guess: 'dies-out', outcome: grown }, en), 'You said 1, it dies out. No. It grows to ±39.2°.');
  assert.equal(said({ guess: 'holds', outcome: fallen }, en), 'You said 2, it holds. Right.');
  // A swing that still creeps up by less than a tenth: the rule is said again, for the verdict beside says that it grows.
  const nearly = outcomeOf(outlook('shimmies', 0.265), 0.255);
  assert.equal(said({ guess: 'grows', outcome: nearly }, en), 'You said 3, it grows. No. It holds at ±15.2°, at most 10 % wider than it was.');
  assert.equal(said({ guess: 'dies-out', outcome: fallen }, en), 'You said 1, it dies out. No. It falls to ±5.7° and holds there.');
  assert.equal(said({ guess: null, outcome: grown }, en), 'It grows to ±39.2°.');
  assert.equal(said({ guess: 'dies-out', outcome: grown }, tr), '1 dedin: söner. Hayır. ±39,2° genliğe büyüyor.');
  assert.equal(said({ guess: 'grows', outcome: null }, en), '');
});

for (const [damping, guess, truth] of /** @type {const} */ ([[60, 'grows', 'dies-out'], [20, 'grows', 'grows'], [47, 'holds', 'holds']]))
  test(`c = ${damping}: asked, guessed, revealed`, () => {
    const { app, session } = opened();
    app.run('predict');
    assert.ok(app.isVeiled && !app.clock.isPlaying);
    assert.equal(session.set('dampingConstant', damping, null), null);
    app.run('settle');
    app.run('guess', guess);
    app.run('reveal');
    assert.ok(!app.isVeiled && app.clock.isPlaying);
    const { predict } = app.state;
    assert.equal(predict?.guess, guess);
    assert.equal(predict?.outcome?.truth, truth);
    assert.equal(predict?.outcome?.amplitude, truth === 'dies-out' ? 0 : session.outlook.amplitude.torsionAngle);
    app.run('predict');
    assert.equal(app.state.predict, null);
  });

test('while it is asked no look ahead is taken, no scale changes, and time stands still', () => {
  const { app, session } = opened();
  const { outlook: known, scales, time } = session;
  const before = session.scene(wanted);
  app.run('predict');
  assert.equal(session.set('dampingConstant', 2, null), null);
  app.run('settle');
  app.run('kick');
  for (const command of ['on', 'back', 'freeze']) app.run(command);
  app.run('seek', 3);
  session.advance(app.clock.elapse(1) + app.clock.elapse(2));
  session.refresh();
  assert.equal(session.outlook, known);
  assert.equal(session.energy, before.energy);
  assert.deepEqual(session.scales, scales);
  assert.equal(session.time, time);
  const { run, magnification } = { ...session.scene(wanted), ...session.scales };
  assert.deepEqual([run.from, run.to, magnification], [before.run.from, before.run.to, scales.magnification], 'the length of the lane tells how long it takes');
  app.run('toggle');
  assert.ok(app.clock.isPlaying && !app.isVeiled, 'to play is to reveal');
  assert.notEqual(session.outlook, known);
  assert.equal(app.state.predict?.outcome?.becomes, 'beyond');
});

test('who leaves without revealing finds the run as it was, and knows what comes', () => {
  const { app, session } = opened();
  app.run('predict');
  session.set('dampingConstant', 60, null);
  app.run('close');
  assert.equal(app.state.predict, null);
  assert.ok(app.clock.isPlaying);
  assert.equal(session.outlook.verdict, 'dies-out');
  app.run('freeze');
  app.run('predict');
  app.run('predict');
  assert.ok(!app.clock.isPlaying, 'it stood still before');
});

test('a guess is made only while it is asked, and may be changed', () => {
  const { app } = opened();
  const made = () => app.state.predict?.guess;
  app.run('guess', 'holds');
  assert.equal(made(), undefined);
  app.run('predict');
  app.run('guess', 'holds');
  app.run('guess', 'grows');
  assert.equal(made(), 'grows');
  app.run('reveal');
  app.run('guess', 'holds');
  assert.equal(made(), 'grows');
  app.run('predictAgain');
  assert.deepEqual(app.state.predict, { guess: null, outcome: null });
});

test('a link that asks opens veiled, standing still, with scales that know no more than the start', () => {
  const link = '#shimmy=2&velocity=80&dampingConstant=2&initial.torsionAngle=0.05&predict=1';
  const { app, session } = opened(0, link);
  assert.ok(app.isVeiled && !app.clock.isPlaying);
  assert.equal(app.link, link);
  assert.equal(session.outlook.verdict, 'rests', 'nothing was looked at');
  assert.ok(session.scales.limits.angle < 0.1);
  app.run('reveal');
  assert.equal(app.state.predict?.outcome?.becomes, 'beyond');
  assert.ok(session.scales.limits.angle > 0.5);
  assert.equal(app.link.includes('predict'), false, 'what was revealed is no riddle any more');

  const running = opened().app;
  running.openLink(link);
  assert.ok(running.isVeiled && !running.clock.isPlaying);
});

test('what the keys mean while it is asked', () => {
  // Where there is no document no element has the focus.
  Object.assign(globalThis, { HTMLElement: class {} });
  const pressed = (/** @type {string} */ key, /** @type {boolean} */ isVeiled) =>
    shortcutOf(/** @type {KeyboardEvent} */ (/** @type {unknown} */ ({ key, target: null })), isVeiled);
  for (const [key, command, value] of [['1', 'guess', 'dies-out'], ['2', 'guess', 'holds'], ['3', 'guess', 'grows'], ['Enter', 'reveal'], ['PageDown', 'reveal']]) {
    assert.equal(pressed(key, true)?.command, command);
    assert.equal(pressed(key, true)?.value, value);
    assert.ok(!pressed(key, false)?.command.match(/guess|reveal/));
  }
  for (const [key, command] of [['p', 'predict'], ['f', 'freeze'], ['d', 'pen'], ['b', 'big'], ['Home', 'rest'], ['Escape', 'close']])
    assert.equal(pressed(key, false)?.command, command);
});

test('leaving the question before it is answered looks ahead again: no false rest stays', () => {
  const { app, session } = opened(0.05, '#shimmy=2&velocity=80&dampingConstant=20&initial.torsionAngle=0.05&predict=1');
  assert.ok(app.isVeiled);
  app.run('close');
  assert.ok(!app.isVeiled);
  assert.equal(session.outlook.verdict, 'shimmies');
});

test('a page that must not move opens at the instant that its address names', () => {
  const app = new App();
  app.open(engine, ['#shimmy=2&velocity=80&dampingConstant=20&initial.torsionAngle=0.05&time=0.1'], { isStill: true });
  assert.ok(Math.abs((app.session?.time ?? 0) - 0.1) < 1e-12);
});
