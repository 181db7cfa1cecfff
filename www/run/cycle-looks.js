/**
 * What the engine says of the motions that repeat, with the gear's values as they are or some of them put elsewhere: asked
 * for when a lens looks.
 *
 * @typedef {import('../engine/engine.js').Engine} Engine
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {ReturnType<Engine['limitCycle']>} LimitCycle
 * @typedef {ReturnType<Engine['describingFunction']>[number]} PredictedCycle
 * @typedef {{ period: number, state: Record<string, number> }} Guess a cycle nearby: its period, and a state on it
 * @typedef {Readonly<Record<string, number>>} Values
 * @typedef {ReturnType<typeof cycleLooks>} CycleLooks
 */

import { stepsAhead } from './lookout.js';

/**
 * @param {Engine} engine
 * @param {{ model: string, parameters: Values }} gear
 * @param {() => Record<string, number>} now the state that its run is in
 */
export function cycleLooks(engine, { model, parameters }, now) {
  const run = (/** @type {Values} */ values) => ({ model, parameters: { ...parameters, ...values }, maxSteps: stepsAhead });
  return {
    /** The cycle near a guess. @param {Guess} guess @param {Values} [values] that are others @returns {LimitCycle} */
    near: (guess, values = {}) => engine.limitCycle(run(values), guess),
    /** The cycle that the run as it is now goes to. @returns {LimitCycle} */
    ofMotion: () => engine.limitCycle({ ...run({}), initial: now() }),
    /** A cycle that larger and larger pushes lead to from rest. @param {Values} [values] that are others @returns {LimitCycle} */
    fromRest: (values = {}) => engine.limitCycle(run(values)),
    /** As describing functions predict them, by rising amplitude. @param {Values} [values] that are others @returns {PredictedCycle[]} */
    predicted: (values = {}) => engine.describingFunction(run(values)),
    /** What becomes of a start. @param {Record<string, number>} initial @param {Values} [values] that are others @returns {Outlook} */
    outlook: (initial, values = {}) => engine.outlook({ ...run(values), initial }),
  };
}

/** What leads to a cycle again when the gear has changed a little; null where there is none. @param {LimitCycle | null} cycle @returns {Guess | null} */
export function guessOf(cycle) {
  if (!cycle?.found || !cycle.period) return null;
  return { period: cycle.period, state: stateAt(cycle.orbit, 0) };
}

/** The state at a place of an orbit, by name. @param {import('../engine/engine.js').Columns} orbit @param {number} i @returns {Record<string, number>} */
export function stateAt(orbit, i) {
  const { time: _, ...states } = orbit;
  return Object.fromEntries(Object.entries(states).map(([name, series]) => [name, series[i]]));
}
