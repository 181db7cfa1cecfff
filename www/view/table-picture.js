import { textFont } from './text.js';

/**
 * A table of figures as a picture: heads, a line, rows.
 *
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {{ text: string, isWord?: boolean }} Head `isWord`: its column stands to the left
 * @typedef {{ heads: readonly Head[], rows: readonly (readonly string[])[] }} Cells
 */

const rowHeight = 1.9;
const gap = 2;

/**
 * @param {Cells} cells
 * @param {Theme} theme
 * @param {Pick<CanvasRenderingContext2D, 'font' | 'measureText'>} ruler
 * @returns {{ size: import('./canvas.js').Size, paint: import('./canvas.js').Paint }}
 */
export function tablePicture({ heads, rows }, theme, ruler) {
  const { size: type } = theme;
  const widthOf = (/** @type {string} */ text, /** @type {number} */ weight) => {
    ruler.font = textFont(theme, 1, weight);
    return ruler.measureText(text).width;
  };
  const widths = heads.map(({ text }, i) => Math.max(widthOf(text, 600), ...rows.map((row) => widthOf(row[i], 400))));
  const width = Math.ceil(widths.reduce((sum, one) => sum + one + gap * type, gap * type));
  const lefts = widths.map((_, i) => gap * type + widths.slice(0, i).reduce((sum, one) => sum + one + gap * type, 0));
  const height = Math.ceil((rows.length + 1.5) * rowHeight * type);
  const paint = (/** @type {CanvasRenderingContext2D} */ context) => {
    context.textBaseline = 'middle';
    const line = (/** @type {readonly string[]} */ texts, /** @type {number} */ middle, /** @type {number} */ weight, /** @type {string} */ color) => {
      context.font = textFont(theme, 1, weight);
      context.fillStyle = color;
      texts.forEach((text, i) => {
        context.textAlign = heads[i].isWord ? 'left' : 'right';
        context.fillText(text, lefts[i] + (heads[i].isWord ? 0 : widths[i]), middle);
      });
    };
    line(heads.map(({ text }) => text), (rowHeight * type) / 2, 600, theme.ink2);
    context.strokeStyle = theme.rule;
    context.lineWidth = 1;
    rows.forEach((row, i) => {
      const top = Math.round((i + 1) * rowHeight * type) + 0.5;
      context.beginPath();
      context.moveTo(gap * type * 0.5, top);
      context.lineTo(width - gap * type * 0.5, top);
      context.stroke();
      line(row, (i + 1.5) * rowHeight * type, 400, theme.ink);
    });
  };
  return { size: { width, height }, paint };
}
