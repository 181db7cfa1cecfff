// How widely the gear swings over the gap: followed row by row, and drawn as a map with the gear as a point that a hand drags.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Quantity } from '../../www/controls/quantity.js';
import { PlaneHand } from '../../www/lens/cycles/plane-hand.js';
import { gapRanges } from '../../www/lens/cycles/settings.js';
import { SwingPlane, coarseFirst, columns, rows, steadyAlong } from '../../www/lens/cycles/swing-plane.js';
import { colorsOfSwings } from '../../www/view/map-colors.js';
import { drawSwingMap, placesOfSwingMap } from '../../www/view/swing-map.js';
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
    parameter: 'velocity', points: [], cycles: [{ amplitude: new Float64Array([amplitude, amplitude]), stable: new Uint8Array([1, 1]), velocity: new Float64Array([1, 120]) }],
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

test('the map has lines, a scale and the gear; veiled it has the gear alone', () => {
  const quantity = (/** @type {string} */ name) => new Quantity(/** @type {typeof table.parameters[number]} */ (table.parameters.find((one) => one.name === name)));
  const size = { width: 560, height: 320 };
  const shown = (/** @type {boolean} */ veiled) => {
    const recorder = recordingContext();
    drawSwingMap(recorder.context, size, {
      x: { ...x, quantity: quantity('velocity') }, y: { ...y, quantity: quantity('freeplayAngle') }, image: /** @type {any} */ ({}), isOld: false,
      sheet: { lines: [{ x: [100, 200], y: [100, 120] }], numbers: [{ text: '2.7°', box: { left: 10, right: 30, top: 10, bottom: 20 }, color: '#000000' }] },
      limit: 20 * degree, point: { x: 50, y: degree }, readings: ['it reads'], veiled,
    }, theme, voiceOf('en'));
    return recorder;
  };
  const { named } = shown(false);
  assert.equal(named('drawImage').length, 1);
  for (const text of ['2.7°', 'it reads', '0°', '±20°']) assert.ok(written(named('fillText')).includes(text), text);
  const places = placesOfSwingMap(size, theme, x, y);
  assert.ok(named('arc').some(({ args: [across, up] }) => Math.abs(across - places.x(50)) < 1e-9 && Math.abs(up - places.y(degree)) < 1e-9));
  near(places.valueX(places.x(33)), 33, 1e-9);
  const hidden = shown(true);
  assert.equal(hidden.named('drawImage').length, 0);
  for (const text of ['2.7°', '±20°']) assert.ok(!written(hidden.named('fillText')).includes(text), text);
  assert.equal(hidden.named('arc').length, 1);
  const colorOf = colorsOfSwings(1, theme);
  assert.ok(colorOf(0)[3] !== colorOf(0.001)[3] && colorOf(0.5)[3] !== colorOf(1)[3] && colorOf(2)[3] === colorOf(1)[3]);
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
