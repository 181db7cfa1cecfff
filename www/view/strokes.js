/**
 * The line styles that mean the same on every plot.
 *
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {(context: CanvasRenderingContext2D, theme: Theme) => void} Style sets color, width and dashes of a stroke
 */

/** Where the motion goes if nothing changes: dotted, in ink. @type {Style} */
export const destination = (context, theme) => set(context, theme.ink, 1.4, [1.5, 4], theme);

/** A cycle that draws its neighbors in: solid. @type {Style} */
export const stableCycle = (context, theme) => set(context, theme.stable, 2.6, [], theme);

/** One that sends them away: dashed. @type {Style} */
export const unstableCycle = (context, theme) => set(context, theme.unstable, 2.4, [7, 5], theme);

/** What tells several pinned runs apart, on the gear, on every plot and in the table, in px. */
export const ghostDashes = [[6, 5], [3, 3], [12, 4, 2, 4], [14, 6]];

/** A run that was pinned: dashed, each in its own way. @param {number} index of the ghost @returns {Style} */
export const ghost = (index) => (context, theme) => set(context, theme.ghost, 1.5, ghostDashes[index % ghostDashes.length], theme);

/** An edge of the gap: dotted. @type {Style} */
export const gapEdge = (context, theme) => set(context, theme.freeplayText, 1.5, [2, 3], theme);

/**
 * Draws in a style, and leaves lines solid after it.
 * @param {CanvasRenderingContext2D} context
 * @param {Theme} theme
 * @param {Style} style
 * @param {() => void} draw
 */
export function inStyle(context, theme, style, draw) {
  style(context, theme);
  draw();
  context.setLineDash([]);
}

/**
 * @param {CanvasRenderingContext2D} context @param {string} color @param {number} width @param {number[]} dash
 * @param {Theme} theme
 */
function set(context, color, width, dash, { line }) {
  context.strokeStyle = color;
  context.lineWidth = width * line;
  context.setLineDash(dash.map((length) => length * line));
}
