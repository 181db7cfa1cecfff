/**
 * The steering head, from above, in a round detail: what ψ turns and what holds it.
 *
 * The tube turns with the wheel. Its tooth sits in a slot of the collar; the spiral spring ties the
 * collar to the fixed housing. Inside the gap the tube turns alone; beyond it the tooth takes the
 * collar along, by s(ψ), and the spring winds. A damper works on a lever of the tube all the time;
 * where there is dry friction a shoe rubs on the tube.
 *
 * A fan of poses is drawn part by part, a translucent layer for each pose.
 *
 * @module
 */

import { drawBrake, drawBrakeTorque, rubs } from './brake.js';
import { drawCollar, drawTube } from './collar.js';
import { drawDamper } from './damper.js';
import { layerOpacity } from './fan.js';
import { headFan, headPose, HOUSING } from './head-pose.js';
import { drawSpring } from './spiral-spring.js';
import { drawStill } from './still.js';
import { translucent } from './theme.js';

/** @typedef {import('./sheet.js').Sheet} Sheet */
/** @typedef {import('./scene.js').Scene} Scene */
/** @typedef {import('./theme.js').Theme} Theme */

const DEGREE = Math.PI / 180;

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Scene} scene
 * @param {Theme} theme
 */
export function drawHead(ctx, sheet, scene, theme) {
  const { x, y, radius } = sheet.head;
  const poses = scene.fan?.length ? headFan(scene) : [headPose(scene)];
  const opacity = layerOpacity(poses.length);
  const edge = radius + sheet.line + 1;
  const box = { x: x - edge, y: y - edge, width: 2 * edge, height: 2 * edge };
  drawStill(ctx, sheet, theme, `housing ${radius}`, box, (onto) => {
    onto.save();
    onto.translate(x, y);
    drawHousing(onto, sheet, radius, theme);
    onto.restore();
  });
  ctx.save();
  ctx.translate(x, y);
  ctx.globalAlpha = opacity * springStrength(scene);
  for (const { collar } of poses) drawSpring(ctx, sheet, radius, collar, collar !== 0, theme);
  ctx.globalAlpha = opacity;
  for (const pose of poses) drawCollar(ctx, sheet, radius, pose, theme);
  for (const pose of poses) drawTube(ctx, sheet, radius, pose, theme);
  if (rubs(scene)) {
    ctx.globalAlpha = 1;
    drawBrake(ctx, sheet, radius, theme);
    // Of many poses there is not one torque.
    if (poses.length === 1) drawBrakeTorque(ctx, sheet, radius, scene, theme);
  }
  ctx.globalAlpha = opacity * damperStrength(scene);
  const current = coilCurrent(scene);
  for (const { tube } of poses) drawDamper(ctx, sheet, radius, tube, theme, current);
  ctx.globalAlpha = 1;
  drawCross(ctx, sheet, radius, theme);
  ctx.restore();
}

/** A part that does nothing is but a shadow. @param {Scene} scene */
const springStrength = ({ parameters }) => ((parameters.torsionalStiffness ?? 1) > 0 ? 1 : 0.3);

/** @param {Scene} scene */
const damperStrength = (scene) => ((scene.parameters.dampingConstant ?? 0) > 0 || coilCurrent(scene) !== null ? 1 : 0.35);

/** The command that fills a coil [A, V]. */
const FULL = 1.5;

/** How full the coil is; null for a damper that has none. @param {Scene} scene */
const coilCurrent = ({ parameters, command = parameters['damper.command'] }) => (command === undefined ? null : command / FULL);

/** Where the leader meets the detail: low on its near side, out of the pointer's way. */
const LEADER_END = 250 * DEGREE;

/**
 * A thin dotted line from the steering axis to the detail.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Theme} theme
 */
export function drawLeader(ctx, sheet, theme) {
  const { axis, head } = sheet;
  ctx.strokeStyle = theme.ghost;
  ctx.lineWidth = sheet.line;
  ctx.setLineDash([2, 4]);
  ctx.beginPath();
  ctx.moveTo(axis.x, axis.y);
  ctx.lineTo(head.x + head.radius * Math.cos(LEADER_END), head.y - head.radius * Math.sin(LEADER_END));
  ctx.stroke();
  ctx.setLineDash([]);
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {number} radius
 * @param {Theme} theme
 */
function drawHousing(ctx, sheet, radius, theme) {
  const inner = HOUSING * radius;
  const well = ctx.createRadialGradient(0, 0, 0.5 * inner, 0, 0, inner);
  well.addColorStop(0, theme.surface);
  well.addColorStop(0.75, theme.surface);
  well.addColorStop(1, theme.raised);
  ctx.beginPath();
  ctx.arc(0, 0, radius, 0, 2 * Math.PI);
  ctx.fillStyle = theme.surface;
  ctx.fill();
  ctx.beginPath();
  ctx.arc(0, 0, inner, 0, 2 * Math.PI);
  ctx.fillStyle = well;
  ctx.fill();

  const strokes = Math.round(radius * 0.82);
  const lean = 0.07;
  ctx.strokeStyle = translucent(theme.ink2, 0.85);
  ctx.lineWidth = sheet.line;
  ctx.beginPath();
  for (let i = 0; i < strokes; i++) {
    const angle = (2 * Math.PI * i) / strokes;
    ctx.moveTo(inner * Math.cos(angle), inner * Math.sin(angle));
    ctx.lineTo(radius * Math.cos(angle + lean), radius * Math.sin(angle + lean));
  }
  ctx.stroke();

  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = 2 * sheet.line;
  ctx.beginPath();
  ctx.arc(0, 0, radius, 0, 2 * Math.PI);
  ctx.stroke();
  ctx.lineWidth = 1.2 * sheet.line;
  ctx.beginPath();
  ctx.arc(0, 0, inner, 0, 2 * Math.PI);
  ctx.stroke();
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {number} radius
 * @param {Theme} theme
 */
function drawCross(ctx, sheet, radius, theme) {
  const arm = 0.065 * radius;
  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = 1.6 * sheet.line;
  ctx.beginPath();
  ctx.moveTo(-arm, 0);
  ctx.lineTo(arm, 0);
  ctx.moveTo(0, -arm);
  ctx.lineTo(0, arm);
  ctx.stroke();
}
