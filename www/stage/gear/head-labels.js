/**
 * The names of the steering head's parts, and how large its gap is drawn.
 *
 * @module
 */

import { decimalsOf, formatNumber } from '../../words/number.js';
import { rubs } from './brake.js';
import { fill, putLabel, writeStill } from './desk.js';
import { DRAWN_GAP } from './head-pose.js';
import { protractorBox } from './protractor.js';
import { plain, strong, widthOf } from './text.js';

/** @typedef {import('./desk.js').Desk} Desk */

const DEGREES = 180 / Math.PI;

/** @param {Desk} desk */
export function writeHeadLabels(desk) {
  const { sheet } = desk;
  if (sheet.detailed) {
    writeDamper(desk);
    writeSpring(desk);
    if (rubs(desk.scene)) writeFriction(desk);
  }
  writeGap(desk);
}

/** Over its eye, where the round detail leaves room for the word; a long one above the round. @param {Desk} desk */
function writeDamper({ ctx, sheet, theme, words }) {
  const { head, small } = sheet;
  const runs = [plain(words.damper)];
  const x = sheet.width - 8 - widthOf(ctx, runs, small, theme);
  const style = { size: small, color: theme.ink2, halo: null };
  const fitting = [0.93, 0.97, 1.01, 1.05, 1.09, 1.13].find((share) => {
    const foot = Math.max(0, share * head.radius - 0.5 * small);
    return x > head.x + Math.sqrt(Math.max(0, head.radius ** 2 - foot ** 2)) + 4 && head.y - share * head.radius > 0.7 * small;
  });
  if (fitting) writeStill(ctx, sheet, runs, { x, y: head.y - fitting * head.radius }, style, theme);
}

/** @param {Desk} desk */
function writeSpring(desk) {
  const { sheet, theme, words } = desk;
  const { head, small } = sheet;
  const style = { size: small, color: theme.psi, halo: theme.ground, farthest: 80, stays: true };
  putLabel(desk, [plain(words.spring)], style, (width, height) =>
    [-0.2, -0.1, 0, 0.1, -0.3, 0.2, 0.9, 0.95].map((share) => ({
      x: head.x - head.radius * Math.sqrt(1 - share * share) - 8 - width,
      y: head.y + share * head.radius - height / 2,
    })),
  );
}

/** Beside the shoe, below the spring's. @param {Desk} desk */
function writeFriction(desk) {
  const { sheet, theme, words } = desk;
  const { head, small } = sheet;
  const style = { size: small, color: theme.stable, halo: theme.ground, farthest: 80, stays: true };
  putLabel(desk, [plain(words.friction)], style, (width, height) =>
    [0.55, 0.65, 0.75, 0.45, 0.3, 0.85].map((share) => ({
      x: head.x - head.radius * Math.sqrt(1 - share * share) - 8 - width,
      y: head.y + share * head.radius - height / 2,
    })),
  );
}

/** The gap, with the factor by which it is drawn larger. @param {Desk} desk */
function writeGap(desk) {
  const { ctx, sheet, scene, theme, words } = desk;
  const freeplay = scene.parameters.freeplayAngle ?? 0;
  if (!(freeplay > 0)) return;
  const { head, small } = sheet;
  const degrees = freeplay * DEGREES;
  const decimals = Math.min(3, decimalsOf(degrees, 0));
  const angle = `${formatNumber(degrees, decimals, words.language)}°`;
  const times = DRAWN_GAP / freeplay;
  const factor = formatNumber(times, times < 10 ? 1 : 0, words.language);
  const right = sheet.width - 14;
  const protractor = protractorBox(sheet);
  const room = right - protractor.x - protractor.width - 4;
  const long = [strong(fill(words.gap, { angle, factor }))];
  const runs =
    widthOf(ctx, long, small, theme) <= room ? long : [strong(fill(words.gapShort, { angle, factor }))];
  const style = { size: small, color: theme.freeplayText, halo: theme.ground, stays: true };
  putLabel(desk, runs, style, (width, height) => [
    { x: right - width, y: head.y + head.radius + 6 },
    { x: right - width, y: head.y + head.radius + 3 },
    { x: head.x - head.radius - 6 - width, y: sheet.band.top + 8 },
    { x: head.x - head.radius - 6 - width, y: head.y + head.radius - height },
  ]);
}
