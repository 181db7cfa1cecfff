import { LitElement, html } from 'lit';

/** @typedef {{ width: number, height: number }} Size in CSS pixels */
/** @typedef {(context: CanvasRenderingContext2D, size: Size) => void} Paint */

/**
 * A canvas that fills its element. The one place that knows of device pixels: `paint` works in CSS pixels.
 * Set `paint`, call `redraw`; it also redraws itself when its size changes.
 */
export class Canvas extends LitElement {
  static properties = { label: {} };

  #observer = new ResizeObserver(() => this.#resize());
  /** @type {CanvasRenderingContext2D | null} */ #context = null;
  /** @type {Size} */ size = { width: 0, height: 0 };
  /** @type {Paint | null} */ paint = null;

  constructor() {
    super();
    /** What a screen reader says the picture is. */
    this.label = '';
  }

  createRenderRoot() {
    return this;
  }

  connectedCallback() {
    super.connectedCallback();
    this.#observer.observe(this);
  }

  disconnectedCallback() {
    this.#observer.disconnect();
    super.disconnectedCallback();
  }

  render() {
    return html`<canvas role="img" aria-label=${this.label}></canvas>`;
  }

  firstUpdated() {
    // Its size comes from the observer, with the layout that is made anyway: to ask for it here would make one more.
    this.#context = this.querySelector('canvas')?.getContext('2d') ?? null;
  }

  redraw() {
    const { width, height } = this.size;
    if (!this.#context || !this.paint || !width || !height) return;
    const ratio = this.#context.canvas.width / width;
    this.#context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.#context.clearRect(0, 0, width, height);
    this.paint(this.#context, this.size);
  }

  #resize() {
    const canvas = this.#context?.canvas;
    if (!canvas) return;
    const { width, height } = this.getBoundingClientRect();
    const ratio = window.devicePixelRatio || 1;
    this.size = { width, height };
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    this.redraw();
  }
}

customElements.define('shimmy-canvas', Canvas);
