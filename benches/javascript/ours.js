// Our module on the case of the benchmark, in Node and in a page alike.

import { enter, errorsOf, shortest } from './contest.js';

/** @typedef {typeof import('../../www/pkg/shimmy.js')} Shimmy */
/** @typedef {import('./case.js').Case} Case */

/** What a method is asked for in the table of work against precision. */
const ASKED = [
  ...['dormand-prince', 'dop853', 'rodas'].flatMap((method) =>
    [1e-4, 1e-6, 1e-8, 1e-10, 1e-12].map((rtol) => ({ method, rtol }))),
  ...[4e-4, 2e-4, 1e-4, 5e-5].map((step) => ({ method: 'rk4', step })),
];

/**
 * One run of the case.
 * @param {Shimmy} shimmy
 * @param {Case} theCase
 * @param {object} how method and tolerance, or step
 */
function solve(shimmy, { model, parameters, initial, times, state }, how) {
  const found = /** @type {Record<string, any>} */ (shimmy.simulate({ model, parameters, initial, times, ...how }));
  const states = times.map((_, time) => state.map((name) => /** @type {number} */ (found[name][time])));
  return { states, steps: found.stats.steps, evaluations: found.stats.evaluations, method: found.stats.method };
}

/**
 * How long the first run of a fresh module takes, and how long one takes after it: the first runs in the baseline
 * compiler of the engine. To be asked before anything else.
 * @param {Shimmy} shimmy
 * @param {Case} theCase
 */
export const warmUp = (shimmy, theCase) => shortest(() => solve(shimmy, theCase, { rtol: 1e-9 }));

/**
 * Our place in the contest.
 * @param {Shimmy} shimmy
 * @param {Case} theCase
 * @param {string} place where the module runs
 */
export const ourEntry = (shimmy, theCase, place) =>
  enter(theCase, `shimmy, wasm in ${place}`, (rtol) => solve(shimmy, theCase, { rtol }));

/**
 * Every method over the decades of tolerance.
 * @param {Shimmy} shimmy
 * @param {Case} theCase
 */
export const workAndPrecision = (shimmy, theCase) =>
  ASKED.map((how) => {
    const { states, steps, evaluations } = solve(shimmy, theCase, how);
    const milliseconds = shortest(() => solve(shimmy, theCase, how), 60).least;
    return { ...how, errors: errorsOf(theCase, states), steps, evaluations, milliseconds };
  });
