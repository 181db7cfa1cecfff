/**
 * How the steering head stands on the sheet: what ψ turns and what holds it.
 *
 * The gap is always drawn ±17°, so that tooth and stop touch on the sheet exactly when |ψ| reaches
 * ψ_fp; the collar's turn is drawn with the magnification of the wheel.
 *
 * @module
 */

import { within } from './pose.js';

/** @typedef {import('./scene.js').Scene} Scene */

const DEGREE = Math.PI / 180;
/** Half of the gap, as drawn. */
export const DRAWN_GAP = 17 * DEGREE;
const LARGEST_TURN = 75 * DEGREE;

/** Radii of the head's parts as shares of the detail's. */
export const HOUSING = 0.885;
export const COLLAR = 0.52;
export const BORE = 0.325;
export const TUBE = 0.27;
export const TOOTH_TIP = 0.49;

/**
 * @typedef {object} HeadPose
 * @property {number} collar drawn turn of the collar, counter-clockwise [rad]
 * @property {number} tube drawn turn of the tube
 * @property {number} gap drawn half gap, 0 without freeplay
 * @property {-1 | 0 | 1} touching the stop that the tooth presses on: 1 the one it meets turning
 *   counter-clockwise, 0 none
 */

/**
 * The head at the present state.
 *
 * @param {Scene} scene
 * @returns {HeadPose}
 */
export function headPose(scene) {
  return headPoseAt(scene, scene.state[0] ?? 0, scene.forces.springAngle);
}

/**
 * The head at each pose of the fan. The tooth takes the collar along by what its place in the slot
 * leaves of ψ.
 *
 * @param {Scene} scene
 * @returns {HeadPose[]}
 */
export function headFan(scene) {
  const freeplay = scene.parameters.freeplayAngle ?? 0;
  return (scene.fan ?? []).map(({ psi }) => headPoseAt(scene, psi, psi - within(psi, freeplay)));
}

/**
 * @param {Scene} scene
 * @param {number} psi
 * @param {number} springAngle
 * @returns {HeadPose}
 */
function headPoseAt(scene, psi, springAngle) {
  const freeplay = scene.parameters.freeplayAngle ?? 0;
  const collar = within(scene.magnification * springAngle, LARGEST_TURN);
  if (!(freeplay > 0)) return { collar, tube: collar, gap: 0, touching: 0 };
  const place = within(psi / freeplay, 1);
  const touching = Math.abs(place) === 1 ? /** @type {-1 | 1} */ (place) : 0;
  return { collar, tube: collar + DRAWN_GAP * place, gap: DRAWN_GAP, touching };
}
