import { textFont, writeEdged } from './text.js';

/**
 * Points at which rest or cycles change, marked by their kind and named.
 *
 * @typedef {import('../pkg/shimmy.js').SpecialPoint['kind']} Kind
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {{ kind: Kind, x: number, y: number, texts: readonly string[] }} Mark in px; `texts`: in fewer and fewer words
 */

/** Half of a mark, in px. */
const reach = 5;

/** Rather than words are left out a name lies on so many points of a curve. */
const dear = 14;

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
 * @param {readonly { x: number, y: number }[]} curves points of what names had better not lie on, in px
 * @param {readonly Box[]} kept what they do not cover
 * @param {Theme} theme
 */
export function drawSpecialPoints(context, frame, marks, curves, kept, theme) {
  const size = reach * Math.sqrt(theme.line);
  /** @type {Box[]} */
  const taken = [];
  // A name never lies on a mark, its own or another's.
  const feet = [...kept, ...marks.map(({ x, y }) => ({ left: x - size, right: x + size, top: y - size, bottom: y + size }))];
  for (const { kind, x, y, texts } of marks) {
    context.beginPath();
    shapes[kind].forEach(([across, down], i) => context[i ? 'lineTo' : 'moveTo'](x + across * size, y + down * size));
    context.closePath();
    context.fillStyle = theme.ink;
    context.strokeStyle = theme.surface;
    context.lineWidth = 2 * theme.line;
    context.stroke();
    context.fill();
    context.font = textFont(theme, 0.95, 600);
    const places = texts.flatMap((text, spared) => placesFor({ x, y }, { width: context.measureText(text).width, height: 1.2 * theme.size }, size, frame, [...taken, ...feet])
      .map((box) => ({ text, box, cost: spared * dear + curves.filter((point) => isWithin(point, box)).length })));
    const best = places.reduce((/** @type {typeof places[number] | null} */ least, one) => (!least || one.cost < least.cost ? one : least), null);
    if (!best) continue;
    const { text, box } = best;
    taken.push(box);
    context.fillStyle = theme.ink;
    context.textAlign = 'left';
    context.textBaseline = 'middle';
    writeEdged(context, text, box.left, (box.top + box.bottom) / 2, theme);
  }
}

/** Beside the mark where nothing else stands: right, left, right above, left above, higher, below. @param {{ x: number, y: number }} at @param {{ width: number, height: number }} size @param {number} gap @param {Box} frame @param {Box[]} taken @returns {Box[]} */
function placesFor({ x, y }, { width, height }, gap, frame, taken) {
  const sides = (/** @type {number} */ top) => [[x + gap, top], [x - gap - width, top]];
  const beside = [[x + 2 * gap, y - height / 2], [x - 2 * gap - width, y - height / 2]];
  return [...[0, 1, 2].flatMap((row) => sides(y - 2 * gap - height * (row + 0.5))), ...beside, ...sides(y + gap)]
    .map(([left, top]) => ({ left, right: left + width, top, bottom: top + height }))
    .filter((box) => box.left >= frame.left - 2 * gap && box.right <= frame.right + 2 * gap && box.top >= frame.top && box.bottom <= frame.bottom
      && taken.every((other) => box.right < other.left || other.right < box.left || box.bottom < other.top || other.bottom < box.top));
}

/** @param {{ x: number, y: number }} point @param {Box} box */
const isWithin = ({ x, y }, { left, right, top, bottom }) => x > left && x < right && y > top && y < bottom;
