/**
 * Earlier poses as faint outlines.
 *
 * @module
 */

import { materialsFor } from './materials.js';
import { inWheelFrame, poseOf } from './pose.js';
import { translucent } from './theme.js';
import { straightShape, traceTire } from './tire-shape.js';

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {import('./scene.js').Scene} scene
 * @param {import('./theme.js').Theme} theme
 */
export function drawTrail(ctx, sheet, scene, theme) {
  ctx.fillStyle = translucent(materialsFor(theme).mark, 0.05);
  ctx.strokeStyle = translucent(theme.ink, 0.1);
  ctx.lineWidth = sheet.line;
  for (const { psi, y } of scene.trail) {
    const pose = poseOf(scene, psi, y);
    const shape = straightShape(pose);
    inWheelFrame(ctx, sheet, pose, () => {
      traceTire(ctx, sheet, pose, shape);
      ctx.fill();
      ctx.stroke();
    });
  }
}
