import { test } from 'node:test';
import assert from 'node:assert/strict';
import { Store } from '../../www/store.js';

/** @returns {import('../../www/store.js').State} */
const opening = () => ({
  object: 'torsional',
  parameters: { velocity: 80, dampingConstant: 20 },
  run: { initial: { torsionAngle: 0.05 } },
  links: {},
  ghosts: [],
  clock: { mode: 'slow', slow: null },
  lens: 'phase',
  views: {},
  story: null,
  predict: null,
  isBig: false,
  velocityUnit: 'm/s',
  language: 'en',
  theme: 'system',
});

/** @param {Store} store @param {number} c @param {string | null} [gesture] */
const damp = (store, c, gesture = null) =>
  store.update({ parameters: { ...store.state.parameters, dampingConstant: c } }, gesture);

test('one drag is one undo', () => {
  const store = new Store(opening());
  for (const c of [21, 25, 30, 60]) damp(store, c, 'c');
  store.settle();
  for (const c of [59, 58]) damp(store, c, 'c');
  assert.equal(store.state.parameters.dampingConstant, 58);
  store.undo();
  assert.equal(store.state.parameters.dampingConstant, 60);
  store.undo();
  assert.equal(store.state.parameters.dampingConstant, 20);
  assert.ok(!store.canUndo);
  store.redo();
  store.redo();
  assert.equal(store.state.parameters.dampingConstant, 58);
  assert.ok(!store.canRedo);
});

test('two knobs are two steps, and a new change ends what could be redone', () => {
  const store = new Store(opening());
  damp(store, 30, 'c');
  store.update({ parameters: { ...store.state.parameters, velocity: 50 } }, 'v');
  store.undo();
  assert.equal(store.state.parameters.velocity, 80);
  assert.equal(store.state.parameters.dampingConstant, 30);
  assert.ok(store.canRedo);
  damp(store, 40);
  assert.ok(!store.canRedo);
});

test('how it is looked at is kept through undo', () => {
  const store = new Store(opening());
  damp(store, 30);
  store.update({ language: 'tr', theme: 'dark' });
  assert.ok(store.canUndo);
  store.undo();
  assert.equal(store.state.language, 'tr');
  assert.equal(store.state.parameters.dampingConstant, 20);
  assert.ok(!store.canUndo);
});

test('a change to the same value is no step, and following the run is none either', () => {
  const store = new Store(opening());
  damp(store, 20);
  store.follow({ parameters: { velocity: 70, dampingConstant: 20 } });
  assert.ok(!store.canUndo);
  assert.equal(store.state.parameters.velocity, 70);
});

test('an experiment that is opened is one step of undo, and its look comes back with it', () => {
  const store = new Store(opening());
  damp(store, 30, 'c');
  store.open({ parameters: { velocity: 50, dampingConstant: 10 }, run: { initial: { torsionAngle: 0.01 } }, lens: 'forces', views: { forces: 'restoring' }, story: { name: 'one', step: 0 } });
  damp(store, 11, 'c');
  store.update({ lens: 'phase' });
  store.undo();
  assert.deepEqual([store.state.parameters.dampingConstant, store.state.lens], [10, 'phase'], 'a look alone is no step');
  store.undo();
  assert.deepEqual([store.state.parameters.dampingConstant, store.state.lens, store.state.views, store.state.story], [30, 'phase', {}, null]);
  store.redo();
  assert.deepEqual([store.state.parameters.velocity, store.state.lens, store.state.views], [50, 'phase', { forces: 'restoring' }]);
  store.update({ language: 'tr' });
  store.undo();
  assert.equal(store.state.language, 'tr');
});

test('opening the same experiment anew is no step', () => {
  const store = new Store(opening());
  store.open({ lens: 'forces' });
  assert.equal(store.state.lens, 'forces');
  assert.ok(!store.canUndo);
});

test('the run as far as it has come takes the place of its start, in all steps that share it, unheard', () => {
  const store = new Store(opening());
  const first = store.state.run;
  damp(store, 30);
  const second = { initial: { torsionAngle: 0.2 } };
  store.update({ run: second });
  damp(store, 40);
  let heard = 0;
  store.subscribe(() => heard++);
  const kept = { ...second, changes: [], time: 0.3 };
  store.keepRun(kept);
  assert.equal(heard, 0);
  assert.equal(store.state.run, kept);
  store.undo();
  assert.equal(store.state.run, kept);
  store.undo();
  assert.equal(store.state.run, first, 'another run stays what it was');
});

test('subscribers hear the state and the one before it until they leave', () => {
  const store = new Store(opening());
  /** @type {number[][]} */
  const heard = [];
  const leave = store.subscribe((now, before) => heard.push([before.parameters.dampingConstant, now.parameters.dampingConstant]));
  damp(store, 30);
  store.undo();
  leave();
  damp(store, 50);
  assert.deepEqual(heard, [[20, 30], [30, 20]]);
});

test('what was done to the run is a step of undo, which goes to where the run was before; redo goes to where it had come to', () => {
  const store = new Store(opening());
  /** @type {(import('../../www/store.js').Place | null)[]} */
  const gone = [];
  store.subscribe((_, __, place) => place && gone.push(place));
  const [first, second, third] = [0.2, 0.3, 0.4].map((time) => placeAt(time));
  damp(store, 30, 'c');
  store.did(first);
  damp(store, 40, 'c');
  store.undo();
  assert.equal(store.state.parameters.dampingConstant, 30, 'a deed ends the gesture');
  assert.deepEqual(gone, [], 'a value set without a run goes nowhere');
  store.here = () => second;
  store.undo();
  assert.equal(store.state.parameters.dampingConstant, 30);
  assert.deepEqual(gone, [first]);
  store.here = () => third;
  store.redo();
  assert.deepEqual(gone, [first, second]);
  store.undo();
  assert.deepEqual(gone, [first, second, first], 'however often');
});

/** @param {number} time @returns {import('../../www/store.js').Place} */
function placeAt(time) {
  const start = { parameters: {}, initial: {} };
  return { object: 'torsional', start, changes: [], isWhole: true, time, latest: time, state: {}, parameters: {}, legs: [] };
}
