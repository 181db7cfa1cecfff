// The limit cycle that the lens Cycles follows, and its multipliers drawn in the unit circle.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CycleWatch, pause } from '../../www/lens/cycles/cycle-watch.js';
import { kindOf, multiplierInWords, multipliersOf, nearnessInWords } from '../../www/lens/cycles/say.js';
import { isOrbit, orbitOf, viewNames } from '../../www/lens/cycles/settings.js';
import { viewsOf } from '../../www/out/views.js';
import { cycleLooks } from '../../www/run/cycle-looks.js';
import { drawMultipliers } from '../../www/view/multipliers.js';
import { voiceOf } from '../../www/words/voice.js';
import { defaults } from './opened-session.mjs';
import { recordingContext, written } from './plot-recorder.mjs';
import { engine } from './stories.mjs';
import { theme } from './theme.mjs';

const [english, turkish] = [voiceOf('en'), voiceOf('tr')];

/** @param {Record<string, number>} values @param {Record<string, number>} [state] */
function gear(values, state = { torsionAngle: 0.01 }) {
  const parameters = { ...defaults, ...values };
  return { object: 'torsional', parameters, cycles: cycleLooks(engine, { model: 'torsional', parameters }, () => state) };
}

/** @param {number} got @param {number} expected @param {number} error */
const near = (got, expected, error) => assert.ok(Math.abs(got - expected) <= error, `${got} for ${expected}`);

test('it finds the cycle of the gear, keeps to it while values change, and says when it is lost and found again', () => {
  const watch = new CycleWatch();
  assert.ok(watch.follow(gear({ velocity: 80, dampingConstant: 30 }), 0));
  // theory.md, computed independently: v = 80, c = 30.
  near(watch.cycle?.amplitude.torsionAngle ?? NaN, 0.20632, 5e-6);
  near(watch.cycle?.frequency ?? NaN, 52.52, 5e-3);
  assert.ok(!watch.follow(gear({ velocity: 80, dampingConstant: 30 }), 1), 'nothing has changed');
  assert.ok(watch.follow(gear({ velocity: 80, dampingConstant: 10 }), 2));
  near(watch.cycle?.amplitude.torsionAngle ?? NaN, 0.39238, 5e-6);
  near(watch.cycle?.amplitude.torsionRate ?? NaN, 124.89, 5e-3);

  assert.ok(watch.follow(gear({ velocity: 80, dampingConstant: 60 }), 3));
  assert.deepEqual([watch.cycle?.found, watch.isOwed], [false, true], 'lost, to be looked for once more');
  assert.ok(!watch.follow(gear({ velocity: 80, dampingConstant: 61 }), 4), 'but not within the same moment');
  assert.ok(watch.follow(gear({ velocity: 80, dampingConstant: 20 }), 4 + pause));
  near(watch.cycle?.amplitude.torsionAngle ?? NaN, 0.26508, 5e-6);
  assert.ok(!watch.isOwed);
});

test('of another object, and from a guess, it looks anew', () => {
  const watch = new CycleWatch();
  const rattling = gear({ velocity: 50, dampingConstant: 100, freeplayAngle: Math.PI / 180 });
  watch.goTo(rattling, null, 0);
  // theory.md 4: 0.022268 rad at 1°.
  near(watch.cycle?.amplitude.torsionAngle ?? NaN, 0.022268, 5e-7);
  watch.goTo(rattling, { period: 1 / 27, state: { torsionAngle: 0.02, torsionRate: 0, lateralDeformation: -0.004 } }, 1);
  near(watch.cycle?.amplitude.torsionAngle ?? NaN, 0.022268, 5e-7);
  watch.follow({ ...rattling, object: 'torsional-linear', cycles: cycleLooks(engine, { model: 'torsional-linear', parameters: {} }, () => ({ torsionAngle: 0.01 })) }, pause + 2);
  assert.equal(watch.cycle?.found ?? false, false, 'a linear gear has none');
});

test('values that nothing can be computed with leave no cycle, and no error', () => {
  const watch = new CycleWatch();
  const wild = { ...gear({}), cycles: cycleLooks(engine, { model: 'torsional', parameters: { ...defaults, velocity: -1 } }, () => ({})) };
  assert.ok(watch.follow(wild, 0));
  assert.deepEqual([watch.cycle, watch.isOwed], [null, false]);
});

test('the trivial multiplier is told apart, and the others in words', () => {
  const cycle = engine.limitCycle({ model: 'torsional', parameters: { velocity: 80, dampingConstant: 30 } });
  const { along, others } = multipliersOf(cycle.multipliers);
  near(along?.re ?? NaN, 1, 1e-6);
  assert.deepEqual(others.map((one) => multiplierInWords(one, english)), ['0.696', '0.00475']);
  assert.deepEqual(others.map((one) => multiplierInWords(one, turkish)), ['0,696', '0,00475']);
  assert.equal(multiplierInWords({ re: 0.5, im: -0.25 }, english), '0.500 ± 0.250i');
  assert.match(nearnessInWords(cycle, english), /0\.696/);
  assert.equal(kindOf(cycle, english), 'A stable limit cycle');
  assert.match(kindOf({ ...cycle, stable: false, symmetric: false }, english), /unstable.*not symmetric/);
  // Two at 1, as at a fold: one of them is of the way along the cycle.
  assert.equal(multipliersOf([{ re: 1, im: 0 }, { re: 1, im: 0 }]).others.length, 1);
  assert.deepEqual(multipliersOf([]), { along: null, others: [] });
});

test('multipliers stand in and out of a circle of their own scale, those that grow in the color of what is unstable', () => {
  for (const [re, color] of /** @type {const} */ ([[0.5, theme.stable], [-1.2, theme.unstable], [40, theme.unstable]])) {
    const { context, named } = recordingContext();
    drawMultipliers(context, { width: 260, height: 260 }, { along: { re: 1, im: 0 }, others: [{ re, im: 0 }] }, theme, english);
    const [circle] = named('arc');
    const [x, y, radius] = circle.args;
    const arms = named('moveTo').filter(({ style }) => style.strokeStyle === color && style.lineWidth === 2.6 * theme.line);
    assert.equal(arms.length, 2, `${re}`);
    near(arms[0].args[0] + 5, x + re * radius, 1e-6);
    near(arms[0].args[1] + 5, y, 1e-6);
  }
  const { context, named } = recordingContext();
  drawMultipliers(context, { width: 260, height: 260 }, { along: { re: 1, im: 0 }, others: [{ re: 40, im: 0 }], veiled: true }, theme, english);
  assert.ok(written(named('fillText')).includes('?'));
  assert.ok(!written(named('fillText')).includes('40'), 'no axis tells of it');
  assert.equal(named('arc').length, 0);
});

test('how the cycle is drawn is readable text, and what is taken along names the pictures of the view', () => {
  assert.deepEqual(orbitOf('space,-120,45'), { name: 'space', yaw: -120, pitch: 45 });
  assert.equal(orbitOf('').name, 'portrait');
  for (const good of ['portrait', 'space', 'space,56,20']) assert.ok(isOrbit(good), good);
  for (const bad of ['', 'orbit', 'portrait,1,2', 'space,181,2', 'space,1,91', 'space,a,b']) assert.ok(!isOrbit(bad), bad);
  for (const view of viewNames)
    for (const voice of [english, turkish])
      for (const { title } of viewsOf({ lens: 'cycles', views: { cycles: view } })) assert.ok(title(voice));
  assert.deepEqual(viewsOf({ lens: 'cycles', views: {} }).map(({ name }) => name), ['gear', 'time', 'cycle', 'multipliers']);
});
