/**
 * The tire from above: rubber bent along the contact line, on a rim that stays in the wheel plane.
 * So y is seen as a shift between rim and tire.
 *
 * @module
 */

import { bendAt } from './contact-line.js';
import { materialsFor } from './materials.js';
import { inWheelFrame } from './pose.js';
import { WHEEL_WIDTH } from './sheet.js';
import { translucent } from './theme.js';
import { traceTire } from './tire-shape.js';
import { drawCrownLight, drawGrooves, drawSipes } from './tread.js';

/** @typedef {import('./sheet.js').Sheet} Sheet */
/** @typedef {import('./pose.js').Pose} Pose */
/** @typedef {import('./contact-line.js').ContactLine} ContactLine */
/** @typedef {import('./tire-shape.js').TireShape} TireShape */
/** @typedef {import('./theme.js').Theme} Theme */

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {import('./scene.js').Scene} scene
 * @param {Pose} pose
 * @param {ContactLine} line
 * @param {TireShape} shape
 * @param {Theme} theme
 */
export function drawTire(ctx, sheet, scene, pose, line, shape, theme) {
  const materials = materialsFor(theme);
  drawShadow(ctx, sheet, pose, shape, materials.shadow);
  inWheelFrame(ctx, sheet, pose, () => {
    traceTire(ctx, sheet, pose, shape);
    ctx.fillStyle = materials.rubber;
    ctx.fill();
    drawCrownLight(ctx, sheet, pose, shape, materials);
    drawPatch(ctx, sheet, pose, line, theme);
    drawGrooves(ctx, sheet, pose, shape, materials);
    drawSipes(ctx, sheet, scene, pose, line, materials);
    traceTire(ctx, sheet, pose, shape);
    ctx.strokeStyle = materials.rubberEdge;
    ctx.lineWidth = 1.4 * sheet.line;
    ctx.stroke();
    drawPatchEdge(ctx, sheet, pose, line, theme);
    drawRim(ctx, sheet, pose, materials);
  });
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {TireShape} shape
 * @param {string} color
 */
function drawShadow(ctx, sheet, pose, shape, color) {
  ctx.fillStyle = translucent(color, 0.1);
  for (let layer = 1; layer <= 2; layer++) {
    ctx.save();
    ctx.translate(2 * layer, 4 * layer);
    inWheelFrame(ctx, sheet, pose, () => {
      traceTire(ctx, sheet, pose, shape);
      ctx.fill();
    });
    ctx.restore();
  }
}

/**
 * The contact, tinted: the grooves are cut into it.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {ContactLine} line
 * @param {Theme} theme
 */
function drawPatch(ctx, sheet, pose, line, theme) {
  tracePatch(ctx, sheet, pose, line);
  ctx.fillStyle = translucent(theme.y, theme.scheme === 'dark' ? 0.36 : 0.62);
  ctx.fill();
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {ContactLine} line
 * @param {Theme} theme
 */
function drawPatchEdge(ctx, sheet, pose, line, theme) {
  tracePatch(ctx, sheet, pose, line);
  ctx.strokeStyle = theme.y;
  ctx.lineWidth = 1.4 * sheet.line;
  ctx.stroke();
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {ContactLine} line
 */
function tracePatch(ctx, sheet, pose, line) {
  const half = 0.43 * WHEEL_WIDTH * sheet.scale;
  const corners = 12;
  ctx.beginPath();
  for (const side of [-1, 1]) {
    for (let i = 0; i <= corners; i++) {
      const l = -side * pose.half * (1 - (2 * i) / corners);
      ctx.lineTo(sheet.scale * (l - pose.caster), -sheet.scale * bendAt(line, pose, l) + side * half);
    }
  }
  ctx.closePath();
}

/**
 * The rim as the eye would see it through the tire: two flanges and the well between them.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {import('./materials.js').Materials} materials
 */
function drawRim(ctx, sheet, pose, materials) {
  const length = 0.54 * pose.radius * sheet.scale;
  const half = 0.36 * WHEEL_WIDTH * sheet.scale;
  ctx.beginPath();
  ctx.roundRect(-pose.caster * sheet.scale - length, -half, 2 * length, 2 * half, 0.4 * half);
  ctx.fillStyle = translucent(materials.metalLit, 0.07);
  ctx.fill();
  ctx.strokeStyle = translucent(materials.metalLit, 0.75);
  ctx.lineWidth = 1.5 * sheet.line;
  ctx.stroke();
}
