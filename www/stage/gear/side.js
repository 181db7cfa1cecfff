/**
 * The gear from the right: leg, wheel and caster over the ground line. The wheel's disc is
 * projected as it turns, so it narrows with cos Mψ and shows its tread with sin Mψ. A fan of poses
 * is drawn part by part, a translucent layer for each pose.
 *
 * @module
 */

import { layerOpacity } from './fan.js';
import { materialsFor } from './materials.js';
import { poseOf } from './pose.js';
import { drawStrut } from './strut.js';
import { drawRollingWheel } from './rolling-wheel.js';
import { translucent } from './theme.js';

/** @typedef {import('./sheet.js').Sheet} Sheet */
/** @typedef {import('./pose.js').Pose} Pose */
/** @typedef {import('./scene.js').Scene} Scene */
/** @typedef {import('./theme.js').Theme} Theme */

/** How much the tire flattens under the load [m], and the spacing of the ground's hatch [m]. */
const FLATTENING = 0.015;
const HATCH = 0.075;

/**
 * The side view's frame.
 *
 * @typedef {object} SideFrame
 * @property {number} x of the steering axis [px]
 * @property {number} ground y of the ground line [px]
 * @property {number} top [px]
 * @property {number} scale
 * @property {number} axle height of the axle [m]
 * @property {number} center place of the wheel's center ahead of the axis, projected [m]
 */

/**
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @returns {SideFrame | null}
 */
export function sideFrame(sheet, pose) {
  if (!sheet.side) return null;
  return {
    x: sheet.axis.x,
    ground: sheet.side.ground,
    top: sheet.side.top,
    scale: sheet.scale,
    axle: pose.radius - FLATTENING,
    center: -pose.caster * pose.cos,
  };
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Scene} scene
 * @param {Pose} pose
 * @param {Theme} theme
 */
export function drawSide(ctx, sheet, scene, pose, theme) {
  const frame = sideFrame(sheet, pose);
  if (!frame) return;
  const materials = materialsFor(theme);
  const poses = scene.fan?.length ? scene.fan.map(({ psi, y }) => poseOf(scene, psi, y)) : [pose];
  const opacity = layerOpacity(poses.length);
  ctx.save();
  ctx.beginPath();
  ctx.rect(0, frame.top, sheet.width, sheet.height - frame.top);
  ctx.clip();
  drawGroundLine(ctx, sheet, frame, scene, theme);
  drawShadow(ctx, frame, pose, materials.shadow);
  drawRollingWheel(ctx, sheet, frame, scene, poses, opacity, theme, materials);
  drawStrut(ctx, sheet, frame, poses, opacity, theme, materials);
  drawAxes(ctx, sheet, frame, theme);
  drawContact(ctx, sheet, frame, pose, theme);
  ctx.restore();
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {SideFrame} frame
 * @param {Scene} scene
 * @param {Theme} theme
 */
function drawGroundLine(ctx, sheet, frame, scene, theme) {
  const depth = 8;
  const spacing = HATCH * frame.scale;
  const smeared = Math.min(1, Math.max(0, (Math.abs(scene.exposure) / HATCH - 0.4) / 0.3));
  ctx.fillStyle = translucent(theme.ghost, 0.28 * smeared);
  ctx.fillRect(0, frame.ground, sheet.width, depth);
  if (smeared < 1) {
    const shift = (scene.roll % HATCH) * frame.scale;
    ctx.strokeStyle = translucent(theme.ink2, 0.8 * (1 - smeared));
    ctx.lineWidth = sheet.line;
    ctx.beginPath();
    for (const offset of [0, 1 / 3, 2 / 3]) {
      for (let x = (offset - 1) * spacing - shift; x < sheet.width + spacing; x += spacing) {
        const length = offset === 0 ? depth : 0.6 * depth;
        ctx.moveTo(x, frame.ground);
        ctx.lineTo(x - length, frame.ground + length);
      }
    }
    ctx.stroke();
  }
  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = 2 * sheet.line;
  ctx.beginPath();
  ctx.moveTo(0, frame.ground);
  ctx.lineTo(sheet.width, frame.ground);
  ctx.stroke();
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {SideFrame} frame
 * @param {Pose} pose
 * @param {string} color
 */
function drawShadow(ctx, frame, pose, color) {
  const x = frame.x + frame.center * frame.scale;
  const reach = 1.25 * pose.radius * frame.scale;
  const shade = ctx.createLinearGradient(x - reach, 0, x + reach, 0);
  shade.addColorStop(0, translucent(color, 0));
  shade.addColorStop(0.5, translucent(color, 0.28));
  shade.addColorStop(1, translucent(color, 0));
  ctx.fillStyle = shade;
  ctx.fillRect(x - reach, frame.ground, 2 * reach, 6);
}

/**
 * The steering axis down to the ground, dash-dot, and the axle's plumb line.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {SideFrame} frame
 * @param {Theme} theme
 */
function drawAxes(ctx, sheet, frame, theme) {
  const axle = frame.x + frame.center * frame.scale;
  // A halo round each dash keeps the axis legible on rubber.
  for (const [color, extra] of /** @type {const} */ ([
    [translucent(theme.surface, 0.75), 2.4],
    [theme.ink, 0],
  ])) {
    ctx.strokeStyle = color;
    ctx.lineWidth = 1.5 * sheet.line + extra;
    ctx.setLineDash([11, 4, 2, 4]);
    ctx.beginPath();
    ctx.moveTo(frame.x, frame.top);
    ctx.lineTo(frame.x, frame.ground + 20);
    ctx.stroke();
  }
  ctx.strokeStyle = translucent(theme.ghost, 0.9);
  ctx.lineWidth = sheet.line;
  ctx.setLineDash([3, 3]);
  ctx.beginPath();
  ctx.moveTo(axle, frame.ground - frame.axle * frame.scale);
  ctx.lineTo(axle, frame.ground);
  ctx.stroke();
  ctx.setLineDash([]);
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {SideFrame} frame
 * @param {Pose} pose
 * @param {Theme} theme
 */
function drawContact(ctx, sheet, frame, pose, theme) {
  const half = pose.half * pose.cos * frame.scale;
  const x = frame.x + frame.center * frame.scale;
  ctx.fillStyle = theme.y;
  ctx.fillRect(x - half, frame.ground - 2.5 * sheet.line, 2 * half, 5 * sheet.line);
}
