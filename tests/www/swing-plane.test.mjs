// How widely the gear swings over the gap: followed row by row, and drawn as a map with the gear as a point that a hand drags.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Quantity } from '../../www/controls/quantity.js';
import { PlaneHand } from '../../www/lens/cycles/plane-hand.js';
import { foldsOf, gapRanges, readFolds, writeFolds } from '../../www/lens/cycles/settings.js';
import { SwingPlane, coarseFirst, columns, rows, steadyAlong } from '../../www/lens/cycles/swing-plane.js';
import { hasTwoAt, twoAlong } from '../../www/lens/cycles/two-motions.js';
import { overlap } from '../../www/view/corner.js';
import { colorsOfSwings } from '../../www/view/map-colors.js';
import { drawSwingMap, placesOfSwingMap } from '../../www/view/swing-map.js';
import { swingSheetOf } from '../../www/view/swing-sheet.js';
import { voiceOf } from '../../www/words/voice.js';
import { defaults, table } from './opened-session.mjs';
import { recordingContext, written } from './plot-recorder.mjs';
import { engine } from './stories.mjs';
import { theme } from './theme.mjs';

const degree = Math.PI / 180;
const x = { parameter: 'velocity', from: 1, to: 120 };
const y = { parameter: 'freeplayAngle', from: 0, to: 3 * degree };

/** @param {number} got @param {number} expected @param {number} error */
const near = (got, expected, error) => assert.ok(Math.abs(got - expected) <= error, `${got} for ${expected}`);

test('a row is the widest stable cycle along the speed, and nothing where it dies out', () => {
  const row = steadyAlong(engine.bifurcation({ model: 'torsional', parameters: { dampingConstant: 100, freeplayAngle: degree }, ...x }), x);
  const at = (/** @type {number} */ velocity) => row[Math.floor(((velocity - x.from) / (x.to - x.from)) * columns)];
  // theory.md 4: 0.022268 rad at v = 50; unstable inside the gap exactly for 3.196 < v < 73.041.
  near(at(50), 0.022268, 1e-4);
  assert.equal(at(80), 0);
  assert.ok(at(72) > 0 && at(75) === 0 && at(2) === 0);
  const folded = engine.bifurcation({
    model: 'torsional', parameters: { dampingConstant: 10, casterLength: -0.05, sideForceLimitAngle: 3 * degree, aligningMomentLimitAngle: 20 * degree }, ...x,
  });
  const wide = steadyAlong(folded, x);
  const [low] = folded.points.filter(({ kind }) => kind === 'fold').map((point) => point.velocity).sort((one, other) => one - other);
  const first = wide.findIndex((value) => value > 0);
  near(x.from + ((first + 0.5) / columns) * (x.to - x.from), low, 1);
  assert.ok(wide[first] > 10 * degree, 'from the fold on it is the upper branch');
});

test('rows come coarse first, those not yet known are as the nearest; a new gear waits, a stop ends it', async () => {
  const order = coarseFirst(8);
  assert.deepEqual(order, [0, 4, 2, 6, 1, 5, 3, 7]);
  assert.deepEqual(coarseFirst(rows).toSorted((one, other) => one - other), Array.from({ length: rows }, (_, i) => i));
  /** @type {{ spec: any, done: (diagram: any) => void, signal: AbortSignal }[]} */
  const jobs = [];
  const plane = new SwingPlane((spec, { signal }) => new Promise((done) => { jobs.push({ spec, done, signal }); }));
  const settle = () => new Promise((done) => { setTimeout(done, 5); });
  const gear = { model: 'torsional', parameters: defaults };
  plane.look({ key: 'a', shape: 's', gear, x, y });
  await settle();
  assert.equal(jobs.length, rows);
  near(jobs[0].spec.parameters.freeplayAngle, (0.5 / rows) * y.to, 1e-12);
  const branch = (/** @type {number} */ amplitude) => ({
    parameter: 'velocity', points: [], equilibria: { velocity: new Float64Array([1, 120]), stable: new Uint8Array([1, 1]), state: {} }, cycles: [{ amplitude: new Float64Array([amplitude, amplitude]), stable: new Uint8Array([1, 1]), velocity: new Float64Array([1, 120]), amplitudes: { torsionAngle: new Float64Array([amplitude, amplitude]) } }],
  });
  jobs[0].done(branch(0.1));
  await settle();
  assert.deepEqual([plane.share, plane.isOld, plane.amplitudes?.values.every((value) => value === 0.1)], [1 / rows, false, true]);
  jobs[1].done(branch(0.3));
  await settle();
  const values = plane.amplitudes?.values ?? new Float64Array();
  assert.deepEqual([values[0], values[(rows - 1) * columns]], [0.1, 0.3]);
  plane.look({ key: 'b', shape: 's', gear, x, y });
  assert.ok(plane.isOld && jobs[2].signal.aborted && plane.amplitudes !== null);
  jobs[2].done(branch(0.7));
  await settle();
  assert.equal(plane.amplitudes?.values.includes(0.7), false, 'what was given up is not shown');
  plane.look({ key: 'c', shape: 't', gear, x, y });
  assert.equal(plane.amplitudes, null);
  plane.stop();
  await settle();
  assert.equal(jobs.length, rows, 'nothing is begun that nobody looks at');
});

/** Straight up at v = 60. @type {import('../../www/pkg/shimmy.js').FoldCurve} */
const foldCurve = { kind: 'fold', closed: false, bounds: true, x: Float64Array.of(60, 60), y: Float64Array.of(0, 3 * degree), frequency: Float64Array.of(50, 50), amplitude: Float64Array.of(0.1, 0.1) };

test('the map has lines, a scale and the gear; veiled it has the gear alone', () => {
  const quantity = (/** @type {string} */ name) => new Quantity(/** @type {typeof table.parameters[number]} */ (table.parameters.find((one) => one.name === name)));
  const size = { width: 560, height: 320 };
  const shown = (/** @type {boolean} */ veiled) => {
    const recorder = recordingContext();
    drawSwingMap(recorder.context, size, {
      x: { ...x, quantity: quantity('velocity') }, y: { ...y, quantity: quantity('freeplayAngle') }, image: /** @type {any} */ ({}), isOld: false,
      sheet: { lines: [{ x: [100, 200], y: [100, 120] }], numbers: [{ text: '2.7°', box: { left: 10, right: 30, top: 10, bottom: 20 }, color: '#000000' }], hatch: Float32Array.of(100, 200, 140, 160), names: [{ text: 'two motions', box: { left: 200, right: 280, top: 100, bottom: 120 }, color: theme.ink }] },
      curves: [foldCurve],
      limit: 20 * degree, point: { x: 50, y: degree }, readings: ['it reads'], veiled,
    }, theme, voiceOf('en'));
    return recorder;
  };
  const { named } = shown(false);
  assert.equal(named('drawImage').length, 1);
  for (const text of ['2.7°', 'it reads', 'two motions', '0°', '±20°']) assert.ok(written(named('fillText')).includes(text), text);
  const places = placesOfSwingMap(size, theme, x, y);
  assert.ok(named('arc').some(({ args: [across, up] }) => Math.abs(across - places.x(50)) < 1e-9 && Math.abs(up - places.y(degree)) < 1e-9));
  near(places.valueX(places.x(33)), 33, 1e-9);
  const fold = named('lineTo').find(({ args: [across], style }) => Math.abs(across - places.x(60)) < 1e-9 && style.dash.length > 0 && style.strokeStyle === theme.ink);
  assert.ok(fold, 'a curve of folds is dashed, in ink');
  assert.ok(named('lineTo').some(({ args: [across, up], style }) => across === 140 && up === 160 && style.strokeStyle === theme.ink), 'two motions are hatched, not as what is unstable');
  const hidden = shown(true);
  assert.equal(hidden.named('drawImage').length, 0);
  for (const text of ['2.7°', '±20°', 'two motions']) assert.ok(!written(hidden.named('fillText')).includes(text), text);
  assert.equal(hidden.named('arc').length, 1);
  const colorOf = colorsOfSwings(1, theme);
  assert.ok(colorOf(0)[3] !== colorOf(0.001)[3] && colorOf(0.5)[3] !== colorOf(1)[3] && colorOf(2)[3] === colorOf(1)[3]);
});

test('two motions are where rest and a cycle are stable, up to the folds; between rows the spans go over into each other', () => {
  const folded = { dampingConstant: 10, casterLength: -0.05, sideForceLimitAngle: 3 * degree, aligningMomentLimitAngle: 20 * degree };
  const diagram = engine.bifurcation({ model: 'torsional', parameters: folded, ...x });
  const [[from, to], ...more] = twoAlong(diagram, x, 0).map((span) => span.map((share) => x.from + share * (x.to - x.from)));
  assert.equal(more.length, 0);
  // Of simulations from near and far, which know of no branch: the start decides inside alone.
  const ends = (/** @type {number} */ velocity) => [0.01, 0.35].map((torsionAngle) => engine.outlook({ model: 'torsional', parameters: { ...folded, velocity }, initial: { torsionAngle } }).verdict);
  assert.deepEqual([from - 0.5, from + 0.5, to - 0.5, to + 0.5].map(ends), [['dies-out', 'dies-out'], ['dies-out', 'shimmies'], ['dies-out', 'shimmies'], ['shimmies', 'shimmies']], `${from} … ${to}`);
  // What friction holds is at rest wherever there is a cycle.
  const rubbed = engine.bifurcation({ model: 'torsional', parameters: { dampingConstant: 20, 'friction.moment': 300 }, ...x });
  const [[held]] = twoAlong(rubbed, x, 300);
  near(x.from + held * (x.to - x.from), rubbed.points.find(({ kind }) => kind === 'fold')?.velocity, 0.05);
  assert.deepEqual(twoAlong(engine.bifurcation({ model: 'torsional', parameters: { dampingConstant: 20 }, ...x }), x, 0), [], 'where a cycle is born rest ends');
  const rows = [[[0.2, 0.4]], [[0.4, 0.8]], []];
  const has = (/** @type {number} */ across, /** @type {number} */ row) => hasTwoAt(/** @type {any} */ (rows), across, (row + 0.5) / 3);
  assert.deepEqual([has(0.25, 0), has(0.25, 0.5), has(0.35, 0.5), has(0.55, 0.5), has(0.65, 0.5), has(0.6, 1.4), has(0.6, 1.6)], [true, false, true, true, false, true, false]);
});

test('the sheet hatches and names where there are two motions, and names the curves clear of each other', () => {
  const frame = { left: 40, right: 540, top: 20, bottom: 320 };
  const [placeX, placeY] = [(/** @type {number} */ v) => frame.left + ((v - 1) / 119) * 500, (/** @type {number} */ v) => frame.bottom - (v / (3 * degree)) * 300];
  const { context } = recordingContext();
  const amplitudes = { values: new Float64Array(20 * 10).fill(0.1), columns: 20, rows: 10 };
  const { hatch, names } = swingSheetOf(context, frame, amplitudes, {
    levels: [], curves: [{ curve: foldCurve, name: 'fold' }, { curve: foldCurve, name: 'Hopf' }], x: placeX, y: placeY, hasTwo: (across) => across > 0.6, two: ['two motions possible', 'two'],
  }, theme);
  assert.deepEqual(names.map(({ text }) => text), ['two motions possible', 'fold', 'Hopf']);
  for (const [i, one] of names.entries()) for (const other of names.slice(i + 1)) assert.ok(!overlap(one.box, other.box));
  assert.ok(names[0].box.left >= frame.left + 0.6 * 500 - 1);
  assert.ok(hatch.length > 0 && hatch.every((value, i) => i % 2 === 1 || value >= frame.left + 0.6 * 500 - 2), 'hatched nowhere else');
  assert.ok(hatch[2] < hatch[0], 'and it leans the other way');
});

test('a plane of folds is readable text; without one it is the damping over the speed', () => {
  assert.equal(writeFolds(foldsOf('', table.parameters)), 'velocity:0.5:100,dampingConstant:0:100');
  const text = 'velocity:1:60,friction.moment:0:300';
  assert.equal(writeFolds(foldsOf(text, table.parameters)), text);
  for (const wrong of ['velocity:1:60', 'velocity:1:60,velocity:1:60', 'velocity:60:1,dampingConstant:0:1', 'velocity:1:60,dampingConstant:0:1,more']) assert.equal(readFolds(wrong, table.parameters), null, wrong);
});

test('a hand drags the point, a click brings it, keys step it', () => {
  const places = placesOfSwingMap({ width: 500, height: 300 }, theme, x, y);
  /** @type {any[]} */
  const told = [];
  const hand = new PlaneHand({
    places: () => places, point: () => ({ x: 50, y: degree }), put: (a, b, gesture) => told.push([Math.round(a), Math.round(b / degree * 10) / 10, gesture]),
    step: (...step) => told.push(step), settle: () => told.push('settle'), hover: (at) => told.push(at === null ? 'away' : 'reads'),
  });
  const target = { closest: () => ({ getBoundingClientRect: () => ({ left: 10, top: 20 }) }), setPointerCapture: () => {}, focus: () => {} };
  const event = (/** @type {number} */ px, /** @type {number} */ py, more = {}) => /** @type {any} */ ({
    clientX: px + 10, clientY: py + 20, pointerId: 1, button: 0, isPrimary: true, pointerType: 'mouse', type: 'pointerup', currentTarget: target, preventDefault() {}, stopPropagation() {}, ...more,
  });
  const [px, py] = [places.x(50), places.y(degree)];
  assert.deepEqual(hand.ring, { x: px, y: py });
  hand.grab(event(px + 3, py));
  hand.drag(event(places.x(80) + 3, places.y(2 * degree)));
  hand.release(event(0, 0));
  assert.deepEqual(told.splice(0), ['away', [80, 2, 'plane drag 1'], 'settle']);
  hand.press(event(places.x(30), places.y(degree)));
  hand.lift(event(places.x(30), places.y(degree)));
  assert.deepEqual(told.splice(0), [[30, 1, null], 'settle']);
  hand.press(event(places.x(30), places.y(degree)));
  hand.move(event(places.x(60), places.y(degree)));
  hand.lift(event(places.x(60), places.y(degree)));
  assert.deepEqual(told.splice(0), ['reads'], 'what moved is no click');
  hand.key(event(0, 0, { key: 'ArrowUp', shiftKey: true }));
  hand.key(event(0, 0, { key: 'Enter' }));
  assert.deepEqual(told.splice(0), [[0, 1, 10], 'settle']);
  hand.grab(event(px, py));
  hand.drag(event(9999, -50));
  assert.deepEqual(told.splice(0)[1], [120, 3, 'plane drag 2'], 'never beyond the plane');
});

test('the map is over the speed unless said, and of a gear without a gap there is none', () => {
  assert.deepEqual(gapRanges('', table.parameters), { x: { parameter: 'velocity', from: 1, to: 120 }, y: { parameter: 'freeplayAngle', from: 0, to: table.parameters.find(({ name }) => name === 'freeplayAngle')?.max } });
  assert.equal(gapRanges('dampingConstant', table.parameters).x?.parameter, 'dampingConstant');
  assert.equal(gapRanges('freeplayAngle', table.parameters).x?.parameter, 'velocity');
  assert.equal(gapRanges('', [{ name: 'velocity', min: 1, max: 2 }]).y, null);
});
