// Undo and redo take the run to the instant before what was done to it, and to where it had come; a record begins it again.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { dragged, isClose, opened, wanted } from './opened-session.mjs';

test('a value set acts at once, and undo takes it back in the running gear', () => {
  const { store, session } = opened();
  session.advance(0.2);
  assert.equal(session.set('dampingConstant', 60, null), null);
  session.settle();
  assert.equal(session.outlook.verdict, 'dies-out');
  store.undo();
  session.settle();
  assert.equal(session.outlook.verdict, 'shimmies');
  assert.equal(session.scene(wanted).parameters.dampingConstant, 20);
  assert.ok(Math.abs(session.time - 0.2) < 1e-12, 'the run goes on');
});

test('going back in time brings back the values of then, without a step of undo', () => {
  const { store, session } = opened();
  session.advance(0.1);
  session.set('dampingConstant', 60, null);
  session.advance(0.1);
  session.seek(0.05);
  assert.equal(store.state.parameters.dampingConstant, 20);
  session.seek(0.15);
  assert.equal(store.state.parameters.dampingConstant, 60);
  store.undo();
  assert.ok(!store.canUndo);
});

test('a blow, a twist and the rest are taken back by undo, and done again by redo', () => {
  const { store, session } = opened();
  session.advance(0.2);
  const before = [...session.scene(wanted).state];
  for (const act of [() => session.kick(), () => session.rest(), () => { session.hold(0.2); session.letGo(); }]) {
    act();
    assert.ok(!isClose(session.scene(wanted).state, before), 'something has happened');
    session.advance(0.05);
    const after = [...session.scene(wanted).state];
    store.undo();
    assert.ok(Math.abs(session.time - 0.2) < 1e-12 && isClose(session.scene(wanted).state, before), 'it is as it was');
    assert.equal(session.recipe.changes.length, 0, 'and nothing of it is on record');
    session.advance(0.1);
    store.redo();
    assert.ok(Math.abs(session.time - 0.25) < 1e-12 && isClose(session.scene(wanted).state, after, 1e-6), 'it is as it had become');
    assert.equal(session.recipe.changes[0].time, 0.2, 'by what was done when it was done');
    store.undo();
    session.advance(0.1);
    session.seek(0.2);
    assert.ok(isClose(session.scene(wanted).state, before), 'and it does not happen again by itself');
  }
});

test('undo takes back what was done last, however time has been moved since', () => {
  const { store, session } = opened();
  session.advance(1);
  session.set('dampingConstant', 40, null);
  session.advance(1);
  session.set('dampingConstant', 80, null);
  session.advance(0.5);
  session.seek(0.5);
  assert.equal(store.state.parameters.dampingConstant, 20);
  store.undo();
  assert.equal(session.time, 2);
  assert.equal(store.state.parameters.dampingConstant, 40, 'in force just before');
  assert.deepEqual(session.recipe.changes.map(({ set }) => set), [{ dampingConstant: 40 }]);
  store.undo();
  assert.equal(session.time, 1);
  assert.equal(session.recipe.changes.length, 0);
  store.redo();
  assert.equal(session.time, 2);
  store.redo();
  assert.equal(session.time, 0.5, 'where it stood when that was undone');
  assert.equal(store.state.parameters.dampingConstant, 20);
  session.seek(2.5);
  assert.equal(store.state.parameters.dampingConstant, 80, 'with all that was done ahead of it');
});

test('undo of what was done in the past brings back all that it had put an end to', () => {
  const { store, session } = opened();
  session.advance(0.3);
  session.kick();
  session.advance(0.3);
  const late = [...session.scene(wanted).state];
  session.seek(0.1);
  session.kick();
  session.advance(0.1);
  store.undo();
  assert.ok(Math.abs(session.time - 0.1) < 1e-12);
  session.seek(0.6);
  assert.ok(isClose(session.scene(wanted).state, late, 1e-6));
  assert.deepEqual(session.recipe.changes.map(({ time }) => time), [0.3]);
});

test('of two blows at one instant undo takes the last, and redo gives it back', () => {
  const { store, session } = opened();
  session.advance(0.2);
  const states = [[...session.scene(wanted).state]];
  for (let i = 0; i < 3; i++) {
    session.kick();
    states.push([...session.scene(wanted).state]);
  }
  for (const i of [2, 1, 0]) {
    store.undo();
    assert.ok(isClose(session.scene(wanted).state, states[i]));
    assert.equal(session.recipe.changes.length, i);
  }
  for (const i of [1, 2, 3]) {
    store.redo();
    assert.ok(isClose(session.scene(wanted).state, states[i]));
    assert.equal(session.recipe.changes.length, i);
  }
});

test('a drag undone leaves nothing on record, and comes back whole', () => {
  const { store, session } = dragged();
  assert.equal(session.recipe.changes.length, 1);
  store.undo();
  assert.ok(Math.abs(session.time - 0.2) < 1e-12);
  assert.equal(session.recipe.changes.length, 0);
  store.redo();
  assert.equal(store.state.parameters.dampingConstant, 60);
  assert.ok(Math.abs(session.time - 0.6) < 1e-9);
});

test('a run begun again is taken back by undo to where it was, with all that had been done to it', () => {
  const { store, session } = opened();
  session.advance(0.1);
  session.set('dampingConstant', 60, null);
  session.advance(0.1);
  const before = [...session.scene(wanted).state];
  session.restart();
  assert.equal(session.time, 0);
  assert.equal(session.recipe.changes.length, 0);
  store.undo();
  assert.ok(Math.abs(session.time - 0.2) < 1e-12 && isClose(session.scene(wanted).state, before, 1e-6));
  assert.deepEqual(session.recipe.changes.map(({ set }) => set), [{ dampingConstant: 60 }]);
  store.redo();
  assert.equal(session.time, 0);
  assert.equal(store.state.parameters.dampingConstant, 60);
});

test('the ground behind comes back with the run', () => {
  const { store, session } = opened();
  session.advance(0.5);
  session.set('velocity', 10, null);
  session.advance(0.5);
  const { roll } = session.scene(wanted);
  assert.ok(Math.abs(roll - 45) < 1e-9);
  store.undo();
  assert.ok(Math.abs(session.scene(wanted).roll - 40) < 1e-9);
  session.advance(0.1);
  assert.ok(Math.abs(session.scene(wanted).roll - 48) < 1e-9);
  store.redo();
  assert.ok(Math.abs(session.scene(wanted).roll - 45) < 1e-9);
});

test('what lies further back than is remembered comes to the present', () => {
  const { store, session } = opened();
  session.advance(0.2);
  const before = [...session.scene(wanted).state];
  session.kick();
  for (let i = 0; i < 70; i++) session.advance(1);
  store.undo();
  assert.ok(session.time > 70);
  assert.ok(isClose(session.scene(wanted).state, before));
});

test('many changes do not confuse what undo goes back to', () => {
  const { store, session } = opened();
  for (let i = 0; i < 190; i++) {
    session.set('dampingConstant', 20 + (i % 7), null);
    session.advance(0.001);
  }
  for (let i = 189; i > 0; i--) {
    store.undo();
    assert.equal(store.state.parameters.dampingConstant, 20 + ((i - 1) % 7));
    assert.ok(Math.abs(session.time - i * 0.001) < 1e-9, `${i}: ${session.time}`);
  }
});

test('a value that stopped the run is undone to just before it', () => {
  const { store, session } = opened();
  session.advance(0.1);
  const before = [...session.scene(wanted).state];
  session.set('casterLength', 1e6, null);
  for (let i = 0; i < 100 && !session.failure; i++) session.advance(0.01);
  assert.ok(session.failure);
  store.undo();
  session.settle();
  assert.equal(session.failure, null);
  assert.ok(Math.abs(session.time - 0.1) < 1e-12 && isClose(session.scene(wanted).state, before));
});

test('a run is begun again from its recipe, with all that was done to it', () => {
  const { session } = opened();
  session.advance(0.1);
  session.set('dampingConstant', 60, null);
  session.advance(0.1);
  session.kick();
  session.advance(0.05);
  session.set('velocity', 60, null);
  session.advance(0.02);
  const { recipe } = session;
  assert.equal(recipe.parameters.dampingConstant, 20);
  assert.equal(recipe.changes.length, 3);
  const { store, session: other } = opened();
  const { time, changes, initial, parameters: start } = recipe;
  store.update({ parameters: { ...start, dampingConstant: 60, velocity: 60 }, run: { initial, start, changes, time } });
  assert.ok(Math.abs(other.time - session.time) < 1e-12);
  other.scene(wanted).state.forEach((value, i) => assert.ok(Math.abs(value - session.scene(wanted).state[i]) < 1e-7 * Math.max(1, Math.abs(value))));
  assert.equal(other.scene(wanted).parameters.velocity, 60);
});

test('a knob dragged twice, or a wheel twisted twice, is on record twice, and begins again as it was', () => {
  const { session } = opened();
  session.advance(0.1);
  for (const values of [[40, 60], [30, 25]]) {
    for (const c of values) session.set('dampingConstant', c, 'dampingConstant drag');
    session.settle();
    session.advance(0.3);
  }
  for (const angle of [0.2, -0.1]) {
    session.hold(angle);
    session.letGo();
    session.advance(0.05);
  }
  const { recipe } = session;
  assert.deepEqual(recipe.changes.map(({ set, state }) => set?.dampingConstant ?? state?.torsionAngle), [60, 25, 0.2, -0.1]);
  const { parameters: start, ...run } = recipe;
  const { store, session: again } = opened();
  store.update({ parameters: { ...start, dampingConstant: 25 }, run: { start, initial: run.initial, changes: run.changes, time: run.time } });
  again.seek(0.35);
  session.seek(0.35);
  assert.ok(isClose(again.scene(wanted).state, session.scene(wanted).state, 1e-6), 'between the two as well');
});
