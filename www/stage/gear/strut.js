/**
 * The leg from the right: outer cylinder, sliding tube, torque links and the fork's near arm.
 *
 * @module
 */

import { FORK_REACH } from './pose.js';

/** @typedef {import('./sheet.js').Sheet} Sheet */
/** @typedef {import('./side.js').SideFrame} SideFrame */
/** @typedef {import('./pose.js').Pose} Pose */
/** @typedef {import('./theme.js').Theme} Theme */
/** @typedef {import('./materials.js').Materials} Materials */

/** Half widths [m]. */
const BODY = 0.07;
const TUBE = 0.038;
const CYLINDER = 0.058;
const ARM = 0.026;
const HUB = 0.028;

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {SideFrame} frame
 * @param {readonly Pose[]} poses one, or the layers of a blur
 * @param {number} opacity of what turns with each of them
 * @param {Theme} theme
 * @param {Materials} materials
 */
export function drawStrut(ctx, sheet, frame, poses, opacity, theme, materials) {
  const { scale } = frame;
  const [{ radius }] = poses;
  const up = (/** @type {number} */ h) => frame.ground - h * scale;
  const wheelTop = frame.axle + radius;
  const top = (frame.ground - frame.top) / scale - 0.012;
  const shoulder = wheelTop + 0.018;
  const cylinder = top - Math.max(0.02, Math.min(0.052, 0.55 * (top - shoulder)));

  ctx.lineJoin = 'round';
  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = 1.6 * sheet.line;
  drawTube(ctx, frame, up(cylinder), up(shoulder), materials);
  drawCylinder(ctx, sheet, frame, up(top), up(cylinder), theme, materials);
  drawRing(ctx, sheet, frame.x, 1.12 * CYLINDER * scale, up(cylinder), 0.012 * scale, theme, materials);
  ctx.globalAlpha = opacity;
  for (const pose of poses) drawArm(ctx, sheet, frame, pose, up(shoulder), up(frame.axle), theme, materials);
  for (const pose of poses) {
    drawLinks(ctx, sheet, frame, pose, up(cylinder + 0.014), up(shoulder - 0.022), theme, materials);
  }
  ctx.globalAlpha = 1;
}

/**
 * Metal that is round about a vertical axis.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {number} middle
 * @param {number} half
 * @param {Materials} materials
 */
function roundMetal(ctx, middle, half, materials) {
  const shine = ctx.createLinearGradient(middle - half, 0, middle + half, 0);
  shine.addColorStop(0, materials.metalShade);
  shine.addColorStop(0.32, materials.metalLit);
  shine.addColorStop(0.65, materials.metal);
  shine.addColorStop(1, materials.metalShade);
  return shine;
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {SideFrame} frame
 * @param {number} top
 * @param {number} bottom
 * @param {Materials} materials
 */
function drawTube(ctx, frame, top, bottom, materials) {
  const half = TUBE * frame.scale;
  const shine = ctx.createLinearGradient(frame.x - half, 0, frame.x + half, 0);
  shine.addColorStop(0, materials.metal);
  shine.addColorStop(0.35, materials.chrome);
  shine.addColorStop(1, materials.metal);
  ctx.fillStyle = shine;
  ctx.beginPath();
  ctx.rect(frame.x - half, top - 4, 2 * half, bottom - top + 8);
  ctx.fill();
  ctx.stroke();
}

/**
 * Its upper end is broken off, as on an engineer's sheet.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {SideFrame} frame
 * @param {number} top
 * @param {number} bottom
 * @param {Theme} theme
 * @param {Materials} materials
 */
function drawCylinder(ctx, sheet, frame, top, bottom, theme, materials) {
  const half = CYLINDER * frame.scale;
  const wave = 3;
  ctx.beginPath();
  ctx.moveTo(frame.x - half, bottom);
  ctx.lineTo(frame.x - half, top);
  ctx.bezierCurveTo(
    frame.x - 0.5 * half, top + 2 * wave,
    frame.x - 0.5 * half, top + wave,
    frame.x, top,
  );
  ctx.bezierCurveTo(
    frame.x + 0.5 * half, top - 2 * wave,
    frame.x + 0.7 * half, top - wave,
    frame.x + half, top,
  );
  ctx.lineTo(frame.x + half, bottom);
  ctx.closePath();
  ctx.fillStyle = roundMetal(ctx, frame.x, half, materials);
  ctx.fill();
  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = 1.6 * sheet.line;
  ctx.stroke();
}

/**
 * Torque links ahead of the tube: the lower one turns with it.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {SideFrame} frame
 * @param {Pose} pose
 * @param {number} upper
 * @param {number} lower
 * @param {Theme} theme
 * @param {Materials} materials
 */
function drawLinks(ctx, sheet, frame, pose, upper, lower, theme, materials) {
  const pins = [
    { x: frame.x + (CYLINDER - 0.006) * frame.scale, y: upper },
    { x: frame.x + (CYLINDER + 0.085 * pose.cos) * frame.scale, y: (upper + lower) / 2 },
    { x: frame.x + (BODY - 0.01) * frame.scale * pose.cos, y: lower },
  ];
  const width = 0.022 * frame.scale;
  ctx.lineCap = 'round';
  for (const [lineWidth, color] of /** @type {const} */ ([
    [width + 3 * sheet.line, theme.ink],
    [width, materials.metal],
  ])) {
    ctx.lineWidth = lineWidth;
    ctx.strokeStyle = color;
    ctx.beginPath();
    for (const pin of pins) ctx.lineTo(pin.x, pin.y);
    ctx.stroke();
  }
  ctx.lineCap = 'butt';
  ctx.strokeStyle = theme.ink;
  ctx.fillStyle = theme.surface;
  ctx.lineWidth = 1.4 * sheet.line;
  for (const pin of pins) {
    ctx.beginPath();
    ctx.arc(pin.x, pin.y, 0.4 * width, 0, 2 * Math.PI);
    ctx.fill();
    ctx.stroke();
  }
}

/**
 * The near arm: from the collar on the tube back, or ahead, to the axle. It stands to the right of
 * the wheel plane, so turning the wheel moves its lower end.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {SideFrame} frame
 * @param {Pose} pose
 * @param {number} top
 * @param {number} axle
 * @param {Theme} theme
 * @param {Materials} materials
 */
function drawArm(ctx, sheet, frame, pose, top, axle, theme, materials) {
  const { scale } = frame;
  const body = BODY * scale;
  const end = frame.x + (0.8 * FORK_REACH * pose.sin - pose.caster * pose.cos) * scale;
  const arm = ARM * scale;
  const drop = axle - top;
  const { x } = frame;
  ctx.beginPath();
  ctx.moveTo(x - body, top);
  ctx.lineTo(x + body, top);
  ctx.bezierCurveTo(x + 1.02 * body, top + 0.5 * drop, end + 2.1 * arm, top + 0.72 * drop, end + arm, axle);
  ctx.arc(end, axle, arm, 0, Math.PI);
  ctx.bezierCurveTo(end - 0.6 * arm, top + 0.72 * drop, x - 1.02 * body, top + 0.5 * drop, x - body, top);
  ctx.closePath();
  ctx.fillStyle = roundMetal(ctx, x, 1.15 * body, materials);
  ctx.fill();
  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = 1.8 * sheet.line;
  ctx.stroke();
  drawRing(ctx, sheet, x, 1.04 * body, top, 0.014 * scale, theme, materials);
  drawAxleEnd(ctx, sheet, end, axle, HUB * scale, theme, materials);
}

/**
 * A flat ring round the leg, as gland nuts and collars are.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {number} middle
 * @param {number} half
 * @param {number} top
 * @param {number} height
 * @param {Theme} theme
 * @param {Materials} materials
 */
function drawRing(ctx, sheet, middle, half, top, height, theme, materials) {
  ctx.beginPath();
  ctx.roundRect(middle - half, top - height / 2, 2 * half, height, 0.3 * height);
  ctx.fillStyle = roundMetal(ctx, middle, half, materials);
  ctx.fill();
  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = 1.4 * sheet.line;
  ctx.stroke();
}

/**
 * The axle's end in the arm: a washer and the pin in it.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {number} x
 * @param {number} y
 * @param {number} radius
 * @param {Theme} theme
 * @param {Materials} materials
 */
function drawAxleEnd(ctx, sheet, x, y, radius, theme, materials) {
  const shine = ctx.createRadialGradient(x - 0.4 * radius, y - 0.4 * radius, 0, x, y, radius);
  shine.addColorStop(0, materials.chrome);
  shine.addColorStop(1, materials.metal);
  ctx.beginPath();
  ctx.arc(x, y, radius, 0, 2 * Math.PI);
  ctx.fillStyle = shine;
  ctx.fill();
  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = 2 * sheet.line;
  ctx.stroke();
  ctx.beginPath();
  ctx.arc(x, y, 0.42 * radius, 0, 2 * Math.PI);
  ctx.lineWidth = 1.2 * sheet.line;
  ctx.stroke();
}
