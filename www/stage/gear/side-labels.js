/**
 * The side view's words and dimensions: contact length and caster under the ground line.
 *
 * @module
 */

import { formatNumber } from '../../words/number.js';
import { fillHead } from './arrow.js';
import { writeStill } from './desk.js';
import { sideFrame } from './side.js';
import { plain, strong, symbol, widthOf } from './text.js';

/** @typedef {import('./desk.js').Desk} Desk */
/** @typedef {import('./side.js').SideFrame} SideFrame */

const MARGIN = 16;

/** @param {number} meters @param {import('../../words/number.js').Language} language */
function millimeters(meters, language) {
  const mm = Math.abs(meters) * 1000;
  return `${formatNumber(mm, Math.abs(mm - Math.round(mm)) < 1e-6 ? 0 : 1, language)} mm`;
}

/** @param {Desk} desk */
export function writeSideLabels(desk) {
  const frame = sideFrame(desk.sheet, desk.pose);
  if (!frame) return;
  writeView(desk, frame);
  writeSteeringAxis(desk, frame);
  writeContactLength(desk, frame);
  writeCaster(desk, frame);
}

/**
 * The axle of the wheel straight ahead: words and dimensions do not follow its swing.
 *
 * @param {Desk} desk
 * @param {SideFrame} frame
 */
const axleAt = ({ pose }, frame) => frame.x - pose.caster * frame.scale;

/** @param {Desk} desk @param {SideFrame} frame */
function wheelSpan(desk, frame) {
  const { pose } = desk;
  const middle = axleAt(desk, frame);
  const half = 1.1 * pose.radius * frame.scale;
  const top = frame.ground - (frame.axle + pose.radius) * frame.scale;
  return { left: middle - half, right: middle + half, top };
}

/** @param {Desk} desk @param {SideFrame} frame */
function writeView(desk, frame) {
  const { ctx, sheet, theme, words } = desk;
  const whole = [strong(`${words.side}: ${words.seenFromTheRight}`)];
  const wheel = wheelSpan(desk, frame);
  const y = frame.top + 0.5 * sheet.small + 10;
  const clear = y + 0.7 * sheet.small < wheel.top;
  const room = clear ? frame.x - 0.1 * frame.scale : wheel.left - 6;
  const fits = MARGIN + widthOf(ctx, whole, sheet.small, theme) <= room;
  const style = { size: sheet.small, color: theme.ink2, halo: null };
  writeStill(ctx, sheet, fits ? whole : [strong(words.side)], { x: MARGIN, y }, style, theme);
}

/** Right of the torque links, where the wheel leaves room. @param {Desk} desk @param {SideFrame} frame */
function writeSteeringAxis(desk, frame) {
  const { ctx, sheet, theme, words } = desk;
  const { small } = sheet;
  const y = frame.top + 0.5 * small + 10;
  const x = frame.x + 0.165 * frame.scale + 10;
  const wheel = wheelSpan(desk, frame);
  if (y + 0.7 * small >= wheel.top && x < wheel.right) return;
  const style = { size: small, color: theme.ink2, halo: null };
  writeStill(ctx, sheet, [plain(words.steeringAxis)], { x, y }, style, theme);
}

/** @param {Desk} desk @param {SideFrame} frame */
function writeContactLength(desk, frame) {
  const { ctx, sheet, pose, theme, words } = desk;
  const runs = [strong('2'), symbol('a'), strong(` ${millimeters(2 * pose.half, words.language)}`)];
  const size = sheet.label;
  const left = Math.min(axleAt(desk, frame) - pose.half * frame.scale, frame.x);
  const x = Math.max(6, left - 10 - widthOf(ctx, runs, size, theme));
  const style = { size, color: theme.y, halo: null };
  writeStill(ctx, sheet, runs, { x, y: frame.ground + 19 }, style, theme);
}

/**
 * The caster between axis and axle, with what it means.
 *
 * @param {Desk} desk
 * @param {SideFrame} frame
 */
function writeCaster(desk, frame) {
  const { ctx, sheet, pose, theme, words } = desk;
  const y = frame.ground + 17;
  const axle = axleAt(desk, frame);
  drawDimension(ctx, sheet, Math.min(frame.x, axle), Math.max(frame.x, axle), frame.ground, theme);

  const style = { size: sheet.label, color: theme.ink, halo: null };
  const runs = [
    plain(`${words.caster} `),
    symbol('e'),
    strong(` ${pose.caster < 0 ? '−' : ''}${millimeters(pose.caster, words.language)}`),
  ];
  const x = Math.max(frame.x, axle) + 12;
  writeStill(ctx, sheet, runs, { x, y: y + 2 }, style, theme);

  const meaning =
    pose.caster > 0 ? words.wheelTrails : pose.caster < 0 ? words.wheelLeads : words.wheelCentered;
  const caption = [plain(meaning)];
  const quiet = { ...style, size: sheet.small, color: theme.ink2 };
  const width = widthOf(ctx, caption, sheet.small, theme);
  const behind = x + widthOf(ctx, runs, sheet.label, theme) + 16;
  const right = sheet.width - MARGIN - width;
  const wheel = wheelSpan(desk, frame);
  if (behind <= right) writeStill(ctx, sheet, caption, { x: behind, y: y + 2 }, quiet, theme);
  else if (wheel.right < right) {
    writeStill(ctx, sheet, caption, { x: right, y: frame.ground - sheet.small }, quiet, theme);
  }
}

/**
 * Extension lines and arrows; the arrows turn outside where there is little room between.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {number} left
 * @param {number} right
 * @param {number} ground
 * @param {import('./theme.js').Theme} theme
 */
function drawDimension(ctx, sheet, left, right, ground, theme) {
  const y = ground + 17;
  ctx.strokeStyle = theme.ink;
  ctx.fillStyle = theme.ink;
  ctx.lineWidth = 1.2 * sheet.line;
  ctx.beginPath();
  for (const x of [left, right]) {
    ctx.moveTo(x, ground + 5);
    ctx.lineTo(x, y + 5);
  }
  ctx.moveTo(left, y);
  ctx.lineTo(right, y);
  ctx.stroke();
  const head = Math.min(7 * sheet.line, 0.42 * (right - left));
  if (head < 3) return;
  fillHead(ctx, left, y, Math.PI, head);
  fillHead(ctx, right, y, 0, head);
}
