/**
 * What stays as it is from frame to frame: drawn once into a bitmap, and stamped from then on.
 *
 * @module
 */

/** @typedef {import('./theme.js').Theme} Theme */
/** @typedef {{x: number, y: number, width: number, height: number}} Box */

/** So many bitmaps are kept; a slider under a hand makes new ones all the time. */
const MOST = 96;

/**
 * Bitmaps by what they show, for as long as the page keeps the same theme object.
 *
 * @type {WeakMap<Theme, Map<string, ImageBitmap>>}
 */
const kept = new WeakMap();

/**
 * Draws what depends on nothing but its key, its box and the theme.
 *
 * @param {CanvasRenderingContext2D} ctx in the sheet's frame, scaled for device pixels alone
 * @param {import('./sheet.js').Sheet} sheet without a cache it is drawn as it is
 * @param {Theme} theme
 * @param {string} key
 * @param {Box} box around all of it, in CSS pixels
 * @param {(ctx: CanvasRenderingContext2D) => void} draw
 */
export function drawStill(ctx, sheet, theme, key, box, draw) {
  // A context that writes lines (out/svg-context.js) takes no bitmaps.
  if (!sheet.isCached || typeof OffscreenCanvas === 'undefined' || !('getTransform' in ctx)) {
    draw(ctx);
    return;
  }
  const { a: scale } = ctx.getTransform();
  const left = Math.floor(box.x * scale);
  const top = Math.floor(box.y * scale);
  const width = Math.ceil((box.x + box.width) * scale) - left;
  const height = Math.ceil((box.y + box.height) * scale) - top;
  let bitmaps = kept.get(theme);
  if (!bitmaps) kept.set(theme, (bitmaps = new Map()));
  // Where in a pixel it begins matters, which pixel does not.
  const place = `${(box.x * scale - left).toFixed(2)} ${(box.y * scale - top).toFixed(2)}`;
  const name = `${key} ${scale} ${width} ${height} ${place}`;
  let bitmap = bitmaps.get(name);
  if (!bitmap) {
    if (bitmaps.size >= MOST) bitmaps.clear();
    bitmap = render(width, height, scale, left, top, draw);
    bitmaps.set(name, bitmap);
  }
  ctx.drawImage(bitmap, left / scale, top / scale, width / scale, height / scale);
}

/**
 * @param {number} width
 * @param {number} height
 * @param {number} scale
 * @param {number} left
 * @param {number} top
 * @param {(ctx: CanvasRenderingContext2D) => void} draw
 */
function render(width, height, scale, left, top, draw) {
  const canvas = new OffscreenCanvas(Math.max(1, width), Math.max(1, height));
  const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d'));
  context.setTransform(scale, 0, 0, scale, -left, -top);
  draw(/** @type {CanvasRenderingContext2D} */ (/** @type {unknown} */ (context)));
  return canvas.transferToImageBitmap();
}
