import { drawArrow } from '../arrow.js';
import { drawLabel } from '../text.js';
import { mix } from './ramp.js';

/**
 * A magnetorheological damper in section, that a hand can move: a cylinder full of fluid, in it the piston with its coil, filled as
 * far as there is current; in the gap the fluid's grains, which stand in chains across it where there is current.
 *
 * @typedef {import('../../style/theme.js').Theme} Theme
 * @typedef {{ x: number, force: number, command: number, isHeld: boolean }} Pose displacement and force as shares of their most, −1 … 1; `command` 0 … 1
 */

/** Shares of the width: the cylinder's ends, the piston at rest, its stroke, its length, and the rod's. */
const [back, front] = [0.06, 0.62];
export const rest = 0.34;
export const stroke = 0.2;
const length = 0.1;
const rod = 0.45;
const windings = 6;
const grains = 7;

/** Where the handle is, in px. @param {import('../canvas.js').Size} size @param {number} x */
export const handleAt = ({ width }, x) => (rest + stroke * x + rod) * width;

/** How far a hand moves the piston, as a share of its most. @param {import('../canvas.js').Size} size @param {number} pixels */
export const shareOf = ({ width }, pixels) => pixels / (stroke * width);

/** @param {CanvasRenderingContext2D} context @param {import('../canvas.js').Size} size @param {Pose} pose @param {Theme} theme */
export function drawCylinder(context, size, { x, force, command, isHeld }, theme) {
  const { width, height } = size;
  if (width < 60 || height < 24) return;
  const at = (/** @type {number} */ share) => share * width;
  const middle = height / 2;
  const bore = Math.min(0.62 * height, 0.12 * width);
  const [top, bottom] = [middle - bore / 2, middle + bore / 2];
  const piston = at(rest + stroke * x);
  const half = at(length) / 2;
  const handle = handleAt(size, x);
  const fluid = mix(theme.surface, theme.stable, 0.22);

  context.fillStyle = fluid;
  context.fillRect(at(back), top, at(front - back), bore);
  context.strokeStyle = theme.ink;
  context.lineWidth = 3.4 * theme.line;
  line(context, piston, middle, handle, middle);
  drawGap(context, { left: piston - half, right: piston + half, top, bottom }, command, theme);
  drawPiston(context, { left: piston - half, right: piston + half, top: top + 0.2 * bore, bottom: bottom - 0.2 * bore }, command, theme);
  context.strokeStyle = theme.ink;
  context.lineWidth = 2 * theme.line;
  context.beginPath();
  context.rect(at(back), top, at(front - back), bore);
  context.stroke();
  line(context, at(back) - 0.5 * bore, middle, at(back), middle);
  context.beginPath();
  context.arc(at(back) - 0.5 * bore, middle, 3.5 * theme.line, 0, 2 * Math.PI);
  context.fillStyle = theme.surface;
  context.fill();
  context.stroke();
  drawHandle(context, handle, middle, bore, isHeld, theme);
  drawForce(context, handle + 0.7 * bore, middle, force * at(0.12), theme);
}

/** @param {CanvasRenderingContext2D} context @param {number} x1 @param {number} y1 @param {number} x2 @param {number} y2 */
function line(context, x1, y1, x2, y2) {
  context.beginPath();
  context.moveTo(x1, y1);
  context.lineTo(x2, y2);
  context.stroke();
}

/** @param {CanvasRenderingContext2D} context @param {import('../axes.js').Box} box @param {number} command @param {Theme} theme */
function drawPiston(context, { left, right, top, bottom }, command, theme) {
  context.fillStyle = theme.stable;
  context.fillRect(left, top, right - left, bottom - top);
  const pitch = (right - left) / (windings + 1);
  const radius = Math.min(0.38 * pitch, 0.16 * (bottom - top));
  for (let i = 0; i < windings; i++) {
    const filled = Math.min(1, Math.max(0, command * windings - i));
    for (const y of [top + 1.7 * radius, bottom - 1.7 * radius]) {
      context.beginPath();
      context.arc(left + (i + 1) * pitch, y, radius, 0, 2 * Math.PI);
      context.fillStyle = mix(theme.surface, theme.force, filled);
      context.fill();
    }
  }
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.4 * theme.line;
  context.beginPath();
  context.rect(left, top, right - left, bottom - top);
  context.stroke();
}

/** Grains in the two gaps: in disorder without current, in chains across the gap with it. @param {CanvasRenderingContext2D} context @param {import('../axes.js').Box} box @param {number} command @param {Theme} theme */
function drawGap(context, { left, right, top, bottom }, command, theme) {
  const gap = 0.2 * (bottom - top);
  const order = Math.min(1, command * 1.5);
  const pitch = (right - left) / grains;
  context.fillStyle = theme.ink2;
  context.beginPath();
  for (const foot of [top, bottom - gap])
    for (let column = 0; column < grains; column++)
      for (let row = 0; row < 3; row++) {
        // A disorder that is always the same.
        const astray = (((column * 7 + row * 13) % 10) / 10 - 0.45) * pitch;
        const x = left + (column + 0.5) * pitch + (1 - order) * astray;
        const y = foot + gap * (0.2 + 0.3 * row);
        context.moveTo(x + 0.1 * gap, y);
        context.arc(x, y, 0.1 * gap, 0, 2 * Math.PI);
      }
  context.fill();
}

/** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} bore @param {boolean} isHeld @param {Theme} theme */
function drawHandle(context, x, y, bore, isHeld, theme) {
  const [wide, tall] = [0.32 * bore, 0.9 * bore];
  context.beginPath();
  context.roundRect(x - wide / 2, y - tall / 2, wide, tall, wide / 3);
  context.fillStyle = isHeld ? theme.psi : theme.surface;
  context.fill();
  context.strokeStyle = theme.psi;
  context.lineWidth = 2.2 * theme.line;
  context.stroke();
}

/** The force that the damper resists with. @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} length @param {Theme} theme */
function drawForce(context, x, y, length, theme) {
  context.strokeStyle = context.fillStyle = theme.force;
  context.lineWidth = 3 * theme.line;
  if (Math.abs(length) > 2) drawArrow(context, { x: length > 0 ? x + length : x, y }, { x: length > 0 ? x : x - length, y }, theme);
  drawLabel(context, [{ symbol: 'F' }], x, y - theme.size * 0.9, theme, { weight: 600 });
}
