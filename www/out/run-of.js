import { plain } from '../engine/fitted.js';

/**
 * The experiment of the page as a run that says everything itself: every parameter and every start, whatever the
 * defaults of a later version, and tolerances at which anybody's solver comes to the same numbers.
 *
 * @typedef {import('../engine/engine.js').Model} Model
 * @typedef {Pick<import('../store.js').State, 'object' | 'parameters' | 'run'>} Experiment
 * @typedef {{
 *   model: string, parameters: Record<string, number>, friction?: Record<string, number>, damper?: import('../engine/engine.js').Run['damper'], initial: Record<string, number>,
 *   duration: number, samples: number, rtol: number,
 * }} WholeRun
 *
 * @param {Experiment} experiment
 * @param {Model} table
 * @param {number} duration in s
 * @returns {WholeRun}
 */
export function runOf({ object, parameters, run }, table, duration) {
  // Forty samples in a cycle of 50 Hz, twenty where the run is long.
  const interval = duration <= 10 ? 5e-4 : 1e-3;
  return plain({
    model: object,
    parameters: Object.fromEntries(table.parameters.map(({ name, default: usual }) => [name, parameters[name] ?? usual])),
    initial: Object.fromEntries(table.state.map(({ name }) => [name, run.initial[name] ?? 0])),
    duration,
    samples: Math.max(2, Math.round(duration / interval) + 1),
    rtol: 1e-11,
  });
}
