/**
 * Fork, axle and steering axis from above. They turn with ψ and do not bend.
 *
 * @module
 */

import { materialsFor } from './materials.js';
import { inWheelFrame } from './pose.js';
import { WHEEL_WIDTH } from './sheet.js';
import { translucent } from './theme.js';

/** @typedef {import('./sheet.js').Sheet} Sheet */
/** @typedef {import('./pose.js').Pose} Pose */
/** @typedef {import('./theme.js').Theme} Theme */

/** From the wheel plane to the middle of an arm [m]. */
const ARM = WHEEL_WIDTH / 2 + 0.029;
export const ARM_WIDTH = 0.035;
const CROWN_RADIUS = 0.057;

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {Theme} theme
 */
export function drawFork(ctx, sheet, pose, theme) {
  const materials = materialsFor(theme);
  inWheelFrame(ctx, sheet, pose, () => {
    drawAxle(ctx, sheet, pose, materials);
    drawArms(ctx, sheet, pose, materials);
    drawNuts(ctx, sheet, pose, materials);
    drawCrown(ctx, sheet, materials);
  });
}

/**
 * Round bars: from back to front the shadow on the tire, the outline, the metal, its shaded and its
 * lit side. Shifts and widths are shares of the bar's width.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {import('./materials.js').Materials} materials
 */
function drawArms(ctx, sheet, pose, materials) {
  const bar = ARM_WIDTH * sheet.scale;
  const outline = (2.4 * sheet.line) / bar;
  ctx.lineCap = 'round';
  ctx.lineJoin = 'round';
  for (const [right, down, width, color] of /** @type {const} */ ([
    [0.2, 0.5, 1.15, translucent(materials.shadow, 0.22)],
    [0, 0, 1 + outline, materials.metalEdge],
    [0, 0, 1, materials.metalShade],
    [-0.06, -0.1, 0.78, materials.metal],
    [-0.14, -0.22, 0.28, materials.metalLit],
  ])) {
    ctx.save();
    ctx.translate(right * bar, down * bar);
    traceArms(ctx, sheet, pose);
    ctx.strokeStyle = color;
    ctx.lineWidth = width * bar;
    ctx.stroke();
    ctx.restore();
  }
  ctx.lineCap = 'butt';
}

/**
 * From one axle end round the wheel to the crown on the steering axis and on to the other end.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 */
export function traceArms(ctx, sheet, pose) {
  const axle = -pose.caster * sheet.scale;
  const arm = ARM * sheet.scale;
  ctx.beginPath();
  ctx.moveTo(axle, -arm);
  ctx.bezierCurveTo(0.45 * axle, -arm, 0, -arm, 0, 0);
  ctx.bezierCurveTo(0, arm, 0.45 * axle, arm, axle, arm);
}

/**
 * The axle runs inside the wheel, so it is only seen through it.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {import('./materials.js').Materials} materials
 */
function drawAxle(ctx, sheet, pose, materials) {
  const half = ARM * sheet.scale;
  const width = 0.026 * sheet.scale;
  ctx.beginPath();
  ctx.rect(-pose.caster * sheet.scale - width / 2, -half, width, 2 * half);
  ctx.fillStyle = translucent(materials.metal, 0.38);
  ctx.fill();
  ctx.strokeStyle = translucent(materials.metalLit, 0.5);
  ctx.lineWidth = sheet.line;
  ctx.stroke();
}

/**
 * Nuts at the axle's ends, each with the edges of its six sides.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {import('./materials.js').Materials} materials
 */
function drawNuts(ctx, sheet, pose, materials) {
  const length = 0.056 * sheet.scale;
  const width = 0.03 * sheet.scale;
  const x = -pose.caster * sheet.scale;
  const shine = ctx.createLinearGradient(x - length / 2, 0, x + length / 2, 0);
  shine.addColorStop(0, materials.metal);
  shine.addColorStop(0.4, materials.metalLit);
  shine.addColorStop(1, materials.metalShade);
  ctx.fillStyle = shine;
  ctx.strokeStyle = materials.metalEdge;
  for (const side of [-1, 1]) {
    const middle = side * (ARM + 0.56 * ARM_WIDTH) * sheet.scale;
    ctx.lineWidth = 1.2 * sheet.line;
    ctx.beginPath();
    ctx.roundRect(x - length / 2, middle - width / 2, length, width, 0.2 * width);
    ctx.fill();
    ctx.stroke();
    ctx.lineWidth = 0.7 * sheet.line;
    ctx.beginPath();
    for (const edge of [-0.25, 0.25]) {
      ctx.moveTo(x + edge * length, middle - width / 2);
      ctx.lineTo(x + edge * length, middle + width / 2);
    }
    ctx.stroke();
  }
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {import('./materials.js').Materials} materials
 */
export function drawCrown(ctx, sheet, materials) {
  const radius = CROWN_RADIUS * sheet.scale;
  const shine = ctx.createRadialGradient(-0.35 * radius, -0.4 * radius, 0, 0, 0, 1.1 * radius);
  shine.addColorStop(0, materials.metalLit);
  shine.addColorStop(0.75, materials.metal);
  shine.addColorStop(1, materials.metalShade);
  ctx.beginPath();
  ctx.arc(0, 0, radius, 0, 2 * Math.PI);
  ctx.fillStyle = shine;
  ctx.fill();
  ctx.strokeStyle = materials.metalEdge;
  ctx.lineWidth = 1.4 * sheet.line;
  ctx.stroke();
}

/**
 * The steering axis: a ring with a cross, which stays where it is.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Theme} theme
 */
export function drawSteeringAxis(ctx, sheet, theme) {
  const { x, y } = sheet.axis;
  const radius = 0.035 * sheet.scale;
  const arm = 0.62 * radius;
  ctx.beginPath();
  ctx.arc(x, y, radius, 0, 2 * Math.PI);
  ctx.fillStyle = translucent(theme.surface, 0.88);
  ctx.fill();
  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = 2 * sheet.line;
  ctx.stroke();
  ctx.beginPath();
  ctx.moveTo(x - arm, y);
  ctx.lineTo(x + arm, y);
  ctx.moveTo(x, y - arm);
  ctx.lineTo(x, y + arm);
  ctx.lineWidth = 1.6 * sheet.line;
  ctx.stroke();
}
