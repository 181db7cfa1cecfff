// Branches of limit cycles: our module, in Node and in a page alike.

import { shortest } from './contest.js';

/** @typedef {typeof import('../../www/pkg/shimmy.js')} Shimmy */
/** @typedef {import('../../www/pkg/shimmy.js').BifurcationSpec} BifurcationSpec */
/** @typedef {{ what: string, points: number, milliseconds: number, goal?: string }} Row */

const DEGREE = Math.PI / 180;

/** What the goal is for: 200 cycles and more. */
const GOAL = 150;

/** @type {[string, Omit<BifurcationSpec, 'model'>][]} */
const BRANCHES = [
  ['from its Hopf point to 120 m/s, c = 20', { parameters: { dampingConstant: 20 }, parameter: 'velocity', from: 10, to: 120, step: 0.0045, probes: 0 }],
  ['through two folds, e = −0.06 m', { parameters: { casterLength: -0.06, aligningMomentLimitAngle: 40 * DEGREE }, parameter: 'velocity', from: 10, to: 120, step: 0.008, probes: 0 }],
  ['a rattle in 1° of freeplay, from Hopf point to Hopf point', { parameters: { dampingConstant: 100, freeplayAngle: DEGREE }, parameter: 'velocity', from: 1, to: 120, step: 0.0035, probes: 0 }],
];

/**
 * @param {Shimmy} shimmy
 * @param {string} place
 * @returns {Row[]}
 */
export function branches(shimmy, place) {
  const ours = `shimmy, wasm in ${place}`;
  /** @param {BifurcationSpec} spec */
  const points = (spec) => shimmy.bifurcation(spec).cycles.reduce((sum, branch) => sum + branch.amplitude.length, 0);
  const rows = BRANCHES.map(([what, rest]) => {
    const spec = { model: 'torsional', ...rest };
    const [count, milliseconds] = [points(spec), shortest(() => shimmy.bifurcation(spec)).least];
    return { what: `${ours}: ${what}`, points: count, milliseconds, goal: `≤ ${GOAL} ms for 200 points: ${Math.round((200 * milliseconds) / count)} ms` };
  });
  const searched = { model: 'torsional', ...BRANCHES[2][1], from: 40, to: 60, step: 0.025, probes: 4 };
  const velocities = { parameter: 'velocity', from: 10, to: 120 };
  const folds = { model: 'torsional', parameters: BRANCHES[1][1].parameters, x: velocities, y: { parameter: 'dampingConstant', from: 0, to: 40 } };
  const curves = shimmy.foldCurve(folds).reduce((sum, curve) => sum + curve.x.length, 0);
  return [
    ...rows,
    { what: `${ours}: the same rattle over 40 … 60 m/s, found by simulation`, points: points(searched), milliseconds: shortest(() => shimmy.bifurcation(searched)).least },
    { what: `${ours}: folds over v and c, from eight diagrams`, points: curves, milliseconds: shortest(() => shimmy.foldCurve(folds)).least },
  ];
}
