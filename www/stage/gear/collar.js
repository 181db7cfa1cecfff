/**
 * The collar with its slot and the tube with its tooth: the freeplay of the steering head.
 *
 * @module
 */

import { BORE, COLLAR, TOOTH_TIP, TUBE } from './head-pose.js';
import { materialsFor } from './materials.js';
import { translucent } from './theme.js';

/** @typedef {import('./sheet.js').Sheet} Sheet */
/** @typedef {import('./head-pose.js').HeadPose} HeadPose */
/** @typedef {import('./theme.js').Theme} Theme */

const DEGREE = Math.PI / 180;
/** Half of the tooth's angle. */
const TOOTH = 10 * DEGREE;
/** Where slot and tooth are: behind the axis on the sheet, below in the picture. */
const SLOT = -90 * DEGREE;

/**
 * A ring open at its slot. In the slot the gap is tinted and its stops are marked; the stop that
 * the tooth presses on glows.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {number} radius
 * @param {HeadPose} pose
 * @param {Theme} theme
 */
export function drawCollar(ctx, sheet, radius, pose, theme) {
  const materials = materialsFor(theme);
  const outer = COLLAR * radius;
  const bore = BORE * radius;
  const middle = -(SLOT + pose.collar);
  const half = TOOTH + pose.gap;

  if (pose.gap > 0) {
    ctx.beginPath();
    ctx.arc(0, 0, outer, middle - half, middle + half);
    ctx.arc(0, 0, bore, middle + half, middle - half, true);
    ctx.closePath();
    ctx.fillStyle = translucent(theme.freeplay, 0.32);
    ctx.fill();
  }

  const shine = ctx.createLinearGradient(-outer, -outer, outer, outer);
  shine.addColorStop(0, materials.metalLit);
  shine.addColorStop(0.55, materials.metal);
  shine.addColorStop(1, materials.metalShade);
  ctx.beginPath();
  ctx.arc(0, 0, outer, middle + half, middle - half + 2 * Math.PI);
  ctx.arc(0, 0, bore, middle - half + 2 * Math.PI, middle + half, true);
  ctx.closePath();
  ctx.fillStyle = shine;
  ctx.fill();
  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = 1.4 * sheet.line;
  ctx.lineJoin = 'round';
  ctx.stroke();

  if (pose.gap === 0) return;
  for (const side of /** @type {const} */ ([-1, 1])) {
    const angle = middle - side * half;
    const touched = pose.touching === side;
    if (touched) drawGlow(ctx, 0.42 * radius, angle, 0.3 * radius, theme);
    ctx.strokeStyle = touched ? theme.freeplayText : theme.freeplay;
    ctx.lineWidth = (touched ? 4.5 : 3.2) * sheet.line;
    ctx.beginPath();
    ctx.moveTo(bore * Math.cos(angle), bore * Math.sin(angle));
    ctx.lineTo(outer * Math.cos(angle), outer * Math.sin(angle));
    ctx.stroke();
  }
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {number} distance
 * @param {number} angle
 * @param {number} size
 * @param {Theme} theme
 */
function drawGlow(ctx, distance, angle, size, theme) {
  const x = distance * Math.cos(angle);
  const y = distance * Math.sin(angle);
  const glow = ctx.createRadialGradient(x, y, 0, x, y, size);
  glow.addColorStop(0, translucent(theme.freeplay, 0.95));
  glow.addColorStop(0.45, translucent(theme.freeplay, 0.5));
  glow.addColorStop(1, translucent(theme.freeplay, 0));
  ctx.fillStyle = glow;
  ctx.beginPath();
  ctx.arc(x, y, size, 0, 2 * Math.PI);
  ctx.fill();
}

/**
 * The tube with its tooth, one outline.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {number} radius
 * @param {HeadPose} pose
 * @param {Theme} theme
 */
export function drawTube(ctx, sheet, radius, pose, theme) {
  const middle = -(SLOT + pose.tube);
  // The tooth's flanks run along radii, as the stops do, so that they meet face to face.
  const root = TOOTH;
  ctx.beginPath();
  ctx.arc(0, 0, TUBE * radius, middle + root, middle - root + 2 * Math.PI);
  ctx.lineTo(TOOTH_TIP * radius * Math.cos(middle - TOOTH), TOOTH_TIP * radius * Math.sin(middle - TOOTH));
  ctx.arc(0, 0, TOOTH_TIP * radius, middle - TOOTH, middle + TOOTH);
  ctx.closePath();
  const shine = ctx.createRadialGradient(-0.1 * radius, -0.12 * radius, 0, 0, 0, TOOTH_TIP * radius);
  shine.addColorStop(0, theme.surface);
  shine.addColorStop(0.5, theme.surface);
  shine.addColorStop(1, translucent(theme.psi, 0.25));
  ctx.fillStyle = theme.surface;
  ctx.fill();
  ctx.fillStyle = shine;
  ctx.fill();
  ctx.strokeStyle = theme.psi;
  ctx.lineWidth = 2.4 * sheet.line;
  ctx.lineJoin = 'round';
  ctx.stroke();
}
