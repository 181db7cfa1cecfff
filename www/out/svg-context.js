import { identity, inverse, isEven, multiply, transform } from './svg/matrix.js';
import { svgColor } from './svg/color.js';
import { SvgGradient } from './svg/gradient.js';
import { SvgPath } from './svg/path.js';
import { textAttributes } from './svg/text-attributes.js';

/**
 * @typedef {import('./svg/matrix.js').Matrix} Matrix
 * @typedef {{ width: number, height: number }} Size
 * @typedef {string | SvgGradient} Style
 * @typedef {Pick<CanvasRenderingContext2D, 'font' | 'textAlign' | 'textBaseline' | 'measureText'>} Ruler a context that knows the fonts
 */

/**
 * A drawing context that writes an SVG document instead of pixels, for as much of a canvas as the drawings use. Text
 * stays text, at the place and as wide as the canvas would set it.
 *
 * The library at hand for this (svgcanvas) clips what was drawn before the clip, leaves baselines to the viewer and
 * translucent `#rrggbbaa` as it is, which editors do not read; and it is ten times as large.
 */
export class SvgContext {
  /** @type {Style} */ fillStyle = '#000000';
  /** @type {Style} */ strokeStyle = '#000000';
  lineWidth = 1;
  /** @type {CanvasLineCap} */ lineCap = 'butt';
  /** @type {CanvasLineJoin} */ lineJoin = 'miter';
  miterLimit = 10;
  lineDashOffset = 0;
  globalAlpha = 1;
  imageSmoothingEnabled = true;
  font = '10px sans-serif';
  /** @type {CanvasTextAlign} */ textAlign = 'start';
  /** @type {CanvasTextBaseline} */ textBaseline = 'alphabetic';

  #size;
  #ruler;
  /** @type {Matrix} */ #matrix = identity;
  /** @type {number[]} */ #dash = [];
  /** The id of the clip in force. */ #clip = '';
  #path = new SvgPath();
  /** @type {Record<string, unknown>[]} */ #saved = [];
  /** @type {{ clip: string, element: string }[]} */ #elements = [];
  /** Definitions by their text, so that equal ones stand once. @type {Map<string, string>} */ #definitions = new Map();

  /**
   * @param {Size} size in CSS pixels
   * @param {Ruler} ruler
   */
  constructor(size, ruler) {
    this.#size = size;
    this.#ruler = ruler;
  }

  /**
   * The context as drawings take it.
   * @returns {CanvasRenderingContext2D}
   */
  get asContext() {
    return /** @type {CanvasRenderingContext2D} */ (/** @type {unknown} */ (this));
  }

  /**
   * All that was drawn, as a file.
   * @param {string} title what the picture shows, for those who do not see it
   */
  document(title) {
    const { width, height } = this.#size;
    const definitions = [...this.#definitions.values()].map((element) => `    ${element}\n`).join('');
    let body = '';
    for (let i = 0; i < this.#elements.length;) {
      const { clip } = this.#elements[i];
      const indent = clip ? '    ' : '  ';
      if (clip) body += `  <g clip-path="url(#${clip})">\n`;
      for (; i < this.#elements.length && this.#elements[i].clip === clip; i++) body += `${indent}${this.#elements[i].element}\n`;
      if (clip) body += '  </g>\n';
    }
    return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" role="img">\n`
      + `  <title>${escape(title)}</title>\n${definitions ? `  <defs>\n${definitions}  </defs>\n` : ''}${body}</svg>\n`;
  }

  save() {
    const { fillStyle, strokeStyle, lineWidth, lineCap, lineJoin, miterLimit, lineDashOffset, globalAlpha, imageSmoothingEnabled, font, textAlign, textBaseline } = this;
    this.#saved.push({
      styles: { fillStyle, strokeStyle, lineWidth, lineCap, lineJoin, miterLimit, lineDashOffset, globalAlpha, imageSmoothingEnabled, font, textAlign, textBaseline },
      matrix: this.#matrix, dash: this.#dash, clip: this.#clip,
    });
  }

  restore() {
    const saved = this.#saved.pop();
    if (!saved) return;
    Object.assign(this, saved.styles);
    this.#matrix = /** @type {Matrix} */ (saved.matrix);
    this.#dash = /** @type {number[]} */ (saved.dash);
    this.#clip = /** @type {string} */ (saved.clip);
  }

  /** @param {number} x @param {number} y */
  translate(x, y) {
    this.transform(1, 0, 0, 1, x, y);
  }

  /** @param {number} x @param {number} y */
  scale(x, y) {
    this.transform(x, 0, 0, y, 0, 0);
  }

  /** @param {number} angle */
  rotate(angle) {
    this.transform(Math.cos(angle), Math.sin(angle), -Math.sin(angle), Math.cos(angle), 0, 0);
  }

  /** @param {...number} matrix */
  transform(...matrix) {
    this.#matrix = multiply(this.#matrix, /** @type {Matrix} */ (matrix));
  }

  beginPath() {
    this.#path = new SvgPath();
  }

  closePath() {
    this.#path.close();
  }

  /** @param {number} x @param {number} y */
  moveTo(x, y) {
    this.#path.moveTo(this.#matrix, x, y);
  }

  /** @param {number} x @param {number} y */
  lineTo(x, y) {
    this.#path.lineTo(this.#matrix, x, y);
  }

  /** @param {number} x1 @param {number} y1 @param {number} x2 @param {number} y2 @param {number} x @param {number} y */
  bezierCurveTo(x1, y1, x2, y2, x, y) {
    this.#path.curveTo(this.#matrix, x1, y1, x2, y2, x, y);
  }

  /** @param {number} x @param {number} y @param {number} width @param {number} height */
  rect(x, y, width, height) {
    this.#path.rect(this.#matrix, x, y, width, height);
  }

  /** @param {number} x @param {number} y @param {number} width @param {number} height @param {number} [radius] of all corners */
  roundRect(x, y, width, height, radius = 0) {
    this.#path.roundRect(this.#matrix, x, y, width, height, radius);
  }

  /** @param {number} x @param {number} y @param {number} radius @param {number} from @param {number} to @param {boolean} [isCounterClockwise] */
  arc(x, y, radius, from, to, isCounterClockwise = false) {
    this.#path.ellipse(this.#matrix, x, y, radius, radius, 0, from, to, isCounterClockwise);
  }

  /**
   * @param {number} x @param {number} y @param {number} radiusX @param {number} radiusY @param {number} turn
   * @param {number} from @param {number} to @param {boolean} [isCounterClockwise]
   */
  ellipse(x, y, radiusX, radiusY, turn, from, to, isCounterClockwise = false) {
    this.#path.ellipse(this.#matrix, x, y, radiusX, radiusY, turn, from, to, isCounterClockwise);
  }

  /** @param {CanvasFillRule} [rule] */
  fill(rule = 'nonzero') {
    this.#fillPath(this.#path, rule);
  }

  stroke() {
    this.#strokePath(this.#path);
  }

  /** Narrows the clip in force to the path. @param {CanvasFillRule} [rule] */
  clip(rule = 'nonzero') {
    const within = this.#clip ? ` clip-path="url(#${this.#clip})"` : '';
    const ruled = rule === 'evenodd' ? ' clip-rule="evenodd"' : '';
    const shape = `<path${ruled} d="${this.#path.data()}"/>`;
    this.#clip = this.#define('clip', (id) => `<clipPath id="${id}"${within}>${shape}</clipPath>`);
  }

  /** @param {number} x @param {number} y @param {number} width @param {number} height */
  fillRect(x, y, width, height) {
    this.#fillPath(this.#rectangle(x, y, width, height), 'nonzero');
  }

  /** @param {number} x @param {number} y @param {number} width @param {number} height */
  strokeRect(x, y, width, height) {
    this.#strokePath(this.#rectangle(x, y, width, height));
  }

  /** @param {number[]} dash */
  setLineDash(dash) {
    this.#dash = dash.length % 2 ? [...dash, ...dash] : [...dash];
  }

  getLineDash() {
    return [...this.#dash];
  }

  /** @param {string} text */
  measureText(text) {
    const { font, textAlign, textBaseline } = this;
    return Object.assign(this.#ruler, { font, textAlign, textBaseline }).measureText(text);
  }

  /** @param {string} text @param {number} x @param {number} y */
  fillText(text, x, y) {
    this.#write(text, x, y, 'fill');
  }

  /** @param {string} text @param {number} x @param {number} y */
  strokeText(text, x, y) {
    this.#write(text, x, y, 'stroke');
  }

  /**
   * A picture of pixels, which stays one.
   * @param {{ toDataURL?: () => string }} image a canvas @param {number} x @param {number} y @param {number} width @param {number} height
   */
  drawImage(image, x, y, width, height) {
    if (!image.toDataURL) throw new Error('only a canvas can be drawn into an SVG');
    const opacity = this.globalAlpha < 1 ? ` opacity="${this.globalAlpha}"` : '';
    const pixels = this.imageSmoothingEnabled ? '' : ' style="image-rendering: pixelated"';
    this.#draw(`<image x="${short(x)}" y="${short(y)}" width="${short(width)}" height="${short(height)}"${turned(this.#matrix)}`
      + ` preserveAspectRatio="none"${opacity}${pixels} href="${image.toDataURL()}"/>`);
  }

  /** @param {number} x1 @param {number} y1 @param {number} x2 @param {number} y2 */
  createLinearGradient(x1, y1, x2, y2) {
    return new SvgGradient('linearGradient', { x1, y1, x2, y2 });
  }

  /** @param {number} fx @param {number} fy @param {number} fr @param {number} cx @param {number} cy @param {number} r */
  createRadialGradient(fx, fy, fr, cx, cy, r) {
    return new SvgGradient('radialGradient', { fx, fy, fr, cx, cy, r });
  }

  /** @param {number} x @param {number} y @param {number} width @param {number} height */
  #rectangle(x, y, width, height) {
    const path = new SvgPath();
    path.rect(this.#matrix, x, y, width, height);
    return path;
  }

  /** @param {SvgPath} path @param {CanvasFillRule} rule */
  #fillPath(path, rule) {
    if (path.isEmpty) return;
    const ruled = rule === 'evenodd' ? ' fill-rule="evenodd"' : '';
    this.#draw(`<path${this.#paint('fill', this.fillStyle, this.#matrix)}${ruled} d="${path.data()}"/>`);
  }

  /** @param {SvgPath} path */
  #strokePath(path) {
    if (path.isEmpty) return;
    const matrix = this.#matrix;
    const paint = (/** @type {Matrix} */ axes) => ` fill="none"${this.#paint('stroke', this.strokeStyle, axes)}`;
    if (isEven(matrix)) {
      this.#draw(`<path${paint(matrix)}${this.#line(Math.hypot(matrix[0], matrix[1]))} d="${path.data()}"/>`);
    } else {
      // A pen that draws wider one way than the other: the path goes back to the axes it was drawn on.
      this.#draw(`<path${paint(identity)}${this.#line(1)}${turned(matrix)} d="${path.data(inverse(matrix), 4)}"/>`);
    }
  }

  /** @param {string} text @param {number} x @param {number} y @param {'fill' | 'stroke'} kind */
  #write(text, x, y, kind) {
    if (!text || !Number.isFinite(x + y)) return;
    const [a, b, c, d] = this.#matrix;
    const isUpright = a === 1 && b === 0 && c === 0 && d === 1;
    const baseline = y + this.#drop(text);
    const [left, top] = isUpright ? transform(this.#matrix, x, baseline) : [x, baseline];
    const axes = isUpright ? this.#matrix : identity;
    const paint = kind === 'fill' ? this.#paint('fill', this.fillStyle, axes) : ` fill="none"${this.#paint('stroke', this.strokeStyle, axes)}${this.#line(1)}`;
    const type = textAttributes(text, this.font, this.textAlign, this.measureText(text).width);
    this.#draw(`<text x="${short(left)}" y="${short(top)}"${isUpright ? '' : turned(this.#matrix)}${type}${paint}>${escape(text)}</text>`);
  }

  /** How far below the y of a text its letters stand: viewers agree on no baseline but that. @param {string} text */
  #drop(text) {
    if (this.textBaseline === 'alphabetic') return 0;
    const here = this.measureText(text).fontBoundingBoxAscent;
    const { font } = this;
    return Object.assign(this.#ruler, { font, textBaseline: 'alphabetic' }).measureText(text).fontBoundingBoxAscent - here;
  }

  /**
   * The color or gradient as attributes.
   * @param {'fill' | 'stroke'} kind @param {Style} style
   * @param {Matrix} axes those of the gradient as the element sees them
   */
  #paint(kind, style, axes) {
    const { color, opacity } = style instanceof SvgGradient
      ? { color: `url(#${this.#define('paint', (id) => style.element(id, axes))})`, opacity: 1 } : svgColor(style);
    const shown = opacity * this.globalAlpha;
    return ` ${kind}="${color}"${shown < 1 ? ` ${kind}-opacity="${Number(shown.toFixed(3))}"` : ''}`;
  }

  /** The pen as attributes. @param {number} scale */
  #line(scale) {
    const dash = this.#dash.length > 0 ? ` stroke-dasharray="${this.#dash.map((length) => short(length * scale)).join(' ')}"` : '';
    const offset = dash && this.lineDashOffset ? ` stroke-dashoffset="${short(this.lineDashOffset * scale)}"` : '';
    const cap = this.lineCap === 'butt' ? '' : ` stroke-linecap="${this.lineCap}"`;
    const join = this.lineJoin === 'miter' ? ` stroke-miterlimit="${this.miterLimit}"` : ` stroke-linejoin="${this.lineJoin}"`;
    return ` stroke-width="${short(this.lineWidth * scale)}"${cap}${join}${dash}${offset}`;
  }

  /**
   * The id of a definition, which is written once however often it is used.
   * @param {string} kind
   * @param {(id: string) => string} element
   */
  #define(kind, element) {
    const key = element('');
    const known = this.#definitions.get(key);
    if (known) return /** @type {RegExpExecArray} */ (/id="([^"]+)"/.exec(known))[1];
    const id = `${kind}-${this.#definitions.size + 1}`;
    this.#definitions.set(key, element(id));
    return id;
  }

  /** @param {string} element */
  #draw(element) {
    this.#elements.push({ clip: this.#clip, element });
  }
}

/** @param {Matrix} matrix */
function turned(matrix) {
  return ` transform="matrix(${matrix.map((value) => Number(value.toFixed(6)) || 0).join(' ')})"`;
}

/** @param {number} value */
function short(value) {
  return String(Number(value.toFixed(2)) || 0);
}

/** @param {string} text */
function escape(text) {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
}
