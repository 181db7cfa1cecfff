import assert from 'node:assert/strict';
import test from 'node:test';
import { refusal, shimmy } from './module.mjs';

const SPEEDS = { parameter: 'velocity', from: 0.5, to: 100, count: 400 };
const CASTERS = { parameter: 'casterLength', from: 0, to: 0.5, count: 300 };
/** @type {any} */
const MAP = { model: 'torsional', x: SPEEDS, y: CASTERS };

/** What a job has of a map. @param {import('../../www/pkg/shimmy.js').Job} job */
const soFar = (job) => /** @type {import('../../www/pkg/shimmy.js').UnfinishedMap} */ (job.result());

test('a map tells what is asked for, row by row from below', () => {
  const map = shimmy.stabilityMap(MAP);
  assert.deepEqual(Object.keys(map), ['stable', 'stablePercent', 'stableArea', 'growthRate']);
  assert.ok(map.stable instanceof Uint8Array && map.growthRate instanceof Float64Array);
  assert.equal(map.stable.length, 120_000);
  assert.equal(map.growthRate?.length, 120_000);
  const stable = map.stable.reduce((sum, cell) => sum + cell, 0);
  assert.ok(Math.abs(map.stablePercent - stable / 1200) < 1e-10);
  assert.ok(Math.abs(map.stableArea - map.stablePercent) < 0.05);

  assert.deepEqual(Object.keys(shimmy.stabilityMap({ ...MAP, quantities: ['stable'] })), ['stable', 'stablePercent', 'stableArea']);
  assert.deepEqual(Object.keys(shimmy.stabilityMap({ ...MAP, quantities: [] })), ['stable', 'stablePercent', 'stableArea']);
  const all = shimmy.stabilityMap({ ...MAP, quantities: ['growthRate', 'frequency', 'kind'] });
  assert.deepEqual(all.kinds, ['monotonic', 'oscillatory']);
  assert.deepEqual(all.growthRate, map.growthRate);
  // The centre of a cell against the gear's own verdict there.
  for (const [column, row] of [[0, 0], [399, 0], [120, 7], [200, 299]]) {
    const velocity = 0.5 + (99.5 * (column + 0.5)) / 400;
    const casterLength = (0.5 * (row + 0.5)) / 300;
    const [leading] = shimmy.eigenvalues({ model: 'torsional', parameters: { velocity, casterLength } });
    const cell = 400 * row + column;
    assert.equal(map.stable[cell] === 1, leading.re < 0);
    assert.ok(Math.abs(Number(map.growthRate?.[cell]) - leading.re) < 1e-9);
    assert.ok(Math.abs(Number(all.frequency?.[cell]) - leading.im / (2 * Math.PI)) < 1e-9);
    assert.equal(all.kind?.[cell], leading.im > 0 ? 1 : 0);
  }
});

test('a tile is a part of the map, and a job makes it in slices', () => {
  const whole = shimmy.stabilityMap(MAP);
  const tile = shimmy.stabilityMap({ ...MAP, tile: { column: 100, row: 50, columns: 20, rows: 3 } });
  assert.equal(tile.stable.length, 60);
  for (let row = 0; row < 3; row++) {
    const from = 400 * (50 + row) + 100;
    assert.deepEqual(tile.stable.slice(20 * row, 20 * row + 20), whole.stable.slice(from, from + 20));
  }
  assert.equal(shimmy.stabilityMap({ ...MAP, tile: { row: 299 } }).stable.length, 400);

  const job = new shimmy.Job('stabilityMap', MAP);
  assert.deepEqual([soFar(job).stable.length, soFar(job).stablePercent, soFar(job).stableArea], [0, null, null]);
  const first = job.advance(0);
  assert.ok(!first.done && first.fraction > 0 && first.fraction < 1);
  const part = soFar(job);
  assert.equal(part.stable.length, Math.round(120_000 * first.fraction));
  assert.deepEqual(part.growthRate, whole.growthRate?.slice(0, part.stable.length));
  assert.equal(part.stableArea, null);
  while (!job.advance(1).done);
  assert.deepEqual(job.advance(1), { done: true, fraction: 1 });
  assert.deepEqual(job.result(), whole);
  job.free();
});

test('the boundary is a curve that ends at the edge', () => {
  const plane = { model: 'torsional', x: { parameter: 'velocity', from: 0.5, to: 600 }, y: { parameter: 'dampingConstant', from: 0, to: 100 } };
  const curves = shimmy.hopfCurve(plane);
  assert.equal(curves.length, 1);
  const [{ x, y, frequency, kind, closed, bounds }] = curves;
  assert.deepEqual([kind, closed, bounds], ['hopf', false, true]);
  assert.equal(y[0], 0);
  assert.equal(x[x.length - 1], 600);
  // theory.md: without damping the critical speed is 15.2593 m/s.
  assert.ok(Math.abs(x[0] - 15.2593) < 5e-5);
  for (let i = 0; i < x.length; i++) {
    const critical = shimmy.routhHurwitz({ model: 'torsional', parameters: { velocity: x[i], dampingConstant: y[i] } }).criticalVelocities;
    assert.ok(critical.some((v) => Math.abs(v / x[i] - 1) < 1e-5) || y[i] > 49.79, `${x[i]}, ${y[i]}`);
    assert.ok(frequency[i] > 50 && frequency[i] < 60);
  }
  const coarse = shimmy.hopfCurve({ ...plane, accuracy: 1e-4 });
  assert.ok(coarse.length === 1 && 5 * coarse[0].x.length < x.length);
  // A count of the axes may stay where it was for the map.
  assert.deepEqual(shimmy.hopfCurve({ ...plane, x: { ...plane.x, count: 3 } }), curves);
  const [island] = shimmy.hopfCurve({ model: 'torsional', parameters: { dampingConstant: 45 }, x: { ...plane.x, to: 300 }, y: { parameter: 'casterLength', from: -0.3, to: 0.5 } });
  assert.ok(island.closed && island.x[0] === island.x[island.x.length - 1]);
});

test('what is linked follows, if asked to', () => {
  const x = { parameter: 'halfContactLength', from: 0.05, to: 0.15, count: 9 };
  const alone = shimmy.stabilityMap({ ...MAP, x });
  const linked = shimmy.stabilityMap({ ...MAP, x, linked: { relaxationLength: true, treadWidthMomentConstant: true } });
  assert.notDeepEqual(linked.growthRate, alone.growthRate);
  const halfContactLength = 0.05 + 0.1 * (2.5 / 9);
  const casterLength = 0.5 * (200.5 / 300);
  const follow = shimmy.linkedParameters({ model: 'torsional', parameters: { halfContactLength } });
  const there = shimmy.stabilityMap({
    model: 'torsional',
    parameters: { ...follow, halfContactLength },
    x: { parameter: 'velocity', from: 49, to: 51, count: 1 },
    y: { parameter: 'casterLength', from: casterLength - 0.001, to: casterLength + 0.001, count: 1 },
  });
  assert.ok(Math.abs(Number(linked.growthRate?.[9 * 200 + 2]) - Number(there.growthRate?.[0])) < 1e-9);
});

test('a bad plane is refused in words', () => {
  /** @param {any} change */
  const refused = (change) => refusal(() => shimmy.stabilityMap({ ...MAP, ...change }));
  assert.equal(refused({ x: { ...SPEEDS, parameter: 'velocty' } }).suggestion, 'velocity');
  assert.equal(refused({ y: SPEEDS }).message, 'y.parameter must be another parameter than x.parameter, got velocity');
  assert.equal(refused({ x: { ...SPEEDS, to: 0.5 } }).message, 'x.to must be > 0.5 (from), got 0.5');
  assert.equal(refused({ x: { ...SPEEDS, from: -1 } }).field, 'x.from');
  assert.equal(refused({ x: { ...SPEEDS, to: Infinity } }).code, 'not-finite');
  assert.equal(refused({ x: { ...SPEEDS, count: 0 } }).message, 'x.count must be a whole number from 1 to 10000000, got 0');
  assert.equal(refused({ x: { ...SPEEDS, count: undefined } }).code, 'missing');
  assert.equal(refused({ x: { ...SPEEDS, count: 40_000 } }).field, 'y.count');
  assert.equal(refused({ x: { ...SPEEDS, step: 1 } }).code, 'unknown-key');
  assert.equal(refused({ quantities: ['growth'] }).suggestion, 'growthRate');
  assert.equal(refused({ quantities: ['stable', 1] }).field, 'quantities');
  assert.equal(refused({ tile: { column: 400 } }).message, 'tile.column must be a whole number from 0 to 399, got 400');
  assert.equal(refused({ tile: { row: 1, rows: 300 } }).field, 'tile.rows');
  assert.equal(refused({ parameters: { velocity: -1 } }).field, 'velocity');
  assert.equal(refused({ x: undefined }).field, 'x');
  assert.equal(refused({ x: { ...SPEEDS, count: 'many' } }).field, 'x.count');
  assert.equal(refused({ y: { ...CASTERS, count: 1.5 } }).field, 'y.count');
  const lengths = { x: { ...CASTERS, parameter: 'halfContactLength', from: 0.1 }, y: { ...CASTERS, parameter: 'relaxationLength', from: 0.1 } };
  assert.equal(refused({ ...lengths, linked: { relaxationLength: true } }).field, 'linked.relaxationLength');
  const { x, y } = MAP;
  assert.equal(refusal(() => shimmy.hopfCurve({ model: 'torsional', x, y, accuracy: 0 })).field, 'accuracy');
  assert.equal(refusal(() => shimmy.hopfCurve({ model: 'torsional', x: { ...x, to: 1e12 }, y })).field, 'x.to');
  const job = refusal(() => new shimmy.Job(/** @type {any} */ ('basin'), MAP));
  assert.deepEqual([job.code, job.field, job.suggestion], ['unknown-name', 'kind', 'basins']);
  assert.match(job.allowed, /^one of stabilityMap, /);
  const going = new shimmy.Job('stabilityMap', MAP);
  assert.equal(refusal(() => going.advance(-1)).field, 'milliseconds');
  assert.equal(refusal(() => going.advance(NaN)).field, 'milliseconds');
  while (!going.advance(5).done);
  assert.equal(soFar(going).stable.length, 120_000);
});
