import { turnedByDrag, turnedByKey } from '../view/look.js';

/**
 * A drawing in space under a hand: turned by a drag or by arrow keys, and kept, in whole degrees, where the hand lets go.
 *
 * @typedef {import('../view/look.js').Look} Look
 */

const degrees = 180 / Math.PI;

export class Turning {
  #kept;
  #keep;
  #redraw;
  /** How it is looked at while a hand turns it. @type {Look | null} */ #look = null;
  /** @type {{ x: number, y: number } | null} */ #grip = null;

  /**
   * @param {() => Look} kept how it is looked at where no hand turns it
   * @param {(degrees: string) => void} keep takes yaw and pitch, `105,20`
   * @param {() => void} redraw
   */
  constructor(kept, keep, redraw) {
    this.#kept = kept;
    this.#keep = keep;
    this.#redraw = redraw;
  }

  get look() {
    return this.#look ?? this.#kept();
  }

  /** @param {PointerEvent} event */
  grab = (event) => {
    if (event.button !== 0) return;
    this.#grip = { x: event.clientX, y: event.clientY };
    /** @type {HTMLElement} */ (event.currentTarget).setPointerCapture(event.pointerId);
  };

  /** @param {PointerEvent} event */
  drag = (event) => {
    if (!this.#grip) return;
    this.#look = turnedByDrag(this.look, event.clientX - this.#grip.x, event.clientY - this.#grip.y);
    this.#grip = { x: event.clientX, y: event.clientY };
    this.#redraw();
  };

  release = () => {
    this.#grip = null;
    if (this.#look) this.#settle(this.#look);
  };

  /** @param {KeyboardEvent} event */
  key = (event) => {
    const turned = turnedByKey(this.look, event.key, event.shiftKey);
    if (!turned) return;
    event.preventDefault();
    event.stopPropagation();
    this.#settle(turned);
  };

  /** @param {Look} look */
  #settle({ yaw, pitch }) {
    this.#look = null;
    this.#keep(`${Math.round(yaw * degrees)},${Math.round(pitch * degrees)}`);
  }
}
