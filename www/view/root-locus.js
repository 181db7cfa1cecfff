import { drawComplexPlane, imaginaryName } from './complex-plane.js';
import { overlap } from './corner.js';
import { drawCross } from './roots.js';
import { colorsOf, written } from './map-colors.js';
import { textFont, widthOfLabel, writeEdged } from './text.js';
import { drawVeil } from './veil.js';

/**
 * The ways of the roots as a parameter is swept, the paler the less of it, for one or some values of another.
 *
 * @typedef {import('./complex-plane.js').Limits} Limits
 * @typedef {import('./complex-plane.js').Places} Places
 * @typedef {import('./map-colors.js').Color} Color
 * @typedef {import('./root-paths.js').Root} Root
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{ label: string, shares: readonly number[], paths: readonly (readonly Root[])[] }} Way `label`: which value of the
 *   other it is for, '' for none; `shares`: how far the sweep is at each root of a path, 0 … 1
 * @typedef {{
 *   ways: readonly Way[], roots: readonly Root[], limits: Limits, sweep: { symbol: string, from: string, to: string }, veiled?: boolean,
 * }} Shown `roots`: of the gear as it is; `sweep`: what the colors mean
 */

const pieces = 24;

/**
 * @param {CanvasRenderingContext2D} context
 * @param {import('./canvas.js').Size} size
 * @param {Shown} shown
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawRootLocus(context, size, { ways, roots, limits, sweep, veiled = false }, theme, voice) {
  const places = drawComplexPlane(context, size, limits, theme, voice, { veiled });
  const { frame, x, y } = places;
  if (veiled) {
    drawVeil(context, frame, theme);
    return;
  }
  const colorOf = colorsOf('frequency', { growthRate: 1, frequency: [-1, 1] }, theme);
  context.save();
  context.beginPath();
  context.rect(frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top + 4);
  context.clip();
  for (const { paths, shares } of ways) for (const path of paths) drawPath(context, path, shares, places, colorOf, theme);
  for (const { re, im } of roots) if (im >= 0) drawCross(context, x(re), y(im), re > 0 ? theme.unstable : theme.stable, theme);
  nameWays(context, ways, roots, places, theme);
  context.restore();
  drawLegend(context, frame, sweep, colorOf, theme);
}

/** @param {CanvasRenderingContext2D} context @param {readonly Root[]} path @param {readonly number[]} shares @param {Places} places @param {(share: number) => Color} colorOf @param {Theme} theme */
function drawPath(context, path, shares, { x, y }, colorOf, theme) {
  context.lineWidth = 2.2 * theme.line;
  context.lineCap = 'round';
  for (let from = 0; from < path.length - 1;) {
    const piece = pieceOf(shares[from]);
    context.strokeStyle = pieceColor(piece, colorOf);
    context.beginPath();
    context.moveTo(x(path[from].re), y(path[from].im));
    do {
      from++;
      context.lineTo(x(path[from].re), y(path[from].im));
    } while (from < path.length - 1 && pieceOf(shares[from]) === piece);
    context.stroke();
  }
  context.lineCap = 'butt';
}

/** @param {number} share */
const pieceOf = (share) => Math.min(Math.floor(share * pieces), pieces - 1);

/** @param {number} piece @param {(share: number) => Color} colorOf */
const pieceColor = (piece, colorOf) => written(colorOf((piece + 0.5) / pieces));

/** How far below the end of its way, and how far beside it, a name may stand, in widths of small type, the best first. */
const below = [0, 0.6, 1.2, 1.8, 2.4, 3];
const beside = [0.7, 2, 3.5];
/** A name further from its end than this is nobody's: then all stand in a column, with lines to their ends. */
const furthest = 1.6;

/**
 * Names at the ends of the ways, of each at the root that swings fastest and is in the picture; none over another, a cross
 * or a number of the grid, as far as there is room.
 * @param {CanvasRenderingContext2D} context @param {readonly Way[]} ways @param {readonly Root[]} roots @param {Places} places @param {Theme} theme
 */
function nameWays(context, ways, roots, { frame, x, y, taken }, theme) {
  context.font = textFont(theme, 0.9, 600);
  context.textBaseline = 'middle';
  context.textAlign = 'left';
  const ends = ways.flatMap(({ label, paths }) => {
    const isSeen = (/** @type {Root} */ { re, im }) => im > 0 && x(re) > frame.left && x(re) < frame.right && y(im) > frame.top;
    const ends = paths.flatMap((path) => {
      const last = path.findLastIndex(isSeen);
      return last > 0 ? [{ at: path[last], before: path[last - 1] }] : [];
    });
    const end = ends.reduce((most, one) => (one.at.im > most.at.im ? one : most), ends[0]);
    // Onward from where the way ends, so that it does not run through its name.
    return label && end ? [{ label, x: x(end.at.re), y: y(end.at.im), isLeftward: end.at.re < end.before.re }] : [];
  }).sort((one, other) => one.y - other.y);
  const full = [...taken, ...roots.map(({ re, im }) => around(x(re), y(im), 0.7 * theme.size, 0.55 * theme.size))];
  const names = ends.map((end) => ({ ...end, width: context.measureText(end.label).width }));
  const near = nearTheirEnds(names, frame, full, theme);
  const isPlain = names.every((end, i) => near[i] && distanceTo(end, near[i]) <= furthest * theme.size);
  for (const [i, box] of (isPlain ? near : inColumn(names, frame, taken, theme)).entries()) {
    if (!isPlain) drawLeader(context, names[i], box, theme);
    context.fillStyle = theme.ink;
    context.font = textFont(theme, 0.9, 600);
    writeEdged(context, names[i].label, box.left, (box.top + box.bottom) / 2, theme);
  }
}

/**
 * @typedef {{ label: string, x: number, y: number, width: number, isLeftward: boolean }} Name of a way, and where that ends, from
 *   the highest down
 * @typedef {import('./axes.js').Box} Box
 */

/** In the order of their ways, so that one can tell which is whose. @param {readonly Name[]} names @param {Box} frame @param {readonly Box[]} taken @param {Theme} theme @returns {Box[]} */
function nearTheirEnds(names, frame, taken, theme) {
  const full = [...taken];
  let lowest = -Infinity;
  return names.flatMap(({ x: across, y: up, width, isLeftward }) => {
    const from = Math.max(up, lowest + 1.25 * theme.size);
    const places = below.flatMap((down) => beside.flatMap((off) => (isLeftward ? [-1, 1] : [1, -1]).map((side) =>
      around(across + side * (off * theme.size + width / 2), from + down * theme.size, width / 2, 0.55 * theme.size))));
    const inside = places.filter(({ left, right, top, bottom }) => left > frame.left && right < frame.right && top > frame.top && bottom < frame.bottom);
    const box = inside.find((one) => !full.some((other) => overlap(one, other))) ?? inside[0];
    if (!box) return [];
    full.push(box);
    lowest = (box.top + box.bottom) / 2;
    return [box];
  });
}

/** Under one another at the right edge, as many as have room. @param {readonly Name[]} names @param {Box} frame @param {readonly Box[]} taken @param {Theme} theme @returns {Box[]} */
function inColumn(names, frame, taken, theme) {
  const step = 1.3 * theme.size;
  const middle = names.reduce((sum, { y }) => sum + y, 0) / names.length;
  const boxAt = (/** @type {Name} */ { width }, /** @type {number} */ y) => around(frame.right - 0.3 * theme.size - width / 2, y, width / 2, 0.6 * theme.size);
  const half = ((names.length - 1) / 2) * step;
  let next = Math.max(frame.top + 0.7 * theme.size, Math.min(middle - half, frame.bottom - (names.length + 0.5) * step));
  return names.flatMap((name) => {
    const number = taken.find((one) => overlap(one, boxAt(name, next)));
    if (number) next = number.bottom + 0.65 * theme.size;
    const box = boxAt(name, next);
    next += step;
    return box.bottom < frame.bottom ? [box] : [];
  });
}

/** @param {{ x: number, y: number }} end @param {Box} box */
function distanceTo({ x, y }, { left, right, top, bottom }) {
  return Math.hypot(Math.max(left - x, 0, x - right), Math.max(top - y, 0, y - bottom));
}

/** From the end of a way to its name. @param {CanvasRenderingContext2D} context @param {{ x: number, y: number }} end @param {Box} box @param {Theme} theme */
function drawLeader(context, end, { left, top, bottom }, theme) {
  context.strokeStyle = theme.ink;
  context.fillStyle = theme.ink;
  context.lineWidth = 0.8 * theme.line;
  context.beginPath();
  context.moveTo(end.x, end.y);
  context.lineTo(left - 0.2 * theme.size, (top + bottom) / 2);
  context.stroke();
  context.beginPath();
  context.arc(end.x, end.y, 2 * theme.line, 0, 2 * Math.PI);
  context.fill();
}

/** @param {number} x @param {number} y @param {number} halfWidth @param {number} halfHeight @returns {Box} */
function around(x, y, halfWidth, halfHeight) {
  return { left: x - halfWidth, right: x + halfWidth, top: y - halfHeight, bottom: y + halfHeight };
}

/** What the colors mean, in the fixed corner. @param {CanvasRenderingContext2D} context @param {Box} frame @param {Shown['sweep']} sweep @param {(share: number) => Color} colorOf @param {Theme} theme */
function drawLegend(context, frame, { symbol, from, to }, colorOf, theme) {
  const { size } = theme;
  const middle = frame.top - 1.1 * size;
  const name = widthOfLabel(context, imaginaryName, theme, 600);
  context.font = textFont(theme, 1);
  const room = frame.right - frame.left - name - 4 * size - context.measureText(from + to + symbol).width;
  const width = Math.max(0, Math.min(6 * size, room));
  const end = frame.right - context.measureText(to).width - 0.5 * size;
  for (let i = 0; i < pieces; i++) {
    context.fillStyle = pieceColor(i, colorOf);
    context.fillRect(end - width + (i / pieces) * width, middle - 0.4 * size, width / pieces + (i < pieces - 1 ? 0.5 : 0), 0.8 * size);
  }
  context.fillStyle = theme.ink2;
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  context.fillText(to, frame.right, middle);
  context.fillText(from, end - width - 0.5 * size, middle);
  const start = end - width - size - context.measureText(from).width;
  context.font = `italic 400 ${1.2 * size}px ${theme.serif}`;
  context.fillText(symbol, start, middle);
}
