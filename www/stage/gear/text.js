/**
 * Short lines of mixed type: italic symbols with subscripts, numbers and words.
 *
 * @module
 */

/** @typedef {import('./theme.js').Theme} Theme */
/** @typedef {'symbol' | 'subscript' | 'strong' | 'plain'} Face */
/** @typedef {{text: string, face: Face}} Run */

/** @param {string} text @returns {Run} */
export const symbol = (text) => ({ text, face: 'symbol' });
/** @param {string} text @returns {Run} */
export const subscript = (text) => ({ text, face: 'subscript' });
/** @param {string} text @returns {Run} */
export const strong = (text) => ({ text, face: 'strong' });
/** @param {string} text @returns {Run} */
export const plain = (text) => ({ text, face: 'plain' });

/**
 * @param {Face} face
 * @param {number} size
 * @param {Theme} theme
 */
function fontOf(face, size, theme) {
  if (face === 'symbol') return `italic 400 ${1.18 * size}px ${theme.serif}`;
  if (face === 'subscript') return `italic 400 ${0.85 * size}px ${theme.serif}`;
  return `${face === 'strong' ? 600 : 400} ${size}px ${theme.sans}`;
}

/**
 * The width of a line, with every digit as wide as a zero, so that a label keeps its place while
 * its number runs.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {readonly Run[]} runs
 * @param {number} size
 * @param {Theme} theme
 */
export function widthOf(ctx, runs, size, theme) {
  let width = 0;
  for (const { text, face } of runs) {
    ctx.font = fontOf(face, size, theme);
    width += ctx.measureText(text.replace(/\d/g, '0')).width;
  }
  return width;
}

/**
 * Writes a line from x to the right, its middle at y, on a halo in the paper's colour.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {readonly Run[]} runs
 * @param {{x: number, y: number}} at
 * @param {{size: number, colour: string, halo: string}} style
 * @param {Theme} theme
 */
export function write(ctx, runs, at, style, theme) {
  ctx.textBaseline = 'middle';
  ctx.textAlign = 'left';
  ctx.lineJoin = 'round';
  ctx.lineWidth = 0.3 * style.size;
  ctx.strokeStyle = style.halo;
  ctx.fillStyle = style.colour;
  for (const paint of /** @type {const} */ (['strokeText', 'fillText'])) {
    let x = at.x;
    for (const { text, face } of runs) {
      ctx.font = fontOf(face, style.size, theme);
      const y = face === 'subscript' ? at.y + 0.32 * style.size : at.y;
      ctx[paint](text, x, y);
      x += ctx.measureText(text).width;
    }
  }
}
