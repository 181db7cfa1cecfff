/**
 * The spiral spring of the steering head, from the fixed housing to the collar.
 *
 * @module
 */

import { COLLAR, HOUSING } from './head-pose.js';
import { translucent } from './theme.js';

const TURNS = 3;
/** Radii of its ends, as shares of the detail's. */
const OUTER = 0.83;
const INNER = 0.57;
const STEPS = 168;

/**
 * A spiral from the housing, at the left, to the collar; heavier while it works.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {number} radius
 * @param {number} collar
 * @param {boolean} wound
 * @param {import('./theme.js').Theme} theme
 */
export function drawSpring(ctx, sheet, radius, collar, wound, theme) {
  const sweep = TURNS * 2 * Math.PI + collar;
  const outer = OUTER * radius;
  const inner = INNER * radius;
  const width = Math.min((wound ? 3.2 : 2.2) * sheet.line, 0.042 * radius);
  ctx.lineJoin = 'round';
  ctx.lineCap = 'round';
  ctx.beginPath();
  ctx.moveTo(-HOUSING * radius, 0);
  for (let i = 0; i <= STEPS; i++) {
    const share = i / STEPS;
    const angle = Math.PI + share * sweep;
    const r = outer + share * (inner - outer);
    ctx.lineTo(r * Math.cos(angle), -r * Math.sin(angle));
  }
  ctx.lineTo(-COLLAR * radius * Math.cos(collar), COLLAR * radius * Math.sin(collar));
  ctx.strokeStyle = theme.psi;
  ctx.lineWidth = width;
  ctx.stroke();
  ctx.lineCap = 'butt';
  // The light along the steel strip, where it is thick enough to show it.
  if (width < 3) return;
  ctx.strokeStyle = translucent(theme.surface, 0.5);
  ctx.lineWidth = 0.3 * width;
  ctx.stroke();
}
