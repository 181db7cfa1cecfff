import { overlap } from './corner.js';
import { drawLabel, textFont, widthOfLabel } from './text.js';

/**
 * The box around a 3-D orbit: its floor, the two walls behind, and numbers and names along the edges in front.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./axes.js').Axis} Axis whose places are −1 … 1
 * @typedef {import('./look.js').Point} Point
 * @typedef {import('./look.js').Projection} Projection
 * @typedef {import('./text.js').Run} Run
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {{ x: Axis, y: Axis, z: Axis }} Axes
 * @typedef {[number, number, number]} Place in the box
 */

/**
 * The floor and the walls behind, with lines through the marks.
 * @param {CanvasRenderingContext2D} context
 * @param {Projection} projection
 * @param {Axes} axes
 * @param {Theme} theme
 */
export function drawFaces(context, projection, { x, y, z }, theme) {
  const [backX, backY] = [-projection.front.x, -projection.front.y];
  const line = (/** @type {Place} */ from, /** @type {Place} */ to) => {
    context.moveTo(projection.across(from[0], from[1]), projection.up(...from));
    context.lineTo(projection.across(to[0], to[1]), projection.up(...to));
  };
  const face = (/** @type {Place[]} */ corners) => {
    context.beginPath();
    corners.forEach((corner, i) => context[i ? 'lineTo' : 'moveTo'](projection.across(corner[0], corner[1]), projection.up(...corner)));
    context.closePath();
  };
  /** @type {Place[]} */
  const floor = [[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1]];
  context.fillStyle = theme.ground;
  context.globalAlpha = 0.5;
  face(floor);
  context.fill();
  context.globalAlpha = 1;

  context.lineWidth = 1;
  for (const zero of [false, true]) {
    context.strokeStyle = zero ? theme.ghost : theme.rule;
    context.globalAlpha = zero ? 0.7 : 1;
    context.beginPath();
    const on = (/** @type {Axis} */ axis) => axis.marks.filter(({ isZero }) => isZero === zero);
    for (const { at } of on(x)) {
      line([at, -1, -1], [at, 1, -1]);
      line([at, backY, -1], [at, backY, 1]);
    }
    for (const { at } of on(y)) {
      line([-1, at, -1], [1, at, -1]);
      line([backX, at, -1], [backX, at, 1]);
    }
    for (const { at } of on(z)) {
      line([-1, backY, at], [1, backY, at]);
      line([backX, -1, at], [backX, 1, at]);
    }
    context.stroke();
  }
  context.globalAlpha = 1;
  context.strokeStyle = theme.rule;
  for (const corners of [floor, [[-1, backY, -1], [1, backY, -1], [1, backY, 1], [-1, backY, 1]], [[backX, -1, -1], [backX, 1, -1], [backX, 1, 1], [backX, -1, 1]]]) {
    face(/** @type {Place[]} */ (corners));
    context.stroke();
  }
}

/**
 * Numbers and names of the axes, each along the edge that shows it best.
 * @param {CanvasRenderingContext2D} context
 * @param {Projection} projection
 * @param {Axes} axes
 * @param {Box} canvas within which all words stay
 * @param {Theme} theme
 * @returns {Box[]} where words stand
 */
export function drawEdges(context, projection, { x, y, z }, canvas, theme) {
  const { front } = projection;
  /** @type {Box[]} */
  const taken = [];
  drawEdge(context, projection, x, [-1, front.y, -1], [1, front.y, -1], canvas, taken, theme);
  drawEdge(context, projection, y, [front.x, -1, -1], [front.x, 1, -1], canvas, taken, theme);
  drawUpright(context, projection, z, taken, theme);
  return taken;
}

/**
 * An edge of the floor: words stand outward of it, level, whatever its slope, and off the words of its neighbor.
 * @param {CanvasRenderingContext2D} context @param {Projection} projection @param {Axis} axis @param {Place} from
 * @param {Place} to @param {Box} canvas @param {Box[]} taken where words stand; those of this edge are added
 * @param {Theme} theme
 */
function drawEdge(context, projection, axis, from, to, canvas, taken, theme) {
  const at = (/** @type {number} */ share) => {
    const [x, y, z] = from.map((start, i) => start + ((to[i] - start) * (share + 1)) / 2);
    return { x: projection.across(x, y), y: projection.up(x, y, z) };
  };
  const [start, middle, end] = [at(-1), at(0), at(1)];
  const length = Math.hypot(end.x - start.x, end.y - start.y);
  if (length < 3 * theme.size) return;
  const along = { x: (end.x - start.x) / length, y: (end.y - start.y) / length };
  // Outward is away from the middle of the floor.
  const floor = { x: projection.across(0, 0), y: projection.up(0, 0, -1) };
  const sign = Math.sign(-along.y * (middle.x - floor.x) + along.x * (middle.y - floor.y)) || Math.sign(along.x) || 1;
  const out = { x: -along.y * sign, y: along.x * sign };
  const boxBeyond = (/** @type {Point} */ point, /** @type {number} */ gap, /** @type {number} */ width) => {
    const distance = gap + (Math.abs(out.x) * width) / 2 + (Math.abs(out.y) * theme.size) / 2;
    const [x, y] = [point.x + out.x * distance, point.y + out.y * distance];
    return { left: x - width / 2, right: x + width / 2, top: y - theme.size / 2, bottom: y + theme.size / 2 };
  };

  context.font = textFont(theme, 0.95);
  context.fillStyle = theme.ink2;
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  let widest = 0;
  for (const { at: share, text } of spaced(axis, length / 2, (Math.abs(along.x) * 2.9 + Math.abs(along.y) * 1.5) * theme.size)) {
    const width = context.measureText(text).width;
    const box = boxBeyond(at(share), theme.size * 0.55, width);
    if (taken.some((other) => overlap(box, other))) continue;
    widest = Math.max(widest, width);
    context.fillText(text, box.left, (box.top + box.bottom) / 2);
    taken.push(box);
  }

  const gap = theme.size * 0.9 + Math.abs(out.x) * widest + Math.abs(out.y) * theme.size;
  for (const isShort of [false, true]) {
    const name = axis.name(isShort);
    const box = boxBeyond(middle, gap, widthOfLabel(context, name, theme, 600));
    const isClear = box.left >= canvas.left && box.right <= canvas.right && !taken.some((other) => overlap(box, other));
    if (!isClear && !isShort) continue;
    drawLabel(context, name, box.left, Math.min(box.bottom, canvas.bottom) - theme.size * 0.14, theme, { weight: 600 });
    taken.push(box);
    return;
  }
}

/**
 * The upright axis, at the edge farthest to the left.
 * @param {CanvasRenderingContext2D} context @param {Projection} projection @param {Axis} axis @param {Box[]} taken
 * @param {Theme} theme
 */
function drawUpright(context, projection, axis, taken, theme) {
  const corners = [-1, 1].flatMap((x) => [-1, 1].map((y) => ({ x, y })));
  // Of two edges in line, the one behind: there a wall meets it.
  const place = (/** @type {{ x: number, y: number }} */ corner) => projection.across(corner.x, corner.y) + projection.nearness(corner.x, corner.y, 0);
  const { x, y } = corners.reduce((best, corner) => (place(corner) < place(best) ? corner : best));
  const left = projection.across(x, y);
  const height = projection.up(x, y, -1) - projection.up(x, y, 1);
  if (height < 3 * theme.size) return;
  context.font = textFont(theme, 0.95);
  context.fillStyle = theme.ink2;
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  let widest = 0;
  for (const { at, text } of spaced(axis, height / 2, 1.6 * theme.size)) {
    const width = context.measureText(text).width;
    const [end, middle] = [left - theme.size * 0.6, projection.up(x, y, at)];
    const box = { left: end - width, right: end, top: middle - theme.size / 2, bottom: middle + theme.size / 2 };
    if (taken.some((other) => overlap(box, other))) continue;
    widest = Math.max(widest, width);
    context.fillText(text, end, middle);
  }
  const name = axis.name(height < 14 * theme.size);
  const right = left - widest - theme.size * 1.1;
  const middle = projection.up(x, y, 0);
  context.save();
  context.translate(right, middle);
  context.rotate(-Math.PI / 2);
  const width = drawLabel(context, name, 0, 0, theme, { align: 'center', weight: 600 });
  context.restore();
  const half = Math.max(width, height + theme.size) / 2;
  taken.push({ left: right - theme.size * 1.2, right: left, top: middle - half, bottom: middle + half });
}

/**
 * The marks that have room for their numbers: all, or every second, third … from zero.
 * @param {Axis} axis
 * @param {number} unit pixels of a length 1 along the edge
 * @param {number} least pixels between two numbers
 */
function spaced({ marks }, unit, least) {
  if (marks.length < 2) return marks;
  const step = (marks[1].at - marks[0].at) * unit;
  const stride = Math.max(1, Math.ceil(least / step - 1e-9));
  const zero = Math.max(0, marks.findIndex(({ isZero }) => isZero));
  return marks.filter((_, i) => (i - zero) % stride === 0);
}
