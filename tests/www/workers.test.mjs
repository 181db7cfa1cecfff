// The workers' organisation, over the real engine and without a browser: what waits, what is cancelled, what dies.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Pool } from '../../www/engine/pool.js';
import { Slices, transferable } from '../../www/engine/slices.js';
import { Assembly, tilesOf } from '../../www/engine/tiles.js';
import { shimmy } from '../node/module.mjs';

/** @typedef {import('../../www/engine/slices.js').Told} Told */

const PLANE = {
  model: 'torsional',
  x: { parameter: 'velocity', from: 0.5, to: 100, count: 60 },
  y: { parameter: 'casterLength', from: 0, to: 0.5, count: 50 },
};

/** A worker without a thread: the same slices over the same engine. What `begin` throws stands for a trap. */
class Worker extends EventTarget {
  isGone = false;
  #slices;

  /** @param {(kind: string, spec: any) => any} begin */
  constructor(begin) {
    super();
    this.#slices = new Slices(begin, (told) => queueMicrotask(() => this.#tell(told)));
  }

  /** @param {Told} told */
  #tell(told) {
    if (!this.isGone) this.dispatchEvent(Object.assign(new Event('message'), { data: structuredClone(told, { transfer: transferable(told) }) }));
  }

  /** @param {any} message */
  postMessage(message) {
    const sent = structuredClone(message);
    if ('cancel' in sent) this.#slices.cancel(sent.cancel);
    else this.#slices.work(sent);
  }

  terminate() {
    this.isGone = true;
    this.#slices.close();
  }
}

/** A job that takes a slice's time for ever, and tells that it was freed. @param {string[]} log */
const endless = (log) => ({ advance: () => ({ done: false, fraction: 0.5 }), result: () => ({ soFar: new Float64Array(3) }), free: () => log.push('freed') });

/** @param {number} most @param {(kind: string, spec: any) => any} [begin] */
function opened(most, begin = (kind, spec) => new shimmy.Job(/** @type {any} */ (kind), spec)) {
  /** @type {Worker[]} */
  const hired = [];
  const pool = new Pool(async () => {
    const worker = new Worker(begin);
    hired.push(worker);
    return worker;
  }, most);
  return { pool, hired };
}

test('a job comes to the result of the function of its name, and tells how far it is', async () => {
  const { pool, hired } = opened(1);
  /** @type {number[]} */
  const fractions = [];
  const map = { ...PLANE, x: { ...PLANE.x, count: 900 }, y: { ...PLANE.y, count: 700 } };
  assert.deepEqual(await pool.run('stabilityMap', map, { onProgress: (fraction) => fractions.push(fraction) }), shimmy.stabilityMap(map));
  assert.ok(fractions.length > 0 && fractions.every((fraction, place) => fraction < 1 && fraction > (fractions[place - 1] ?? 0)));
  assert.equal(hired.length, 1);
  pool.close();
});

test('no more workers than there is work or room for; one takes up the next job', async () => {
  const { pool, hired } = opened(2);
  await pool.run('stabilityMap', PLANE);
  assert.equal(hired.length, 1);
  const results = await Promise.all([1, 2, 3, 4, 5].map(() => pool.run('stabilityMap', PLANE)));
  assert.equal(hired.length, 2);
  for (const result of results) assert.deepEqual(result, shimmy.stabilityMap(PLANE));
  pool.close();
});

test("a refusal arrives with the engine's data, and the worker goes on", async () => {
  const { pool, hired } = opened(1);
  const bad = { ...PLANE, x: { ...PLANE.x, parameter: 'velocty' } };
  await assert.rejects(pool.run('stabilityMap', bad), { code: 'unknown-name', field: 'x.parameter', suggestion: 'velocity' });
  await assert.rejects(pool.run('stability', PLANE), { field: 'kind' });
  await assert.rejects(pool.run('stabilityMap', { ...PLANE, y: () => 0 }), { name: 'DataCloneError' });
  assert.equal((await pool.run('stabilityMap', PLANE)).stable.length, 3000);
  assert.equal(hired.length, 1);
  pool.close();
});

test('a job that is cancelled makes room, whether it runs or waits', async () => {
  /** @type {string[]} */
  const log = [];
  const { pool, hired } = opened(1, (kind, spec) => (kind === 'endless' ? endless(log) : new shimmy.Job(/** @type {any} */ (kind), spec)));
  const [runs, waits] = [new AbortController(), new AbortController()];
  const running = pool.run('endless', {}, { signal: runs.signal });
  const waiting = pool.run('endless', {}, { signal: waits.signal });
  const last = pool.run('stabilityMap', PLANE);
  waits.abort();
  await assert.rejects(waiting, { name: 'AbortError' });
  await new Promise((then) => setTimeout(then, 5));
  runs.abort(new Error('enough'));
  await assert.rejects(running, { message: 'enough' });
  assert.equal((await last).stable.length, 3000);
  assert.deepEqual(log, ['freed']);
  assert.equal(hired.length, 1);
  await assert.rejects(pool.run('stabilityMap', PLANE, { signal: runs.signal }), { message: 'enough' });
  pool.close();
});

test('what is there on the way is told to who asks', async () => {
  const going = endless([]);
  /** @type {Told[]} */
  const told = [];
  let now = 0;
  const slices = new Slices(() => going, (message) => told.push(message), () => (now += 60));
  slices.work({ id: 7, kind: 'endless', spec: {}, parts: true });
  while (told.length < 4) await new Promise((then) => setTimeout(then, 1));
  slices.cancel(7);
  slices.close();
  assert.deepEqual(told.slice(0, 4).map((message) => 'part' in message), [false, true, false, true]);
});

test('a dead instance is replaced, and only its own job is lost', async () => {
  const { pool, hired } = opened(1, (kind, spec) => {
    if (kind === 'fatal') throw new WebAssembly.RuntimeError('unreachable');
    return new shimmy.Job(/** @type {any} */ (kind), spec);
  });
  const fatal = pool.run('fatal', {});
  const next = pool.run('stabilityMap', PLANE);
  await assert.rejects(fatal, /the engine stopped: RuntimeError: unreachable/);
  assert.deepEqual(await next, shimmy.stabilityMap(PLANE));
  assert.deepEqual(hired.map((worker) => worker.isGone), [true, false]);
  hired[1].dispatchEvent(new Event('error'));
  assert.ok(hired[1].isGone);
  assert.equal((await pool.run('stabilityMap', PLANE)).stable.length, 3000);
  assert.equal(hired.length, 3);
  pool.close();
});

test('where no worker can be had, what waits is told so', async () => {
  const pool = new Pool(() => Promise.reject(new Error('no workers here')), 2);
  await assert.rejects(pool.run('stabilityMap', PLANE), { message: 'no workers here' });
  await assert.rejects(pool.run('stabilityMap', PLANE), { message: 'no workers here' });
});

test('basins and sweeps that were made in tiles are those that were made at once', () => {
  const starts = {
    model: 'torsional',
    // theory.md 4: at 50 m/s with c = 100 a gap of 1° holds a rattle. (A large cycle of its own is there at 0.06 rad.)
    parameters: { velocity: 50, dampingConstant: 100, freeplayAngle: Math.PI / 180 },
    x: { state: 'torsionAngle', from: -0.3, to: 0.3, count: 9 },
    y: { state: 'torsionRate', from: -60, to: 60, count: 7 },
    refine: false,
  };
  const gears = { ...starts, parameters: {}, x: { parameter: 'velocity', from: 10, to: 110, count: 9 }, y: { parameter: 'dampingConstant', from: 0, to: 60, count: 7 } };
  for (const spec of /** @type {any[]} */ ([starts, gears])) {
    const assembly = new Assembly(spec);
    for (const tile of tilesOf('basins', spec, 2)) assembly.put(tile, shimmy.basins({ ...spec, tile }));
    const whole = shimmy.basins(spec);
    const { amplitude, endings, ...others } = assembly.result;
    assert.deepEqual(Object.keys(assembly.result).sort(), Object.keys(whole).sort());
    assert.deepEqual({ kind: whole.kind, kinds: whole.kinds, ending: whole.ending, apart: whole.apart, followed: 63 }, others);
    // Amplitudes are measured to 2e-3 where there is a gap: the place in a lane decides of the last digits.
    assert.ok(amplitude.every((/** @type {number} */ a, /** @type {number} */ cell) => Math.abs(a - whole.amplitude[cell]) <= 4e-3 * a));
    assert.deepEqual(endings.map((/** @type {any} */ ending) => [ending.kind, ending.cells]), whole.endings.map((ending) => [ending.kind, ending.cells]));
  }
  const { x, y } = gears;
  const sweep = /** @type {any} */ ({ model: 'torsional', over: { x, y } });
  const assembly = new Assembly(sweep);
  const tiles = tilesOf('sweep', sweep, 1, { columns: 2, rows: 1 });
  assert.deepEqual(tiles.map(({ columns }) => columns), Array(7).fill(9), 'whole rows');
  for (const tile of tiles) assembly.put(tile, shimmy.sweep({ ...sweep, tile }));
  assert.deepEqual(assembly.result, shimmy.sweep(sweep));
});

test('tiles cover a plane once, and together are the plane', () => {
  const whole = shimmy.stabilityMap(PLANE);
  for (const size of [{}, { columns: 7, rows: 11 }, { columns: 1000, rows: 1000 }, { columns: 0, rows: 1 }]) {
    const assembly = new Assembly(PLANE);
    const seen = new Uint8Array(3000);
    for (const tile of tilesOf('stabilityMap', PLANE, 3, size)) {
      for (let row = tile.row; row < tile.row + tile.rows; row++)
        for (let column = tile.column; column < tile.column + tile.columns; column++) seen[60 * row + column]++;
      assembly.put(tile, shimmy.stabilityMap({ ...PLANE, tile }));
    }
    assert.ok(seen.every((count) => count === 1), JSON.stringify(size));
    const { stable, growthRate, stablePercent, stableArea } = assembly.result;
    assert.deepEqual(stable, whole.stable);
    // A root is sought from its neighbour's, so its last digits know where a tile begins.
    assert.ok(growthRate.every((/** @type {number} */ rate, /** @type {number} */ cell) => Math.abs(rate - Number(whole.growthRate?.[cell])) < 1e-9));
    assert.ok(Math.abs(stablePercent - whole.stablePercent) < 1e-9);
    // The boundary is known to 1e-6 of a plane, and so in each of the tiles that it passes.
    assert.ok(Math.abs(stableArea - whole.stableArea) < 1e-4);
  }
});
