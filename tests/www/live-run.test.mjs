// A run's record: from it the run is begun again elsewhere at any instant, and undo and redo come back to what it was.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { LiveRun } from '../../www/run/live-run.js';
import { dragged, isClose, opened, wanted } from './opened-session.mjs';
import { engine } from './stories.mjs';

/** @typedef {ReturnType<typeof opened>['session']} Session */

/** @param {Session} session */
const stateOf = (session) => [...session.scene(wanted).state];

/** The record leads to the very motion that is on the page, with its values. @param {Session} session @param {number} [share] */
function assertTold(session, share = 1e-6) {
  const { state, parameters } = session.scene(wanted);
  const again = new LiveRun(engine, session.recipe);
  assert.deepEqual({ ...again.parameters }, { ...parameters });
  assert.ok(isClose(state, again.state, share), `${again.state} for ${state}`);
  again.free();
}

/** A drag, a blow 0.2 s later, and 0.2 s more go by. */
function draggedAndStruck() {
  const { store, session } = dragged();
  session.advance(0.2);
  session.kick();
  session.advance(0.2);
  return { store, session };
}

test('amid a drag that has been made the record holds the part of it up to there', () => {
  const { session } = draggedAndStruck();
  session.seek(0.4);
  const { changes, time } = session.recipe;
  assert.deepEqual([changes, time], [[{ time: 0.4, set: { dampingConstant: session.scene(wanted).parameters.dampingConstant } }], 0.4]);
  assert.ok(changes[0].set && changes[0].set.dampingConstant > 35 && changes[0].set.dampingConstant < 45);
  session.kick();
  session.advance(0.1);
  assert.deepEqual(session.recipe.changes.map(({ time: at }) => at), [0.4, 0.4], 'what was done ahead of it is gone, what came before is not');
  session.seek(0.1);
  assert.equal(session.recipe.changes.length, 0);
});

test('amid a hold that has been made the record holds the wheel as it was held there', () => {
  const { session } = opened();
  session.advance(0.1);
  for (let i = 0; i <= 20; i++) {
    session.hold(0.01 * i);
    session.advance(0.005);
  }
  session.letGo();
  session.advance(0.1);
  session.seek(0.15);
  const [torsionAngle, torsionRate, lateralDeformation] = stateOf(session);
  assert.ok(torsionAngle > 0.08 && torsionAngle < 0.12);
  assert.deepEqual(session.recipe.changes, [{ time: 0.15, state: { torsionAngle, torsionRate, lateralDeformation } }]);
  assertTold(session);
});

test('a blow amid a drag that had been made is taken back, and the rest of the drag and what followed come back', () => {
  const { store, session } = draggedAndStruck();
  session.seek(0.4);
  const before = stateOf(session);
  const { dampingConstant } = store.state.parameters;
  session.kick();
  session.advance(0.1);
  const after = stateOf(session);
  store.undo();
  assert.ok(isClose(stateOf(session), before), `${stateOf(session)} for ${before}`);
  assert.deepEqual([session.time, store.state.parameters.dampingConstant], [0.4, dampingConstant]);
  session.seek(1);
  assert.equal(store.state.parameters.dampingConstant, 60);
  assert.equal(session.recipe.changes.length, 2);
  session.seek(0.4);
  store.redo();
  assert.ok(isClose(stateOf(session), after, 1e-6) && Math.abs(session.time - 0.5) < 1e-12);
});

test('a change in the past puts an end to what had been done after it, on record too', () => {
  const { session } = opened();
  session.advance(0.3);
  session.kick();
  session.advance(0.1);
  session.seek(0.1);
  session.kick();
  session.advance(0.3);
  assert.deepEqual(session.recipe.changes.map(({ time }) => time), [0.1]);
  assertTold(session);
});

test('who goes back to a place has the time before him that had been lived there', () => {
  const { parameters } = opened().session.recipe;
  const live = new LiveRun(engine, { object: 'torsional', parameters, initial: { torsionAngle: 0.05 }, changes: [], time: 0.6 });
  const late = [...live.state];
  live.seek(0.1);
  const { place } = live;
  live.apply({ kick: 10 });
  live.advance(0.1);
  assert.ok(Math.abs(live.range[1] - 0.2) < 1e-12, 'the blow put an end to it');
  live.goTo(place);
  assert.ok(Math.abs(live.time - 0.1) < 1e-12 && Math.abs(live.range[1] - 0.6) < 1e-9, `${live.range}`);
  live.seek(0.6);
  assert.ok(isClose(live.state, late, 1e-6));
  live.free();
});

test('a run too long to be lived again begins with the state and the values of now, and goes on the same', () => {
  const long = opened().session;
  long.advance(30);
  long.set('dampingConstant', 30, null);
  for (let i = 0; i < 31; i++) long.advance(1);
  const busy = opened().session;
  for (let i = 0; i < 41; i++) {
    busy.set('dampingConstant', 21 + i / 10, null);
    busy.advance(0.002);
  }
  for (const session of [long, busy]) {
    const { changes, time, parameters } = session.recipe;
    assert.deepEqual([changes.length, time, parameters.dampingConstant], [1, 0, session.scene(wanted).parameters.dampingConstant]);
    assertTold(session, 1e-12);
    const again = new LiveRun(engine, session.recipe);
    again.advance(0.05);
    session.advance(0.05);
    assert.ok(isClose(stateOf(session), again.state, 1e-6));
    again.free();
  }
  busy.seek(0.0301);
  assert.equal(busy.recipe.changes.length, 16, 'further back its record is short enough');
  assertTold(busy);
});

test('so many changes that the first are forgotten: undo finds them again, redo the last', () => {
  const { store, session } = opened();
  const count = 190;
  for (let i = 0; i < count; i++) {
    session.set('dampingConstant', 20 + ((i + 1) % 7), null);
    session.advance(0.001);
  }
  const last = stateOf(session);
  assertTold(session, 1e-12);
  session.seek(0.1195);
  const isForgotten = session.recipe.changes.length === 1;
  assert.ok(isForgotten, 'what is left of the record does not lead here');
  assertTold(session, 1e-12);
  session.seek(count * 0.001);
  for (let i = 0; i < count - 1; i++) store.undo();
  assert.deepEqual(session.recipe.changes.map(({ set }) => set?.dampingConstant), [21], 'the record goes back to the start again');
  assertTold(session);
  for (let i = 0; i < count - 1; i++) store.redo();
  assert.ok(Math.abs(session.time - count * 0.001) < 1e-9);
  assert.ok(isClose(stateOf(session), last, 1e-5), `${stateOf(session)} for ${last}`);
});

test('what redo goes back to comes to the present where either its instant or the change lies beyond what is remembered', () => {
  for (const [stands, lives] of /** @type {const} */ ([
    // The change, at 30 s, is remembered; where the run stood when it was undone, at 20 s, is not.
    [20, 55],
    // Where it stood is remembered; the change is not.
    [80, 65],
  ])) {
    const { store, session } = opened();
    const live = (/** @type {number} */ seconds) => { for (let i = 0; i < seconds; i++) session.advance(1); };
    live(30);
    session.kick();
    if (stands > 30) live(stands - 30);
    else session.seek(stands);
    const stood = stateOf(session);
    store.undo();
    assert.ok(Math.abs(session.time - 30) < 1e-9);
    live(lives);
    store.redo();
    assert.ok(Math.abs(session.time - 30 - lives) < 1e-9, `${session.time}`);
    assert.ok(isClose(stateOf(session), stood), `${stateOf(session)} for ${stood}`);
  }
});

test('where undone changes lie ahead, what comes after the instant is what they had made of it', () => {
  const { store, session } = opened();
  session.advance(0.2);
  session.set('dampingConstant', 40, null);
  session.advance(0.2);
  session.set('dampingConstant', 80, null);
  session.advance(0.2);
  const late = stateOf(session);
  session.seek(0.1);
  store.undo();
  store.redo();
  assert.ok(Math.abs(session.time - 0.1) < 1e-12);
  session.seek(0.6);
  assert.ok(isClose(stateOf(session), late, 1e-6), `${stateOf(session)} for ${late}`);
});

test('when a run was last changed or struck is told of the instant that is looked at', () => {
  const { parameters } = opened().session.recipe;
  const changes = [{ time: 0.1, kick: 10 }, { time: 0.2, set: { dampingConstant: 40 } }, { time: 0.3, state: { torsionAngle: 0.1 } }];
  const live = new LiveRun(engine, { object: 'torsional', parameters, initial: { torsionAngle: 0.05 }, changes, time: 0.4 });
  const told = [0.05, 0.15, 0.25, 0.35].map((time) => {
    live.seek(time);
    return [live.changedAt, live.struckAt];
  });
  assert.deepEqual(told, [[0, -Infinity], [0.1, 0.1], [0.2, 0.1], [0.3, 0.3]]);
  live.free();
});

test('a drag that is undone before the hand lets go does not go on in the drag before it', () => {
  const { store, session } = opened();
  session.set('dampingConstant', 30, 'drag');
  session.settle();
  session.advance(0.1);
  session.set('dampingConstant', 50, 'drag');
  store.undo();
  session.advance(0.1);
  session.set('dampingConstant', 40, 'drag');
  assert.deepEqual(session.recipe.changes.map(({ time, set }) => [time, set?.dampingConstant]), [[0, 30], [0.2, 40]]);
});
