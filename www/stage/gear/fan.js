/**
 * The wheel where its motion is too fast for the screen: the poses of one frame's exposure laid
 * over each other, as a camera would see them. No single pose can be read from it.
 *
 * @module
 */

import { bendAt, contactLine, traceBehind } from './contact-line.js';
import { drawCrown, traceArms, ARM_WIDTH } from './fork.js';
import { materialsFor } from './materials.js';
import { inWheelFrame, onSheet, poseOf } from './pose.js';
import { atAngle } from './protractor.js';
import { RIBBON_WIDTH } from './track.js';
import { translucent } from './theme.js';
import { along, STATIONS, tireShape, traceTire } from './tire-shape.js';

/** @typedef {import('./sheet.js').Sheet} Sheet */
/** @typedef {import('./scene.js').Scene} Scene */
/** @typedef {import('./pose.js').Pose} Pose */
/** @typedef {import('./theme.js').Theme} Theme */

/** How much of the ground all poses hide together, where they all stand. */
const COVER = 0.94;

/** The opacity of each of so many layers; one alone is not translucent. @param {number} count */
export const layerOpacity = (count) => (count === 1 ? 1 : 1 - (1 - COVER) ** (1 / count));

/**
 * Lowest and highest ψ: of the last cycle where they are known, else of the fan.
 *
 * @param {Scene} scene
 */
export function swingOf({ extremes, fan }) {
  const angles = extremes ?? (fan ?? []).map(({ psi }) => psi);
  return { low: Math.min(...angles), high: Math.max(...angles) };
}

/**
 * @typedef {object} Blade one pose of the fan
 * @property {Pose} pose
 * @property {import('./contact-line.js').Trace} trace
 * @property {import('./contact-line.js').ContactLine} line
 * @property {import('./tire-shape.js').TireShape} shape
 */

/**
 * The fan's poses, each on the track as it lay at that moment of the exposure.
 *
 * @param {Scene} scene
 * @param {number} length how much of the track is seen [m]
 * @returns {Blade[]}
 */
export function bladesOf(scene, length) {
  const fan = scene.fan ?? [];
  const last = Math.max(1, fan.length - 1);
  return fan.map(({ psi, y }, i) => {
    const pose = poseOf(scene, psi, y);
    const roll = scene.roll - scene.exposure * (1 - i / last);
    const trace = traceBehind({ ...scene, roll }, pose, length);
    const line = contactLine(trace, pose);
    return { pose, trace, line, shape: tireShape(pose, line) };
  });
}

/**
 * The track under the fan, blurred by the same exposure.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {readonly Blade[]} blades
 * @param {Theme} theme
 */
export function drawTrackFan(ctx, sheet, blades, theme) {
  const { mark } = materialsFor(theme);
  const opacity = layerOpacity(blades.length);
  const { axis, scale } = sheet;
  for (const [color, width, strength] of /** @type {const} */ ([
    [mark, RIBBON_WIDTH * scale, theme.scheme === 'dark' ? 0.5 : 0.24],
    [theme.y, 2 * sheet.line, 0.7],
  ])) {
    const fade = ctx.createLinearGradient(axis.x, 0, -0.1 * sheet.width, 0);
    fade.addColorStop(0, translucent(color, strength * opacity));
    fade.addColorStop(1, translucent(color, 0));
    ctx.strokeStyle = fade;
    ctx.lineWidth = width;
    for (const { trace } of blades) {
      ctx.beginPath();
      // Every third point is enough for a blur.
      for (let i = 0; i < trace.x.length; i += 3) ctx.lineTo(axis.x + scale * trace.x[i], axis.y - scale * trace.y[i]);
      ctx.stroke();
    }
  }
}

/**
 * Tires, strings and forks, back to front, each a translucent layer for every pose: part by part,
 * or the last poses' tires would hide the first poses' forks.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {readonly Blade[]} blades
 * @param {Theme} theme
 */
export function drawWheelFan(ctx, sheet, blades, theme) {
  const materials = materialsFor(theme);
  const bar = ARM_WIDTH * sheet.scale;
  const forEach = (/** @type {(blade: Blade) => void} */ draw) => {
    for (const blade of blades) inWheelFrame(ctx, sheet, blade.pose, () => draw(blade));
  };
  ctx.lineJoin = 'round';
  ctx.lineCap = 'round';
  ctx.globalAlpha = layerOpacity(blades.length);

  ctx.fillStyle = materials.rubber;
  forEach(({ pose, shape }) => {
    traceTire(ctx, sheet, pose, shape);
    ctx.fill();
  });
  ctx.fillStyle = translucent(materials.rubberLit, 0.8);
  forEach(({ pose, shape }) => {
    ctx.beginPath();
    along(ctx, sheet, pose, shape, 0.8, 3, STATIONS - 3);
    along(ctx, sheet, pose, shape, -0.5, STATIONS - 3, 3);
    ctx.fill();
  });
  ctx.strokeStyle = theme.y;
  ctx.lineWidth = 5 * sheet.line;
  forEach((blade) => {
    traceString(ctx, sheet, blade);
    ctx.stroke();
  });
  for (const [width, color] of /** @type {const} */ ([
    [bar + 2 * sheet.line, materials.metalEdge],
    [bar, materials.metal],
    [0.5 * bar, materials.metalLit],
  ])) {
    ctx.strokeStyle = color;
    ctx.lineWidth = width;
    forEach(({ pose }) => {
      traceArms(ctx, sheet, pose);
      ctx.stroke();
    });
  }
  ctx.globalAlpha = 1;
  ctx.lineCap = 'butt';
  ctx.save();
  ctx.translate(sheet.axis.x, sheet.axis.y);
  drawCrown(ctx, sheet, materials);
  ctx.restore();
}

/**
 * The contact line, as the current path in the wheel's frame.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Blade} blade
 */
function traceString(ctx, sheet, { pose, line }) {
  ctx.beginPath();
  for (const share of [1, 0.5, 0, -0.5, -1]) {
    const l = share * pose.half;
    ctx.lineTo(sheet.scale * (l - pose.caster), -sheet.scale * bendAt(line, pose, l));
  }
}

/**
 * The wheel plane swept over the protractor.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {readonly Blade[]} blades
 * @param {Theme} theme
 */
export function drawPlaneFan(ctx, sheet, blades, theme) {
  ctx.strokeStyle = translucent(theme.psi, 1.2 * layerOpacity(blades.length));
  ctx.lineWidth = 3 * sheet.line;
  for (const { pose } of blades) {
    const tail = onSheet(sheet, pose, -pose.radius - 0.05, 0);
    const tip = atAngle(sheet, sheet.protractor - 2, pose.angle);
    ctx.beginPath();
    ctx.moveTo(tail.x, tail.y);
    ctx.lineTo(tip.x, tip.y);
    ctx.stroke();
  }
}
