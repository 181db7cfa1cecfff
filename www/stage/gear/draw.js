/**
 * The torsional nose gear, drawn from data alone: the same scene gives the same picture.
 *
 * Top view, steering-head detail and side view, from back to front. One file a part; this one
 * holds their order.
 *
 * @module
 */

import { bendsFurther, heldLine } from './bend.js';
import { restingLine, traceBehind } from './contact-line.js';
import { bladesOf, drawPlaneFan, drawTrackFan, drawWheelFan, swingOf } from './fan.js';
import { forceArrows, drawForces } from './forces.js';
import { drawFork, drawSteeringAxis } from './fork.js';
import { drawGhosts, drawModeGhost } from './ghost.js';
import { drawGround } from './ground.js';
import { drawHand } from './hand.js';
import { drawHead, drawLeader } from './head.js';
import { writeHeadLabels } from './head-labels.js';
import { blockFan, blockMovingParts } from './obstacles.js';
import { Placer } from './placer.js';
import { drawnAngle, poseNow, poseOf } from './pose.js';
import { drawExtremes, drawPointer, drawScale, drawSweep } from './protractor.js';
import { sheetFor } from './sheet.js';
import { drawSide } from './side.js';
import { writeSideLabels } from './side-labels.js';
import { drawString } from './string.js';
import { drawTire } from './tire.js';
import { straightShape, tireShape } from './tire-shape.js';
import { writeSwing, writeTopLabels } from './top-labels.js';
import { writeTopNotes } from './top-notes.js';
import { drawTrack } from './track.js';
import { drawTrail } from './trail.js';

export { sheetFor, trackLength } from './sheet.js';

/** @typedef {import('./scene.js').Scene} Scene */
/** @typedef {import('./scene.js').Size} Size */
/** @typedef {import('./scene.js').GearWords} GearWords */
/** @typedef {import('./desk.js').Desk} Desk */
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
 * @param {{cache?: boolean}} [options] without a cache nothing is drawn but paths and text, as a
 *   context that makes SVG of them needs it
 */
export function drawGear(ctx, size, scene, theme, words, { cache = true } = {}) {
  const sheet = { ...sheetFor(size, scene), isCached: cache };
  const isFan = Boolean(scene.fan?.length);
  const pose = isFan ? poseOf(scene, 0, 0) : poseNow(scene);
  const placer = new Placer({
    x: 6,
    y: sheet.band.top + 2,
    width: size.width - 12,
    height: sheet.band.bottom - sheet.band.top - 4,
  });
  if (scene.layout === 'phone') placer.blockBox(pagerOn(size));
  const desk = { ctx, sheet, scene, pose, theme, words, placer };

  ctx.fillStyle = theme.page;
  ctx.fillRect(0, 0, size.width, size.height);
  drawSide(ctx, sheet, scene, pose, theme);
  writeSideLabels(desk);
  if (!sheet.hasTop) return;
  if (isFan) drawTopFan(desk);
  else drawTop(desk);
}

/** Where the page lays its two dots over the one view that it shows, as style/gear.css has them. @param {Size} size */
const pagerOn = ({ width, height }) => ({ x: width / 2 - 36, y: height - 24, width: 72, height: 24 });

/** How much of the track the sheet shows behind the axis [m]. @param {Desk} desk */
const trackSeen = ({ sheet, pose }) => 1.1 * (sheet.axis.x / sheet.scale + pose.half);

/** @param {Desk} desk */
function drawTop(desk) {
  const { ctx, sheet, scene, pose, theme, words } = desk;
  const trace = traceBehind(scene, pose, trackSeen(desk));
  const resting = restingLine(trace, pose);
  const line = heldLine(resting);
  const shape = tireShape(pose, line);
  const arrows = forceArrows(sheet, scene, pose, line);

  onTheGround(desk, () => {
    drawTrack(ctx, sheet, trace, theme);
    drawGhosts(ctx, sheet, scene, trackSeen(desk), theme);
    drawTrail(ctx, sheet, scene, theme);
    drawLeader(ctx, sheet, theme);
    drawHand(ctx, sheet, scene, pose, shape, theme);
    drawTire(ctx, sheet, scene, pose, line, shape, theme);
    drawFork(ctx, sheet, pose, theme);
    drawModeGhost(ctx, sheet, scene, trackSeen(desk), theme);
    drawScale(ctx, sheet, scene, theme, words);
    drawSweep(ctx, sheet, 0, pose.angle, theme);
    drawPointer(ctx, sheet, pose, theme);
    drawExtremes(ctx, sheet, scene, theme);
    drawSteeringAxis(ctx, sheet, theme);
    drawString(ctx, sheet, pose, line, theme);
    drawForces(ctx, sheet, arrows, theme);
  });
  drawHead(ctx, sheet, scene, theme);
  writeTopNotes(desk, bendsFurther(scene, resting));
  blockMovingParts(desk, shape, arrows);
  writeHeadLabels(desk);
  writeTopLabels(desk, arrows);
}

/** The top view where single poses would lie. @param {Desk} desk */
function drawTopFan(desk) {
  const { ctx, sheet, scene, pose, theme, words } = desk;
  const blades = bladesOf(scene, trackSeen(desk));
  const { low, high } = swingOf(scene);

  onTheGround(desk, () => {
    drawTrackFan(ctx, sheet, blades, theme);
    drawLeader(ctx, sheet, theme);
    drawHand(ctx, sheet, scene, pose, straightShape(pose), theme);
    drawWheelFan(ctx, sheet, blades, theme);
    drawScale(ctx, sheet, scene, theme, words);
    drawSweep(ctx, sheet, drawnAngle(scene, low), drawnAngle(scene, high), theme);
    drawPlaneFan(ctx, sheet, blades, theme);
    drawExtremes(ctx, sheet, scene, theme);
    drawSteeringAxis(ctx, sheet, theme);
  });
  drawHead(ctx, sheet, scene, theme);
  writeTopNotes(desk);
  blockFan(desk, blades);
  writeHeadLabels(desk);
  writeSwing(desk);
}

/** Draws on the ground band and nowhere else. @param {Desk} desk @param {() => void} draw */
function onTheGround({ ctx, sheet, scene, theme }, draw) {
  ctx.save();
  ctx.beginPath();
  ctx.rect(0, sheet.band.top, sheet.width, sheet.band.bottom - sheet.band.top);
  ctx.clip();
  drawGround(ctx, sheet, scene, theme);
  draw();
  ctx.restore();
}
