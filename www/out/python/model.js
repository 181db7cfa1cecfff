import { torsionalLinear } from './torsional-linear.js';
import { torsional } from './torsional.js';

/**
 * @typedef {{ subject: string, imports: string[], rates: string, load: string }} PythonModel
 *   `subject`: what the model is, with source and equations; `imports`: from `math`; `rates`: a function of time and state
 *   that knows each parameter by its symbol; `load`: a function of ψ and y, the moments on a wheel at rest that friction may hold
 */

/**
 * A model's equations in Python; null for one that has none yet. A new one is a file beside this and a line here.
 * @param {string} name
 * @returns {PythonModel | null}
 */
export function pythonModel(name) {
  return { torsional, 'torsional-linear': torsionalLinear }[name] ?? null;
}
