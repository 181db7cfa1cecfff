/**
 * What a label needs at hand, and the one way to put a label down.
 *
 * @module
 */

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
 * @param {{size: number, color: string, halo: string, farthest?: number}} style
 * @param {(width: number, height: number) => {x: number, y: number}[]} wishes top left corners,
 *   dearest first
 * @returns {Box | null}
 */
export function putLabel(desk, runs, style, wishes) {
  const { ctx, theme, placer } = desk;
  const width = widthOf(ctx, runs, style.size, theme);
  const height = LEADING * style.size;
  const box = placer.place(width, height, wishes(width, height), style.farthest);
  if (!box) return null;
  write(ctx, runs, { x: box.x, y: box.y + height / 2 }, style, theme);
  return box;
}

/** A word with what its {braces} name. @param {string} word @param {Record<string, string>} values */
export const fill = (word, values) => word.replace(/\{(\w+)\}/g, (_, name) => values[name] ?? '');
