import { grids, inPanel, panelsIn } from './panels.js';
import { textFont } from './text.js';

/**
 * @typedef {import('./canvas.js').Size} Size
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {{ label: string, draw: (context: CanvasRenderingContext2D, size: Size) => void }} Multiple
 *   `draw`: as on a canvas of that size; all of them should get the same limits, or the eye compares scales
 */

/**
 * The same plot of several runs, side by side in panels of one size, each under its name.
 * @param {CanvasRenderingContext2D} context
 * @param {Size} size
 * @param {Multiple[]} multiples
 * @param {Theme} theme
 */
export function drawSmallMultiples(context, size, multiples, theme) {
  if (multiples.length === 0) return;
  const heading = theme.size * 1.7;
  panelsIn(size, grids(multiples.length)).slice(0, multiples.length).forEach((panel, i) => {
    const { label, draw } = multiples[i];
    inPanel(context, { ...panel, bottom: panel.top + heading }, () => {
      context.font = textFont(theme, 1, 600);
      context.textAlign = 'left';
      context.textBaseline = 'alphabetic';
      context.fillStyle = theme.ink;
      context.fillText(label, theme.size * 0.8, theme.size * 1.35);
    });
    inPanel(context, { ...panel, top: panel.top + heading }, draw);
  });
}
