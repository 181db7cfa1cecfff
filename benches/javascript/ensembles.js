// Ensembles: trajectories of two seconds that a core takes in a second, beside the scalar loops; and what workers share.

import { fork } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { Worker } from 'node:worker_threads';

import { shortest } from './contest.js';

/** @typedef {typeof import('../../www/pkg/shimmy.js')} Shimmy */
/** @typedef {{ what: string, perSecond: number, goal?: string }} Row */

/** Steps of two seconds at 50 Hz, a hundredth of a swing each. */
const STEPS = 10_000;
const COUNT = 64;
/** How often each group of workers does the ensemble in a round, and how many rounds. */
const TIMES = 8;
const ROUNDS = 25;

/**
 * As many motions as make this ensemble, none of which settles: the gear is at its critical speed, where a swing neither
 * grows nor fades. Each takes ten stretches of a thousand steps, four hundred of them measured.
 * @type {import('../../www/pkg/shimmy.js').BasinsSpec}
 */
export const ENSEMBLE = {
  model: 'torsional',
  parameters: { velocity: 37.263, dampingConstant: 30 },
  x: { state: 'torsionAngle', from: 0.02, to: 0.03, count: COUNT },
  y: { state: 'torsionRate', from: -1, to: 1, count: 1 },
  refine: false,
  duration: 1.9,
};

/** What a worker does: the ensemble so many times, each by a job. @param {Shimmy} shimmy @param {number} times */
export function work(shimmy, times) {
  for (let time = 0; time < times; time++) {
    const job = new shimmy.Job('basins', ENSEMBLE);
    while (!job.advance(8).done);
    const { kind } = /** @type {import('../../www/pkg/shimmy.js').Basins} */ (job.result());
    if (kind.some((cell) => cell !== 4)) throw new Error('a motion has settled: the ensemble is no measure');
    job.free();
  }
}

/** The textbook's loop with the tire law from the standard library. @param {number} steps */
function plain(steps) {
  const [v, e, a, sigma, k, c, load, side, aligning, tread] = [37.263, 0.1, 0.1, 0.3, 1e5, 30, 9000, 20, 2, 270];
  const [delta, limit, h] = [(5 * Math.PI) / 180, (10 * Math.PI) / 180, 2e-4];
  const rate = (/** @type {number} */ psi, /** @type {number} */ turning, /** @type {number} */ y) => {
    const alpha = Math.atan(y / sigma);
    const force = side * load * Math.max(-delta, Math.min(delta, alpha));
    const moment = Math.abs(alpha) <= limit ? ((-aligning * load * limit) / Math.PI) * Math.sin((Math.PI * alpha) / limit) : 0;
    return [turning, -k * psi - (c + tread / v) * turning + moment - e * force, v * psi + (e - a) * turning - (v / sigma) * y];
  };
  let x = [0.025, 0, 0];
  const moved = (/** @type {number[]} */ by, /** @type {number} */ time) => x.map((value, i) => value + time * by[i]);
  for (let step = 0; step < steps; step++) {
    const k1 = rate(x[0], x[1], x[2]);
    const b = moved(k1, h / 2);
    const k2 = rate(b[0], b[1], b[2]);
    const d = moved(k2, h / 2);
    const k3 = rate(d[0], d[1], d[2]);
    const f = moved(k3, h);
    const k4 = rate(f[0], f[1], f[2]);
    x = x.map((value, i) => value + (h / 6) * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]));
  }
  return x;
}

/** @typedef {(times: number) => Promise<unknown>} Hand what does the ensemble so many times */

/** @param {Worker | import('node:child_process').ChildProcess} hand @param {(times: number) => void} send @returns {Hand} */
const heard = (hand, send) => (times) =>
  new Promise((done) => {
    /** @type {any} */ (hand).once('message', done);
    send(times);
  });

/** Trajectories a second of groups of hands, each the best of rounds that take turns: who else is at work hits all alike. @param {Hand[][]} groups */
async function perSecondOf(groups) {
  const least = groups.map(() => Infinity);
  for (const hands of groups) await Promise.all(hands.map((hand) => hand(4)));
  for (let round = 0; round < ROUNDS; round++) {
    for (const [place, hands] of groups.entries()) {
      const start = performance.now();
      await Promise.all(hands.map((hand) => hand(TIMES)));
      least[place] = Math.min(least[place], performance.now() - start);
    }
  }
  return groups.map((hands, place) => (hands.length * TIMES * COUNT) / (least[place] / 1000));
}

/**
 * One and two workers, one with relaxed SIMD, and one and two processes that share nothing: what those two gain is what the
 * machine gives.
 * @param {WebAssembly.Module} module
 * @param {WebAssembly.Module | null} relaxed
 */
async function shared(module, relaxed) {
  const workers = [module, module, ...(relaxed ? [relaxed] : [])].map((workerData) => new Worker(new URL('./ensemble-worker.js', import.meta.url), { workerData }));
  const processes = [1, 2].map(() => fork(fileURLToPath(new URL('./ensemble-process.js', import.meta.url))));
  const [one, other, ...fused] = workers.map((worker) => heard(worker, (times) => worker.postMessage(times)));
  const [by, itself] = processes.map((process) => heard(process, (times) => process.send(times)));
  try {
    return await perSecondOf([[one], [one, other], [by], [by, itself], ...fused.map((hand) => [hand])]);
  } finally {
    for (const process of processes) process.kill();
    await Promise.all(workers.map((worker) => worker.terminate()));
  }
}

/**
 * @param {Shimmy} shimmy
 * @param {string} place
 * @param {WebAssembly.Module} module
 * @param {WebAssembly.Module | null} relaxed the one with relaxed SIMD, where that can be had
 * @returns {Promise<Row[]>}
 */
export async function ensembles(shimmy, place, module, relaxed) {
  const run = { model: 'torsional', parameters: ENSEMBLE.parameters, initial: { torsionAngle: 0.025 }, method: 'rk4', step: 2e-4, duration: 2, samples: 2 };
  const perSecond = (/** @type {() => unknown} */ work, /** @type {number} */ trajectories) => trajectories / (shortest(work, 1500).least / 1000);
  const [alone, both, by, itself, fused] = await shared(module, relaxed);
  const times = (/** @type {number} */ two, /** @type {number} */ one) => `${(two / one).toFixed(2)} × one`;
  return [
    { what: `plain JavaScript in ${place}, one by one`, perSecond: perSecond(() => plain(STEPS), 1) },
    { what: `shimmy, wasm in ${place}, one by one (simulate, rk4)`, perSecond: perSecond(() => shimmy.simulate(run), 1) },
    { what: `shimmy, wasm in ${place}, in lanes (basins)`, perSecond: perSecond(() => work(shimmy, 1), COUNT), goal: '≥ 6,500' },
    { what: `the same in one worker`, perSecond: alone },
    ...(fused ? [{ what: `the same with relaxed SIMD`, perSecond: fused, goal: '≥ 9,000' }] : []),
    { what: `the same in two workers: ${times(both, alone)}`, perSecond: both, goal: '≥ 1.8 ×' },
    { what: `in two processes that share nothing: ${times(itself, by)}, which is what the machine gives`, perSecond: itself },
  ];
}
