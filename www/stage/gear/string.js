/**
 * The stretched string: the contact line, its leading point, and the triangle whose angle is the
 * slip angle α = arctan(y/σ).
 *
 * @module
 */

import { bendAt } from './contact-line.js';
import { inWheelFrame } from './pose.js';
import { translucent } from './theme.js';

/** @typedef {import('./sheet.js').Sheet} Sheet */
/** @typedef {import('./pose.js').Pose} Pose */
/** @typedef {import('./contact-line.js').ContactLine} ContactLine */
/** @typedef {import('./theme.js').Theme} Theme */

/** Share of the tangent, from its far end, at which the arc of α is drawn. */
const ARC = 0.5;

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {ContactLine} line
 * @param {Theme} theme
 */
export function drawString(ctx, sheet, pose, line, theme) {
  inWheelFrame(ctx, sheet, pose, () => {
    drawTriangle(ctx, sheet, pose, theme);
    drawLine(ctx, sheet, pose, line, theme);
    drawLeadingPoint(ctx, sheet, pose, theme);
  });
}

/**
 * y from the wheel plane to the leading point, and the string's tangent from there back to the
 * plane, σ further ahead.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {Theme} theme
 */
function drawTriangle(ctx, sheet, pose, theme) {
  const x = sheet.scale * (pose.half - pose.caster);
  const y = -sheet.scale * pose.deformation;
  const reach = sheet.scale * pose.relaxation;
  ctx.beginPath();
  ctx.moveTo(x, 0);
  ctx.lineTo(x + reach, 0);
  ctx.lineTo(x, y);
  ctx.closePath();
  ctx.fillStyle = translucent(theme.y, 0.1);
  ctx.fill();

  ctx.strokeStyle = theme.y;
  ctx.lineWidth = 2 * sheet.line;
  ctx.beginPath();
  ctx.moveTo(x, 0);
  ctx.lineTo(x, y);
  ctx.stroke();
  ctx.setLineDash([7, 4]);
  ctx.beginPath();
  ctx.moveTo(x, y);
  ctx.lineTo(x + reach, 0);
  ctx.stroke();
  ctx.setLineDash([]);

  const slip = Math.atan2(y, reach);
  const radius = ARC * Math.hypot(reach, y);
  ctx.lineWidth = 1.6 * sheet.line;
  ctx.beginPath();
  ctx.arc(x + reach, 0, radius, Math.PI, Math.PI - slip, slip > 0);
  ctx.stroke();
}

/**
 * Thick where the tire touches the ground.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {ContactLine} line
 * @param {Theme} theme
 */
function drawLine(ctx, sheet, pose, line, theme) {
  const x = (/** @type {number} */ l) => sheet.scale * (l - pose.caster);
  const free = 6;
  const ends = () => {
    ctx.beginPath();
    for (const side of [-1, 1]) {
      for (let i = 0; i <= free; i++) {
        const l = side * (pose.half + ((pose.radius - pose.half) * i) / free);
        if (i === 0) ctx.moveTo(x(l), -sheet.scale * bendAt(line, pose, l));
        else ctx.lineTo(x(l), -sheet.scale * bendAt(line, pose, l));
      }
    }
    ctx.stroke();
  };
  const contact = () => {
    ctx.beginPath();
    line.l.forEach((l, i) => ctx.lineTo(x(l), -sheet.scale * line.n[i]));
    ctx.stroke();
  };
  ctx.lineCap = 'round';
  ctx.lineJoin = 'round';
  ctx.strokeStyle = theme.surface;
  ctx.lineWidth = 4.4 * sheet.line;
  if (pose.half < pose.radius) ends();
  ctx.lineWidth = 8 * sheet.line;
  contact();
  ctx.strokeStyle = theme.y;
  ctx.lineWidth = 2 * sheet.line;
  if (pose.half < pose.radius) ends();
  ctx.lineWidth = 4.6 * sheet.line;
  contact();
  ctx.lineCap = 'butt';
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {Theme} theme
 */
function drawLeadingPoint(ctx, sheet, pose, theme) {
  const x = sheet.scale * (pose.half - pose.caster);
  ctx.beginPath();
  ctx.arc(x, -sheet.scale * pose.deformation, 4.6 * sheet.line, 0, 2 * Math.PI);
  ctx.fillStyle = theme.surface;
  ctx.fill();
  ctx.strokeStyle = theme.y;
  ctx.lineWidth = 2.4 * sheet.line;
  ctx.stroke();
}
