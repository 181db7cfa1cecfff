// The timeline's two lanes, drawn from a run of the engine.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import init, * as engine from '../../www/pkg/shimmy.js';
import { App } from '../../www/app.js';
import { drawTimeline } from '../../www/stage/draw-timeline.js';
import { lanesOf } from '../../www/stage/lanes.js';
import { voiceOf } from '../../www/words/voice.js';
import { recordingContext, written } from './plot-recorder.mjs';
import { theme } from './theme.mjs';

await init({ module_or_path: await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)) });

const size = { width: 836, height: 148 };
const lanes = lanesOf(size, theme);
/** @type {[number, number]} */
const moment = [-0.08, 0.02];

/** @param {{ exposure?: number, isPinned?: boolean }} [options] */
function scene({ exposure = 0, isPinned = false } = {}) {
  const app = new App();
  app.open(engine, [], { isStill: false });
  const { session } = app;
  assert.ok(session);
  session.advance(0.2);
  if (isPinned) {
    app.run('pin');
    session.set('dampingConstant', 60, null);
    session.advance(0.05);
  }
  return session.scene({ moment, trackLength: 1, stretches: 200, exposure });
}

/** @param {Partial<Parameters<typeof drawTimeline>[2]>} [more] */
function drawn(more = {}, at = lanes) {
  const recorder = recordingContext();
  drawTimeline(recorder.context, at, { scene: scene(), moment, shown: 'torsionAngle', cursors: [], labels: [], isVeiled: false, ...more }, theme, voiceOf('en'));
  return recorder;
}

const dot = (/** @type {ReturnType<typeof drawn>} */ { named }) => named('arc').length;
const dotted = (/** @type {ReturnType<typeof drawn>} */ { named }) =>
  named('lineTo').filter(({ style }) => style.strokeStyle === theme.psi && style.dash.length > 0).length;

test('what comes is drawn at once, dotted, and said; veiled, neither', () => {
  const open = drawn();
  assert.ok(dotted(open) > 20);
  assert.ok(written(open.named('fillText')).includes('what comes if nothing changes'));
  const veiled = drawn({ isVeiled: true });
  assert.equal(dotted(veiled), 0);
  assert.ok(!written(veiled.named('fillText')).includes('what comes if nothing changes'));
  assert.equal(written(veiled.named('fillText')).filter((text) => text === '?').length, 2, 'a veil on each lane');
});

test('each state is drawn on its own axis, with the point of now on the curve', () => {
  for (const [shown, value, limit] of /** @type {const} */ ([['torsionAngle', 0, 'angle'], ['torsionRate', 1, 'rate'], ['lateralDeformation', 2, 'deformation']])) {
    const now = scene();
    const { named } = drawn({ shown });
    const height = named('arc').at(-1)?.args[1];
    const { top, bottom } = lanes.moment;
    const share = (bottom - height) / (bottom - top);
    assert.ok(Math.abs(share - (0.5 + now.state[value] / (2 * now.scales.limits[limit]))) < 1e-6, shown);
  }
});

test('where the motion is too fast for the screen the lane is a blur without a point', () => {
  assert.equal(dot(drawn()), 1);
  const blurred = drawn({ scene: scene({ exposure: 1 / 60 }) });
  assert.equal(dot(blurred), 0);
  const past = blurred.named('moveTo').filter(({ style }) => style.strokeStyle === theme.psi && style.dash.length === 0);
  assert.equal(past.length, 16, 'as many positions as the gear has poses');
  assert.ok(past.every(({ style }) => style.globalAlpha < 0.2));
  const shift = past[15].args[0] - past[0].args[0];
  const { left, right } = lanes.moment;
  assert.ok(Math.abs(shift - ((15 / 16) * (1 / 60) / 0.1) * (right - left)) < 1e-6, 'spread over the exposure');
});

test('a ghost is dashed beside the run, and what cursors read stands in the corner of the words', () => {
  const pinned = scene({ isPinned: true });
  const { named } = drawn({ scene: pinned, labels: ['c = 20'] });
  assert.ok(named('lineTo').some(({ style }) => style.strokeStyle === theme.ghost && style.dash.length > 0));
  const words = written(drawn({ cursors: [-0.02] }).named('fillText'));
  assert.ok(words.some((text) => text.startsWith('20 ms ago · ')));
  assert.ok(!words.includes('what comes if nothing changes'));
});

test('a low timeline has the lower lane alone', () => {
  const low = lanesOf({ width: 390, height: 84 }, theme);
  assert.equal(low.run, null);
  assert.ok(low.moment.bottom - low.moment.top > 50);
  assert.ok(!written(drawn({}, low).named('fillText')).includes('run'));
});
