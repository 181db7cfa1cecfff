/**
 * The tire's outline from above, bent along the contact line.
 *
 * @module
 */

import { bendAt } from './contact-line.js';
import { WHEEL_WIDTH } from './sheet.js';

/** @typedef {import('./sheet.js').Sheet} Sheet */
/** @typedef {import('./pose.js').Pose} Pose */

/** The outline's last station; the first is 0. */
export const STATIONS = 30;
/** Exponent of the superellipse that rounds the tire's shoulders. */
const ROUNDNESS = 5;

/** The tire's half width at a share of its radius, 1 in the middle and 0 at the ends. @param {number} share */
export const profile = (share) => (1 - Math.abs(share) ** ROUNDNESS) ** (1 / ROUNDNESS);

/** The stations as shares of the radius, from −1 to 1, dense at the ends, and the widths there. */
const shares = Float64Array.from({ length: STATIONS + 1 }, (_, i) =>
  Math.sin((Math.PI / 2) * ((2 * i) / STATIONS - 1)),
);
const halfWidths = shares.map((share) => (WHEEL_WIDTH / 2) * profile(share));

/**
 * The tire's outline in the wheel's frame: stations from the back to the front, with the
 * bent center line and the half width at each.
 *
 * @typedef {object} TireShape
 * @property {Float64Array} l
 * @property {Float64Array} bend
 * @property {Float64Array} half
 */

/**
 * @param {Pose} pose
 * @param {import('./contact-line.js').ContactLine} line
 * @returns {TireShape}
 */
export function tireShape(pose, line) {
  const l = shares.map((share) => pose.radius * share);
  return { l, bend: l.map((station) => bendAt(line, pose, station)), half: halfWidths };
}

/**
 * The shape at a pose whose track is not known: its contact is drawn straight.
 *
 * @param {Pose} pose
 */
export function straightShape(pose) {
  return tireShape(pose, { l: [pose.half, -pose.half], n: [pose.deformation, pose.deformation] });
}

/**
 * Adds a line along the tire to the path: `share` of the way from the center line to the left edge.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {TireShape} shape
 * @param {number} share −1 … 1
 * @param {number} from first station
 * @param {number} to last station, before or after the first
 */
export function along(ctx, sheet, pose, shape, share, from, to) {
  const step = from < to ? 1 : -1;
  for (let i = from; i !== to + step; i += step) {
    const n = shape.bend[i] + share * shape.half[i];
    ctx.lineTo(sheet.scale * (shape.l[i] - pose.caster), -sheet.scale * n);
  }
}

/**
 * The closed outline, as the current path in the wheel's frame.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {TireShape} shape
 */
export function traceTire(ctx, sheet, pose, shape) {
  ctx.beginPath();
  along(ctx, sheet, pose, shape, 1, 0, STATIONS);
  along(ctx, sheet, pose, shape, -1, STATIONS, 0);
  ctx.closePath();
}
