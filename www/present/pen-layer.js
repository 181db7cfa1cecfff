import { html } from 'lit';
import { tell } from '../command.js';
import { Canvas } from '../view/canvas.js';
import { drawStrokes } from './draw-strokes.js';

/**
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('./ink.js').Stroke} Stroke
 * @typedef {import('./stroke.js').Point} Point
 */

/** A point nearer than this to the one before says nothing new, in px. */
const nearest = 1.5;
const stillness = matchMedia('(prefers-reduced-motion: reduce)');

/**
 * A sheet over a view on which a pen draws with mouse, finger or stylus. While no pen is in hand it lets everything
 * through; a second finger takes the page, not the pen. Tells a finished stroke by the command `penStroke`.
 */
export class PenLayer extends Canvas {
  /** The name of the view below. */ view = '';
  /** The stroke under way, and whose it is. @type {{ pointer: number, points: Point[] } | null} */ #drawn = null;
  /** @type {readonly Stroke[]} */ #all = [];
  /** @type {Theme | null} */ #theme = null;

  constructor() {
    super();
    /** @type {import('../view/canvas.js').Paint} */
    this.paint = (context, size) => {
      if (!this.#theme) return;
      const strokes = this.#all.filter(({ view }) => view === this.view)
        .map((stroke) => (stillness.matches ? { ...stroke, strength: 1 } : stroke));
      if (this.#drawn) strokes.push({ view: this.view, points: this.#drawn.points, strength: 1 });
      drawStrokes(context, size, strokes, this.#theme);
    };
  }

  connectedCallback() {
    super.connectedCallback();
    this.addEventListener('pointerdown', (event) => this.#begin(event));
    // The gear below keeps a finger on its wheel from moving the page, two of them too.
    this.addEventListener('touchstart', (event) => event.stopPropagation(), { passive: true });
    this.addEventListener('pointermove', (event) => this.#go(event));
    this.addEventListener('pointerup', (event) => this.#end(event));
    this.addEventListener('pointercancel', () => this.#drop());
  }

  render() {
    return html`<canvas aria-hidden="true"></canvas>`;
  }

  /**
   * Shows the ink that belongs to a view.
   * @param {string} view
   * @param {readonly Stroke[]} all the same list as long as nothing has changed
   * @param {Theme} theme
   */
  show(view, all, theme) {
    if (view === this.view && all === this.#all && theme === this.#theme) return;
    if (view !== this.view) this.#drawn = null;
    this.view = view;
    this.#all = all;
    this.#theme = theme;
    this.redraw();
  }

  /** @param {PointerEvent} event */
  #begin(event) {
    // The gear below is not grabbed.
    event.stopPropagation();
    if (this.#drawn) {
      if (event.pointerId !== this.#drawn.pointer) this.#drop();
      return;
    }
    if (event.button !== 0 || !event.isPrimary) return;
    event.preventDefault();
    this.setPointerCapture(event.pointerId);
    this.#drawn = { pointer: event.pointerId, points: [this.#pointOf(event)] };
    this.redraw();
  }

  /** @param {PointerEvent} event */
  #go(event) {
    if (event.pointerId !== this.#drawn?.pointer) return;
    event.stopPropagation();
    const { points } = this.#drawn;
    const all = event.getCoalescedEvents?.() ?? [];
    for (const one of all.length > 0 ? all : [event]) {
      const point = this.#pointOf(one);
      if (this.#distance(points[points.length - 1], point) >= nearest) points.push(point);
    }
    this.redraw();
  }

  /** @param {PointerEvent} event */
  #end(event) {
    if (event.pointerId !== this.#drawn?.pointer) return;
    event.stopPropagation();
    const { points } = this.#drawn;
    this.#drawn = null;
    tell(this, 'penStroke', { view: this.view, points });
  }

  #drop() {
    this.#drawn = null;
    this.redraw();
  }

  /** Of what points, a stylus alone feels how hard. @param {PointerEvent} event @returns {Point} */
  #pointOf({ clientX, clientY, pressure, pointerType }) {
    const { left, top, width, height } = this.getBoundingClientRect();
    return { x: (clientX - left) / width, y: (clientY - top) / height, pressure: pointerType === 'pen' && pressure > 0 ? pressure : 0.5 };
  }

  /** @param {Point} one @param {Point} other in px */
  #distance(one, other) {
    return Math.hypot((other.x - one.x) * this.size.width, (other.y - one.y) * this.size.height);
  }
}

customElements.define('shimmy-pen-layer', PenLayer);
