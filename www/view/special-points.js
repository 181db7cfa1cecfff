import { textFont, writeEdged } from './text.js';

/**
 * Points at which rest or cycles change, marked by their kind and named.
 *
 * @typedef {import('../pkg/shimmy.js').SpecialPoint['kind']} Kind
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {{ kind: Kind, x: number, y: number, text: string }} Mark in px
 */

/** Half of a mark, in px. */
const reach = 5;

/** The corners of a mark, as shares of its reach. @type {Readonly<Record<Kind, readonly (readonly [number, number])[]>>} */
const shapes = {
  hopf: [[-1, -1], [1, -1], [1, 1], [-1, 1]],
  fold: [[0, -1.4], [1.4, 0], [0, 1.4], [-1.4, 0]],
  'neimark-sacker': [[0, -1.4], [1.3, 1], [-1.3, 1]],
  'period-doubling': [[-1.3, -1], [1.3, -1], [0, 1.4]],
  'branch-point': [[-1.4, -0.5], [1.4, -0.5], [1.4, 0.5], [-1.4, 0.5]],
  divergence: [[-0.5, -1.4], [0.5, -1.4], [0.5, 1.4], [-0.5, 1.4]],
};

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Box} frame
 * @param {readonly Mark[]} marks
 * @param {Theme} theme
 */
export function drawSpecialPoints(context, frame, marks, theme) {
  const size = reach * Math.sqrt(theme.line);
  /** @type {Box[]} */
  const taken = [];
  for (const { kind, x, y, text } of marks) {
    context.beginPath();
    shapes[kind].forEach(([across, down], i) => context[i ? 'lineTo' : 'moveTo'](x + across * size, y + down * size));
    context.closePath();
    context.fillStyle = theme.ink;
    context.strokeStyle = theme.surface;
    context.lineWidth = 2 * theme.line;
    context.stroke();
    context.fill();
    context.font = textFont(theme, 0.95, 600);
    const width = context.measureText(text).width;
    const box = placeFor({ x, y }, { width, height: 1.2 * theme.size }, size, frame, taken);
    if (!box) continue;
    taken.push(box);
    context.textAlign = 'left';
    context.textBaseline = 'middle';
    writeEdged(context, text, box.left, (box.top + box.bottom) / 2, theme);
  }
}

/** Beside the mark where nothing else stands: right above, left above, higher, below. @param {{ x: number, y: number }} at @param {{ width: number, height: number }} size @param {number} gap @param {Box} frame @param {Box[]} taken @returns {Box | null} */
function placeFor({ x, y }, { width, height }, gap, frame, taken) {
  const tries = [0, 1, 2].flatMap((row) => [[x + gap, y - 2 * gap - height * (row + 0.5)], [x - gap - width, y - 2 * gap - height * (row + 0.5)]]);
  for (const [left, top] of [...tries, [x + gap, y + gap], [x - gap - width, y + gap]]) {
    const box = { left, right: left + width, top, bottom: top + height };
    const isInside = box.left >= frame.left - 2 * gap && box.right <= frame.right + 2 * gap && box.top >= frame.top && box.bottom <= frame.bottom;
    if (isInside && taken.every((other) => box.right < other.left || other.right < box.left || box.bottom < other.top || other.bottom < box.top)) return box;
  }
  return null;
}
