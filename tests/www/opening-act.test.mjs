// The first ten seconds, frame by frame, over the real engine: what is said is true when it is said.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import init, * as engine from '../../www/pkg/shimmy.js';
import { App } from '../../www/app.js';
import { OpeningAct } from '../../www/present/opening-act.js';
import { numbersOf } from '../../www/stage/verdict-line.js';

await init({ module_or_path: await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)) });
const degrees = 180 / Math.PI;

/** A page as it opens for a new visitor. @param {{ isStill?: boolean, addresses?: string[] }} [how] */
function opened({ isStill = false, addresses = [''] } = {}) {
  const app = new App();
  app.open(engine, addresses, { isStill });
  return { app, session: /** @type {import('../../www/run/session.js').Session} */ (app.session) };
}

/**
 * Frames of a sixtieth, as the loop lets them go by, and what was seen at each whole second.
 * @param {App} app
 * @param {number} seconds
 */
function play(app, seconds) {
  const { clock, session } = app;
  assert.ok(session);
  const seen = [];
  for (let frame = 0; frame <= 60 * seconds; frame++) {
    const now = 100 + frame / 60;
    session.advance(clock.elapse(now));
    app.act?.elapse(now, clock.isPlaying);
    if (frame % 60 > 0) continue;
    session.refresh();
    // The swing of the cycle gone by, as the page shows it.
    seen.push({ moment: app.act?.moment, swing: session.seen.present.amplitude * degrees, verdict: session.outlook.verdict, numbers: numbersOf(session.seen, app.voice).map(({ text }) => text) });
  }
  return seen;
}

test('second by second: the wheel, its swing, the sentence, ±10°, one breath, silence, and what to try', () => {
  const { app, session } = opened();
  assert.deepEqual([app.clock.rate, app.state.parameters.velocity, app.state.parameters.dampingConstant], [50, 80, 20]);
  assert.deepEqual(session.recipe.initial, { torsionAngle: 0.05 });
  const seen = play(app, 12);
  assert.deepEqual(seen.map(({ moment }) => moment),
    ['wheel', 'wheel', 'wheel', 'sentence', 'sentence', 'sentence', 'sentence', 'sentence', 'breath', 'breath', 'breath', 'breath', 'over']);
  // At 1 s: the pointer at the protractor's radius of 0.5 m has gone over 15 of the sheet's pixels of 330 a meter.
  assert.equal(session.scales.magnification, 1);
  assert.ok((2 * seen[1].swing / degrees) * 0.5 * 330 > 15, `±${seen[1].swing}°`);
  // At 6 s: ±10°, in whole degrees.
  assert.equal(Math.round(seen[6].swing), 10);
  assert.ok(seen.every(({ verdict }) => verdict === 'shimmies'));
  assert.match(seen[6].numbers[0], /^±(9\.[5-9]|10\.[0-4])° and growing$/);
  assert.ok(seen.slice(2).every(({ swing }, i) => swing > seen[i + 1].swing), 'it grows all the time');
});

test('a hidden page misses nothing: what was not seen does not count', () => {
  const act = new OpeningAct();
  act.elapse(0, true);
  act.elapse(60, true);
  assert.equal(act.moment, 'wheel');
  act.elapse(61, false);
  act.elapse(70, true);
  assert.equal(act.moment, 'wheel');
});

test('each moment begins once', () => {
  const act = new OpeningAct();
  let begun = 0;
  for (let frame = 0; frame <= 900; frame++) begun += Number(act.elapse(frame / 60, true));
  assert.equal(begun, 3);
});

test('any command ends it', () => {
  const { app } = opened();
  play(app, 4);
  assert.equal(app.act?.moment, 'sentence');
  app.run('kick');
  assert.equal(app.act, null);
});

test('only a fresh page plays it: what a link or an earlier visit brings is shown as it is', () => {
  assert.ok(opened().app.act);
  for (const address of ['#shimmy=2&velocity=80&dampingConstant=20&initial.torsionAngle=0.05', '?velocity=70'])
    assert.equal(opened({ addresses: ['', address] }).app.act, null);
});

test('a page that must not move stands at the last of it', () => {
  const { app, session } = opened({ isStill: true });
  assert.equal(app.act, null);
  assert.ok(!app.clock.isPlaying);
  assert.ok(Math.abs(session.time - OpeningAct.end / 50) < 1e-12);
  assert.ok(session.seen.present.amplitude * degrees > 10);
  const { past, future } = session.scene({ moment: [-0.08, 0.02], trackLength: 1, stretches: 200, exposure: 0 }).run;
  assert.ok(past.time.length > 5 && future.time.length > 5, 'the whole run is drawn');
});
