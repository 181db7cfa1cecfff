/**
 * The damper on its lever: piston and rod move with ψ, the cylinder swings about a fixed eye. One with a magnetorheological
 * fluid has a coil about its piston, filled as far as there is current.
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
/** The coil's windings on either side of its piston, and what of the bore each takes. */
const WINDINGS = 4;
const WINDING = 0.2;

/**
 * @param {CanvasRenderingContext2D} ctx with its origin on the steering axis of the detail
 * @param {import('./sheet.js').Sheet} sheet
 * @param {number} radius of the steering head [px]
 * @param {number} turn of the tube as drawn, counter-clockwise [rad]
 * @param {import('./theme.js').Theme} theme
 * @param {number | null} [current] as a share of the most, 0 … 1; null where it has no coil
 */
export function drawDamper(ctx, sheet, radius, turn, theme, current = null) {
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
  drawCylinder(ctx, sheet, radius, distance, piston, theme, current);
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
 * @param {number | null} current
 */
function drawCylinder(ctx, sheet, radius, distance, piston, theme, current) {
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
  if (current === null) {
    ctx.fillStyle = theme.stable;
    ctx.fillRect(-piston - 0.035 * radius, -bore / 2, 0.07 * radius, bore);
  } else drawCoil(ctx, sheet, { x: -piston, radius, bore }, current, theme);
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
 * A piston with its coil in section: rings of windings, each filled once there is current for it.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {{x: number, radius: number, bore: number}} piston
 * @param {number} current 0 … 1
 * @param {import('./theme.js').Theme} theme
 */
function drawCoil(ctx, sheet, { x, radius, bore }, current, theme) {
  const width = 0.15 * radius;
  const pitch = width / WINDINGS;
  const opacity = ctx.globalAlpha;
  // The fluid has a gap to pass between piston and bore.
  ctx.fillStyle = theme.stable;
  ctx.fillRect(x - width / 2, -0.44 * bore, width, 0.88 * bore);
  for (let i = 0; i < WINDINGS; i++) {
    const filled = Math.min(1, Math.max(0, current * WINDINGS - i));
    for (const side of [-1, 1]) {
      ctx.beginPath();
      ctx.arc(x - width / 2 + (i + 0.5) * pitch, side * 0.26 * bore, Math.min(0.42 * pitch, WINDING * bore), 0, 2 * Math.PI);
      ctx.fillStyle = theme.surface;
      ctx.fill();
      ctx.globalAlpha = opacity * filled;
      ctx.fillStyle = theme.force;
      ctx.fill();
      ctx.globalAlpha = opacity;
    }
  }
  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = sheet.line;
  ctx.beginPath();
  ctx.rect(x - width / 2, -0.44 * bore, width, 0.88 * bore);
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
