// A hand on the wheel of the running gear: it holds, lets go, or was never there.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { opened, wanted } from './opened-session.mjs';

test('a wheel in a hand has no future to be drawn; let go it has one again', () => {
  const { session } = opened();
  session.advance(0.1);
  assert.ok(session.scene(wanted).future.time.length > 50);
  session.hold(0.2);
  for (let i = 0; i < 5; i++) {
    session.advance(0.01);
    session.hold(0.2 + 0.01 * i);
    const { future, time, state } = session.scene(wanted);
    assert.ok(future.time.length >= 1 && future.time.length <= 2, `${future.time.length} instants`);
    assert.ok(future.time.every((at) => at <= time + 1e-12), 'what comes is drawn');
    assert.ok(Math.abs(future.torsionAngle[future.time.length - 1] - state[0]) < 1e-9, 'it ends where the hand is');
  }
  session.letGo();
  const { future } = session.scene(wanted);
  assert.ok(future.time.length > 50 && Math.abs(future.time[future.time.length - 1] - wanted.moment[1]) < 1e-9);
});

test('a hand holds the wheel while the ground rolls on, and lets it go from there', () => {
  const { session } = opened();
  session.advance(0.1);
  for (let i = 0; i < 200; i++) {
    session.hold(0.1);
    session.advance(1 / 3000);
  }
  session.hold(0.1);
  const { state, parameters } = session.scene(wanted);
  assert.equal(state[0], 0.1);
  assert.equal(state[1], 0);
  // A wheel held askew drags its tire along until it runs straight: y = σψ. (The moment is brief: within 5 %.)
  assert.ok(Math.abs(state[2] / (parameters.relaxationLength * 0.1) - 1) < 0.05);
  session.letGo();
  assert.equal(session.scene(wanted).state[0], 0.1);
  session.advance(0.01);
  assert.notEqual(session.scene(wanted).state[0], 0.1);
});

test('one hold, however long and far, is one step of undo, and one entry of the record', () => {
  const { store, session } = opened();
  session.advance(0.1);
  const before = [...session.scene(wanted).state];
  for (const angle of [0.05, 0.1, 0.2]) {
    session.hold(angle);
    session.advance(0.02);
  }
  session.letGo();
  assert.equal(session.recipe.changes.length, 1);
  assert.equal(session.recipe.changes[0].state?.torsionAngle, 0.2);
  session.advance(0.1);
  store.undo();
  assert.ok(!store.canUndo);
  assert.ok(Math.abs(session.time - 0.1) < 1e-12);
  assert.deepEqual([...session.scene(wanted).state], before);
});

test('a hand that only touched the wheel leaves nothing behind', () => {
  const { store, session } = opened();
  session.advance(0.1);
  const before = [...session.scene(wanted).state];
  session.hold(before[0]);
  session.advance(0.005);
  session.letBe();
  assert.ok(!store.canUndo && !session.isHeld);
  assert.deepEqual([...session.scene(wanted).state], before);
});

test('a hand on a run that has stopped, or that stops under it, does nothing and lets go', () => {
  const { store, session } = opened();
  session.advance(0.1);
  session.hold(0.1);
  session.set('casterLength', 1e6, null);
  for (let i = 0; i < 100 && !session.failure; i++) session.advance(0.01);
  assert.ok(session.failure, 'it can be computed');
  const { failure } = session;
  session.hold(0.2);
  session.letGo();
  assert.ok(!session.isHeld);
  assert.equal(session.failure, failure, 'why it stopped is still told');
  store.undo();
  session.settle();
  assert.equal(session.failure, null);
});

test('a hold taken back leaves on record the blow that was struck at the same instant', () => {
  const { store, session } = opened();
  session.advance(0.1);
  session.kick();
  const kicked = [...session.scene(wanted).state];
  session.hold(0.2);
  session.letGo();
  store.undo();
  const { parameters, initial, changes, time } = session.recipe;
  const { store: other, session: again } = opened();
  other.update({ parameters: { ...parameters }, run: { initial, changes, time } });
  again.scene(wanted).state.forEach((value, i) => assert.ok(Math.abs(value - kicked[i]) < 1e-9 * Math.max(1, Math.abs(kicked[i]))));
});
