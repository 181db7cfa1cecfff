import { transform } from './matrix.js';

/**
 * @typedef {import('./matrix.js').Matrix} Matrix
 * @typedef {import('./matrix.js').Point} Point
 * @typedef {{ letter: 'M' | 'L' | 'C' | 'Z', points: Point[] }} Segment
 */

const circle = 2 * Math.PI;

/**
 * A path as a canvas builds it: each point is set down through the transform in force at that moment, arcs as Bézier
 * curves, which every transform leaves true.
 */
export class SvgPath {
  /** @type {Segment[]} */ #segments = [];

  get isEmpty() {
    return this.#segments.length === 0;
  }

  /** @param {Matrix} matrix @param {number} x @param {number} y */
  moveTo(matrix, x, y) {
    this.#add('M', matrix, [x, y]);
  }

  /** @param {Matrix} matrix @param {number} x @param {number} y */
  lineTo(matrix, x, y) {
    this.#add(this.isEmpty ? 'M' : 'L', matrix, [x, y]);
  }

  /** @param {Matrix} matrix @param {...number} numbers two control points and the end */
  curveTo(matrix, ...numbers) {
    if (this.isEmpty) this.moveTo(matrix, numbers[0], numbers[1]);
    this.#add('C', matrix, numbers);
  }

  close() {
    if (!this.isEmpty) this.#segments.push({ letter: 'Z', points: [] });
  }

  /** @param {Matrix} matrix @param {number} x @param {number} y @param {number} width @param {number} height */
  rect(matrix, x, y, width, height) {
    this.moveTo(matrix, x, y);
    for (const [right, down] of [[width, 0], [width, height], [0, height]]) this.lineTo(matrix, x + right, y + down);
    this.close();
  }

  /**
   * @param {Matrix} matrix
   * @param {number} x @param {number} y @param {number} radiusX @param {number} radiusY
   * @param {number} turn @param {number} from @param {number} to @param {boolean} isCounterClockwise
   */
  ellipse(matrix, x, y, radiusX, radiusY, turn, from, to, isCounterClockwise) {
    const sweep = sweepOf(from, to, isCounterClockwise);
    const pieces = Math.max(1, Math.ceil(Math.abs(sweep) / (Math.PI / 4) - 1e-9));
    const step = sweep / pieces;
    const handle = (4 / 3) * Math.tan(step / 4);
    const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
    /** @param {number} along @param {number} across @returns {Point} */
    const at = (along, across) => [x + along * radiusX * cos - across * radiusY * sin, y + along * radiusX * sin + across * radiusY * cos];
    this.lineTo(matrix, ...at(Math.cos(from), Math.sin(from)));
    for (let i = 0; i < pieces; i++) {
      const [one, other] = [from + i * step, from + (i + 1) * step];
      this.curveTo(matrix,
        ...at(Math.cos(one) - handle * Math.sin(one), Math.sin(one) + handle * Math.cos(one)),
        ...at(Math.cos(other) + handle * Math.sin(other), Math.sin(other) - handle * Math.cos(other)),
        ...at(Math.cos(other), Math.sin(other)));
    }
  }

  /**
   * @param {Matrix} matrix
   * @param {number} x @param {number} y @param {number} width @param {number} height @param {number} radius
   */
  roundRect(matrix, x, y, width, height, radius) {
    const r = Math.min(radius, Math.abs(width) / 2, Math.abs(height) / 2);
    const quarter = Math.PI / 2;
    const corners = [[x + width - r, y + r, -quarter], [x + width - r, y + height - r, 0], [x + r, y + height - r, quarter], [x + r, y + r, 2 * quarter]];
    this.moveTo(matrix, x + r, y);
    for (const [cx, cy, from] of corners) this.ellipse(matrix, cx, cy, r, r, 0, from, from + quarter, false);
    this.close();
  }

  /**
   * The attribute `d`, seen through one more transform where one is given.
   * @param {Matrix} [matrix]
   * @param {number} [decimals]
   */
  data(matrix, decimals = 2) {
    const number = (/** @type {number} */ value) => String(Number(value.toFixed(decimals)) || 0);
    return this.#segments.map(({ letter, points }) => letter
      + points.map(([x, y]) => (matrix ? transform(matrix, x, y) : [x, y]).map(number).join(' ')).join(' ')).join('');
  }

  /**
   * A canvas leaves out what has no place on it.
   * @param {Segment['letter']} letter @param {Matrix} matrix @param {number[]} numbers
   */
  #add(letter, matrix, numbers) {
    if (!numbers.every(Number.isFinite)) return;
    /** @type {Point[]} */
    const points = [];
    for (let i = 0; i < numbers.length; i += 2) points.push(transform(matrix, numbers[i], numbers[i + 1]));
    this.#segments.push({ letter, points });
  }
}

/** How far an arc goes round, as a canvas takes its two angles. @param {number} from @param {number} to @param {boolean} isCounterClockwise */
function sweepOf(from, to, isCounterClockwise) {
  const way = isCounterClockwise ? from - to : to - from;
  const length = way >= circle ? circle : way - circle * Math.floor(way / circle);
  return isCounterClockwise ? -length : length;
}
