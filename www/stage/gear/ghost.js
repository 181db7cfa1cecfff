/**
 * Ghosts: other runs in lockstep, as dashed outlines with dashed tracks, under the wheel itself; a mode in
 * the color of ψ over it, or the wheel would hide most of it.
 *
 * @module
 */

import { ghostDashes } from '../../view/strokes.js';
import { contactLine, traceBehind } from './contact-line.js';
import { inWheelFrame, poseNow } from './pose.js';
import { translucent } from './theme.js';
import { tireShape, traceTire } from './tire-shape.js';

/** @typedef {import('./sheet.js').Sheet} Sheet */
/** @typedef {import('./scene.js').Scene} Scene */
/** @typedef {import('./scene.js').Ghost} Ghost */
/** @typedef {import('./theme.js').Theme} Theme */

/** The dashes of a ghost [px]. @param {Sheet} sheet @param {number} index */
export const ghostDash = (sheet, index) => ghostDashes[index % ghostDashes.length].map((dash) => dash * sheet.line);

/**
 * The ghost as a scene of its own, in the magnification of this one.
 *
 * @param {Scene} scene
 * @param {Ghost} ghost
 * @returns {Scene}
 */
const sceneOfGhost = (scene, { state, parameters, track, roll = scene.roll }) =>
  ({ ...scene, state, parameters, track, roll });

/** The color of a ghost, and how wide its lines are [px]. @param {Sheet} sheet @param {Ghost} ghost @param {Theme} theme */
export const ghostStroke = (sheet, { isMode }, theme) => ({ color: isMode ? theme.psi : theme.ghost, width: (isMode ? 2.6 : 1.8) * sheet.line });

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Scene} scene
 * @param {number} length how much of the tracks is seen [m]
 * @param {Theme} theme
 */
export function drawGhosts(ctx, sheet, scene, length, theme) {
  ctx.lineJoin = 'round';
  ctx.strokeStyle = theme.ghost;
  ctx.fillStyle = translucent(theme.ghost, 0.08);
  scene.ghosts?.forEach((ghost, index) => {
    if (ghost.isMode) return;
    const own = sceneOfGhost(scene, ghost);
    const pose = poseNow(own);
    const trace = traceBehind(own, pose, length);
    const shape = tireShape(pose, contactLine(trace, pose));
    ctx.setLineDash(ghostDash(sheet, index));
    ctx.lineWidth = 1.5 * sheet.line;
    ctx.beginPath();
    trace.x.forEach((x, i) => ctx.lineTo(sheet.axis.x + sheet.scale * x, sheet.axis.y - sheet.scale * trace.y[i]));
    ctx.stroke();
    ctx.lineWidth = 1.8 * sheet.line;
    inWheelFrame(ctx, sheet, pose, () => {
      traceTire(ctx, sheet, pose, shape);
      ctx.fill();
      ctx.stroke();
    });
  });
  ctx.setLineDash([]);
}

/**
 * A mode's outline and track, on a pale edge so that they stand off the tire as well as the ground.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Scene} scene
 * @param {number} length how much of the track is seen [m]
 * @param {Theme} theme
 */
export function drawModeGhost(ctx, sheet, scene, length, theme) {
  scene.ghosts?.forEach((ghost, index) => {
    if (!ghost.isMode) return;
    const own = sceneOfGhost(scene, ghost);
    const pose = poseNow(own);
    const trace = traceBehind(own, pose, length);
    const shape = tireShape(pose, contactLine(trace, pose));
    const { color, width } = ghostStroke(sheet, ghost, theme);
    ctx.lineJoin = 'round';
    for (const [stroke, wide, dash] of /** @type {const} */ ([[translucent(theme.ground, 0.8), width + 2.4 * sheet.line, []], [color, width, ghostDash(sheet, index)]])) {
      ctx.strokeStyle = stroke;
      ctx.lineWidth = wide;
      ctx.setLineDash(dash);
      ctx.beginPath();
      trace.x.forEach((x, i) => ctx.lineTo(sheet.axis.x + sheet.scale * x, sheet.axis.y - sheet.scale * trace.y[i]));
      ctx.stroke();
      inWheelFrame(ctx, sheet, pose, () => {
        traceTire(ctx, sheet, pose, shape);
        ctx.stroke();
      });
    }
    ctx.setLineDash([]);
  });
}
