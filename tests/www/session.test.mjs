// The session over the real engine: what the gear does reaches the page, as scenes, outlook and scales.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { openingParameters } from '../../www/opening.js';
import { Session } from '../../www/run/session.js';
import { gearAtRest } from '../../www/stage/at-rest.js';
import { numbersOf } from '../../www/stage/verdict-line.js';
import { Store } from '../../www/store.js';
import { languages, voiceOf } from '../../www/words/voice.js';
import { defaults, opened, table, wanted } from './opened-session.mjs';
import { engine } from './stories.mjs';

test('the page opens on a gear that shimmies', () => {
  const { session } = opened();
  assert.equal(session.outlook.verdict, 'shimmies');
  assert.equal(session.scales.magnification, 1);
  assert.equal(session.outlook.amplitude.torsionAngle.toFixed(5), '0.26508');
  assert.equal(session.outlook.frequency?.toFixed(2), '51.87');
});

test('a scene holds numbers only, at the start, on the way, and back', () => {
  const { session } = opened();
  for (const move of [() => {}, () => session.advance(1e-4), () => session.advance(0.3), () => session.seek(0.05), () => session.seek(0)]) {
    move();
    const { past, orbitPast, track, future, run, state, trail } = session.scene(wanted);
    const series = [past, orbitPast, track, future, run.past, run.future].flatMap(
      (one) => Object.values(one).filter((value) => typeof value !== 'string' && 'length' in Object(value)));
    for (const values of [...series, state, trail.flatMap(({ psi, y }) => [psi, y])])
      assert.ok([.../** @type {Iterable<number>} */ (values)].every(Number.isFinite));
    assert.ok(Math.abs(past.torsionAngle[past.torsionAngle.length - 1] - state[0]) < 1e-9, 'the past ends now');
    assert.ok(Math.abs(future.torsionAngle[0] - state[0]) < 1e-12, 'the future begins now');
  }
});

test('the ground behind keeps the speed it was driven at', () => {
  const { session } = opened();
  session.advance(0.5);
  const before = session.scene(wanted);
  session.set('velocity', 10, null);
  const after = session.scene(wanted);
  assert.ok(Math.abs(after.roll - 40) < 1e-9);
  assert.deepEqual(after.track, before.track);
  session.advance(0.01);
  const { roll, track } = session.scene(wanted);
  assert.ok(Math.abs(roll - 40.1) < 1e-9);
  assert.ok(Math.abs(roll - track.distance[0] - wanted.trackLength) < 1e-9, 'the track is as long as it is seen');
});

test('a run that is begun again in its midst is drawn as large as it was: by its widest swing', () => {
  const begin = (/** @type {number | undefined} */ time, changes = /** @type {import('../../www/run/live-run.js').Change[]} */ ([])) => {
    const { store, session } = opened();
    store.open({ parameters: { ...store.state.parameters, velocity: 20 }, run: { initial: { torsionAngle: 0.05 }, changes, ...(time && { time }) } });
    return session;
  };
  // 0.05 rad are 2.9°, which × 5 draws at 14°. By half a second it has died to 0.2°.
  assert.equal(begin(undefined).scales.magnification, 5);
  const later = begin(0.5);
  assert.ok(later.outlook.present.amplitude < 5e-3, `${later.outlook.present.amplitude}`);
  assert.equal(later.scales.magnification, 5);
  // A blow in between swung it 20 times as wide as anything else: as it did before the reload, that one counts.
  const struck = begin(1, [{ time: 0.2, kick: 400 }]);
  assert.equal(struck.scales.magnification, 1);
  // What comes is no secret of the drawing's: veiled, only what has been seen counts.
  const { state } = opened().store;
  const asked = new Store({ ...state, predict: { guess: null, outcome: null }, run: { initial: { torsionAngle: 0.05 }, time: 0.02 } });
  assert.equal(new Session(engine, asked).scales.magnification, 5);
});

test('the magnification is that of the start of the run until a hand asks for another', () => {
  const { session } = opened();
  const { magnification } = session.scales;
  session.set('dampingConstant', 47.5, null);
  session.settle();
  assert.equal(session.set('velocity', -3, null)?.code, 'out-of-range');
  session.settle();
  session.kick();
  session.advance(1);
  session.refresh();
  assert.equal(session.scales.magnification, magnification);
  session.set('dampingConstant', 90, null);
  session.advance(1);
  session.settle();
  assert.equal(session.scales.magnification, magnification);
  session.fit();
  assert.ok(session.scales.magnification > magnification);
});

test('axes follow a run that grows out of them, and hold one that stays within', () => {
  const { store, session } = opened();
  store.open({ parameters: { ...store.state.parameters, dampingConstant: 0, torsionalStiffness: 0 }, run: { initial: { torsionAngle: 0.05 } } });
  let changes = 0;
  let last = session.scales.limits;
  for (let step = 0; step < 40; step++) {
    session.advance(0.1);
    session.refresh();
    const { limits } = session.scales;
    const { state } = session.scene(wanted);
    assert.ok(Math.abs(state[0]) <= limits.angle && Math.abs(state[1]) <= limits.rate, `${state[0]} of ${limits.angle} at ${session.time}`);
    if (limits !== last) changes++;
    last = limits;
  }
  assert.ok(Math.abs(session.scene(wanted).run.past.high.at(-1) ?? 0) > 2, 'it has grown beyond 120°');
  assert.ok(changes > 0 && changes < 15, `${changes}`);
});

test('another run, as a link brings it, begins at its start', () => {
  const { store, session } = opened();
  session.advance(0.3);
  store.update({ parameters: { ...defaults, velocity: 30, dampingConstant: 40 }, run: { initial: { torsionAngle: 0.02 } } });
  assert.equal(session.time, 0);
  assert.equal(session.scene(wanted).state[0], 0.02);
  assert.equal(session.outlook.verdict, 'dies-out');
  store.undo();
  assert.equal(session.outlook.verdict, 'shimmies');
});

test('small motions are magnified anew when a run starts, not while it goes on', () => {
  const { session } = opened();
  for (const [name, value] of /** @type {[string, number][]} */ ([['velocity', 50], ['dampingConstant', 100], ['freeplayAngle', Math.PI / 180]]))
    session.set(name, value, 'drag');
  session.refresh();
  assert.equal(session.scales.magnification, 1);
  session.settle();
  assert.equal(session.outlook.verdict, 'rattles');
  session.restart();
  assert.ok(session.scales.magnification >= 5);
});

test('the ground has gone by as far as the wheel has rolled, through changes of speed and time', () => {
  const { session } = opened();
  session.advance(0.1);
  session.set('velocity', 40, null);
  session.advance(0.1);
  assert.ok(Math.abs(session.scene(wanted).roll - 12) < 1e-9);
});

test('the gear at rest is drawn with the engine’s own defaults', () => {
  for (const [name, value] of Object.entries(gearAtRest.parameters))
    assert.equal(value, openingParameters[name] ?? defaults[name], name);
});

test('every parameter of the table has a word in both languages', () => {
  for (const { name } of table.parameters)
    for (const words of Object.values(languages)) assert.ok(Object.hasOwn(words, `parameter.${name}`), name);
});

test('the line under the verdict says how wide, how fast, where to', () => {
  const { session } = opened();
  const line = () => numbersOf(session.outlook, voiceOf('en')).map(({ text }) => text).join(' · ');
  assert.match(line(), /^±\d\.\d° and growing · 5\d\.\d Hz · heads for ±15\.2°$/);
  session.advance(3);
  session.refresh();
  assert.equal(line(), '±15.2° · 51.9 Hz · settled');
  session.set('dampingConstant', 60, null);
  session.refresh();
  assert.match(line(), /^±1\d\.\d° and falling · 5\d\.\d Hz · heads for 0°$/);
});

test('the line under the verdict calls settled what no longer changes as shown, and knows its limit from the start', () => {
  const { session } = opened();
  const { outlook } = session;
  const line = (/** @type {number} */ now) =>
    numbersOf({ ...outlook, present: { ...outlook.present, amplitude: now, trend: 'falling' } }, voiceOf('en')).map(({ text }) => text).join(' · ');
  assert.match(line(outlook.amplitude.torsionAngle * 1.001), /^±15\.2° · \S+ Hz · settled$/);
  assert.match(line(0.27), /and falling/);
  assert.match(line(5), /^±286\.5° and falling · \S+ Hz · Beyond 29°/);
});

test('the line under the verdict calls nothing settled on an unstable cycle', () => {
  const { session } = opened();
  const { outlook } = session;
  const there = { ...outlook, settled: false, present: { ...outlook.present, amplitude: outlook.amplitude.torsionAngle, trend: /** @type {const} */ ('steady'), stable: false } };
  const line = (/** @type {'en' | 'tr'} */ language) => numbersOf(there, voiceOf(language)).map(({ text }) => text).join(' · ');
  assert.match(line('en'), /^±15\.2° · \S+ Hz · on an unstable cycle · a small push decides$/);
  assert.match(line('tr'), /^±15,2° · \S+ Hz · kararsız çevrimde · sonunu küçük bir itme belirler$/);
});

test('the swing told of is the one that trail and marks show', () => {
  const { session } = opened();
  assert.equal(session.seen, session.outlook);
  session.advance(0.15);
  session.refresh();
  const [low, high] = session.scene(wanted).extremes ?? [];
  assert.ok(Math.abs(session.seen.present.amplitude - Math.max(high ?? 0, -(low ?? 0))) < 1e-3);
  assert.ok(session.outlook.present.amplitude > session.seen.present.amplitude, 'it grows');
  session.kick();
  assert.equal(session.seen, session.outlook, 'the cycle before a blow says nothing of now');
});

test('where a frame is too long for one state the scene has those of its exposure, of the run and of its ghosts', () => {
  const { session } = opened();
  session.advance(0.2);
  session.pin();
  session.advance(0.1);
  assert.equal(session.scene(wanted).exposed, null);
  assert.equal(session.scene(wanted).ghosts[0].exposed, null);
  const { exposed, ghosts, state, time, fan } = session.scene({ ...wanted, exposure: 1 / 60 });
  assert.ok(exposed && fan);
  const last = exposed.time.length - 1;
  assert.ok(exposed.time[0] <= time - 1 / 60 && exposed.time[1] > time - 1 / 60, 'it begins with the exposure');
  // 64 a cycle, of which 1/60 s at 51.9 Hz is 0.86.
  assert.ok(last >= 54, `${last}`);
  ['torsionAngle', 'torsionRate', 'lateralDeformation'].forEach((name, i) =>
    assert.ok(Math.abs(exposed[/** @type {'torsionAngle'} */ (name)][last] - state[i]) < 1e-9 * Math.max(1, Math.abs(state[i])), 'and ends now'));
  // The gear's fan is of the same stretch.
  assert.ok(Math.abs(exposed.torsionAngle[0] - fan[0].psi) < 0.02);
  assert.ok(ghosts[0].exposed && ghosts[0].exposed.time.length > 40);
});

test('where the sheet shows no track it ends now, however the distance is rounded', () => {
  // A distance of the wheel turned back into a time may be a rounding later than now, which no history goes to.
  let isLater = 0;
  for (let i = 0; i < 60; i++) {
    const { session, store } = opened();
    store.follow({ parameters: { ...store.state.parameters, velocity: 30 + i / 7 } });
    session.advance(0.001 + i / 3000);
    const { time, roll, track } = session.scene({ ...wanted, trackLength: 0 });
    assert.equal(session.failure, null);
    assert.ok(track.time.every((at) => at <= time) && track.distance.every((at) => at <= roll), `${i}`);
    if (roll / store.state.parameters.velocity > time) isLater++;
  }
  assert.ok(isLater > 0, 'no rounding was met: the test says nothing');
});

test('axes far too large for the motion are chosen anew when a hand lets go', () => {
  const { session } = opened();
  session.advance(2);
  session.refresh();
  session.scales = { ...session.scales, limits: { angle: 80 * Math.PI / 180, rate: 400, deformation: 1 } };
  session.set('dampingConstant', 31, null);
  session.settle();
  assert.ok(session.scales.limits.angle < 25 * Math.PI / 180);
});

test('a ghost goes on as it was, beside the run that is changed', () => {
  const { store, session } = opened();
  session.advance(0.1);
  session.pin();
  session.set('dampingConstant', 60, null);
  session.advance(0.3);
  session.refresh();
  const { ghosts, state } = session.scene(wanted);
  assert.equal(ghosts.length, 1);
  assert.equal(ghosts[0].parameters.dampingConstant, 20);
  assert.equal(ghosts[0].outlook?.verdict, 'shimmies');
  assert.equal(session.outlook.verdict, 'dies-out');
  const { session: alone } = opened();
  alone.advance(0.4);
  const expected = alone.scene(wanted).state;
  Array.from(ghosts[0].state).forEach((value, i) => assert.ok(Math.abs(value - expected[i]) < 1e-6 * Math.max(1, Math.abs(expected[i])), 'as if nothing had been changed'));
  assert.ok(Math.abs(state[0]) < Math.abs(expected[0]) + 0.2);
  session.seek(0.2);
  alone.seek(0.2);
  Array.from(session.scene(wanted).ghosts[0].state).forEach((value, i) => assert.ok(Math.abs(value - alone.scene(wanted).state[i]) < 1e-5 * Math.max(1, Math.abs(value))));
  session.restart();
  assert.equal(session.scene(wanted).ghosts[0].state[0], 0.05, 'from the same start');
  store.undo();
  store.undo();
  assert.equal(store.state.parameters.dampingConstant, 20);
  store.undo();
  assert.equal(session.scene(wanted).ghosts.length, 0, 'undo lets it go');
});

test('the energy of a cycle is told with the outlook', () => {
  const { session } = opened();
  session.advance(3);
  session.refresh();
  const { energy } = session;
  assert.ok(energy);
  assert.ok(Math.abs(energy.tire - energy.damper - energy.treadWidth) < 1e-4 * energy.tire, 'on the cycle in equals out');
});

test('what goes in and out agrees with where the swing goes, from the first instant on', () => {
  for (const velocity of [28, 30, 80]) {
    const { store, session } = opened();
    store.update({ parameters: { ...store.state.parameters, velocity }, run: { initial: { torsionAngle: 0.05 } } });
    assert.equal(session.outlook.present.trend, 'growing', `${velocity} m/s`);
    assert.ok((session.energy?.stored ?? 0) > 0, `${velocity} m/s: ${session.energy?.stored} J`);
  }
});
