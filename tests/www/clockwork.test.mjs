// The clock and a hand on the wheel, as the page carries them out: over the real engine, without a browser.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import init, * as engine from '../../www/pkg/shimmy.js';
import { App } from '../../www/app.js';

await init({ module_or_path: await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)) });

function opened() {
  const app = new App();
  app.open(engine, [], { isStill: false });
  const { session } = app;
  assert.ok(session);
  session.advance(0.1);
  return { app, session };
}

/** @type {Parameters<import('../../www/run/session.js').Session['scene']>[0]} */
const wanted = { moment: [-0.08, 0.02], trackLength: 1.2, stretches: 200, exposure: 0 };

test('whatever takes the run elsewhere lets go of the wheel first, as one step of undo', () => {
  for (const [name, value] of /** @type {[string, unknown][]} */ ([['seek', 0.05], ['back', undefined], ['start', undefined], ['rest', undefined], ['kick', undefined]])) {
    const { app, session } = opened();
    app.run('hold', 0.1);
    app.run(name, value);
    assert.ok(!session.isHeld, name);
    assert.ok(app.store.canUndo, name);
  }
});

test('undo while the wheel is held takes back the hold and nothing before it', () => {
  const { app, session } = opened();
  const before = [...session.scene(wanted).state];
  app.run('kick');
  const kicked = [...session.scene(wanted).state];
  app.run('hold', 0.15);
  app.run('undo');
  assert.ok(!session.isHeld);
  assert.deepEqual([...session.scene(wanted).state], kicked);
  app.run('undo');
  assert.deepEqual([...session.scene(wanted).state], before);
});

test('the magnification stays while the wheel is held, however far it is turned', () => {
  const { app, session } = opened();
  app.run('magnify', 10);
  app.run('hold', 0.4);
  session.refresh();
  assert.equal(session.scales.magnification, 10);
});

test('a value changed under a held wheel stays when the hold is undone', () => {
  const { app, session } = opened();
  app.run('hold', 0.1);
  session.set('dampingConstant', 60, 'drag');
  session.settle();
  session.advance(0.01);
  app.run('release');
  app.run('undo');
  assert.equal(app.state.parameters.dampingConstant, 60);
  assert.equal(session.scene(wanted).parameters.dampingConstant, 60);
  assert.ok(Math.abs(session.time - 0.1) < 1e-12);
  app.run('undo');
  assert.equal(session.scene(wanted).parameters.dampingConstant, 20);
});

test('where less motion is asked for time goes slowly, whatever the state says, and no more when it is not', () => {
  const app = new App();
  app.open(engine, ['#shimmy=2&initial.torsionAngle=0.05&clock=strobe'], { isStill: true });
  assert.equal(app.state.clock.mode, 'strobe');
  assert.equal(app.clock.mode, 'slow');
  app.run('rate', { mode: 'real' });
  assert.equal(app.clock.mode, 'slow');
  app.beStill(false);
  assert.equal(app.clock.mode, 'real');
});

test('the strobe locks to the beat of now, and to none where the wheel does not swing', () => {
  const { app, session } = opened();
  app.run('rate', { mode: 'strobe' });
  const { frequency } = session.outlook.present;
  assert.ok(frequency && Math.abs((app.clock.period ?? 0) - 1 / frequency) < 1e-12);
  app.run('rest');
  app.lockStrobe();
  assert.equal(app.clock.period, null);
});

test('the magnification chosen by hand outlives the run, and is given back to it', () => {
  const { app, session } = opened();
  const { magnification } = session.scales;
  app.run('magnify', 20);
  assert.equal(session.scales.magnification, 20);
  app.run('start');
  app.run('fit');
  assert.equal(session.scales.magnification, 20);
  assert.match(app.link, /view\.magnification=20/);
  app.run('magnify', null);
  assert.equal(session.scales.magnification, magnification);
  assert.doesNotMatch(app.link, /magnification/);
});

test('a sheet with four ghosts takes no fifth and says so', () => {
  const { app } = opened();
  for (let i = 0; i < 5; i++) app.run('pin');
  assert.equal(app.state.ghosts.length, 4);
  assert.match(app.notes[0].text, /^4 ghosts are on the sheet/);
});
