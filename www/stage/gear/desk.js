/**
 * What a label needs at hand, and the one way to put a label down.
 *
 * @module
 */

import { drawStill } from './still.js';
import { widthOf, write } from './text.js';

/**
 * @typedef {object} Desk
 * @property {CanvasRenderingContext2D} ctx
 * @property {import('./sheet.js').Sheet} sheet
 * @property {import('./scene.js').Scene} scene
 * @property {import('./pose.js').Pose} pose
 * @property {import('./theme.js').Theme} theme
 * @property {import('./scene.js').GearWords} words
 * @property {import('./placer.js').Placer} placer
 */

/** @typedef {import('./text.js').Run} Run */
/** @typedef {import('./placer.js').Box} Box */

/** Height of a label's box as a multiple of its type. */
export const LEADING = 1.3;

/**
 * Writes a label where there is room for it; null where there is none.
 *
 * @param {Desk} desk
 * @param {readonly Run[]} runs
 * @param {{size: number, color: string, halo: string, farthest?: number, stays?: boolean}} style
 *   `stays`: the same in nearly every frame
 * @param {(width: number, height: number) => {x: number, y: number}[]} wishes top left corners,
 *   dearest first
 * @returns {Box | null}
 */
export function putLabel(desk, runs, style, wishes) {
  const { ctx, sheet, theme, placer } = desk;
  const width = widthOf(ctx, runs, style.size, theme);
  const height = LEADING * style.size;
  const box = placer.place(width, height, wishes(width, height), style.farthest);
  if (!box) return null;
  const at = { x: box.x, y: box.y + height / 2 };
  if (style.stays) writeStill(ctx, sheet, runs, at, style, theme);
  else write(ctx, runs, at, style, theme);
  return box;
}

/**
 * Writes a line that is the same in nearly every frame.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {readonly Run[]} runs
 * @param {{x: number, y: number}} at
 * @param {{size: number, color: string, halo: string | null}} style
 * @param {import('./theme.js').Theme} theme
 */
export function writeStill(ctx, sheet, runs, at, style, theme) {
  const { size, color, halo } = style;
  const key = `${runs.map(({ text, face }) => `${face} ${text}`).join('|')} ${size} ${color} ${halo}`;
  // Italics lean out of their box, halos stand round it.
  const box = { x: at.x - size, y: at.y - size, width: widthOf(ctx, runs, size, theme) + 2 * size, height: 2 * size };
  drawStill(ctx, sheet, theme, key, box, (onto) => write(onto, runs, at, style, theme));
}

/** A word with what its {braces} name. @param {string} word @param {Record<string, string>} values */
export const fill = (word, values) => word.replace(/\{(\w+)\}/g, (_, name) => values[name] ?? '');
