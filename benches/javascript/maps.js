// Maps of stability: our module beside the plain loop over the same cells, in Node and in a page alike.

import { shortest } from './contest.js';

/** @typedef {typeof import('../../www/pkg/shimmy.js')} Shimmy */
/** @typedef {import('../../www/pkg/shimmy.js').MapSpec} MapSpec */
/** @typedef {{ what: string, cells: number, milliseconds: number, percent?: number, goal?: string }} Row */

/** How long the plain loop is repeated, in ms: its first rounds are an interpreter's, and its best is to stand beside ours. */
const PLAIN = 3000;

const SPEEDS = { parameter: 'velocity', from: 0.5, to: 100, count: 1000 };
const CASTERS = { parameter: 'casterLength', from: 0, to: 0.5, count: 1000 };
const DAMPINGS = { parameter: 'dampingConstant', from: 0, to: 100, count: 1000 };

/** @type {[string, MapSpec, string][]} */
const MAPS = [
  ['e over v', { model: 'torsional', x: SPEEDS, y: CASTERS }, '≤ 0.06 ms'],
  ['c over v', { model: 'torsional', x: SPEEDS, y: DAMPINGS }, '≤ 0.06 ms'],
  ['c over v to 600 m/s, two boundaries a row', { model: 'torsional', x: { ...SPEEDS, to: 600 }, y: DAMPINGS }, '≤ 0.5 ms'],
  ['c_Fα over a, σ and κ following: degree 5', {
    model: 'torsional',
    x: { parameter: 'halfContactLength', from: 0.01, to: 0.3, count: 1000 },
    y: { parameter: 'sideForceDerivative', from: 1, to: 50, count: 1000 },
    linked: { relaxationLength: true, treadWidthMomentConstant: true },
  }, '≤ 0.5 ms'],
];

/**
 * The whole map within the module, from making room for it to its last cell, without reading the question and without
 * copying the answer: a job's time less that of a job of one cell.
 * @param {Shimmy} shimmy
 * @param {MapSpec} map
 */
function within(shimmy, map) {
  const work = (/** @type {MapSpec} */ spec) => () => {
    const job = new shimmy.Job('stabilityMap', spec);
    job.advance(1e6);
    job.free();
  };
  const one = { ...map, x: { ...map.x, count: 1 }, y: { ...map.y, count: 1 } };
  return shortest(work(map)).least - shortest(work(one), 100).least;
}

/** The conditions of Routh and Hurwitz as a textbook has them, cell by cell, with the default gear. @param {number} count */
function plain(count) {
  const [a, sigma, inertia, k, c, load, sideForce, aligning, tread] = [0.1, 0.3, 1, 1e5, 10, 9000, 20, 2, 270];
  const stable = new Uint8Array(count * count);
  for (let row = 0; row < count; row++) {
    const e = (0.5 * (row + 0.5)) / count;
    for (let column = 0; column < count; column++) {
      const v = 0.5 + (99.5 * (column + 0.5)) / count;
      const b = (-(aligning + e * sideForce) * load) / (sigma * inertia);
      const a2 = v / sigma + (c + tread / v) / inertia;
      const a1 = k / inertia + ((c + tread / v) * v) / (sigma * inertia) - (e - a) * b;
      const a0 = (v * k) / (sigma * inertia) - v * b;
      stable[count * row + column] = a2 > 0 && a0 > 0 && a2 * a1 > a0 ? 1 : 0;
    }
  }
  return stable;
}

/**
 * @param {Shimmy} shimmy
 * @param {string} place
 * @returns {Row[]}
 */
export function maps(shimmy, place) {
  const ours = `shimmy, wasm in ${place}`;
  const only = { quantities: /** @type {MapSpec['quantities']} */ (['stable']) };
  const [first] = MAPS;
  const whole = { ...first[1], ...only };
  const small = { ...first[1], x: { ...SPEEDS, count: 400 }, y: { ...CASTERS, count: 300 } };
  const cells = 1e6;
  return [
    { what: `plain JavaScript in ${place}, cell by cell: e over v`, cells, milliseconds: shortest(() => plain(1000), PLAIN).least, percent: 100 * plain(1000).reduce((sum, cell) => sum + cell, 0) / cells },
    ...MAPS.map(([what, map, goal]) => {
      const spec = { ...map, ...only };
      return { what: `${ours}, in the module: ${what}`, cells, milliseconds: within(shimmy, spec), percent: shimmy.stabilityMap(spec).stablePercent, goal };
    }),
    { what: `${ours}, the whole call, with area and copy: e over v`, cells, milliseconds: shortest(() => shimmy.stabilityMap(whole)).least },
    { what: `${ours}, growth rates in the module: e over v`, cells: 120_000, milliseconds: within(shimmy, small), goal: '≤ 4 ms' },
    { what: `${ours}, growth rates, the whole call`, cells: 120_000, milliseconds: shortest(() => shimmy.stabilityMap(small)).least },
    { what: `${ours}, the boundary as a curve: e over v`, cells: 0, milliseconds: shortest(() => shimmy.hopfCurve(first[1])).least },
  ];
}
