// Live tables of cycles and three methods side by side: their numbers, how they are computed slice by slice, and as files.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Rows, patience } from '../../www/lens/cycles/rows.js';
import { chosenOf, settledOf, tableNumbers, thesisTables } from '../../www/lens/cycles/thesis-tables.js';
import { offBy, threeMethods } from '../../www/lens/cycles/three-methods.js';
import { cycleLooks } from '../../www/run/cycle-looks.js';
import { tablePicture } from '../../www/view/table-picture.js';
import { drawThreeMethods } from '../../www/view/three-methods.js';
import { Quantity } from '../../www/controls/quantity.js';
import { voiceOf } from '../../www/words/voice.js';
import { table } from './opened-session.mjs';
import { recordingContext, written } from './plot-recorder.mjs';
import { engine } from './stories.mjs';
import { theme } from './theme.mjs';

const cycles = cycleLooks(engine, { model: 'torsional', parameters: {} }, () => ({}));

/** @param {number} got @param {number} expected @param {number} error */
const near = (got, expected, error) => assert.ok(Math.abs(got - expected) <= error, `${got} for ${expected}`);

/** @param {string} number @param {number} row */
const settled = (number, row) => settledOf(cycles, thesisTables[number], thesisTables[number].rows[row]);

test('the tables have the values of theory.md 3 and 4', () => {
  // v = 80, c = 10 and 30; the digits shown there.
  const [ten, thirty] = [settled('5.12', 0), settled('5.12', 2)];
  near(ten.amplitude.torsionAngle, 0.39238, 5e-6);
  near(ten.amplitude.torsionRate, 124.89, 5e-3);
  near(ten.amplitude.lateralDeformation, 0.0749, 5e-6);
  near(ten.frequency ?? NaN, 51.215, 5e-4);
  near(thirty.amplitude.torsionAngle, 0.20632, 5e-6);
  near(settled('5.13', 0).amplitude.torsionRate, 67.23, 5e-3);
  assert.deepEqual([4, 5].map((row) => settled('5.12', row).verdict), ['dies-out', 'dies-out'], 'critical c at v = 80: 48.530');
  assert.equal(settled('5.13', 5).verdict, 'dies-out', 'critical v at c = 30: 37.263');

  const rattles = [0.011171, 0.022268, 0.033219];
  for (const number of ['6.1', '6.2']) rattles.forEach((expected, i) => near(settled(number, i + 1).amplitude.torsionAngle, expected, 6e-7));
  for (const row of [4, 5, 6]) assert.deepEqual([settled('6.2', row).verdict, settled('6.2', row).amplitude.torsionAngle], ['dies-out', 0], 'at v = 80 it dies out');
  [0.22254, 0.22958, 0.23577, 0.24134].forEach((expected, i) => near(settled('6.5', i).amplitude.torsionAngle, expected, 5e-6));
});

test('from a touch and from a large start the same cycles', () => {
  for (const [one, other] of [['5.8', '5.10'], ['5.9', '5.11']])
    thesisTables[one].rows.forEach((_, i) => near(settled(one, i).amplitude.torsionAngle, settled(other, i).amplitude.torsionAngle, 1e-7));
});

test('a setting names a table, or else it is the first', () => {
  assert.equal(chosenOf(tableNumbers, '6.4'), '6.4');
  for (const text of ['', '5.7', '6.6', 'toString']) assert.equal(chosenOf(tableNumbers, text), '5.8');
  assert.deepEqual(tableNumbers.toSorted(), Object.keys(thesisTables).toSorted());
});

test('three methods, one number', () => {
  const { describing, shooting, simulation, cycle } = threeMethods(cycles, { velocity: 80, dampingConstant: 30 }, null);
  // theory.md 3.
  near(describing?.torsionAngle ?? NaN, 0.20525, 6e-6);
  near(describing?.frequency ?? NaN, 52.521, 6e-4);
  near(shooting?.torsionAngle ?? NaN, 0.20632, 5e-6);
  near(simulation?.torsionAngle ?? NaN, 0.20632, 5e-6);
  near(offBy(describing, shooting, 'torsionAngle') ?? NaN, 0.20525 / 0.20632 - 1, 5e-5);
  assert.deepEqual([offBy(null, shooting, 'frequency'), offBy(describing, null, 'frequency')], [null, null]);
  const next = threeMethods(cycles, { velocity: 90, dampingConstant: 30 }, cycle);
  near(next.shooting?.torsionAngle ?? NaN, cycles.fromRest({ velocity: 90, dampingConstant: 30 }).amplitude.torsionAngle, 1e-9);
  const half = Math.PI / 360;
  // theory.md 3, at 1°: 0.02213 predicted, 0.02227 simulated; at v = 80 none.
  const rattle = threeMethods(cycles, { velocity: 50, dampingConstant: 100, freeplayAngle: 2 * half }, null);
  near(rattle.describing?.torsionAngle ?? NaN, 0.02213, 1e-5);
  near(rattle.simulation?.torsionAngle ?? NaN, 0.02227, 5e-6);
  assert.deepEqual(Object.values(threeMethods(cycles, { velocity: 80, dampingConstant: 100, freeplayAngle: half }, cycle)), [null, null, null, null]);
});

test('rows are answered slice by slice, and anew only once the gear has stood still', () => {
  let now = 0;
  /** @type {number[]} */
  const asked = [];
  const rows = /** @type {Rows<number, number>} */ (new Rows());
  const ask = (/** @type {number} */ spec, /** @type {number | null} */ before) => {
    asked.push(spec);
    now += 3;
    if (spec === 3) throw new Error('not finite');
    return spec + (before ?? 0);
  };
  rows.look({ key: 'a', shape: 's', specs: [1, 2, 3, 4] }, ask, now);
  assert.ok(rows.advance(5, () => now));
  assert.deepEqual([asked, rows.items.map(({ answer }) => answer), rows.isDone], [[1, 2], [1, 3, null, null], false]);
  rows.advance(5, () => now);
  assert.deepEqual([rows.items.map(({ answer }) => answer), rows.isDone], [[1, 3, null, 4], true], 'one that cannot be answered is left out');
  rows.look({ key: 'a', shape: 's', specs: [1, 2, 3, 4] }, ask, now);
  assert.ok(rows.isDone);
  rows.look({ key: 'b', shape: 's', specs: [1, 2, 3, 4] }, ask, now);
  assert.ok(!rows.advance(5, () => now) && rows.items.every(({ isOld }) => isOld), 'a moving slider waits');
  assert.deepEqual(rows.items.map(({ answer }) => answer), [1, 3, null, 4], 'what was there stays');
  now += patience;
  assert.ok(rows.advance(1, () => now));
  assert.deepEqual(rows.items.map(({ isOld }) => isOld), [false, true, true, true]);
  rows.look({ key: 'c', shape: 't', specs: [5] }, ask, now);
  assert.deepEqual([rows.items[0].answer, rows.advance(1, () => now)], [null, true], 'what is seen for the first time does not wait');
});

test('a table as a picture has each head and cell once, figures to the right', () => {
  const { context, named } = recordingContext();
  const picture = tablePicture({ heads: [{ text: 'v, m/s' }, { text: 'becomes', isWord: true }], rows: [['30', 'shimmies'], ['100', 'dies out']] }, theme, context);
  picture.paint(context, picture.size);
  const texts = named('fillText');
  assert.deepEqual(written(texts), ['v, m/s', 'becomes', '30', 'shimmies', '100', 'dies out']);
  assert.deepEqual(texts.map(({ style }) => style.textAlign), ['right', 'left', 'right', 'left', 'right', 'left']);
  assert.equal(texts[2].args[1], texts[4].args[1]);
  assert.ok(texts.every(({ args: [, x, y] }) => x > 0 && x < picture.size.width && y > 0 && y < picture.size.height));
});

test('curves of the methods break where there is no cycle; simulation is rings where it was asked', () => {
  const { context, named } = recordingContext();
  const velocity = table.parameters.find(({ name }) => name === 'velocity');
  assert.ok(velocity);
  const place = (/** @type {number} */ value, /** @type {number | null} */ shooting) => ({ value, shooting, describing: shooting, simulation: value % 20 === 0 ? shooting : null });
  drawThreeMethods(context, { width: 500, height: 240 }, {
    quantity: new Quantity(velocity), from: 30, to: 100, now: 80, limit: 0.4, names: { describing: 'd', shooting: 's', simulation: 'i' },
    places: [place(30, 0.1), place(40, 0.2), place(50, null), place(60, 0.3), place(70, 0.2)],
  }, theme, voiceOf('en'));
  const solid = named('moveTo', 'lineTo').filter(({ style }) => style.strokeStyle === theme.stable && style.lineWidth === 2.6 * theme.line && style.dash.length === 0);
  const curve = solid.slice(-4).map(({ name, args }) => [name, args[0]]);
  assert.deepEqual(curve.map(([name]) => name), ['moveTo', 'lineTo', 'moveTo', 'lineTo']);
  assert.equal(new Set(curve.map(([, x]) => x)).size, 4);
  // Two of the places were simulated; one more ring is the key's.
  assert.equal(named('arc').length, 3);
});
