/**
 * The track on the ground: what the tire has just drawn there.
 *
 * It leaves the wheel along the string's tangent, because the contact does not slip.
 *
 * @module
 */

import { materialsFor } from './materials.js';
import { translucent } from './theme.js';

/** [m] */
export const RIBBON_WIDTH = 0.13;

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {import('./contact-line.js').Trace} trace
 * @param {import('./theme.js').Theme} theme
 */
export function drawTrack(ctx, sheet, trace, theme) {
  const count = trace.x.length;
  if (count < 2) return;
  const newest = sheet.axis.x + sheet.scale * trace.x[0];

  const ribbon = ctx.createLinearGradient(newest, 0, -0.06 * sheet.width, 0);
  const { mark } = materialsFor(theme);
  const strength = theme.scheme === 'dark' ? 0.8 : 0.46;
  ribbon.addColorStop(0, translucent(mark, strength));
  ribbon.addColorStop(1, translucent(mark, 0));
  ctx.fillStyle = ribbon;
  ctx.beginPath();
  follow(ctx, sheet, trace, 0, count, RIBBON_WIDTH / 2);
  follow(ctx, sheet, trace, count - 1, -1, -RIBBON_WIDTH / 2);
  ctx.fill();

  const line = ctx.createLinearGradient(newest, 0, -0.3 * sheet.width, 0);
  line.addColorStop(0, theme.y);
  line.addColorStop(1, translucent(theme.y, 0));
  ctx.strokeStyle = line;
  ctx.lineWidth = 2 * sheet.line;
  ctx.lineJoin = 'round';
  ctx.beginPath();
  follow(ctx, sheet, trace, 0, count, 0);
  ctx.stroke();
}

/**
 * Adds one side of the ribbon to the path, from one point up to another.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {import('./contact-line.js').Trace} trace
 * @param {number} from
 * @param {number} until
 * @param {number} aside to the left [m]
 */
function follow(ctx, sheet, trace, from, until, aside) {
  const step = from < until ? 1 : -1;
  for (let i = from; i !== until; i += step) {
    ctx.lineTo(
      sheet.axis.x + sheet.scale * trace.x[i],
      sheet.axis.y - sheet.scale * (trace.y[i] + aside),
    );
  }
}
