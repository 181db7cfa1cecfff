// Opening stories, walking them, and coming back: over the real engine, without a page.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { presets } from '../../www/story/presets.js';
import { isAnswered, neighbor, told } from '../../www/story/player.js';
import { openedApp, sessionOf } from './stories.mjs';

/** @param {import('../../www/app.js').App} app */
const seen = (app) => {
  const { object, parameters, links, ghosts, clock, lens, views, story } = app.state;
  return structuredClone({ object, parameters, links, ghosts, clock, lens, views, story, time: sessionOf(app).time, state: [...sessionOf(app).scene(wanted).state], verdict: sessionOf(app).outlook.verdict });
};
const wanted = { moment: /** @type {[number, number]} */ ([-0.08, 0.02]), trackLength: 1.2, stretches: 60, exposure: 0 };

/** A visitor's own experiment, changed on the way. @param {import('../../www/app.js').App} app */
function tinker(app) {
  const session = sessionOf(app);
  session.advance(0.2);
  session.set('dampingConstant', 33, null);
  session.settle();
  session.advance(0.1);
  session.kick();
  session.advance(0.05);
  app.run('pin');
  session.advance(0.03);
  app.run('lens', 'phase');
  app.run('rate', { mode: 'slow', slow: 100 });
  app.run('view', { of: 'timeline', shows: 'lateralDeformation' });
}

test('a story puts its whole setting on the page, and plays', () => {
  const app = openedApp();
  tinker(app);
  app.run('pause');
  app.isDrawerOpen = true;
  app.run('open', 'freeplay');
  app.run('next');
  const { object, parameters, ghosts, clock, views, story } = app.state;
  assert.equal(object, 'torsional');
  assert.equal(parameters.velocity, 50);
  assert.equal(parameters.freeplayAngle, Math.PI / 180);
  assert.deepEqual({ ghosts, clock, views, story }, { ghosts: [], clock: { mode: 'slow', slow: null }, views: {}, story: { name: 'freeplay', step: 1 } });
  assert.equal(sessionOf(app).outlook.verdict, 'rattles');
  assert.equal(sessionOf(app).time, 0);
  assert.ok(app.clock.isPlaying);
  assert.ok(!app.isDrawerOpen);
});

test('back to what you had is back to the instant, with the look of it', () => {
  const app = openedApp();
  tinker(app);
  app.run('pause');
  app.run('magnify', 5);
  const before = seen(app);
  for (const command of ['cure', 'linear']) app.run('open', command);
  app.run('next');
  app.run('comeBack');
  assert.deepEqual(seen(app), before);
  assert.ok(!app.clock.isPlaying);
  assert.equal(sessionOf(app).scales.magnification, 5);
  assert.equal(app.left, null);
});

test('what a visitor made of a story is kept when the next one opens; an untouched story is not', () => {
  const app = openedApp();
  app.run('open', 'cure');
  sessionOf(app).advance(0.1);
  app.run('open', 'linear');
  assert.equal(app.left?.state.story, null, 'still what was there before the first story');
  app.run('open', 'cure');
  sessionOf(app).set('dampingConstant', 17, null);
  sessionOf(app).advance(0.1);
  app.run('open', 'linear');
  app.run('comeBack');
  assert.deepEqual(app.state.story, { name: 'cure', step: 0 });
  assert.equal(app.state.parameters.dampingConstant, 17);
});

test('undo goes back through an opening, with its look, and on to the changes before it', () => {
  const app = openedApp();
  tinker(app);
  const before = seen(app);
  app.run('open', 'limit-cycle');
  sessionOf(app).advance(0.2);
  app.run('undo');
  assert.deepEqual(seen(app), before);
  app.run('undo');
  assert.equal(app.state.ghosts.length, 0, 'the pinned ghost');
  app.run('undo');
  app.run('undo');
  assert.equal(app.state.parameters.dampingConstant, 20, 'the damping');
  assert.ok(sessionOf(app).time > 0, 'in the run as it goes, not from its start');
  for (let i = 0; i < 4; i++) app.run('redo');
  assert.equal(app.state.story?.name, 'limit-cycle');
  assert.deepEqual(app.state.views, { phase: 'portrait' });
});

test('coming back can be undone', () => {
  const app = openedApp();
  app.run('open', 'cure');
  sessionOf(app).advance(0.1);
  app.run('comeBack');
  assert.equal(app.state.story, null);
  app.run('undo');
  assert.deepEqual(app.state.story, { name: 'cure', step: 0 });
  assert.ok(Math.abs(sessionOf(app).time - 0.1) < 1e-12);
});

test('a step that goes on keeps the run, where nothing was done to it', () => {
  const app = openedApp();
  app.run('open', 'cure');
  sessionOf(app).advance(0.4);
  app.run('next');
  assert.equal(app.state.parameters.dampingConstant, 30);
  assert.ok(sessionOf(app).time > 0.39, 'the swing shrinks before one’s eyes');
  app.run('previous');
  assert.equal(sessionOf(app).time, 0, 'back begins anew');
  sessionOf(app).advance(0.4);
  sessionOf(app).set('velocity', 60, null);
  app.run('next');
  assert.equal(sessionOf(app).time, 0);
  assert.equal(app.state.parameters.velocity, 80);
});

test('the keys of a clicker walk all presets, forth and back', () => {
  const app = openedApp();
  app.commands = { ...app.commands, predict: () => {} };
  const way = [];
  for (let i = 0; i < 200 && (i === 0 || neighbor(app, 1)); i++) {
    app.run('next');
    // A question takes two presses.
    if (app.state.story) way.push(`${app.state.story.name} ${app.state.story.step}`);
  }
  const all = presets.flatMap(({ name, steps }) => steps.flatMap(({ asks }, i) => (asks ? [`${name} ${i}`, `${name} ${i}`] : [`${name} ${i}`])));
  assert.deepEqual(way, all);
  app.run('next');
  assert.deepEqual(app.state.story, { name: presets.at(-1)?.name, step: (presets.at(-1)?.steps.length ?? 0) - 1 });
  for (let i = 0; i < 200; i++) app.run('previous');
  assert.deepEqual(app.state.story, { name: 'first-look', step: 0 });
});

test('a question is asked before it is answered', () => {
  const app = openedApp();
  const asked = /** @type {string[]} */ ([]);
  app.commands = { ...app.commands, predict: () => asked.push(`c = ${app.state.parameters.dampingConstant}`) };
  app.run('open', 'cure');
  app.run('next');
  app.run('next');
  assert.deepEqual(app.state.story, { name: 'cure', step: 2 });
  assert.ok(told(app)?.step.asks && !isAnswered(app));
  app.run('next');
  assert.deepEqual(asked, ['c = 30'], 'veiled before the value changes');
  assert.equal(app.state.parameters.dampingConstant, 60);
  assert.ok(isAnswered(app));
  const { time } = sessionOf(app);
  app.run('next');
  assert.deepEqual(app.state.story, { name: 'cure', step: 3 });
  assert.ok(sessionOf(app).time >= time, 'the answered run goes on');
});

test('figures are walked as figures', () => {
  const app = openedApp();
  app.run('open', 'figure-5.87');
  app.run('next');
  assert.equal(app.state.story?.name, 'figure-5.88a');
  app.run('previous');
  app.run('previous');
  assert.equal(app.state.story?.name, 'figure-5.86');
  app.run('open', 'figure-5.59');
  app.run('previous');
  assert.equal(app.state.story?.name, 'figure-5.58');
  app.run('open', 'figure-5.5');
  assert.equal(neighbor(app, -1), null);
  app.run('previous');
  assert.equal(app.state.story?.name, 'figure-5.5');
});

test('what cannot be opened yet is not opened', () => {
  const app = openedApp();
  const before = app.state;
  for (const name of ['figure-5.2', 'figure-5.3', 'nothing', '__proto__']) app.run('open', name);
  assert.equal(app.state, before);
  assert.equal(app.left, null);
});

test('a link carries the story and its step; one that is not known is told', () => {
  const app = openedApp();
  app.run('open', 'growing');
  app.run('next');
  const again = openedApp(app.link);
  assert.deepEqual(again.state.story, { name: 'growing', step: 1 });
  assert.deepEqual(again.state.clock, { mode: 'strobe', slow: null });
  assert.equal(told(again)?.at, 1);
  assert.equal(again.left, null);
  const lost = openedApp('#shimmy=2&velocity=70&story=nothing,3');
  assert.equal(lost.state.story, null);
  assert.match(lost.notes[0].text, /story nothing \(unknown\)/);
  const beyond = openedApp('#shimmy=2&velocity=70&story=cure,99');
  assert.equal(told(beyond)?.at, 3);
});

test('a link that is opened in a running page can be left again', () => {
  const app = openedApp();
  tinker(app);
  const before = seen(app);
  app.openLink('#shimmy=2&velocity=33&initial.torsionAngle=0.1&lens=phase');
  assert.equal(app.state.parameters.velocity, 33);
  app.run('comeBack');
  assert.deepEqual(seen(app), before);
});

test('without motion a story is shown paused, with its run drawn as far as it settles', () => {
  const app = openedApp();
  app.isStill = true;
  app.clock.pause();
  app.run('open', 'limit-cycle');
  assert.ok(!app.clock.isPlaying);
  assert.ok(sessionOf(app).time > 0.3);
});

test('another object keeps the values and the start that both have', () => {
  const app = openedApp();
  const session = sessionOf(app);
  session.set('velocity', 66, null);
  session.set('freeplayAngle', 0.01, null);
  session.advance(0.2);
  const before = seen(app);
  app.run('object', 'torsional-linear');
  assert.equal(app.state.object, 'torsional-linear');
  assert.equal(app.state.parameters.velocity, 66);
  assert.ok(!('freeplayAngle' in app.state.parameters));
  assert.deepEqual(app.state.run, { initial: { torsionAngle: 0.05 } });
  assert.equal(sessionOf(app).outlook.verdict, 'grows');
  app.run('undo');
  assert.deepEqual(seen(app), before);
});

test('a story chooses the knobs, the first for the thumb', () => {
  const app = openedApp();
  assert.deepEqual(app.knobs, []);
  app.run('open', 'caster');
  assert.deepEqual(app.knobs, ['casterLength', 'velocity', 'dampingConstant', 'torsionalStiffness']);
  assert.equal(app.knobs, app.knobs, 'the same list each time, or the dock would forget a choice');
  app.run('endStory');
  assert.deepEqual(app.knobs, []);
  assert.equal(app.knobs, app.knobs);
});

test('reset all ends the story', () => {
  const app = openedApp();
  app.run('open', 'linear');
  app.run('resetAll');
  assert.equal(app.state.story, null);
  assert.equal(app.state.object, 'torsional');
});

test('a hand lets go of the wheel before a story opens', () => {
  const app = openedApp();
  app.run('hold', 0.2);
  assert.ok(sessionOf(app).isHeld);
  app.run('open', 'cure');
  assert.ok(!sessionOf(app).isHeld);
  app.run('comeBack');
  assert.ok(Math.abs(sessionOf(app).scene(wanted).state[0] - 0.2) < 1e-12, 'and what it held comes back');
});

test('Reset all is undone to the instant, with what was done to the run', () => {
  const app = openedApp();
  const session = sessionOf(app);
  session.advance(0.1);
  session.set('dampingConstant', 30, null);
  session.advance(0.05);
  session.kick();
  session.advance(0.02);
  const before = [session.time, ...session.scene(wanted).state];
  app.run('resetAll');
  assert.equal(session.time, 0);
  app.run('undo');
  [session.time, ...session.scene(wanted).state].forEach((value, i) => assert.ok(Math.abs(value - before[i]) < 1e-6 * Math.max(1, Math.abs(before[i]))));
  assert.equal(app.state.parameters.dampingConstant, 30);
});
