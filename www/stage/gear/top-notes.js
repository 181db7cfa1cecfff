/**
 * The words of the top view that stay where they are: what is drawn and how, whose ghosts, and how
 * fast it rolls.
 *
 * @module
 */

import { formatNumber } from '../../words/number.js';
import { drawArrow } from './arrow.js';
import { LEADING, putLabel, fill } from './desk.js';
import { ghostDash, ghostStroke } from './ghost.js';
import { protractorBox } from './protractor.js';
import { plain, strong, symbol, widthOf } from './text.js';

/** @typedef {import('./desk.js').Desk} Desk */

const MARGIN = 16;
/** Where the note on the scale begins: beside the mark of the list that it opens, as style/gear.css has it. */
export const SCALE_AT = 31;
/** Length of a ghost's dashes before its name [px]. */
const SAMPLE = 26;
const TRACK_NOTE_AT = 12;

/**
 * @param {Desk} desk
 * @param {boolean} [isHeld] whether the tire bends further than it is drawn
 */
export function writeTopNotes(desk, isHeld = false) {
  const { sheet, placer } = desk;
  placer.blockCircle({ ...sheet.head, radius: sheet.head.radius + 2 });
  placer.blockBox(protractorBox(sheet));
  const right = writeSpeed(desk);
  const left = writeScale(desk, Math.min(right, noteEnd(desk)), isHeld);
  if (desk.scene.fan?.length) writeTooFast(desk, left, right);
  if (sheet.roomy) writeTrack(desk);
  writeGhosts(desk);
}

/**
 * How far from the left edge a note may reach, so that neither force nor moment crosses it in any
 * ordinary swing. The state has no say, or notes would jump as the wheel swings.
 *
 * @param {Desk} desk
 */
function noteEnd({ sheet, scene }) {
  const contact = sheet.axis.x - Math.max(0, scene.parameters.casterLength ?? 0) * sheet.scale;
  const swept = Math.max(0.35 * ((sheet.band.bottom - sheet.band.top) / 2), 0.13 * sheet.scale);
  return contact - swept - 10;
}

/** The left end of what is written. @param {Desk} desk */
function writeSpeed(desk) {
  const { ctx, sheet, scene, theme, words, placer } = desk;
  const { velocity } = scene.parameters;
  const right = sheet.width - MARGIN;
  if (velocity === undefined) return right;
  const speed = formatNumber(velocity, Number.isInteger(velocity) ? 0 : 1, words.language);
  const arrow = sheet.roomy ? 0.115 * sheet.width : 44;
  const style = { size: sheet.label, color: theme.ink2, halo: theme.ground, stays: true, farthest: sheet.roomy ? undefined : 0 };
  // Where there is little room the arrow goes first, then the words: the dock has the speed, too.
  const written = putLabel(desk, [symbol('v'), strong(` ${speed} m/s`)], style, (width, height) => [
    { x: right - arrow - 8 - width, y: sheet.band.bottom - 3 - height },
    { x: right - width, y: sheet.band.bottom - 3 - height },
  ]);
  if (!written) return right;
  const y = written.y + written.height / 2;
  const ink = { color: theme.ink2, halo: null, width: 1.6 * sheet.line, head: 9 * sheet.line };
  // The label may have been moved aside: the arrow takes what room is left, if it is worth an arrow.
  const tail = Math.max(right - arrow, written.x + written.width + 8);
  if (right - tail >= 2 * ink.head) {
    drawArrow(ctx, { x: tail, y }, { x: right, y }, ink);
    placer.blockBox({ x: tail, y: y - 6, width: right - tail, height: 12 });
  }
  return written.x - 12;
}

/**
 * Whether the drawing is to scale, at the foot on the left, in one line or two. Returns its right end.
 *
 * @param {Desk} desk
 * @param {number} end
 * @param {boolean} isHeld
 */
function writeScale(desk, end, isHeld) {
  const { ctx, sheet, scene, theme, words } = desk;
  const { small, band } = sheet;
  const larger = scene.magnification !== 1;
  const factor = formatNumber(scene.magnification, 0, words.language);
  // To scale is what one expects, so where room is scarce only the contrary is said.
  const scales = larger ? [words.drawnLarger, words.drawnLargerShort, words.drawnLargerShortest] : [];
  const bends = isHeld ? [words.bendsFurther, words.bendsFurther, words.bendsFurtherShort] : [];
  const said = larger || isHeld
    ? [0, 1, 2].map((i) => [scales[i], bends[i]].filter(Boolean).join('; '))
    : [words.drawnToScale];
  const notes = [...said.map((how) => `${words.top}: ${fill(how, { factor })}`), words.top];
  const width = (/** @type {string} */ line) => widthOf(ctx, [strong(line)], small, theme);
  /** @type {string[] | null} */
  let lines = null;
  for (const note of notes) lines ??= inLines(note, width, end - SCALE_AT, larger || isHeld ? 2 : 1);
  const style = { size: small, color: larger || isHeld ? theme.freeplayText : theme.ink2, halo: theme.ground, stays: true };
  lines?.reverse().forEach((line, i) =>
    putLabel(desk, [strong(line)], { ...style, farthest: 0 }, (_, height) => [
      { x: SCALE_AT, y: band.bottom - 5 - (i + 1) * height },
    ]),
  );
  return SCALE_AT + Math.max(...(lines ?? []).map(width)) + 12;
}

/**
 * A sentence in one line, or in two that are nearest to equal; none where it does not fit.
 *
 * @param {string} sentence
 * @param {(line: string) => number} widthOfLine
 * @param {number} room
 * @param {number} most lines
 */
function inLines(sentence, widthOfLine, room, most) {
  if (widthOfLine(sentence) <= room) return [sentence];
  if (most < 2) return null;
  const words = sentence.split(' ');
  const halves = words.slice(1).map((_, i) => [words.slice(0, i + 1).join(' '), words.slice(i + 1).join(' ')]);
  const widest = halves.map((lines) => Math.max(...lines.map(widthOfLine)));
  const least = Math.min(...widest);
  return least <= room ? halves[widest.indexOf(least)] : null;
}

/**
 * At the foot, under the blur that it explains, between the other notes.
 *
 * @param {Desk} desk
 * @param {number} left
 * @param {number} right
 */
function writeTooFast(desk, left, right) {
  const { sheet, theme, words } = desk;
  const size = sheet.roomy ? sheet.label : sheet.small;
  const style = { size, color: theme.ink, halo: theme.ground, farthest: 200, stays: true };
  putLabel(desk, [strong(words.tooFast)], style, (width, height) => [
    {
      x: Math.max(left, Math.min(right - width, sheet.axis.x - width / 2)),
      y: sheet.band.bottom - 3 - height,
    },
  ]);
}

/** @param {Desk} desk */
function writeTrack(desk) {
  const { sheet, theme, words } = desk;
  const style = { size: sheet.small, color: theme.y, halo: theme.ground, farthest: 60, stays: true };
  putLabel(desk, [plain(words.trackOnTheGround)], style, () => [{ x: MARGIN, y: sheet.band.top + TRACK_NOTE_AT }]);
}

/**
 * Each ghost's dashes and what sets it apart, as far as there is room left of the wheel and above
 * the track. A mode's may reach over the wheel, as far as the steering head: without it nobody knows
 * what swings there.
 *
 * @param {Desk} desk
 */
function writeGhosts(desk) {
  const { ctx, sheet, scene, theme, placer } = desk;
  if (scene.fan?.length) return;
  const size = sheet.small;
  const height = LEADING * size;
  const end = noteEnd(desk);
  const foot = sheet.axis.y - 0.045 * sheet.scale;
  const style = { size, color: theme.ink2, halo: theme.ground, farthest: 0, stays: true };
  let x = MARGIN;
  let y = sheet.band.top + (sheet.roomy ? TRACK_NOTE_AT + height + 2 : 6);
  scene.ghosts?.forEach((ghost, index) => {
    const { label, isMode } = ghost;
    if (!label) return;
    const runs = [isMode ? strong(label) : plain(label)];
    const width = SAMPLE + 6 + widthOf(ctx, runs, size, theme);
    const most = isMode ? sheet.head.x - sheet.head.radius - 10 : end;
    if (x > MARGIN && x + width > most) {
      x = MARGIN;
      y += height;
    }
    if (x + width > most || y + height > foot) return;
    if (!putLabel(desk, runs, isMode ? { ...style, color: theme.psi } : style, () => [{ x: x + SAMPLE + 6, y }])) return;
    const { color, width: wide } = ghostStroke(sheet, ghost, theme);
    ctx.strokeStyle = color;
    ctx.lineWidth = wide;
    ctx.setLineDash(ghostDash(sheet, index));
    ctx.beginPath();
    ctx.moveTo(x, y + height / 2);
    ctx.lineTo(x + SAMPLE, y + height / 2);
    ctx.stroke();
    ctx.setLineDash([]);
    placer.blockBox({ x, y, width: SAMPLE, height });
    x += width + 14;
  });
}
