import { drawBoundary } from './boundary.js';
import { drawHatch } from './hatch.js';
import { linear } from './scale.js';
import { drawLabel, widthOfLabel } from './text.js';

/**
 * The same plane for several values, side by side: what is unstable tinted and hatched, the exact boundary, how much is
 * stable, and the ranges once above all.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./text.js').Run} Run
 * @typedef {import('../run/linear-looks.js').Range} Range
 * @typedef {import('../run/linear-looks.js').BoundaryCurve} BoundaryCurve
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {{
 *   image: CanvasImageSource | null, hatch: Float32Array | null, boundary: readonly BoundaryCurve[], label: Run[], share: string,
 *   isOld: boolean, isNow: boolean,
 * }} PlaneShown `image`: a pixel a cell; `isNow`: its values are the gear's; `isOld`: of values that are no more
 * @typedef {{ x: Range, y: Range, ranges: string[], planes: readonly PlaneShown[], point: { x: number, y: number }, heads?: Heads | null, ends: { x: string[], y: string[] } }} Shown
 *   `ranges`: in words, in fewer and fewer of them; `ends`: of the axes, at the first plane
 * @typedef {Run[][][]} Heads of each list, where two are compared in a grid
 */

/**
 * @typedef {{ width: number, height: number, top: number, boxes: Box[], plots: Box[], grid?: Grid }} Layout
 *   `top`: where the ranges stand; `plots`: without the words; boxes and plots as the planes come
 * @typedef {{ rows: number, columns: number, isTurned: boolean }} Grid the first list down and the second across, or turned
 */

/** Narrower than this a plane is not read, in widths of small type; and its height by its width. */
const [narrowest, narrowestOfGrid, shape] = [10, 5.5, 0.72];
const gap = 10;
/** From the numbers at an axis to it, and from there to the picture's edge. */
const [besideAxis, margin] = [4, 4];

/**
 * Where each plane goes: rows filled from the left, the words over each within its box.
 * @param {number} width
 * @param {number} count
 * @param {Theme} theme
 * @param {{ isTall: boolean, ends?: number }} words whether those over a plane take two lines; `ends`: how wide the ends of the
 *   upward axis are
 * @returns {Layout}
 */
export function layBeside(width, count, theme, { isTall, ends = 0 }) {
  const edge = theme.size * 2.4;
  const start = Math.max(edge, besideAxis + ends + margin);
  const inner = width - start - edge;
  const most = Math.max(1, Math.floor((inner + gap) / (theme.size * narrowest + gap)));
  // Rows as equal as can be.
  const columns = Math.ceil(count / Math.ceil(count / most));
  const wide = Math.floor((inner - (columns - 1) * gap) / columns);
  const words = theme.size * (isTall ? 3 : 1.7);
  const tall = words + Math.round(shape * wide);
  const top = theme.size * 1.8;
  const boxes = Array.from({ length: count }, (_, i) => {
    const [column, row] = [i % columns, Math.floor(i / columns)];
    const [left, upper] = [start + column * (wide + gap), top + theme.size * 0.4 + row * (tall + gap)];
    return { left, right: left + wide, top: upper, bottom: upper + tall };
  });
  return { width, height: (boxes[count - 1]?.bottom ?? top) + gap + theme.size, top, boxes, plots: boxes.map((box) => ({ ...box, top: box.top + words })) };
}

/**
 * The planes of two lists as rows and columns, with room for their heads: the first list down, or across where the second is
 * longer than there is room for; as wide as the room, or wider, to be scrolled.
 * @param {number} room
 * @param {readonly [number, number]} counts of the two lists
 * @param {Theme} theme
 * @param {{ heads: readonly [number, number], ends: number }} words how wide the heads of each list and the ends of the upward axis are
 * @returns {Layout}
 */
export function layGrid(room, counts, theme, { heads, ends }) {
  const lay = (/** @type {boolean} */ isTurned) => {
    const [rows, columns] = isTurned ? [counts[1], counts[0]] : counts;
    const [leftHeads, topHeads] = isTurned ? [heads[1], heads[0]] : heads;
    const [left, edge, words] = [Math.max(4 * theme.size, ends, leftHeads) + theme.size, theme.size * 1.6, theme.size * 1.7];
    const wide = Math.max(theme.size * narrowestOfGrid, topHeads, Math.floor((room - left - edge - (columns - 1) * gap) / columns));
    const tall = words + Math.round(shape * wide);
    const top = theme.size * 1.8;
    const boxes = Array.from({ length: rows * columns }, (_, i) => {
      const [first, second] = [Math.floor(i / counts[1]), i % counts[1]];
      const [row, column] = isTurned ? [second, first] : [first, second];
      const [x, y] = [left + column * (wide + gap), top + theme.size * 1.6 + row * (tall + gap)];
      return { left: x, right: x + wide, top: y, bottom: y + tall };
    });
    return {
      width: left + columns * (wide + gap) - gap + edge, height: boxes[boxes.length - 1].bottom + gap + theme.size, top,
      boxes, plots: boxes.map((box) => ({ ...box, top: box.top + words })), grid: { rows, columns, isTurned },
    };
  };
  const straight = lay(false);
  return straight.width <= room || counts[1] <= counts[0] ? straight : lay(true);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {import('./canvas.js').Size} size
 * @param {Shown} shown
 * @param {Layout} layout
 * @param {Theme} theme
 */
export function drawPlanesBeside(context, { width }, { x, y, ranges, planes, point, heads, ends }, { top, boxes, plots, grid }, theme) {
  context.fillStyle = theme.ink2;
  const room = width - 3.2 * theme.size;
  const words = ranges.find((text) => widthOfLabel(context, [{ text }], theme) <= room) ?? ranges[ranges.length - 1];
  drawLabel(context, [{ text: words }], theme.size * 1.6, top - theme.size * 0.6, theme);
  planes.forEach((plane, i) => {
    const [box, plot] = [boxes[i], plots[i]];
    if (!box) return;
    const isTwoLines = plot.top - box.top > 2 * theme.size;
    context.fillStyle = theme.ink;
    drawLabel(context, plane.label, box.left, box.top + theme.size * 1.15, theme, { weight: 600 });
    drawLabel(context, [{ text: plane.share }], isTwoLines ? box.left : box.right, box.top + theme.size * (isTwoLines ? 2.5 : 1.15), theme, { align: isTwoLines ? 'left' : 'right' });
    drawPlane(context, plot, plane, { x, y, point }, theme);
  });
  if (heads && grid) drawHeads(context, heads, boxes, plots, grid, theme);
  writeEnds(context, ends, plots, theme);
}

/** @param {CanvasRenderingContext2D} context @param {Heads} heads @param {Box[]} boxes @param {Box[]} plots @param {Grid} grid @param {Theme} theme */
function drawHeads(context, heads, boxes, plots, { rows, columns, isTurned }, theme) {
  // From plane to plane along the top, and down the left.
  const [across, down] = isTurned ? [rows, 1] : [1, columns];
  context.fillStyle = theme.ink;
  heads[isTurned ? 0 : 1].forEach((head, i) => {
    const { left, right, top } = boxes[i * across];
    drawLabel(context, head, (left + right) / 2, top - theme.size * 0.15, theme, { align: 'center', weight: 600 });
  });
  heads[isTurned ? 1 : 0].forEach((head, i) => {
    const { left, top, bottom } = plots[i * down];
    drawLabel(context, head, left - theme.size * 0.5, (top + bottom) / 2 + theme.size * 0.35, theme, { align: 'right', weight: 600 });
  });
}

/** The ends of the axes: to the left of the first plane and below the lowest of its column. @param {CanvasRenderingContext2D} context @param {Shown['ends']} ends @param {Box[]} plots @param {Theme} theme */
function writeEnds(context, ends, plots, theme) {
  const [first] = plots;
  if (!first) return;
  const lowest = plots.findLast(({ left }) => left === first.left) ?? first;
  context.fillStyle = theme.ink2;
  drawLabel(context, [{ text: ends.y[1] }], first.left - besideAxis, first.top + theme.size * 0.8, theme, { align: 'right' });
  drawLabel(context, [{ text: ends.y[0] }], first.left - besideAxis, first.bottom, theme, { align: 'right' });
  drawLabel(context, [{ text: ends.x[0] }], lowest.left, lowest.bottom + theme.size * 1.1, theme);
  drawLabel(context, [{ text: ends.x[1] }], lowest.right, lowest.bottom + theme.size * 1.1, theme, { align: 'right' });
}

/** @param {CanvasRenderingContext2D} context @param {Box} plot @param {PlaneShown} plane @param {Pick<Shown, 'x' | 'y' | 'point'>} where @param {Theme} theme */
function drawPlane(context, { left, right, top, bottom }, { image, hatch, boundary, isOld, isNow }, { x, y, point }, theme) {
  const place = { x: linear([x.from, x.to], [left, right]), y: linear([y.from, y.to], [bottom, top]) };
  context.save();
  context.beginPath();
  context.rect(left, top, right - left, bottom - top);
  context.clip();
  context.globalAlpha = isOld ? 0.4 : 1;
  if (image) context.drawImage(image, left, top, right - left, bottom - top);
  if (hatch) {
    context.translate(left, top);
    drawHatch(context, hatch, theme);
    context.translate(-left, -top);
  }
  if (!isOld) drawBoundary(context, boundary, place.x, place.y, theme);
  if (isNow) {
    const ring = 4 * Math.sqrt(theme.line);
    for (const [color, wide] of /** @type {const} */ ([[theme.surface, 5], [theme.ink, 2]])) {
      context.strokeStyle = color;
      context.lineWidth = wide * theme.line;
      context.beginPath();
      context.arc(place.x(point.x), place.y(point.y), ring, 0, 2 * Math.PI);
      context.stroke();
    }
  }
  context.restore();
  context.strokeStyle = isNow ? theme.ink : theme.ghost;
  context.lineWidth = (isNow ? 2 : 1) * theme.line;
  context.strokeRect(left + 0.5, top + 0.5, right - left - 1, bottom - top - 1);
}

/** How wide the widest of some heads is. @param {CanvasRenderingContext2D} context @param {Run[][]} heads @param {Theme} theme */
export function widthOfHeads(context, heads, theme) {
  return Math.max(...heads.map((head) => widthOfLabel(context, head, theme, 600)));
}

/** How wide the ends of an axis are. @param {CanvasRenderingContext2D} context @param {string[]} ends @param {Theme} theme */
export function widthOfEnds(context, ends, theme) {
  return Math.max(...ends.map((text) => widthOfLabel(context, [{ text }], theme)));
}

/** How wide the words over a plane are, in one line. @param {CanvasRenderingContext2D} context @param {Pick<PlaneShown, 'label' | 'share'>} plane @param {Theme} theme */
export function widthOfWords(context, { label, share }, theme) {
  return widthOfLabel(context, label, theme, 600) + theme.size + widthOfLabel(context, [{ text: share }], theme);
}
