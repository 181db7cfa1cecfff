/**
 * Dry friction in the steering head: a fixed shoe that rubs on the tube, and the torque by which it works against the turning.
 *
 * @module
 */

import { fillHead } from './arrow.js';
import { HOUSING, TUBE } from './head-pose.js';
import { materialsFor } from './materials.js';

/** @typedef {import('./sheet.js').Sheet} Sheet */
/** @typedef {import('./scene.js').Scene} Scene */
/** @typedef {import('./theme.js').Theme} Theme */

const DEGREE = Math.PI / 180;
/** Where the shoe is, to the left, and half of the angle that it embraces. */
const PLACE = 196 * DEGREE;
const EMBRACE = 38 * DEGREE;
/** Radii of lining and shoe beyond the tube, and the torque's arc, as shares of the detail's. */
const LINING = TUBE + 0.045;
const SHOE = TUBE + 0.12;
const ARC = 0.475;
/** The arc of a friction that gives all it can. */
const FULL = 62 * DEGREE;

/** Whether anything rubs. @param {Pick<Scene, 'parameters'>} scene */
export const rubs = ({ parameters }) => (parameters['friction.moment'] ?? 0) > 0;

/**
 * @param {CanvasRenderingContext2D} ctx with its origin on the steering axis of the detail
 * @param {Sheet} sheet
 * @param {number} radius of the steering head [px]
 * @param {Theme} theme
 */
export function drawBrake(ctx, sheet, radius, theme) {
  const materials = materialsFor(theme);
  const half = 0.04 * radius;
  ctx.save();
  ctx.rotate(-PLACE);
  ctx.lineJoin = 'round';
  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = 1.2 * sheet.line;
  ctx.fillStyle = materials.metal;
  ctx.beginPath();
  ctx.rect(SHOE * radius, -half, (HOUSING - SHOE) * radius, 2 * half);
  ctx.fill();
  ctx.stroke();
  ring(ctx, LINING * radius, SHOE * radius);
  ctx.fill();
  ctx.stroke();
  ring(ctx, (TUBE + 0.01) * radius, LINING * radius);
  ctx.fillStyle = theme.stable;
  ctx.fill();
  ctx.restore();
}

/**
 * The torque on the tube as an arc around it, from the shoe the way it turns the wheel: as long as it is large.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {number} radius
 * @param {Scene} scene
 * @param {Theme} theme
 */
export function drawBrakeTorque(ctx, sheet, radius, scene, theme) {
  const share = (scene.forces.frictionTorque ?? 0) / (scene.parameters['friction.moment'] ?? 1);
  const head = 0.15 * radius;
  // Positive turns counter-clockwise, which on a canvas is against its angles.
  const sweep = -share * FULL;
  const arc = ARC * radius;
  if (Math.abs(sweep) * arc < head) return;
  const end = -PLACE + sweep;
  const neck = end - Math.sign(sweep) * ((0.8 * head) / arc);
  for (const [color, width] of /** @type {const} */ ([[theme.surface, 5.5], [theme.stable, 2.6]])) {
    ctx.strokeStyle = color;
    ctx.fillStyle = color;
    ctx.lineWidth = width * sheet.line;
    ctx.beginPath();
    ctx.arc(0, 0, arc, -PLACE, neck, sweep < 0);
    ctx.stroke();
    // The head lies along the chord from its neck.
    const [x, y] = [arc * Math.cos(end), arc * Math.sin(end)];
    fillHead(ctx, x, y, Math.atan2(y - arc * Math.sin(neck), x - arc * Math.cos(neck)), head);
    if (color === theme.surface) ctx.stroke();
  }
}

/** A piece of a ring as wide as the shoe. @param {CanvasRenderingContext2D} ctx @param {number} inner @param {number} outer */
function ring(ctx, inner, outer) {
  ctx.beginPath();
  ctx.arc(0, 0, outer, -EMBRACE, EMBRACE);
  ctx.arc(0, 0, inner, EMBRACE, -EMBRACE, true);
  ctx.closePath();
}
