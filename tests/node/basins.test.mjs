import assert from 'node:assert/strict';
import test from 'node:test';
import { refusal, shimmy } from './module.mjs';

const ANGLES = { state: 'torsionAngle', from: -0.3, to: 0.3, count: 13 };
const RATES = { state: 'torsionRate', from: -60, to: 60, count: 9 };
const SPEEDS = { parameter: 'velocity', from: 10, to: 110, count: 9 };
const DAMPINGS = { parameter: 'dampingConstant', from: 0, to: 60, count: 7 };
const GEAR = { model: 'torsional', parameters: { velocity: 80, dampingConstant: 30 } };
/** @type {any} */
const BASINS = { ...GEAR, x: ANGLES, y: RATES };
/** @type {any} */
const SWEEP = { ...GEAR, over: SPEEDS };

test('basins tell where each start ends, and in which motions', () => {
  const basins = shimmy.basins({ ...BASINS, refine: false });
  assert.deepEqual(Object.keys(basins), ['kind', 'kinds', 'amplitude', 'apart', 'ending', 'endings', 'followed']);
  assert.ok(basins.kind instanceof Uint8Array && basins.ending instanceof Uint8Array && basins.amplitude instanceof Float64Array);
  assert.deepEqual(basins.kinds, ['rest', 'rattle', 'shimmy', 'divergence', 'unsettled']);
  assert.deepEqual([basins.kind.length, basins.followed, basins.apart], [117, 117, 0.02]);
  // theory.md 3: one cycle, of 0.20632 rad, from wherever; the wheel that stands still stands for ever.
  assert.deepEqual(basins.endings.map(({ kind, cells }) => [kind, cells]), [['rest', 1], ['shimmy', 116]]);
  assert.deepEqual([basins.kind[58], basins.amplitude[58]], [0, 0]);
  for (let cell = 0; cell < 117; cell++) {
    assert.equal(basins.endings[basins.ending[cell]].kind, basins.kinds[basins.kind[cell]]);
    if (cell !== 58) assert.ok(Math.abs(basins.amplitude[cell] - 0.20632) < 1e-5, `${cell}: ${basins.amplitude[cell]}`);
  }
});

test('a plane of parameters tells what becomes of each gear', () => {
  const basins = shimmy.basins({ model: 'torsional', x: SPEEDS, y: DAMPINGS });
  assert.equal(basins.apart, 1);
  for (const [column, row] of [[0, 0], [4, 0], [8, 3], [1, 6], [5, 2]]) {
    const velocity = 10 + (100 * (column + 0.5)) / 9;
    const dampingConstant = (60 * (row + 0.5)) / 7;
    const outlook = shimmy.outlook({ model: 'torsional', parameters: { velocity, dampingConstant }, initial: { torsionAngle: 0.01 }, duration: 20 });
    const cell = 9 * row + column;
    const kind = { shimmies: 'shimmy', 'dies-out': 'rest', rests: 'rest', rattles: 'rattle', grows: 'divergence' }[outlook.verdict];
    assert.equal(basins.kinds[basins.kind[cell]], kind, `${velocity} ${dampingConstant}`);
    if (basins.amplitude[cell] < 1000) assert.ok(Math.abs(basins.amplitude[cell] - outlook.amplitude.torsionAngle) <= 1e-4 * outlook.amplitude.torsionAngle);
  }
});

test('a sweep goes there and back, and keeps its motion', () => {
  const sweep = shimmy.sweep(SWEEP);
  assert.deepEqual(Object.keys(sweep), ['value', 'up', 'down', 'kinds']);
  assert.deepEqual(Array.from(sweep.value), [10, 22.5, 35, 47.5, 60, 72.5, 85, 97.5, 110]);
  assert.deepEqual(Object.keys(sweep.up), ['kind', 'amplitude', 'settled']);
  assert.ok([...sweep.up.settled, ...sweep.down.settled].every((settled) => settled === 1));
  // theory.md 2: critical at 37.263 m/s.
  assert.deepEqual(Array.from(sweep.up.kind), [0, 0, 0, 2, 2, 2, 2, 2, 2]);
  const rates = shimmy.sweep({ ...SWEEP, measure: 'torsionRate' });
  const cycle = shimmy.limitCycle({ ...GEAR, parameters: { velocity: 85, dampingConstant: 30 } });
  assert.ok(Math.abs(sweep.up.amplitude[6] / cycle.amplitude.torsionAngle - 1) < 1e-4);
  assert.ok(Math.abs(rates.up.amplitude[6] / cycle.amplitude.torsionRate - 1) < 1e-3);
  const plane = shimmy.sweep({ ...SWEEP, over: { x: SPEEDS, y: DAMPINGS } });
  assert.equal(plane.down.amplitude.length, 63);
  assert.deepEqual(shimmy.sweep({ ...SWEEP, over: { x: SPEEDS, y: DAMPINGS }, tile: { row: 2, rows: 3 } }).up.kind, plane.up.kind.slice(18, 45));
});

test('jobs make both in slices, and tell what is there', () => {
  for (const [kind, spec, whole] of /** @type {[any, any, any][]} */ ([['basins', { ...BASINS, refine: false }, shimmy.basins({ ...BASINS, refine: false })], ['sweep', SWEEP, shimmy.sweep(SWEEP)]])) {
    const job = new shimmy.Job(kind, spec);
    const early = /** @type {any} */ (job.result());
    const kinds = early.kind ?? early.up.kind;
    assert.ok(kinds.every((/** @type {number} */ cell) => cell === 255));
    let before = 0;
    for (let told = job.advance(0); !told.done; told = job.advance(1)) {
      assert.ok(told.fraction >= before && told.fraction < 1);
      before = told.fraction;
    }
    assert.deepEqual(job.advance(1), { done: true, fraction: 1 });
    assert.deepEqual(job.result(), whole);
    job.free();
  }
});

test('what makes no sense is refused in words', () => {
  const basins = (/** @type {any} */ change) => refusal(() => shimmy.basins({ ...BASINS, ...change }));
  assert.equal(basins({ x: { ...ANGLES, state: 'torsionAngel' } }).suggestion, 'torsionAngle');
  assert.equal(basins({ x: { ...ANGLES, state: 'torsionAngel' } }).field, 'x.state');
  assert.equal(basins({ x: { ...ANGLES, parameter: 'velocity' } }).message, 'x.state must be given without a parameter: one of the two, got both');
  assert.equal(basins({ x: { from: 0, to: 1, count: 3 } }).code, 'missing');
  assert.equal(basins({ x: { ...ANGLES, to: -0.3 } }).message, 'x.to must be > -0.3 (from), got -0.3');
  assert.equal(basins({ y: { ...RATES, to: Infinity } }).code, 'not-finite');
  assert.equal(basins({ y: { ...RATES, to: 1e300 } }).field, 'y.to');
  assert.equal(basins({ y: { ...SPEEDS, from: 0 } }).field, 'y.from');
  assert.equal(basins({ x: { ...ANGLES, count: 0 } }).field, 'x.count');
  assert.equal(basins({ x: { ...ANGLES, count: 1e6 } }).field, 'y.count');
  assert.equal(basins({ x: undefined }).code, 'missing');
  assert.equal(basins({ y: ANGLES }).message, 'y must be another one than x, torsionAngle, got torsionAngle');
  assert.equal(basins({ duration: 0 }).field, 'duration');
  assert.equal(basins({ duration: 1001 }).code, 'too-large');
  assert.equal(basins({ refine: 1 }).field, 'refine');
  assert.equal(basins({ tile: { column: 13 } }).field, 'tile.column');
  assert.equal(basins({ model: 'torsion' }).suggestion, 'torsional');
  assert.equal(basins({ linked: { relaxationLenght: true } }).suggestion, 'relaxationLength');
  const sweep = (/** @type {any} */ change) => refusal(() => shimmy.sweep({ ...SWEEP, ...change }));
  assert.equal(sweep({ over: null }).code, 'missing');
  assert.equal(sweep({ over: { x: SPEEDS } }).field, 'over.y');
  assert.equal(sweep({ over: { x: SPEEDS, y: { ...DAMPINGS, parameter: 'damping' } } }).suggestion, 'dampingConstant');
  assert.equal(sweep({ over: ANGLES }).code, 'unknown-key');
  assert.equal(sweep({ measure: 'torsionRat' }).suggestion, 'torsionRate');
  assert.equal(sweep({ over: { x: SPEEDS, y: DAMPINGS }, tile: { columns: 3 } }).field, 'tile.columns');
  assert.equal(sweep({ x: SPEEDS }).code, 'unknown-key');
});

test('gears so wild that nobody can follow them come to an end all the same', () => {
  for (const parameters of [{ relaxationLength: 1e-9 }, { velocity: 1e12 }, { torsionalStiffness: 1e12 }, { momentOfInertia: 1e-12 }, { sideForceLimitAngle: 1.6 }, { aligningMomentLimitAngle: 1e-12 }, { verticalForce: 0 }, { torsionalStiffness: 0, verticalForce: 0 }]) {
    const spec = { model: 'torsional', parameters, x: { ...ANGLES, count: 2 }, y: { ...RATES, count: 1 }, duration: 0.01 };
    try {
      const { kind, amplitude } = shimmy.basins(/** @type {any} */ (spec));
      assert.ok(kind.every((cell) => cell < 5) && amplitude.every((a) => a >= 0), JSON.stringify(parameters));
    } catch (error) {
      assert.ok(error instanceof Error && 'code' in error, `${error}`);
    }
  }
  const linear = shimmy.basins(/** @type {any} */ ({ ...BASINS, model: 'torsional-linear', x: { ...ANGLES, count: 4 }, y: { ...RATES, count: 2 } }));
  assert.deepEqual(linear.endings, [{ kind: 'divergence', low: 1000, high: 1000, cells: 8 }]);
});
