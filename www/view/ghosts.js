import { strokeCurve } from './curve.js';
import { ghost as ghostStyle, inStyle } from './strokes.js';
import { textFont, writeEdged } from './text.js';

/**
 * Pinned runs on a plot: each dashed in its own way, named in a corner, and numbered at the curve where there are several.
 *
 * @typedef {import('./curve.js').Curve} Curve
 * @typedef {import('./key.js').Key} Key
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{ label: string }} Labelled `label`: how it differs from the run, and what became of it
 */

/**
 * One key a ghost: several small ones find room where a list would not.
 * @param {Labelled[]} ghosts
 * @param {Theme} theme
 * @param {Voice} voice
 * @returns {Key[]}
 */
export function keysOfGhosts(ghosts, theme, voice) {
  return ghosts.map(({ label }, i) => {
    const text = ghosts.length > 1 ? `${i + 1}: ${label}` : voice.say('plot.ghost', { label });
    return { entry: { text, short: text.replace(/ \([^()]*\)$/, ''), style: ghostStyle(i) }, color: theme.ghost, weight: 600 };
  });
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {{ curve: Curve, isClosed: boolean }[]} ghosts
 * @param {Theme} theme
 */
export function drawGhosts(context, ghosts, theme) {
  ghosts.forEach(({ curve, isClosed }, i) => inStyle(context, theme, ghostStyle(i), () => strokeCurve(context, curve, { isClosed })));
  if (ghosts.length < 2) return;
  context.font = textFont(theme, 0.9, 600);
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  ghosts.forEach(({ curve }, i) => numberAt(context, curve, String(i + 1), theme));
}

/** Sets the number on the curve where it is highest. @param {CanvasRenderingContext2D} context @param {Curve} curve @param {string} number @param {Theme} theme */
function numberAt(context, { count, x, y }, number, theme) {
  if (count < 1) return;
  let highest = 0;
  for (let i = 1; i < count; i++) if (y(i) < y(highest)) highest = i;
  context.fillStyle = theme.ghost;
  writeEdged(context, number, x(highest), y(highest), theme, 5);
}
