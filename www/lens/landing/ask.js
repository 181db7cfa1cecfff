/**
 * What the lens asks the engine for: the landing roll of a gear, and the branches of cycles that it rolls over.
 *
 * @typedef {import('./settings.js').RollValues} RollValues
 * @typedef {import('./roll.js').Roll} Roll
 * @typedef {{ model: string, parameters: Readonly<Record<string, number>> }} Gear
 */

import { durationOf } from './settings.js';

/** Samples a second: thirty in a cycle of 50 Hz, which lose two thirds of a percent of a peak at most. */
const fine = 1600;

/** The roll of a gear. @param {Gear} gear @param {RollValues} roll */
export function rollSpec({ model, parameters }, { torsionAngle, ...roll }) {
  return { model, parameters: { ...parameters }, initial: { torsionAngle }, ...roll, samples: Math.max(2, Math.ceil(fine * durationOf(roll))) };
}

/**
 * Has a roll computed beside the page.
 * @param {typeof import('../../engine/workers.js').runJob} run @param {ReturnType<typeof rollSpec>} spec @param {{ signal: AbortSignal }} options
 * @returns {Promise<Roll>}
 */
export const rolled = (run, spec, options) => /** @type {any} */ (run)('landingRoll', spec, options);

/** The branches under a roll, a little further than it goes. @param {Gear} gear @param {RollValues} roll @returns {import('../../pkg/shimmy.js').BifurcationSpec} */
export const branchSpec = ({ model, parameters }, roll) => ({
  model, parameters: { ...parameters }, parameter: 'velocity', from: Math.max(0.5, Math.min(roll.finalVelocity, 5) / 2), to: Math.max(100, 1.05 * roll.touchdownVelocity), step: 0.05, tolerance: 1e-4, points: 300, probes: 3,
});
