// Basins: endings as colors and words, cells that are not known yet, the picture, and the start that a hand drags.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { colorsOfEndings, endingInWords, spread, swingsOn } from '../../www/lens/cycles/endings.js';
import { twoEndings } from '../../www/story/presets.js';
import { drawBasins, placesOfBasins } from '../../www/view/basins.js';
import { voiceOf } from '../../www/words/voice.js';
import { opened, wanted } from './opened-session.mjs';
import { recordingContext, written } from './plot-recorder.mjs';
import { engine } from './stories.mjs';
import { theme } from './theme.mjs';

const [english, turkish] = [voiceOf('en'), voiceOf('tr')];
const degree = Math.PI / 180;

/** @param {number} got @param {number} expected @param {number} error */
const near = (got, expected, error) => assert.ok(Math.abs(got - expected) <= error, `${got} for ${expected}`);

test('endings have words and colors, two of a kind their own', () => {
  const { endings } = engine.basins({
    model: 'torsional', parameters: { velocity: 50, dampingConstant: 100, freeplayAngle: degree },
    x: { state: 'torsionAngle', from: -0.1, to: 0.1, count: 8 }, y: { state: 'torsionRate', from: -10, to: 10, count: 6 },
  });
  assert.equal(endings.length, 1);
  // theory.md 4: 0.022268 rad.
  assert.equal(endingInWords(endings[0], english), 'rattles in the gap, ±1.28°');
  assert.equal(endingInWords(endings[0], turkish), 'boşlukta takırdıyor, ±1,28°');
  const ending = (/** @type {import('../../www/lens/cycles/endings.js').Ending['kind']} */ kind, high = 0) => ({ kind, low: high, high, cells: 1 });
  const all = [ending('rest'), ending('rattle', 0.02), ending('shimmy', 0.1), ending('shimmy', 0.3), ending('divergence', Infinity), ending('unsettled')];
  for (const one of all) for (const voice of [english, turkish]) assert.doesNotMatch(endingInWords(one, voice), /NaN|Infinity|undefined|[{}]/);
  const colors = colorsOfEndings(all, theme);
  assert.equal(new Set(colors).size, all.length);
  assert.ok(colors.every((color) => /^#[0-9a-f]{6}$/.test(color)));
  assert.equal(colors[0], theme.surface);
  assert.deepEqual(all.map(swingsOn), [false, true, true, true, true, false]);
});

test('what is not known yet is as the nearest that is, and never as beyond the edge', () => {
  const none = 255;
  assert.deepEqual([...spread(Uint8Array.from([1, none, none, none, none, 2]), 3)], [1, 1, 2, 1, 2, 2]);
  assert.deepEqual([...spread(Uint8Array.from([none, none, none, none]), 2)], [none, none, none, none]);
  // The end of a row is no neighbor of the beginning of the next.
  assert.deepEqual([...spread(Uint8Array.from([none, none, 7, none, none, none, none, none, none]), 3)].slice(3, 6), [7, 7, 7]);
});

test('the plane has the colors, a hatch where it swings on, the motion and the start; veiled only these two', () => {
  const size = { width: 500, height: 400 };
  const limits = { angle: 0.3, rate: 100 };
  const places = placesOfBasins(size, theme, limits);
  near(places.valueX(places.x(0.1)), 0.1, 1e-12);
  near(places.valueY(places.y(-40)), -40, 1e-9);
  const drawn = (/** @type {boolean} */ veiled) => {
    const recorder = recordingContext();
    drawBasins(recorder.context, size, {
      limits, image: /** @type {any} */ ({}), hatch: Float32Array.from([places.x(0), 300, places.x(0.1), 200]), isOld: false,
      cycle: { torsionAngle: [0.2, 0, -0.2, 0], torsionRate: [0, 60, 0, -60] }, isCycleStable: true, trail: {}, state: [0.05, 10, 0], exposed: null, start: { x: 0.1, y: -40 }, veiled,
    }, theme, english);
    return recorder;
  };
  const { named } = drawn(false);
  assert.equal(named('drawImage').length, 1);
  const hatched = named('moveTo').filter(({ style }) => style.strokeStyle === theme.unstable);
  assert.equal(hatched.length, 1);
  const rings = named('arc').map(({ args: [x, y] }) => [x, y]);
  assert.ok(rings.some(([x, y]) => Math.abs(x - places.x(0.1)) < 1e-9 && Math.abs(y - places.y(-40)) < 1e-9));
  const hidden = drawn(true);
  assert.equal(hidden.named('drawImage').length, 0);
  assert.equal(hidden.named('moveTo').filter(({ style }) => style.strokeStyle === theme.unstable).length, 0);
  assert.ok(written(hidden.named('fillText')).includes('?'));
  assert.deepEqual(hidden.named('arc').map(({ args: [x] }) => x).toSorted(), named('arc').map(({ args: [x] }) => x).toSorted());
});

test('a start that is dragged is where the run starts, with all its drags one step of undo; the drawing keeps its scale meanwhile', () => {
  const { store, session } = opened();
  session.advance(0.1);
  session.pin();
  session.advance(0.1);
  const [before, { run, ghosts }, { scales }] = [session.recipe, store.state, session];
  for (const torsionAngle of [0.1, 0.15, 0.2]) {
    session.startFrom({ torsionAngle, torsionRate: 5 }, 'plane drag 1');
    assert.deepEqual([session.time, session.scene(wanted).start, session.scales], [0, { torsionAngle, torsionRate: 5 }, scales]);
    session.advance(0.02);
  }
  session.settle();
  assert.deepEqual(store.state.run, { initial: { torsionAngle: 0.2, torsionRate: 5 } });
  assert.deepEqual(session.recipe.changes, []);
  assert.deepEqual(store.state.ghosts.map(({ from, initial }) => [from, initial]), [[0, ghosts[0].initial]], 'a ghost begins with it, from its own start');
  store.undo();
  assert.deepEqual([session.recipe, store.state.run, store.state.ghosts], [before, run, ghosts]);
  store.redo();
  assert.deepEqual(session.scene(wanted).start, { torsionAngle: 0.2, torsionRate: 5 });
  // A swing that would leave the scale takes it along.
  session.scales = { ...session.scales, magnification: 50 };
  session.startFrom({ torsionAngle: 0.3 }, 'plane drag 2');
  assert.ok(session.scales.magnification < 50);
});

test('the gear that is offered for its two endings has two', () => {
  const { endings } = engine.basins({
    model: 'torsional', parameters: { ...twoEndings.parameters },
    x: { state: 'torsionAngle', from: -0.4, to: 0.4, count: 24 }, y: { state: 'torsionRate', from: -120, to: 120, count: 16 },
  });
  assert.deepEqual(endings.map(({ kind }) => kind), ['rest', 'shimmy']);
  assert.ok(endings.every(({ cells }) => cells > 0.03 * 24 * 16), 'either is seen');
});
