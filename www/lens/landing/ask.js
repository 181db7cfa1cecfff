/**
 * What the lens asks the engine for: the landing roll of a gear, and the branches of cycles that it rolls over.
 *
 * @typedef {import('./settings.js').RollValues} RollValues
 * @typedef {{ model: string, parameters: Readonly<Record<string, number>> }} Gear
 */

/** Rows for drawing: more than the steps of any landing, so that each is there, and every turn of ψ among them. */
const rows = 200_000;
/** A picture needs no more, and a landing of the usual length is there within a frame or two. */
const rtol = 1e-6;
/** What an absurd gear may cost. */
const maxSteps = 1_000_000;

/** The roll of a gear. @param {Gear} gear @param {RollValues} roll @returns {import('../../pkg/shimmy.js').Run & { parameters: Record<string, number> }} */
export function rollSpec({ model, parameters }, { torsionAngle, ...roll }) {
  const { velocity: _, ...others } = parameters;
  return { model, parameters: others, initial: { torsionAngle }, ...roll, rows, rtol, maxSteps };
}

/** The branches under a roll, a little further than it goes. @param {Gear} gear @param {RollValues} roll @returns {import('../../pkg/shimmy.js').BifurcationSpec} */
export const branchSpec = ({ model, parameters }, roll) => ({
  model, parameters: { ...parameters }, parameter: 'velocity', from: Math.max(0.5, Math.min(roll.finalVelocity, 5) / 2), to: Math.max(100, 1.05 * roll.touchdownVelocity), step: 0.05, tolerance: 1e-4, points: 300, probes: 3,
});
