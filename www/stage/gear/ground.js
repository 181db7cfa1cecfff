/**
 * The runway in the top view: a band that rolls by from right to left.
 *
 * @module
 */

import { translucent } from './theme.js';

/** The pattern repeats after this many meters, more than any sheet shows. */
const PERIOD = 8;
const JOINT_SPACING = 1;
const JOINT = 0.009;
const SPECKLES = 1000;
/** The first of them are larger stones. */
const STONES = 250;
/** The shortest streak [m], that of a runway at rest, and the longest, across most of a sheet. */
const SHORTEST = 0.012;
const LONGEST = 2;

/**
 * Speckles as x [m], height in the band (0 … 1) and own length [m], three numbers each, in an
 * order that looks like none: additive sequences of the golden ratio and its kin (M. Roberts'
 * R2 sequence), which spread evenly and never form rows.
 */
const speckles = new Float64Array(3 * SPECKLES).map((_, index) => {
  const n = Math.floor(index / 3) + 1;
  if (index % 3 === 0) return ((n * 0.7548776662466927) % 1) * PERIOD;
  if (index % 3 === 1) return (n * 0.5698402909980532) % 1;
  return 0.03 * ((n * 0.618033988749895) % 1);
});

/** @param {number} value @param {number} period */
const wrap = (value, period) => value - period * Math.floor(value / period);

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {import('./scene.js').Scene} scene
 * @param {import('./theme.js').Theme} theme
 */
export function drawGround(ctx, sheet, scene, theme) {
  const { top, bottom } = sheet.band;
  ctx.fillStyle = theme.ground;
  ctx.fillRect(0, top, sheet.width, bottom - top);
  drawSpeckles(ctx, sheet, scene, theme);
  drawJoints(ctx, sheet, scene, theme);
  drawStraightAhead(ctx, sheet, theme);
}

/**
 * Streaks as long as one frame's travel, as a camera would see them; fainter as they grow, so that
 * the runway keeps its brightness at every speed.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {import('./scene.js').Scene} scene
 * @param {import('./theme.js').Theme} theme
 */
function drawSpeckles(ctx, sheet, scene, theme) {
  const { top, bottom } = sheet.band;
  const exposure = Math.min(LONGEST, Math.max(0, scene.exposure));
  const visible = sheet.width / sheet.scale;
  const inset = 4;
  const strength = 1 / (1 + 6 * exposure);
  ctx.lineCap = 'round';
  for (const [from, until, width, color] of /** @type {const} */ ([
    [STONES, SPECKLES, 1.1, translucent(theme.rule, strength)],
    [0, STONES, 1.5, translucent(theme.ghost, 0.27 * strength)],
  ])) {
    ctx.strokeStyle = color;
    ctx.lineWidth = width * sheet.line;
    ctx.beginPath();
    for (let i = from; i < until; i++) {
      const x = wrap(speckles[3 * i] - scene.roll, PERIOD);
      const length = SHORTEST + speckles[3 * i + 2] + exposure;
      if (x - length > visible) continue;
      const height = speckles[3 * i + 1];
      const y = top + inset + height * (bottom - top - 2 * inset);
      ctx.moveTo((x - length) * sheet.scale, y);
      ctx.lineTo(x * sheet.scale, y);
    }
    ctx.stroke();
  }
  ctx.lineCap = 'butt';
}

/**
 * Joints between the runway's slabs, smeared by the same exposure: over a whole slab they are one even tint, so that
 * nothing flickers however far the runway goes from frame to frame.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {import('./scene.js').Scene} scene
 * @param {import('./theme.js').Theme} theme
 */
function drawJoints(ctx, sheet, scene, theme) {
  const { top, bottom } = sheet.band;
  const smear = Math.max(0, scene.exposure);
  const width = Math.min(JOINT_SPACING, JOINT + smear);
  const first = wrap(-scene.roll, JOINT_SPACING);
  const strength = 0.5 * (JOINT / width) + (width < 0.5 ? 0.35 : 0.175 / width);
  ctx.fillStyle = translucent(theme.rule, Math.min(1, strength));
  if (width === JOINT_SPACING) ctx.fillRect(0, top, sheet.width, bottom - top);
  else for (let x = first; (x - width) * sheet.scale < sheet.width; x += JOINT_SPACING) {
    ctx.fillRect((x - width) * sheet.scale, top, width * sheet.scale, bottom - top);
  }
  ctx.fillStyle = theme.rule;
  ctx.fillRect(0, top, sheet.width, 1);
  ctx.fillRect(0, bottom - 1, sheet.width, 1);
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {import('./theme.js').Theme} theme
 */
function drawStraightAhead(ctx, sheet, theme) {
  ctx.strokeStyle = theme.ghost;
  ctx.lineWidth = sheet.line;
  ctx.setLineDash([14, 4, 2, 4]);
  ctx.beginPath();
  ctx.moveTo(0, sheet.axis.y);
  ctx.lineTo(sheet.width, sheet.axis.y);
  ctx.stroke();
  ctx.setLineDash([]);
}
