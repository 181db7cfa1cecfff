// Values set in the running gear: all of them or none, those that follow with them, and a wild one that stops it.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { defaults, opened, wanted } from './opened-session.mjs';

test('a refused value changes nothing and says why', () => {
  const { store, session } = opened();
  const refusal = session.set('velocity', -3, null);
  assert.equal(refusal?.code, 'out-of-range');
  assert.equal(refusal?.allowed, '> 0 m/s');
  assert.equal(store.state.parameters.velocity, 80);
  assert.ok(!store.canUndo);
});

test('of several values set at once one that is refused lets none through', () => {
  const { store, session } = opened();
  session.advance(0.1);
  const refusal = session.setPoint({ dampingConstant: 60, velocity: -3 }, null);
  assert.equal(refusal?.allowed, '> 0 m/s');
  assert.equal(session.scene(wanted).parameters.dampingConstant, 20);
  assert.equal(store.state.parameters.dampingConstant, 20);
  assert.ok(!store.canUndo && session.recipe.changes.length === 0);
  assert.equal(session.setPoint({ dampingConstant: 60, velocity: 50 }, null), null);
  store.undo();
  assert.deepEqual([store.state.parameters.dampingConstant, store.state.parameters.velocity], [20, 80]);
});

test('a value that is in force already is nothing done: neither undo nor a link has it', () => {
  const { store, session } = opened();
  session.advance(0.1);
  assert.equal(session.set('velocity', 80, null), null);
  assert.equal(session.setPoint({ velocity: 80, dampingConstant: 20 }, null), null);
  assert.ok(!store.canUndo);
  assert.deepEqual([session.recipe.changes, store.state.links], [[], opened().store.state.links]);
  session.setPoint({ velocity: 80, dampingConstant: 33 }, null);
  assert.deepEqual(session.recipe.changes, [{ time: 0.1, set: { dampingConstant: 33 } }]);
  assert.equal(session.set('velocity', NaN, null)?.code, 'not-finite');
});

test('a wild value stops the run without a throw, and the next one finds the motion as it was', () => {
  for (const [name, value] of /** @type {[string, number][]} */ ([['casterLength', 1e6], ['relaxationLength', 1e-300]])) {
    const { session } = opened();
    session.advance(0.2);
    const before = [...session.scene(wanted).state];
    session.set(name, value, null);
    session.settle();
    for (let i = 0; i < 100 && !session.failure; i++) session.advance(0.01);
    assert.ok(session.failure, `${name} = ${value} can be computed`);
    session.settle();
    session.kick();
    session.set(name, defaults[name], null);
    session.settle();
    assert.equal(session.failure, null);
    assert.ok(Math.abs(session.time - 0.2) < 1e-12);
    session.scene(wanted).state.forEach((now, i) => assert.ok(Math.abs(now - before[i]) < 1e-9 * Math.max(1, Math.abs(now))));
    assert.equal(session.outlook.verdict, 'shimmies');
  }
});

test('values that follow others follow while they are joined', () => {
  const { store, session } = opened();
  store.follow({ links: { relaxationLength: true, treadWidthMomentConstant: true } });
  session.set('halfContactLength', 0.12, null);
  assert.ok(Math.abs(store.state.parameters.relaxationLength - 0.36) < 1e-12);
  assert.ok(Math.abs(store.state.parameters.treadWidthMomentConstant - 0.15 * 0.0144 * 20 * 9000) < 1e-9);
  session.set('relaxationLength', 0.5, null);
  assert.equal(store.state.links.relaxationLength, false, 'a hand parts them');
  session.set('halfContactLength', 0.1, null);
  assert.equal(store.state.parameters.relaxationLength, 0.5);
  assert.ok(Math.abs(store.state.parameters.treadWidthMomentConstant - 270) < 1e-9);
  session.toggleLink('relaxationLength');
  assert.ok(Math.abs(store.state.parameters.relaxationLength - 0.3) < 1e-12, 'joined again, it follows at once');
});

test('a point sets its values alone, parts what would follow them, is one undo a drag, and is set whole or not at all', () => {
  const { store, session } = opened();
  store.follow({ links: { relaxationLength: true, treadWidthMomentConstant: true } });
  const before = store.state.parameters;
  for (const halfContactLength of [0.11, 0.12, 0.13]) assert.equal(session.setPoint({ halfContactLength, velocity: 40 }, 'point drag 1'), null);
  assert.deepEqual(store.state.parameters, { ...before, halfContactLength: 0.13, velocity: 40 });
  assert.deepEqual(store.state.links, { relaxationLength: false, treadWidthMomentConstant: false });
  const refusal = session.setPoint({ velocity: -1, dampingConstant: 60 }, null);
  assert.match(String(refusal), /velocity/);
  assert.deepEqual(store.state.parameters, { ...before, halfContactLength: 0.13, velocity: 40 });
  assert.equal(session.scene(wanted).parameters.dampingConstant, before.dampingConstant);
  store.undo();
  assert.deepEqual(store.state.parameters, before);
  assert.deepEqual(store.state.links, { relaxationLength: true, treadWidthMomentConstant: true });
});
