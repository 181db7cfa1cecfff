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

/** So many widths of a face are kept: what a running number shows comes again. */
const MOST_WIDTHS = 600;

/**
 * A face at a size: the font's name for the context, and the widths of what was written in it.
 *
 * @typedef {{font: string, widths: Map<string, number>}} Type
 */

/**
 * Types by face and size, for as long as the page keeps the same theme object.
 *
 * @type {WeakMap<Theme, Record<Face, Map<number, Type>>>}
 */
const types = new WeakMap();

/**
 * @param {Face} face
 * @param {number} size
 * @param {Theme} theme
 */
function typeOf(face, size, theme) {
  let faces = types.get(theme);
  if (!faces) {
    faces = { symbol: new Map(), subscript: new Map(), strong: new Map(), plain: new Map() };
    types.set(theme, faces);
  }
  let type = faces[face].get(size);
  if (!type) faces[face].set(size, (type = { font: fontOf(face, size, theme), widths: new Map() }));
  return type;
}

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
 * The width of a run with every digit as wide as a zero, so that a label keeps its place while its
 * number runs.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Run} run
 * @param {number} size
 * @param {Theme} theme
 */
function runWidth(ctx, { text, face }, size, theme) {
  const { font, widths } = typeOf(face, size, theme);
  let width = widths.get(text);
  if (width === undefined) {
    if (widths.size >= MOST_WIDTHS) widths.clear();
    const steady = text.replace(/\d/g, '0');
    width = steady === text ? undefined : widths.get(steady);
    if (width === undefined) {
      ctx.font = font;
      width = ctx.measureText(steady).width;
      widths.set(steady, width);
    }
    widths.set(text, width);
  }
  return width;
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {readonly Run[]} runs
 * @param {number} size
 * @param {Theme} theme
 */
export function widthOf(ctx, runs, size, theme) {
  return runs.reduce((width, run) => width + runWidth(ctx, run, size, theme), 0);
}

/**
 * Writes a line from x to the right, its middle at y. A halo in the paper's color keeps it legible
 * over what is drawn; the halos come first, so that none covers a neighbor's letters.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {readonly Run[]} runs
 * @param {{x: number, y: number}} at
 * @param {{size: number, color: string, halo: string | null}} style
 * @param {Theme} theme
 */
export function write(ctx, runs, at, style, theme) {
  const { size } = style;
  ctx.textBaseline = 'middle';
  ctx.textAlign = 'left';
  ctx.lineJoin = 'round';
  ctx.lineWidth = 0.3 * size;
  if (style.halo) ctx.strokeStyle = style.halo;
  ctx.fillStyle = style.color;
  let x = at.x;
  const places = runs.map((run) => {
    const place = { x, y: run.face === 'subscript' ? at.y + 0.32 * size : at.y };
    x += runWidth(ctx, run, size, theme);
    return place;
  });
  let font = '';
  /** @param {'strokeText' | 'fillText'} paint @param {number} i */
  const put = (paint, i) => {
    const wanted = typeOf(runs[i].face, size, theme).font;
    // To set a font costs more than to write with it.
    if (font !== wanted) ctx.font = font = wanted;
    ctx[paint](runs[i].text, places[i].x, places[i].y);
  };
  if (style.halo) for (let i = runs.length - 1; i >= 0; i--) put('strokeText', i);
  for (let i = 0; i < runs.length; i++) put('fillText', i);
}
