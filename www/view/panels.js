/**
 * How an area is shared by a few plots.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./canvas.js').Size} Size
 */

/** Width over height of a plot that is good to read. */
const best = 1.5;

/**
 * The area in rows of panels, by the layout whose panels are nearest to a good shape.
 * @param {Size} size
 * @param {number[][]} layouts how many panels each row may have, row by row
 * @returns {Box[]} row by row, from the left
 */
export function panelsIn({ width, height }, layouts) {
  const off = (/** @type {number[]} */ rows) =>
    Math.max(...rows.map((count) => Math.abs(Math.log((width / count) / (height / rows.length) / best))));
  const rows = layouts.reduce((nearest, layout) => (off(layout) < off(nearest) ? layout : nearest));
  const tall = height / rows.length;
  return rows.flatMap((count, row) => Array.from({ length: count }, (_, i) => ({
    left: (width * i) / count, right: (width * (i + 1)) / count, top: tall * row, bottom: tall * (row + 1),
  })));
}

/**
 * Layouts of so many equal panels: one to all in a row; the last row may be filled in part.
 * @param {number} count
 * @returns {number[][]}
 */
export function grids(count) {
  return Array.from({ length: count }, (_, i) => Array.from({ length: Math.ceil(count / (i + 1)) }, () => i + 1));
}

/**
 * Draws in a panel as if it were a canvas of its own; nothing leaves it.
 * @param {CanvasRenderingContext2D} context
 * @param {Box} panel
 * @param {(context: CanvasRenderingContext2D, size: Size) => void} draw
 */
export function inPanel(context, { left, right, top, bottom }, draw) {
  const size = { width: right - left, height: bottom - top };
  context.save();
  context.translate(left, top);
  context.beginPath();
  context.rect(0, 0, size.width, size.height);
  context.clip();
  draw(context, size);
  context.restore();
}
