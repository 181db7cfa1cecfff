/**
 * A 2D context that draws nothing and remembers everything: every stroke, fill and text with its
 * place on the canvas, after all transforms. A test can then ask what was drawn where.
 */

/**
 * @typedef {{x: number, y: number}} Point
 * @typedef {{kind: 'stroke' | 'fill', paths: Point[][], color: unknown, lineWidth: number, dash: number[], opacity: number}} Mark
 * @typedef {{text: string, x: number, y: number, width: number, size: number, color: unknown, font: string, opacity: number, halo: boolean}} Written
 */

/** Steps in which an arc is recorded. */
const ARC_STEPS = 24;

class Gradient {
  /** @param {number} at @param {string} color */
  addColorStop(at, color) {
    if (!(at >= 0 && at <= 1)) throw new RangeError(`a color stop ${color} at ${at}`);
  }
}

export class RecordingContext {
  /** @type {Mark[]} */
  marks = [];
  /** @type {Written[]} */
  texts = [];

  fillStyle = /** @type {unknown} */ ('#000');
  strokeStyle = /** @type {unknown} */ ('#000');
  lineWidth = 1;
  lineCap = 'butt';
  lineJoin = 'miter';
  globalAlpha = 1;
  font = '10px sans-serif';
  textAlign = 'left';
  textBaseline = 'alphabetic';

  /** @type {[number, number, number, number, number, number]} */
  #matrix = [1, 0, 0, 1, 0, 0];
  /** @type {number[]} */
  #dash = [];
  /** @type {{styles: object, matrix: [number, number, number, number, number, number], dash: number[]}[]} */
  #stack = [];
  /** @type {Point[][]} */
  #paths = [];

  save() {
    const { fillStyle, strokeStyle, lineWidth, lineCap, lineJoin, globalAlpha, font } = this;
    this.#stack.push({
      styles: { fillStyle, strokeStyle, lineWidth, lineCap, lineJoin, globalAlpha, font },
      matrix: [...this.#matrix],
      dash: this.#dash,
    });
  }

  restore() {
    const saved = this.#stack.pop();
    if (!saved) throw new Error('restore without save');
    Object.assign(this, saved.styles);
    this.#matrix = saved.matrix;
    this.#dash = saved.dash;
  }

  /** @param {number} x @param {number} y */
  translate(x, y) {
    this.#multiply(1, 0, 0, 1, x, y);
  }

  /** @param {number} x @param {number} y */
  scale(x, y) {
    this.#multiply(x, 0, 0, y, 0, 0);
  }

  /** @param {number} angle */
  rotate(angle) {
    this.#multiply(Math.cos(angle), Math.sin(angle), -Math.sin(angle), Math.cos(angle), 0, 0);
  }

  /** @param {number} a @param {number} b @param {number} c @param {number} d @param {number} e @param {number} f */
  #multiply(a, b, c, d, e, f) {
    const [A, B, C, D, E, F] = this.#matrix;
    this.#matrix = [A * a + C * b, B * a + D * b, A * c + C * d, B * c + D * d, A * e + C * f + E, B * e + D * f + F];
  }

  /** @param {number} x @param {number} y @returns {Point} */
  #onCanvas(x, y) {
    if (!Number.isFinite(x) || !Number.isFinite(y)) throw new RangeError(`a point at (${x}, ${y})`);
    const [a, b, c, d, e, f] = this.#matrix;
    return { x: a * x + c * y + e, y: b * x + d * y + f };
  }

  beginPath() {
    this.#paths = [];
  }

  /** @param {number} x @param {number} y */
  moveTo(x, y) {
    this.#paths.push([this.#onCanvas(x, y)]);
  }

  /** @param {number} x @param {number} y */
  lineTo(x, y) {
    const path = this.#paths.at(-1);
    if (path) path.push(this.#onCanvas(x, y));
    else this.moveTo(x, y);
  }

  /** @param {number} x1 @param {number} y1 @param {number} x2 @param {number} y2 @param {number} x @param {number} y */
  bezierCurveTo(x1, y1, x2, y2, x, y) {
    this.#onCanvas(x1, y1);
    this.#onCanvas(x2, y2);
    this.lineTo(x, y);
  }

  closePath() {
    const path = this.#paths.at(-1);
    if (path) path.push(path[0]);
  }

  /** @param {number} x @param {number} y @param {number} width @param {number} height */
  rect(x, y, width, height) {
    this.moveTo(x, y);
    this.lineTo(x + width, y);
    this.lineTo(x + width, y + height);
    this.lineTo(x, y + height);
    this.closePath();
  }

  /** @param {number} x @param {number} y @param {number} width @param {number} height */
  roundRect(x, y, width, height) {
    this.rect(x, y, width, height);
  }

  /** @param {number} x @param {number} y @param {number} radius @param {number} from @param {number} to @param {boolean} [counterClockwise] */
  arc(x, y, radius, from, to, counterClockwise = false) {
    this.ellipse(x, y, radius, radius, 0, from, to, counterClockwise);
  }

  /**
   * @param {number} x @param {number} y @param {number} radiusX @param {number} radiusY
   * @param {number} turn only 0 is known here
   * @param {number} from @param {number} to @param {boolean} [counterClockwise]
   */
  ellipse(x, y, radiusX, radiusY, turn, from, to, counterClockwise = false) {
    if (!(radiusX >= 0 && radiusY >= 0)) throw new RangeError(`radii ${radiusX}, ${radiusY}`);
    if (turn !== 0) throw new Error('turned ellipses are not recorded');
    const circle = 2 * Math.PI;
    const wrap = (/** @type {number} */ angle) => angle - circle * Math.floor(angle / circle);
    const whole = Math.abs(to - from) >= circle && from < to !== counterClockwise;
    const sweep = whole ? circle : counterClockwise ? wrap(from - to) : wrap(to - from);
    for (let i = 0; i <= ARC_STEPS; i++) {
      const angle = from + ((counterClockwise ? -1 : 1) * sweep * i) / ARC_STEPS;
      this.lineTo(x + radiusX * Math.cos(angle), y + radiusY * Math.sin(angle));
    }
  }

  stroke() {
    this.#mark('stroke', this.strokeStyle);
  }

  fill() {
    this.#mark('fill', this.fillStyle);
  }

  clip() {}

  /** @param {number} x @param {number} y @param {number} width @param {number} height */
  fillRect(x, y, width, height) {
    this.beginPath();
    this.rect(x, y, width, height);
    this.fill();
  }

  /** @param {'stroke' | 'fill'} kind @param {unknown} color */
  #mark(kind, color) {
    if (!(this.lineWidth > 0)) throw new RangeError(`a line width of ${this.lineWidth}`);
    this.marks.push({
      kind,
      paths: this.#paths.map((path) => [...path]),
      color,
      lineWidth: this.lineWidth,
      dash: this.#dash,
      opacity: this.globalAlpha,
    });
  }

  /** @param {number[]} dash */
  setLineDash(dash) {
    this.#dash = dash;
  }

  /** A width that is near enough for Latin and the same everywhere. @param {string} text */
  measureText(text) {
    return { width: 0.5 * this.#fontSize() * text.length };
  }

  #fontSize() {
    return Number(/([\d.]+)px/.exec(this.font)?.[1] ?? 10);
  }

  /** @param {string} text @param {number} x @param {number} y */
  fillText(text, x, y) {
    this.#write(text, x, y, this.fillStyle, false);
  }

  /** @param {string} text @param {number} x @param {number} y */
  strokeText(text, x, y) {
    this.#write(text, x, y, this.strokeStyle, true);
  }

  /** @param {string} text @param {number} x @param {number} y @param {unknown} color @param {boolean} halo */
  #write(text, x, y, color, halo) {
    const at = this.#onCanvas(x, y);
    const { font, globalAlpha: opacity } = this;
    const { width } = this.measureText(text);
    this.texts.push({ text, ...at, width, size: this.#fontSize(), color, font, opacity, halo });
  }

  createLinearGradient(/** @type {number[]} */ ...line) {
    return this.#gradient(line);
  }

  createRadialGradient(/** @type {number[]} */ ...circles) {
    return this.#gradient(circles);
  }

  /** @param {number[]} numbers */
  #gradient(numbers) {
    if (!numbers.every(Number.isFinite)) throw new RangeError(`a gradient over ${numbers}`);
    return new Gradient();
  }

  /** Saves that were not restored. */
  get depth() {
    return this.#stack.length;
  }

  /**
   * The context as drawings take it.
   *
   * @returns {CanvasRenderingContext2D}
   */
  get asContext() {
    return /** @type {CanvasRenderingContext2D} */ (/** @type {unknown} */ (this));
  }
}
