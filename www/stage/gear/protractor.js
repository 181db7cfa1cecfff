/**
 * The protractor ahead of the wheel: true degrees, whatever the magnification.
 *
 * @module
 */

import { formatNumber } from '../../words/number.js';
import { fillHead } from './arrow.js';
import { onSheet } from './pose.js';
import { drawStill } from './still.js';
import { plain, widthOf, write } from './text.js';
import { translucent } from './theme.js';

/** @typedef {import('./sheet.js').Sheet} Sheet */
/** @typedef {import('./pose.js').Pose} Pose */
/** @typedef {import('./scene.js').Scene} Scene */
/** @typedef {import('./theme.js').Theme} Theme */

const DEGREE = Math.PI / 180;
/** Drawn degrees: ticks, numbers, and half of the arc. */
const TICK = 5;
const NUMBERED = 10;
const REACH = 25;
/** Length of the triangles at the last cycle's extremes [px, times the line's factor]. */
const TRIANGLE = 9;

/** From the arc to its numbers, clear of the triangles [px]. @param {Sheet} sheet */
const numbersAt = (sheet) => TRIANGLE * sheet.line + 4;

/** Radius of the wedge 0 … ψ, as a share of the protractor's. */
export const WEDGE = 0.74;

/**
 * A point of the protractor, `angle` drawn radians from straight ahead.
 *
 * @param {Sheet} sheet
 * @param {number} radius [px]
 * @param {number} angle
 */
export const atAngle = (sheet, radius, angle) => ({
  x: sheet.axis.x + radius * Math.cos(angle),
  y: sheet.axis.y - radius * Math.sin(angle),
});

/** The room that the arc, its ticks and numbers take. @param {Sheet} sheet */
export function protractorBox(sheet) {
  const arc = sheet.protractor * Math.sin(REACH * DEGREE);
  const numbers = (sheet.protractor + numbersAt(sheet)) * Math.sin(2 * NUMBERED * DEGREE);
  const half = Math.max(arc, numbers + 0.5 * sheet.small) + 2;
  const left = atAngle(sheet, sheet.protractor, REACH * DEGREE).x - 4;
  const right = sheet.axis.x + sheet.protractor + numbersAt(sheet) + 2.8 * sheet.small;
  return { x: left, y: sheet.axis.y - half, width: right - left, height: 2 * half };
}

/**
 * The arc with its ticks and numbers.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Scene} scene
 * @param {Theme} theme
 * @param {import('./scene.js').GearWords} words
 */
export function drawScale(ctx, sheet, scene, theme, words) {
  const { x, y, width, height } = protractorBox(sheet);
  const box = { x: x - 4, y: y - 4, width: width + 8, height: height + 8 };
  const key = `protractor ${sheet.protractor} ${scene.magnification} ${words.language} ${sheet.small}`;
  drawStill(ctx, sheet, theme, key, box, (onto) => {
    drawArc(onto, sheet, theme);
    writeNumbers(onto, sheet, scene, theme, words);
  });
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Theme} theme
 */
function drawArc(ctx, sheet, theme) {
  const { x, y } = sheet.axis;
  const radius = sheet.protractor;
  ctx.strokeStyle = theme.ink2;
  ctx.lineWidth = 1.4 * sheet.line;
  ctx.beginPath();
  ctx.arc(x, y, radius, -REACH * DEGREE, REACH * DEGREE);
  for (let degrees = -REACH; degrees <= REACH; degrees += TICK) {
    const length = degrees % NUMBERED === 0 ? 9 : 5;
    const from = atAngle(sheet, radius, degrees * DEGREE);
    const to = atAngle(sheet, radius + length, degrees * DEGREE);
    ctx.moveTo(from.x, from.y);
    ctx.lineTo(to.x, to.y);
  }
  ctx.stroke();
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Scene} scene
 * @param {Theme} theme
 * @param {import('./scene.js').GearWords} words
 */
function writeNumbers(ctx, sheet, scene, theme, words) {
  const radius = sheet.protractor;
  const style = { size: sheet.small, color: theme.ink2, halo: theme.ground };
  const decimals = NUMBERED % scene.magnification === 0 ? 0 : 1;
  const apart = (radius + numbersAt(sheet)) * Math.sin(NUMBERED * DEGREE);
  const step = apart > 1.15 * sheet.small ? NUMBERED : 2 * NUMBERED;
  for (let degrees = -2 * NUMBERED; degrees <= 2 * NUMBERED; degrees += step) {
    const number = formatNumber(degrees / scene.magnification, decimals, words.language);
    const text = [plain(degrees === 0 ? '0' : `${degrees > 0 ? '+' : ''}${number}°`)];
    const at = atAngle(sheet, radius + numbersAt(sheet), degrees * DEGREE);
    const room = sheet.width - 4 - widthOf(ctx, text, sheet.small, theme);
    write(ctx, text, { x: Math.min(at.x, room), y: at.y }, style, theme);
  }
}

/**
 * The wedge from one drawn angle to another, 0 … ψ.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {number} from
 * @param {number} to
 * @param {Theme} theme
 */
export function drawSweep(ctx, sheet, from, to, theme) {
  const { x, y } = sheet.axis;
  const radius = WEDGE * sheet.protractor;
  ctx.beginPath();
  ctx.moveTo(x, y);
  ctx.arc(x, y, radius, -from, -to, to > from);
  ctx.closePath();
  ctx.fillStyle = translucent(theme.psi, 0.13);
  ctx.fill();
  ctx.beginPath();
  ctx.arc(x, y, radius, -from, -to, to > from);
  ctx.strokeStyle = theme.psi;
  ctx.lineWidth = 3.5 * sheet.line;
  ctx.stroke();
}

/**
 * The wheel plane, dotted, from behind the tire to its pointer on the protractor.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {Theme} theme
 */
export function drawPointer(ctx, sheet, pose, theme) {
  const tail = onSheet(sheet, pose, -pose.radius - 0.05, 0);
  const tip = atAngle(sheet, sheet.protractor - 2, pose.angle);
  const neck = atAngle(sheet, sheet.protractor - 12, pose.angle);
  for (const [width, color] of /** @type {const} */ ([
    [4.2, translucent(theme.surface, 0.45)],
    [2, theme.psi],
  ])) {
    ctx.strokeStyle = color;
    ctx.lineWidth = width * sheet.line;
    ctx.setLineDash([2.2 * sheet.line, 3.4 * sheet.line]);
    ctx.beginPath();
    ctx.moveTo(tail.x, tail.y);
    ctx.lineTo(neck.x, neck.y);
    ctx.stroke();
  }
  ctx.setLineDash([]);
  ctx.fillStyle = theme.psi;
  fillHead(ctx, tip.x, tip.y, -pose.angle, 13 * sheet.line);
}

/**
 * Triangles on the arc's outer side at the last cycle's lowest and highest ψ.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Scene} scene
 * @param {Theme} theme
 */
export function drawExtremes(ctx, sheet, scene, theme) {
  if (!scene.extremes) return;
  ctx.fillStyle = theme.psi;
  for (const psi of scene.extremes) {
    const angle = scene.magnification * psi;
    if (!(Math.abs(angle) <= REACH * DEGREE)) continue;
    const tip = atAngle(sheet, sheet.protractor + 1, angle);
    fillHead(ctx, tip.x, tip.y, Math.PI - angle, TRIANGLE * sheet.line);
  }
}
