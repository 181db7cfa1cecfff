/**
 * A hand on the wheel, from the press to the lift: which pointer it is, what the wheel is turned to, and whether it was a
 * twist or only a tap. Knows no element; the gear's view tells it of pointers.
 *
 * @typedef {import('./gear/grab.js').Point} Point
 * @typedef {import('./gear/scene.js').Scene} Scene
 * @typedef {import('./gear/scene.js').Size} Size
 */

import { Hold, isOnWheel } from './gear/grab.js';

/** A press shorter than this, in ms, that moves less than this, in px, is a tap. */
const longestTap = 250;
const widestTap = 4;

export class Hand {
  /** @type {{ pointer: number, hold: Hold, size: Size, from: Point, since: number, isTap: boolean } | null} */ #grip = null;

  get isHolding() {
    return this.#grip !== null;
  }

  /**
   * A pointer presses. A second one changes nothing.
   * @param {number} pointer @param {Point} point @param {number} now in ms @param {Size} size @param {Scene} scene
   * @returns {boolean} whether it has hold of the wheel
   */
  press(pointer, point, now, size, scene) {
    if (this.#grip || !isOnWheel(size, scene, point)) return false;
    this.#grip = { pointer, hold: new Hold(size, scene, point), size, from: point, since: now, isTap: true };
    return true;
  }

  /**
   * @param {number} pointer @param {Point} point @param {Size} size @param {Scene} scene
   * @returns {number | null} ψ in rad that the wheel is turned to; null for a pointer that does not hold it
   */
  move(pointer, point, size, scene) {
    const grip = this.#grip;
    if (grip?.pointer !== pointer) return null;
    if (grip.size.width !== size.width || grip.size.height !== size.height) {
      // The axis has moved under the hand: it takes hold anew, so that the wheel does not jump.
      Object.assign(grip, { hold: new Hold(size, scene, point), size });
    }
    grip.isTap &&= Math.hypot(point.x - grip.from.x, point.y - grip.from.y) < widestTap;
    return grip.hold.turnTo(point);
  }

  /**
   * @param {number} pointer @param {number} now in ms
   * @returns {'twist' | 'tap' | null} what it was; null for a pointer that did not hold the wheel
   */
  lift(pointer, now) {
    const grip = this.#grip;
    if (grip?.pointer !== pointer) return null;
    this.#grip = null;
    return grip.isTap && now - grip.since < longestTap ? 'tap' : 'twist';
  }

  /** The wheel is out of the hand, whatever the pointer does. */
  drop() {
    this.#grip = null;
  }
}
