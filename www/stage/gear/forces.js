/**
 * What the ground does to the tire: side force and aligning moment, in true proportion to the
 * run's full scale.
 *
 * @module
 */

import { drawArrow, fillHead } from './arrow.js';
import { bendAt } from './contact-line.js';
import { onSheet, within } from './pose.js';

/** @typedef {import('./sheet.js').Sheet} Sheet */
/** @typedef {import('./pose.js').Pose} Pose */
/** @typedef {import('./scene.js').Scene} Scene */
/** @typedef {import('./theme.js').Theme} Theme */

/**
 * From the band's edge to the tip of the longest arrow [m]: so far does the contact swing aside in
 * an ordinary swing. Where it swings further the arrow slides back along its line, as a force may, and
 * ends so many px from the edge. And the longest arc [rad].
 */
const ROOM_TO_SWING = 0.03;
const CLEARANCE = 6;
const LONGEST_ARC = 1.05;
/** The arc's distance behind the contact center, beyond the wheel's radius [m]. */
const ARC_CLEARANCE = 0.05;

/**
 * @typedef {object} ForceArrows
 * @property {{from: {x: number, y: number}, to: {x: number, y: number}, length: number}} side
 * @property {{x: number, y: number, radius: number, start: number, end: number}} moment
 *   center [px], and canvas angles [rad]: clockwise from the x axis
 */

/**
 * @param {Sheet} sheet
 * @param {Scene} scene
 * @param {Pose} pose
 * @param {import('./contact-line.js').ContactLine} line
 * @returns {ForceArrows}
 */
export function forceArrows(sheet, scene, pose, line) {
  const { sideForce, aligningMoment } = scene.forces;
  const { force, moment } = scene.forceScale;
  const longest = (sheet.band.bottom - sheet.band.top) / 2 - ROOM_TO_SWING * sheet.scale;
  const length = longest * share(sideForce, force);
  const bend = bendAt(line, pose, 0);
  const side = onTheBand(sheet, onSheet(sheet, pose, 0, bend), onSheet(sheet, pose, 0, bend + length / sheet.scale));
  const center = onSheet(sheet, pose, 0, 0);
  const start = Math.PI - pose.angle;
  return {
    side: { ...side, length: Math.abs(length) },
    moment: {
      x: center.x,
      y: center.y,
      radius: (pose.radius + ARC_CLEARANCE) * sheet.scale,
      start,
      end: start - LONGEST_ARC * share(aligningMoment, moment),
    },
  };
}

/**
 * An arrow, slid back along its line until its tip is on the band.
 *
 * @param {Sheet} sheet
 * @param {{x: number, y: number}} from
 * @param {{x: number, y: number}} to
 */
function onTheBand({ band, width }, from, to) {
  const over = (/** @type {number} */ at, /** @type {number} */ low, /** @type {number} */ high) =>
    Math.max(0, low + CLEARANCE - at, at - high + CLEARANCE);
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const back = Math.max(share(over(to.x, 0, width), Math.abs(dx)), share(over(to.y, band.top, band.bottom), Math.abs(dy)));
  const slid = (/** @type {{x: number, y: number}} */ { x, y }) => ({ x: x - back * dx, y: y - back * dy });
  return { from: slid(from), to: slid(to) };
}

/** A value as a share of its full scale, −1.1 … 1.1. @param {number} value @param {number} full */
function share(value, full) {
  return full > 0 ? within(value / full, 1.1) : 0;
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {ForceArrows} arrows
 * @param {Theme} theme
 */
export function drawForces(ctx, sheet, arrows, theme) {
  drawMoment(ctx, sheet, arrows.moment, theme);
  if (arrows.side.length < 1) return;
  drawArrow(ctx, arrows.side.from, arrows.side.to, {
    color: theme.force,
    halo: theme.surface,
    width: 4.5 * sheet.line,
    head: 17 * sheet.line,
  });
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {ForceArrows['moment']} moment
 * @param {Theme} theme
 */
function drawMoment(ctx, sheet, moment, theme) {
  const { x, y, radius, start, end } = moment;
  const length = radius * Math.abs(end - start);
  if (length < 1) return;
  const counterClockwise = end < start;
  const head = Math.min(16 * sheet.line, length);
  const neck = end + (counterClockwise ? 1 : -1) * ((0.8 * head) / radius);
  // The head points along the arc's chord under it, so that it sits on the curve.
  const chord = end + (counterClockwise ? 1 : -1) * (head / (2 * radius));
  const direction = chord + (counterClockwise ? -Math.PI / 2 : Math.PI / 2);
  const tip = { x: x + radius * Math.cos(end), y: y + radius * Math.sin(end) };
  for (const [color, extra] of /** @type {const} */ ([
    [theme.ground, 4],
    [theme.force, 0],
  ])) {
    ctx.strokeStyle = color;
    ctx.fillStyle = color;
    ctx.lineWidth = 3.4 * sheet.line + extra;
    ctx.beginPath();
    ctx.arc(x, y, radius, start, neck, counterClockwise);
    ctx.stroke();
    fillHead(ctx, tip.x, tip.y, direction, head);
  }
}
