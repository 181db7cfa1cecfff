/**
 * The damper on its lever: piston and rod move with ψ, the cylinder swings about a fixed eye.
 *
 * @module
 */

import { materialsFor } from './materials.js';

/** Lengths as shares of the steering head's radius. */
const LEVER = 0.6;
const EYE = { x: 1.07, y: 0.66 };
const CYLINDER = 0.62;
const BORE = 0.2;
/** The piston's place at rest and how near it comes to the cylinder's ends. */
const PISTON_AT_REST = 0.31;
const PISTON_MARGIN = 0.07;

/**
 * @param {CanvasRenderingContext2D} ctx with its origin on the steering axis of the detail
 * @param {import('./sheet.js').Sheet} sheet
 * @param {number} radius of the steering head [px]
 * @param {number} turn of the tube as drawn, counter-clockwise [rad]
 * @param {import('./theme.js').Theme} theme
 */
export function drawDamper(ctx, sheet, radius, turn, theme) {
  const materials = materialsFor(theme);
  const pin = { x: -LEVER * radius * Math.sin(turn), y: -LEVER * radius * Math.cos(turn) };
  const eye = { x: EYE.x * radius, y: -EYE.y * radius };
  const distance = Math.hypot(eye.x - pin.x, eye.y - pin.y);
  const rest = Math.hypot(EYE.x, EYE.y - LEVER) * radius;
  const free = PISTON_AT_REST * radius + distance - rest;
  const piston = Math.min((CYLINDER - PISTON_MARGIN) * radius, Math.max(PISTON_MARGIN * radius, free));

  drawLever(ctx, sheet, radius, turn, theme, materials);
  ctx.save();
  ctx.translate(eye.x, eye.y);
  ctx.rotate(Math.atan2(eye.y - pin.y, eye.x - pin.x));
  drawCylinder(ctx, sheet, radius, distance, piston, theme);
  ctx.restore();
  drawPin(ctx, sheet, pin, theme);
  drawPin(ctx, sheet, eye, theme);
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {number} radius
 * @param {number} turn
 * @param {import('./theme.js').Theme} theme
 * @param {import('./materials.js').Materials} materials
 */
function drawLever(ctx, sheet, radius, turn, theme, materials) {
  const half = 0.032 * radius;
  ctx.save();
  ctx.rotate(-turn);
  ctx.beginPath();
  ctx.roundRect(-half, -LEVER * radius - half, 2 * half, (LEVER - 0.22) * radius + half, half);
  ctx.fillStyle = materials.metal;
  ctx.fill();
  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = 1.2 * sheet.line;
  ctx.stroke();
  ctx.restore();
}

/**
 * In the cylinder's frame: origin at its eye, the lever's pin at −distance on the x axis.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {number} radius
 * @param {number} distance
 * @param {number} piston distance of the piston from the eye
 * @param {import('./theme.js').Theme} theme
 */
function drawCylinder(ctx, sheet, radius, distance, piston, theme) {
  const materials = materialsFor(theme);
  const length = CYLINDER * radius;
  const bore = BORE * radius;
  const round = ctx.createLinearGradient(0, -bore / 2, 0, bore / 2);
  round.addColorStop(0, materials.metal);
  round.addColorStop(0.35, theme.surface);
  round.addColorStop(0.6, theme.surface);
  round.addColorStop(1, materials.metal);
  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = 2.8 * sheet.line;
  ctx.beginPath();
  ctx.moveTo(-distance, 0);
  ctx.lineTo(-length, 0);
  ctx.stroke();
  ctx.beginPath();
  ctx.roundRect(-length, -bore / 2, length, bore, 3 * sheet.line);
  ctx.fillStyle = round;
  ctx.fill();
  ctx.lineWidth = 2.2 * sheet.line;
  ctx.beginPath();
  ctx.moveTo(-length, 0);
  ctx.lineTo(-piston, 0);
  ctx.stroke();
  ctx.fillStyle = theme.stable;
  ctx.fillRect(-piston - 0.035 * radius, -bore / 2, 0.07 * radius, bore);
  ctx.lineWidth = 1.6 * sheet.line;
  ctx.beginPath();
  ctx.roundRect(-length, -bore / 2, length, bore, 3 * sheet.line);
  ctx.stroke();
  // The gland that the rod slides through.
  const gland = 0.055 * radius;
  ctx.beginPath();
  ctx.roundRect(-length - gland / 2, -0.36 * bore, gland, 0.72 * bore, 0.25 * gland);
  ctx.fillStyle = materials.metal;
  ctx.fill();
  ctx.lineWidth = 1.2 * sheet.line;
  ctx.stroke();
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {{x: number, y: number}} at
 * @param {import('./theme.js').Theme} theme
 */
function drawPin(ctx, sheet, at, theme) {
  ctx.beginPath();
  ctx.arc(at.x, at.y, 3.6 * sheet.line, 0, 2 * Math.PI);
  ctx.fillStyle = theme.surface;
  ctx.fill();
  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = 2.6 * sheet.line;
  ctx.stroke();
}
