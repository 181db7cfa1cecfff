// A landing roll: what is read of it, why it shimmies where it does, how it is asked for, kept in a link and drawn.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Quantity } from '../../www/controls/quantity.js';
import { cases } from '../../www/lens/landing/cases.js';
import { gearOf, gearWith, isLive, rollNow } from '../../www/lens/landing/gear.js';
import { RollSet } from '../../www/lens/landing/roll-set.js';
import { amplitudesOf, distancesOf, momentsOf, shimmyOf, stretchesOf, thresholdOf, windowOf } from '../../www/lens/landing/roll.js';
import { reasonsInWords, summaryOf } from '../../www/lens/landing/say.js';
import { durationOf, readRoll, refusedIn, rollOf, usualRoll, writeRoll } from '../../www/lens/landing/settings.js';
import { RollWork } from '../../www/lens/landing/roll-work.js';
import { reasonsOf } from '../../www/lens/landing/why.js';
import { readLink } from '../../www/link/read.js';
import { drawRollHistory } from '../../www/view/roll-history.js';
import { drawRunway } from '../../www/view/runway.js';
import { voiceOf } from '../../www/words/voice.js';
import { table } from './opened-session.mjs';
import { numbersOf, recordingContext, written } from './plot-recorder.mjs';
import { standInRoll } from './stand-in-roll.mjs';
import { engine } from './stories.mjs';
import { theme } from './theme.mjs';

const degree = Math.PI / 180;
const english = voiceOf('en');
const velocity = new Quantity(/** @type {typeof table.parameters[number]} */ (table.parameters.find(({ name }) => name === 'velocity')));

/** @param {number} got @param {number} expected @param {number} error */
const near = (got, expected, error) => assert.ok(Math.abs(got - expected) <= error, `${got} for ${expected}`);

/** A roll that rings at 50 Hz with an amplitude over time. @param {(time: number) => number} amplitude */
function ringing(amplitude, { from = 80, braking = 3, to = 5 } = {}) {
  const end = (from - to) / braking;
  const time = Float64Array.from({ length: 40_001 }, (_, i) => (i * end) / 40_000);
  const [torsionAngle, torsionRate] = [Math.sin, Math.cos].map((wave, i) => time.map((at) => amplitude(at) * (100 * Math.PI) ** i * wave(100 * Math.PI * at)));
  return { time, velocity: time.map((at) => from - braking * at), torsionAngle, torsionRate };
}

test('speed and distance are those of even braking: v₀t − bt²/2', () => {
  const roll = ringing(() => 0);
  const distance = distancesOf(roll);
  near(distance[distance.length - 1], (80 ** 2 - 5 ** 2) / 6, 1e-9);
  const at = momentsOf(roll);
  for (const time of [0, 0.0001, 7.3, 24.9999, 25, 99]) {
    const then = Math.min(time, 25);
    near(at(time).velocity, 80 - 3 * then, 1e-9);
    near(at(time).distance, 80 * then - 1.5 * then ** 2, 1e-9);
  }
});

test('no peak is lost, however few stretches there are', () => {
  const roll = ringing((time) => (Math.abs(time - 12.34) < 0.02 ? 0.3 : 0.01));
  for (const count of [7, 90, 900]) {
    const { low, high } = stretchesOf(roll, count);
    assert.equal(Math.max(...high), Math.max(...roll.torsionAngle));
    assert.equal(Math.min(...low), Math.min(...roll.torsionAngle));
  }
  assert.ok(Math.max(...amplitudesOf(stretchesOf(roll, 90))) > 0.29);
  // More stretches than samples: none is empty.
  const sparse = { time: [0, 1, 2], velocity: [3, 2, 1], torsionAngle: [0.1, -0.2, 0.3], torsionRate: [0, 0, 0] };
  assert.ok(stretchesOf(sparse, 50).low.every(Number.isFinite));
});

test('between rows that are few the window shows the motion all the same', () => {
  // Seven rows a cycle of 50 Hz.
  const time = Float64Array.from({ length: 351 }, (_, i) => i / 350);
  const roll = { time, velocity: time.map(() => 50), torsionAngle: time.map((at) => Math.sin(100 * Math.PI * at)), torsionRate: time.map((at) => 100 * Math.PI * Math.cos(100 * Math.PI * at)) };
  const seen = windowOf(roll, 0.3, 0.42, 200);
  assert.ok(seen.torsionAngle.every((angle, i) => Math.abs(angle - Math.sin(100 * Math.PI * seen.time[i])) < 4e-3));
  // Before touchdown and after the end there is nothing more.
  assert.ok([...windowOf(roll, -0.1, 0.1, 50).torsionAngle, ...windowOf(roll, 0.9, 1.2, 50).torsionAngle].every(Number.isFinite));
});

test('it shimmies from the first swing that is wider than a degree to the last, and its widest is told', () => {
  const roll = ringing((time) => (time > 4 && time < 16 ? 0.2 * Math.sin((Math.PI * (time - 4)) / 12) : 0.005));
  const { begins, ends, widest, touchdown, stop } = shimmyOf(roll, thresholdOf({}));
  // 0.2 sin(π(t − 4)/12) is a degree wide 0.334 s after 4 s and as long before 16 s.
  near(begins?.time ?? NaN, 4.334, 0.02);
  near(ends?.time ?? NaN, 15.666, 0.02);
  near(ends?.velocity ?? NaN, 80 - 3 * 15.666, 0.06);
  near(widest.angle, 0.2, 1e-4);
  near(widest.velocity, 50, 0.1);
  assert.deepEqual([touchdown.velocity, stop.velocity], [80, 5]);
  assert.equal(shimmyOf(ringing(() => 0.01), thresholdOf({})).begins, null);
  assert.equal(shimmyOf(ringing(() => 0.1), thresholdOf({})).ends, null);
  // In a gap the wheel turns freely: only what goes beyond it by as much is shimmy.
  assert.equal(shimmyOf(ringing(() => 0.03), thresholdOf({ freeplayAngle: degree })).begins, null);
});

const parameters = Object.fromEntries(table.parameters.map(({ name, default: usual }) => [name, usual]));

/** @param {Readonly<Record<string, number>>} values @param {{ from: number, to: number, braking: number, start?: number }} roll */
function landed(values, roll) {
  const gear = { ...parameters, ...values };
  const diagram = engine.bifurcation({ model: 'torsional', parameters: gear, parameter: 'velocity', from: 2, to: 200, step: 0.02, tolerance: 1e-5 });
  const threshold = thresholdOf(gear);
  const shimmy = shimmyOf(standInRoll(gear, roll), threshold);
  return { shimmy, diagram, threshold, reasons: reasonsOf(shimmy, diagram, threshold) };
}

test('past a branch that comes down to nothing a shimmy ends late, and the slower the braking the less', () => {
  const fast = landed({ dampingConstant: 20 }, { from: 80, to: 5, braking: 6 });
  const slow = landed({ dampingConstant: 20 }, { from: 35, to: 15, braking: 1 });
  assert.deepEqual([fast, slow].map(({ reasons }) => reasons.map(({ key }) => key)), [['begins.once', 'ends.late'], ['begins.once', 'ends.late']]);
  const [late, lessLate] = [fast, slow].map(({ reasons }) => reasons[1].values);
  // theory.md 2: rest becomes unstable at 27.600 m/s with c = 20; a degree wide a branch is a little above.
  for (const { boundary } of [late, lessLate]) assert.ok(boundary > 27.6 && boundary < 27.9, String(boundary));
  assert.ok(lessLate.late < late.late, `${lessLate.late} and ${late.late} m/s late`);
  assert.match(reasonsInWords(fast.reasons, fast.threshold, velocity, english)[1], /That is delay, not a fold\.$/);
});

test('where the branch folds a shimmy goes on though rest is stable already, and that is told instead', () => {
  // The gear of the preset "folded": at 40 m/s rest and a wide cycle are both stable.
  const { reasons, shimmy, threshold } = landed({ dampingConstant: 10, casterLength: -0.05, sideForceLimitAngle: 3 * degree, aligningMomentLimitAngle: 20 * degree }, { from: 80, to: 10, braking: 3, start: 0.3 });
  const end = reasons[1];
  assert.equal(end.key, 'ends.fold');
  assert.ok(end.values.fold < end.values.boundary && end.values.at < end.values.boundary, JSON.stringify(end.values));
  assert.match(reasonsInWords(reasons, threshold, velocity, english)[1], /^The branch folds/);
  assert.match(summaryOf(shimmy, threshold, velocity, english), /^It shimmies from .* down to .* m\/s, over \d+ m; ±\d/);
});

test('who comes from above the upper boundary starts late, for the swing has to grow first', () => {
  // theory.md 2: with c = 40 rest is unstable between 51.881 and 205.13 m/s; with c = 45 the upper boundary lies lower.
  const { reasons, diagram } = landed({ dampingConstant: 47 }, { from: 170, to: 60, braking: 5 });
  assert.equal(reasons[0].key, 'begins.late');
  const upper = Math.max(...diagram.points.filter(({ kind }) => kind === 'hopf').map(({ velocity: at }) => at));
  near(reasons[0].values.boundary, upper, 1e-9);
  assert.ok(reasons[0].values.late > 1);
});

test('with a damper that sticks rest is stable throughout, and the shimmy beside it is told of', () => {
  const model = 'torsional.current-dependent-bouc-wen';
  const gear = { dampingConstant: 20, 'damper.command': 0 };
  const diagram = engine.bifurcation({ model, parameters: gear, parameter: 'velocity', from: 2, to: 100, step: 0.05, tolerance: 1e-4, probes: 3 });
  const threshold = thresholdOf({});
  const shimmy = shimmyOf(engine.landingRoll({ model, parameters: gear, initial: { torsionAngle: 0.01 }, touchdownVelocity: 80, rows: 200_000, rtol: 1e-6 }), threshold);
  const reasons = reasonsOf(shimmy, diagram, threshold);
  assert.deepEqual(reasons.map(({ key }) => key), ['begins.pushed', 'ends.beside']);
  const fold = Math.max(...diagram.points.filter(({ kind }) => kind === 'fold').map((point) => point.velocity));
  near(reasons[1].values.fold, fold, 0.5);
  assert.ok(reasons[1].values.at < fold);
});

test('a calm roll says whether anything lies beside it', () => {
  assert.deepEqual(landed({ dampingConstant: 60 }, { from: 80, to: 5, braking: 3 }).reasons.map(({ key }) => key), ['calm.stable']);
  const { reasons, shimmy, threshold } = landed({ dampingConstant: 10, casterLength: -0.05, sideForceLimitAngle: 3 * degree, aligningMomentLimitAngle: 20 * degree }, { from: 42, to: 20, braking: 3 });
  assert.equal(reasons[0].key, 'calm.beside');
  assert.match(summaryOf(shimmy, threshold, velocity, english), /^No shimmy/);
});

test('a landing is readable text; what is none is refused with its reason', () => {
  assert.equal(writeRoll(usualRoll), '80,3,5,0,0.01');
  assert.deepEqual(readRoll('70,2.5,10,0.3,0.02'), { touchdownVelocity: 70, deceleration: 2.5, finalVelocity: 10, liftFraction: 0.3, torsionAngle: 0.02 });
  assert.equal(durationOf(usualRoll), 25);
  for (const wrong of ['', '80,3,5,0', '80,3,5,0,x', '80,0,5,0,0', '5,3,80,0,0', '80,3,5,1,0', '80,0.1,5,0,0', '80,3,5,0,9']) assert.equal(readRoll(wrong), null, wrong);
  assert.deepEqual([{ deceleration: 0 }, { finalVelocity: 90 }, { liftFraction: 1 }, { deceleration: 0.1 }, { torsionAngle: 2 }].map((change) => refusedIn({ ...usualRoll, ...change })), ['positive', 'order', 'share', 'long', 'turn']);
  assert.equal(rollOf('nothing'), usualRoll);
  const read = (/** @type {string} */ link) => readLink(`#shimmy=2&lens=landing&${link}`, [table], () => true)?.problems.map(({ reason }) => reason);
  assert.deepEqual(read('view.landing=table&view.landingRoll=80,3,5,0.2,0.01&view.landingSort=ends,down'), []);
  assert.deepEqual(read('view.landing=sky&view.landingRoll=1,2&view.landingSort=%20'), ['unclear', 'unclear', 'unclear']);
});

test('the gear that lands is the one on the stage, with its own landing where it is one', () => {
  const scene = { object: 'torsional', parameters };
  assert.equal(isLive(scene), false);
  assert.equal(rollNow(scene, { landingRoll: '70,3,5,0,0.01' }).touchdownVelocity, 70);
  const landing = { object: 'torsional.bouc-wen.none.landing', parameters: { ...parameters, 'damper.command': 0.5, touchdownVelocity: 60 } };
  assert.equal(rollNow(landing, { landingRoll: '70,3,5,0,0.01' }).touchdownVelocity, 60);
  assert.deepEqual([gearOf(landing).model, gearOf(landing).parameters.touchdownVelocity], ['torsional.bouc-wen', undefined]);
  const values = { dampingConstant: 40, current: 0.75 };
  assert.equal(gearWith(gearOf(scene), values).model, 'torsional.current-dependent-bouc-wen');
  assert.equal(gearWith(gearOf(landing), values).model, 'torsional.bouc-wen');
  assert.deepEqual([gearWith(gearOf(scene), values).parameters.dampingConstant, gearWith(gearOf(scene), values).parameters['damper.command']], [40, 0.75]);
});

test('sixteen landings, row by row the figures of the thesis', () => {
  assert.equal(cases.length, 16);
  assert.deepEqual(cases[0], { dampingConstant: 20, current: 0, figure: 'figure-7.27' });
  assert.deepEqual(cases[6], { dampingConstant: 40, current: 0.75, figure: 'figure-7.33' });
  assert.deepEqual(cases[15], { dampingConstant: 70, current: 1, figure: 'figure-7.42' });
});

const settle = () => new Promise((done) => { setTimeout(done); });

test('many landings are computed one by one; what fails is told, what is of another gear is old until it is there', async (t) => {
  t.mock.timers.enable({ apis: ['setTimeout'] });
  /** @type {any[]} */
  const asked = [];
  const set = new RollSet(cases, /** @type {any} */ ((/** @type {string} */ kind, /** @type {any} */ spec, /** @type {{ signal: AbortSignal }} */ { signal }) => new Promise((done, fail) => {
    asked.push({ kind, spec, done, fail, signal });
    signal.addEventListener('abort', () => fail(signal.reason));
  })));
  let changes = 0;
  set.onChange = () => { changes++; };
  set.look({ model: 'torsional', parameters }, usualRoll);
  assert.equal(asked.length, 16);
  assert.deepEqual([asked[5].kind, asked[5].spec.model, asked[5].spec.parameters.dampingConstant, asked[5].spec.parameters['damper.command']], ['landingRoll', 'torsional.current-dependent-bouc-wen', 40, 0.5]);
  assert.deepEqual([asked[5].spec.touchdownVelocity, asked[5].spec.deceleration, asked[5].spec.finalVelocity, asked[5].spec.initial.torsionAngle], [80, 3, 5, 0.01]);
  const rolled = ringing((time) => (time < 10 ? 0.1 : 0));
  asked[0].done(rolled);
  asked[1].fail(new Error('too wild'));
  for (let i = 0; i < 5; i++) await Promise.resolve();
  assert.equal(changes, 2);
  near(set.items[0].answer?.shimmy.ends?.time ?? NaN, 10, 0.02);
  assert.deepEqual([set.items[1].isFailed, set.items[2].isOld, set.fraction], [true, true, 2 / 16]);
  // The speed is that of the landing, whatever the gear rolls at.
  set.look({ model: 'torsional', parameters: { ...parameters, velocity: 33, dampingConstant: 5 } }, usualRoll);
  assert.equal(asked.length, 16);
  set.look({ model: 'torsional', parameters: { ...parameters, casterLength: 0.2 } }, usualRoll);
  assert.ok(asked[3].signal.aborted && set.items[0].isOld && set.items[0].answer !== null);
  t.mock.timers.tick(300);
  assert.equal(asked.length, 32);
  set.stop();
  assert.ok(asked[20].signal.aborted);
});

test('a roll and the branches under it are one answer: no reason is given while either is of another gear', async () => {
  /** @type {any[]} */
  const asked = [];
  const work = new RollWork(/** @type {any} */ ((/** @type {string} */ kind, /** @type {any} */ spec) => new Promise((done) => { asked.push({ kind, spec, done }); })));
  const gear = { model: 'torsional', parameters: { ...parameters, dampingConstant: 20 } };
  work.look(gear, usualRoll);
  work.look({ ...gear, parameters: { ...gear.parameters, velocity: 12 } }, usualRoll);
  assert.deepEqual(asked.map(({ kind }) => kind), ['landingRoll', 'bifurcation']);
  asked[0].done(standInRoll(gear.parameters, { from: 80, to: 5, braking: 6 }));
  await settle();
  assert.deepEqual([work.reasons.length, work.isOld], [0, false]);
  asked[1].done(engine.bifurcation(asked[1].spec));
  await settle();
  assert.deepEqual(work.reasons.map(({ key }) => key), ['begins.once', 'ends.late']);
  assert.equal(work.reasons, work.reasons);
  work.look({ ...gear, parameters: { ...gear.parameters, casterLength: 0.2 } }, usualRoll);
  assert.deepEqual(work.reasons, []);
});

/** @param {Partial<import('../../www/view/runway.js').Shown>} [more] @returns {import('../../www/view/runway.js').Shown} */
const runway = (more) => ({
  length: 1000, distance: [0, 500, 1000], low: [-0.01, -0.2, 0], high: [0.01, 0.2, 0], limit: 0.4, shimmy: [100, 800], now: { distance: 400, velocity: 60 }, fastest: 80, isOld: false, veiled: false,
  flags: [{ distance: 0, text: 'touchdown 80', kind: 'plain' }, { distance: 100, text: 'shimmy 76', kind: 'shimmy' }, { distance: 1000, text: 'end 5', kind: 'plain' }], ...more,
});

test('the runway has its distances, its flags where they belong, the speed in both units, and nothing of what is veiled', () => {
  const { context, named, calls } = recordingContext();
  const places = drawRunway(context, { width: 600, height: 130 }, runway(), theme, english);
  assert.ok(places);
  near(places.from(places.at(321)), 321, 1e-9);
  const words = written(named('fillText'));
  for (const wanted of ['0', '200', '1000 m', 'touchdown 80', 'shimmy 76', 'end 5', '60', 'm/s', '117', 'kn']) assert.ok(words.includes(wanted), `${wanted} in ${words}`);
  assert.ok(numbersOf(calls).every(Number.isFinite));
  // A flag's pole stands at its distance.
  assert.ok(named('moveTo').some(({ args: [x] }) => Math.abs(x - places.at(100)) <= 1));
  const veiled = recordingContext();
  drawRunway(veiled.context, { width: 600, height: 130 }, runway({ veiled: true }), theme, english);
  const told = written(veiled.named('fillText'));
  assert.ok(told.includes('?') && !told.some((text) => /shimmy|end/.test(text)), String(told));
  assert.equal(drawRunway(context, { width: 90, height: 20 }, runway(), theme, english), null);
});

test('the history has seconds below, speeds above, the window beside it, and hides what is to come', () => {
  const roll = ringing((time) => (time < 10 ? 0.1 : 0.001));
  const shown = {
    from: 0, to: 25, band: stretchesOf(roll, 300), limit: 0.2, threshold: degree, freeplay: 0, now: 5, speeds: [{ time: 0, text: '80 m/s' }, { time: 10, text: '50' }, { time: 10.1, text: '49.7' }],
    window: { time: [4.95, 5, 5.05], torsionAngle: [0, 0.1, 0] }, span: /** @type {[number, number]} */ ([-0.08, 0.04]), isOld: false, veiled: false,
  };
  const { context, named, calls } = recordingContext();
  const places = drawRollHistory(context, { width: 600, height: 120 }, shown, theme, english);
  const words = written(named('fillText'));
  for (const wanted of ['0', '25 s', '80 m/s', '50', 'around now', 'now']) assert.ok(words.includes(wanted), `${wanted} in ${words}`);
  assert.ok(!words.includes('49.7'), 'no number over another');
  assert.ok(numbersOf(calls).every(Number.isFinite));
  near(places?.from(places.frame.left) ?? NaN, 0, 1e-9);
  const veiled = recordingContext();
  drawRollHistory(veiled.context, { width: 600, height: 120 }, { ...shown, veiled: true }, theme, english);
  assert.equal(written(veiled.named('fillText')).filter((text) => text === '?').length, 2);
  const narrow = recordingContext();
  drawRollHistory(narrow.context, { width: 380, height: 200 }, shown, theme, english);
  assert.ok(!written(narrow.named('fillText')).includes('around now'));
});
