/**
 * How the wheel stands on the sheet: the state, magnified.
 *
 * One factor M multiplies ψ and y together, or the slip angle would lie. Points of the wheel are
 * (l, n): l meters ahead of the contact center along the wheel plane, n meters to its left.
 *
 * @module
 */

import { heldDeformation } from './bend.js';
import { WHEEL_RADIUS, WHEEL_WIDTH } from './sheet.js';

/** @typedef {import('./scene.js').Scene} Scene */
/** @typedef {import('./sheet.js').Sheet} Sheet */

/** Beyond this the drawn wheel stands still: the model is not trusted there, and numbers tell. */
export const LARGEST_ANGLE = (75 * Math.PI) / 180;

/**
 * @typedef {object} Pose
 * @property {number} angle drawn angle of the wheel, Mψ [rad]
 * @property {number} cos
 * @property {number} sin
 * @property {number} deformation drawn deformation at the leading contact point, My as far as a tire bends [m]
 * @property {number} caster e [m]
 * @property {number} half half contact length a [m]
 * @property {number} relaxation relaxation length σ [m]
 * @property {number} radius of the wheel, larger than its constant under a very long contact [m]
 */

/** A value held between ± limit; what is no number is taken as 0. @param {number} value @param {number} limit */
export const within = (value, limit) => Math.min(limit, Math.max(-limit, Number.isFinite(value) ? value : 0));

/** Mψ [rad]. @param {Scene} scene @param {number} psi */
export const drawnAngle = (scene, psi) => within(scene.magnification * psi, LARGEST_ANGLE);

/** My as far as a tire bends [m]. @param {Scene} scene @param {number} y */
export const drawnDeformation = (scene, y) => heldDeformation(within(scene.magnification * y, Infinity));

/**
 * @param {Scene} scene
 * @param {number} psi
 * @param {number} y
 * @returns {Pose}
 */
export function poseOf(scene, psi, y) {
  const { casterLength = 0, halfContactLength = 0.1, relaxationLength = 0.3 } = scene.parameters;
  const angle = drawnAngle(scene, psi);
  return {
    angle,
    cos: Math.cos(angle),
    sin: Math.sin(angle),
    deformation: drawnDeformation(scene, y),
    caster: casterLength,
    half: halfContactLength,
    relaxation: relaxationLength,
    radius: Math.min(1.24 * WHEEL_RADIUS, Math.max(WHEEL_RADIUS, 1.15 * halfContactLength)),
  };
}

/**
 * The pose at the present state.
 *
 * @param {Scene} scene
 */
export function poseNow(scene) {
  return poseOf(scene, scene.state[0] ?? 0, scene.state[2] ?? 0);
}

/**
 * A point of the wheel on the sheet [px].
 *
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {number} l
 * @param {number} n
 */
export function onSheet(sheet, pose, l, n) {
  const ahead = l - pose.caster;
  return {
    x: sheet.axis.x + sheet.scale * (ahead * pose.cos - n * pose.sin),
    y: sheet.axis.y - sheet.scale * (ahead * pose.sin + n * pose.cos),
  };
}

/**
 * Runs `draw` with the context in the wheel's frame: origin on the steering axis, x along the
 * wheel plane, in pixels.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {() => void} draw
 */
export function inWheelFrame(ctx, sheet, pose, draw) {
  ctx.save();
  ctx.translate(sheet.axis.x, sheet.axis.y);
  ctx.rotate(-pose.angle);
  draw();
  ctx.restore();
}

/** How far the wheel and its fork reach to each side of the wheel plane [m]. */
export const FORK_REACH = WHEEL_WIDTH / 2 + 0.055;
