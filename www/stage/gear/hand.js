/**
 * A hand on the wheel: a soft halo while it holds, a crisp ring while the keyboard would.
 *
 * @module
 */

import { inWheelFrame } from './pose.js';
import { translucent } from './theme.js';
import { traceTire } from './tire-shape.js';

/** The halo's layers: how far each reaches beyond the tire [px], and how strong it is. */
const HALO = /** @type {const} */ ([[15, 0.1], [10, 0.13], [5, 0.2]]);
/** The ring's distance from the tire, and its width [px]. */
const GAP = 3.5;
const RING = 2.5;

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {import('./scene.js').Scene} scene
 * @param {import('./pose.js').Pose} pose
 * @param {import('./tire-shape.js').TireShape} shape
 * @param {import('./theme.js').Theme} theme
 */
export function drawHand(ctx, sheet, scene, pose, shape, theme) {
  if (!scene.held && !scene.focused) return;
  ctx.lineJoin = 'round';
  inWheelFrame(ctx, sheet, pose, () => {
    traceTire(ctx, sheet, pose, shape);
    if (scene.held) {
      for (const [reach, strength] of HALO) {
        ctx.strokeStyle = translucent(theme.psi, strength);
        ctx.lineWidth = 2 * reach * sheet.line;
        ctx.stroke();
      }
    }
    if (!scene.focused) return;
    for (const [color, reach] of /** @type {const} */ ([
      [theme.psi, GAP + RING],
      [theme.ground, GAP],
    ])) {
      ctx.strokeStyle = color;
      ctx.lineWidth = 2 * reach * sheet.line;
      ctx.stroke();
    }
  });
}
