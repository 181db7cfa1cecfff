/**
 * Long work beside the page: the jobs of the engine, in workers that each have an instance of the one compiled module; those
 * that move many motions at once, of the one made for that.
 *
 * @typedef {import('../pkg/shimmy.js').Jobs} Jobs
 * @typedef {keyof Jobs} Kind
 * @typedef {import('./tiles.js').Tile} Tile
 */

import { compiledEngine } from './engine.js';
import { Pool } from './pool.js';
import { compiledForEnsembles } from './relaxed.js';
import { startWorker } from './start-worker.js';
import { Assembly, tilesOf } from './tiles.js';

/** @type {Record<'ensembles' | 'others', Pool | null>} */
const shared = { ensembles: null, others: null };

/** Workers that leave a core to the page, where there is more than one. @param {Kind} kind of their jobs */
function poolFor(kind) {
  const most = (navigator.hardwareConcurrency || 2) - 1;
  if (kind === 'basins' || kind === 'sweep') return (shared.ensembles ??= workers(most, compiledForEnsembles));
  return (shared.others ??= workers(most));
}

/** The workers that look for a damper's values. */
export const pool = () => poolFor('identification');

/** As many workers as asked for, at least one; started when there is work. @param {number} most @param {() => Promise<WebAssembly.Module>} compiled */
export const workers = (most, compiled = compiledEngine) =>
  new Pool(async () => {
    const [worker, module] = await Promise.all([startWorker(), compiled()]);
    worker.postMessage({ module });
    return worker;
  }, most);

/**
 * Runs a job of the engine beside the page. Rejected with the engine's refusal (its data as properties), with the signal's
 * reason, or where the worker died; the next call has another one.
 * @template {Kind} K
 * @param {K} kind
 * @param {Jobs[K]['spec']} spec
 * @param {object} [options]
 * @param {(fraction: number) => void} [options.onProgress] how much is done, 0 … 1
 * @param {(part: Jobs[K]['part']) => void} [options.onPart] what is there on the way, ten times a second
 * @param {AbortSignal} [options.signal] ends the job
 * @param {Pool} [options.among] other workers than the page's
 * @returns {Promise<Jobs[K]['result']>}
 */
export const runJob = (kind, spec, { among, ...options } = {}) => (among ?? poolFor(kind)).run(kind, spec, options);

/**
 * Runs a job over a plane tile by tile, so that all workers share it.
 * @template {Kind} K
 * @param {K} kind one whose spec has `x.count`, `y.count` and `tile`
 * @param {Jobs[K]['spec']} spec without a tile
 * @param {object} [options]
 * @param {(tile: Tile, result: Jobs[K]['result']) => void} [options.onTile] a tile that is done
 * @param {(fraction: number) => void} [options.onProgress]
 * @param {AbortSignal} [options.signal]
 * @param {{ columns?: number, rows?: number }} [options.size] of a tile
 * @param {Pool} [options.among] other workers than the page's
 * @returns {Promise<Jobs[K]['result']>} of the whole plane
 */
export async function mapTiles(kind, spec, { onTile, onProgress, signal, size, among = poolFor(kind) } = {}) {
  const whole = new Assembly(spec);
  const tiles = tilesOf(kind, spec, among.size, size);
  const cells = tiles.map(({ columns, rows }) => columns * rows);
  const all = cells.reduce((sum, count) => sum + count, 0);
  const done = tiles.map(() => 0);
  const ended = new AbortController();
  const one = async (/** @type {Tile} */ tile, /** @type {number} */ place) => {
    const told = (/** @type {number} */ fraction) => {
      done[place] = fraction * cells[place];
      onProgress?.(done.reduce((sum, part) => sum + part, 0) / all);
    };
    const result = await among.run(kind, { ...spec, tile }, { onProgress: told, signal: signal ? AbortSignal.any([signal, ended.signal]) : ended.signal });
    whole.put(tile, result);
    told(1);
    onTile?.(tile, result);
  };
  try {
    await Promise.all(tiles.map(one));
  } catch (error) {
    ended.abort(error); // one that fails ends the others
    throw error;
  }
  return whole.result;
}
