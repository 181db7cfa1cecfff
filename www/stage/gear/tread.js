/**
 * The tread from above: rubber that is round across and along, its grooves, and the sipes that
 * roll over it.
 *
 * @module
 */

import { bendAt } from './contact-line.js';
import { WHEEL_WIDTH } from './sheet.js';
import { translucent } from './theme.js';
import { along, profile, STATIONS } from './tire-shape.js';

/** @typedef {import('./sheet.js').Sheet} Sheet */
/** @typedef {import('./pose.js').Pose} Pose */
/** @typedef {import('./tire-shape.js').TireShape} TireShape */
/** @typedef {import('./materials.js').Materials} Materials */

/** Where the grooves run, as shares of the width from the center line. */
const GROOVES = [-0.34, -0.12, 0.12, 0.34];
/** Sipes on the circumference; they show the wheel rolling, from above and from the side. */
export const SIPES = 20;
/** How far a sipe leans back toward the edge [m]. */
const LEAN = 0.014;

/**
 * Light from the upper left of the sheet, as bands over the dark rubber: from and to as shares of
 * the half width, and how much of the light each adds.
 */
const LIGHT = /** @type {const} */ ([
  [-0.86, 0.95, 0.5],
  [-0.5, 0.86, 0.34],
  [-0.05, 0.68, 0.3],
]);

/**
 * How much of the sipes is seen: they fade before the frame rate could make them stand or run back.
 *
 * @param {import('./scene.js').Scene} scene
 * @param {Pose} pose
 */
export function sipesSeen(scene, pose) {
  const spacing = (2 * Math.PI) / SIPES;
  const turn = Math.abs(scene.exposure) / pose.radius / spacing;
  return Math.min(1, Math.max(0, 1 - (turn - 0.32) / 0.14));
}

/**
 * The light on the crown, in the wheel's frame.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {TireShape} shape
 * @param {Materials} materials
 */
export function drawCrownLight(ctx, sheet, pose, shape, materials) {
  const reach = pose.radius * sheet.scale;
  const center = -pose.caster * sheet.scale;
  const light = ctx.createLinearGradient(center - reach, 0, center + reach, 0);
  for (const [at, strength] of [[0.02, 0], [0.3, 0.9], [0.55, 1], [0.75, 0.8], [0.99, 0]]) {
    light.addColorStop(at, translucent(materials.rubberLit, strength));
  }
  ctx.fillStyle = light;
  for (const [from, to, strength] of LIGHT) {
    ctx.globalAlpha = strength;
    ctx.beginPath();
    along(ctx, sheet, pose, shape, to, 1, STATIONS - 1);
    along(ctx, sheet, pose, shape, from, STATIONS - 1, 1);
    ctx.fill();
  }
  ctx.globalAlpha = 1;
}

/**
 * Grooves that follow the bend, with light on their far walls, and the shoulder that the sky lights.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {TireShape} shape
 * @param {Materials} materials
 */
export function drawGrooves(ctx, sheet, pose, shape, materials) {
  ctx.lineJoin = 'round';
  for (const [width, color, shift] of /** @type {const} */ ([
    [2.4, materials.groove, 0],
    [0.8, translucent(materials.rubberShine, 0.5), 1.6],
  ])) {
    ctx.strokeStyle = color;
    ctx.lineWidth = width * sheet.line;
    const aside = (shift * sheet.line) / sheet.scale;
    ctx.beginPath();
    for (const share of GROOVES) {
      // Outer grooves end where the shoulder rounds off.
      const end = Math.abs(share) > 0.3 ? 3 : 2;
      const n = share * WHEEL_WIDTH - aside;
      for (let i = end; i <= STATIONS - end; i++) {
        const x = sheet.scale * (shape.l[i] - pose.caster);
        const y = -sheet.scale * (shape.bend[i] + n);
        if (i === end) ctx.moveTo(x, y);
        else ctx.lineTo(x, y);
      }
    }
    ctx.stroke();
  }
  ctx.strokeStyle = translucent(materials.rubberShine, 0.8);
  ctx.lineWidth = 1.1 * sheet.line;
  ctx.beginPath();
  along(ctx, sheet, pose, shape, 0.93, 4, STATIONS - 4);
  ctx.stroke();
}

/**
 * Short cuts in both shoulders, rolling forward over the top.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {import('./scene.js').Scene} scene
 * @param {Pose} pose
 * @param {import('./contact-line.js').ContactLine} line
 * @param {Materials} materials
 */
export function drawSipes(ctx, sheet, scene, pose, line, materials) {
  const seen = sipesSeen(scene, pose);
  if (seen === 0) return;
  const spacing = (2 * Math.PI) / SIPES;
  const turned = (scene.roll / pose.radius) % spacing;
  ctx.strokeStyle = translucent(materials.groove, seen);
  ctx.lineWidth = 1.6 * sheet.line;
  ctx.beginPath();
  for (let angle = turned - 1.35; angle < 1.35; angle += spacing) {
    const l = pose.radius * Math.sin(angle);
    const bend = bendAt(line, pose, l);
    const edge = 0.5 * WHEEL_WIDTH * profile(Math.sin(angle)) - 0.002;
    const root = Math.min(edge, 0.36 * WHEEL_WIDTH);
    const lean = LEAN * Math.cos(angle);
    for (const side of [-1, 1]) {
      ctx.moveTo(sheet.scale * (l - pose.caster), -sheet.scale * (bend + side * root));
      ctx.lineTo(sheet.scale * (l - lean - pose.caster), -sheet.scale * (bend + side * edge));
    }
  }
  ctx.stroke();
}
