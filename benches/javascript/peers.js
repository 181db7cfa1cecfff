// The solvers in JavaScript that shimmy is measured against: one line of JSON for each.

import ode45 from 'ode45-cash-karp';
import odex from 'odex';

import { theCase } from './case.js';
import { enter } from './contest.js';
import { dormandPrince } from './dormand-prince.js';
import { gear } from './textbook.js';

const initial = theCase.state.map((name) => theCase.initial[name] ?? 0);
const system = gear(theCase.parameters.velocity, theCase.parameters.dampingConstant);

/** @type {Record<string, (tolerance: number) => import('./contest.js').Outcome>} */
const solvers = {
  'Dormand-Prince by hand': (tolerance) => dormandPrince(system, initial, theCase.times, tolerance),

  'ode45-cash-karp': (tolerance) => {
    let evaluations = 0;
    /** @type {typeof system} */
    const counted = (rate, state) => {
      evaluations++;
      system(rate, state);
    };
    const integrator = ode45(Float64Array.from(initial), counted, 0, 1e-5, { tol: tolerance, verbose: false });
    let steps = 0;
    const states = theCase.times.map((time) => {
      while (integrator.step(time)) steps++;
      return Float64Array.from(integrator.y);
    });
    return { states, steps, evaluations };
  },

  odex: (tolerance) => {
    const solver = new odex.Solver(3);
    solver.relativeTolerance = tolerance;
    solver.absoluteTolerance = tolerance / 100;
    solver.maxSteps = 1e6;
    const rate = [0, 0, 0];
    /** @param {number} _ @param {number[]} y */
    const rateAt = (_, y) => {
      system(rate, y);
      return rate.slice();
    };
    let [now, state, steps, evaluations] = [0, initial, 0, 0];
    const states = theCase.times.map((time) => {
      const leg = solver.solve(rateAt, now, state, time);
      if (leg.outcome !== odex.Outcome.Converged) throw new Error('odex gave up');
      [now, state, steps, evaluations] = [time, leg.y, steps + leg.nAccept, evaluations + leg.nEval];
      return leg.y;
    });
    return { states, steps, evaluations };
  },
};

for (const [name, solve] of Object.entries(solvers)) console.log(JSON.stringify(enter(theCase, name, solve)));
