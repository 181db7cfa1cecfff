/**
 * The torsional nose gear, drawn from data alone: the same scene gives the same picture.
 *
 * Top view, steering-head detail and side view, from back to front. One file a part; this one
 * holds their order.
 *
 * @module
 */

import { contactLine, traceBehind } from './contact-line.js';
import { forceArrows, drawForces } from './forces.js';
import { drawFork, drawSteeringAxis } from './fork.js';
import { drawGround } from './ground.js';
import { drawHead, drawLeader } from './head.js';
import { writeHeadLabels } from './head-labels.js';
import { Placer } from './placer.js';
import { poseNow } from './pose.js';
import { drawProtractor } from './protractor.js';
import { sheetFor } from './sheet.js';
import { drawSide } from './side.js';
import { writeSideLabels } from './side-labels.js';
import { drawString } from './string.js';
import { drawTire } from './tire.js';
import { tireShape } from './tire-shape.js';
import { blockMovingParts, writeTopLabels, writeTopNotes } from './top-labels.js';
import { drawTrack } from './track.js';
import { drawTrail } from './trail.js';

export { sheetFor, trackLength } from './sheet.js';

/** @typedef {import('./scene.js').Scene} Scene */
/** @typedef {import('./scene.js').Size} Size */
/** @typedef {import('./scene.js').GearWords} GearWords */
/** @typedef {import('./sheet.js').Sheet} Sheet */
/** @typedef {import('./theme.js').Theme} Theme */

/**
 * Draws the whole stage above the transport. The page lays its verdict over the top left, in the
 * first `sheetFor(size, scene).band.top` pixels, left of the steering head.
 *
 * @param {CanvasRenderingContext2D} ctx already scaled for device pixels
 * @param {Size} size in CSS pixels
 * @param {Scene} scene
 * @param {Theme} theme
 * @param {GearWords} words
 */
export function drawGear(ctx, size, scene, theme, words) {
  const sheet = sheetFor(size, scene);
  const pose = poseNow(scene);
  const placer = new Placer({
    x: 6,
    y: sheet.band.top + 2,
    width: size.width - 12,
    height: sheet.band.bottom - sheet.band.top - 4,
  });
  const desk = { ctx, sheet, scene, pose, theme, words, placer };

  ctx.fillStyle = theme.page;
  ctx.fillRect(0, 0, size.width, size.height);
  drawSide(ctx, sheet, scene, pose, theme);
  writeSideLabels(desk);
  drawTop(desk);
}

/** @param {import('./desk.js').Desk} desk */
function drawTop(desk) {
  const { ctx, sheet, scene, pose, theme, words } = desk;
  const trace = traceBehind(scene, pose, 1.1 * (sheet.axis.x / sheet.scale + pose.half));
  const line = contactLine(trace, pose);
  const shape = tireShape(pose, line);
  const arrows = forceArrows(sheet, scene, pose, line);

  ctx.save();
  ctx.beginPath();
  ctx.rect(0, sheet.band.top, sheet.width, sheet.band.bottom - sheet.band.top);
  ctx.clip();
  drawGround(ctx, sheet, scene, theme);
  drawTrack(ctx, sheet, trace, theme);
  drawTrail(ctx, sheet, scene, theme);
  drawLeader(ctx, sheet, theme);
  drawTire(ctx, sheet, scene, pose, line, shape, theme);
  drawFork(ctx, sheet, pose, theme);
  drawProtractor(ctx, sheet, scene, pose, theme, words);
  drawSteeringAxis(ctx, sheet, theme);
  drawString(ctx, sheet, pose, line, theme);
  drawForces(ctx, sheet, arrows, theme);
  ctx.restore();

  drawHead(ctx, sheet, scene, theme);
  writeTopNotes(desk);
  blockMovingParts(desk, shape, arrows);
  writeHeadLabels(desk);
  writeTopLabels(desk, arrows);
}
