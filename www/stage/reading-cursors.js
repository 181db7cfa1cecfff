/**
 * The cursors on the time lane: a loose one that follows the mouse or the keys, and up to two that are pinned. A pinned
 * one stays at its instant of the run while time goes on; the loose one stays where it is on the screen.
 */

const most = 2;

export class ReadingCursors {
  /** Where the loose one is, in s from now; null where there is none. @type {number | null} */ #loose = null;
  /** @type {number[]} in s of the run */ #pinned = [];

  get isEmpty() {
    return this.#loose === null && this.#pinned.length === 0;
  }

  /** Whether the loose one is there. */
  get isLoose() {
    return this.#loose !== null;
  }

  /**
   * The loose one is put somewhere, kept within what can be read.
   * @param {number} offset in s from now @param {[number, number]} window what can be read
   */
  put(offset, [from, to]) {
    this.#loose = Math.min(Math.max(offset, from), to);
  }

  /** @param {number} step in s @param {[number, number]} window */
  move(step, window) {
    this.put((this.#loose ?? 0) + step, window);
  }

  /** The mouse is gone. */
  takeLoose() {
    this.#loose = null;
  }

  /**
   * Pins a cursor. After two the next one begins anew, and so it does where those pinned are out of sight.
   * @param {number} offset in s from now @param {number} now in s of the run @param {[number, number]} window
   */
  pin(offset, now, [from, to]) {
    const seen = this.#pinned.filter((time) => time - now >= from && time - now <= to);
    this.#pinned = [...(seen.length < most ? seen : []), now + offset];
  }

  /** Pins the loose one where it is. @param {number} now @param {[number, number]} window */
  pinLoose(now, window) {
    if (this.#loose !== null) this.pin(this.#loose, now, window);
  }

  clear() {
    this.#loose = null;
    this.#pinned = [];
  }

  /**
   * Those to be drawn and read: the pinned ones, and the loose one where there is room for it.
   * @param {number} now in s of the run @param {[number, number]} window
   * @returns {number[]} in s from now, at most two
   */
  at(now, [from, to]) {
    const pinned = this.#pinned.map((time) => time - now).filter((offset) => offset >= from && offset <= to);
    return [...pinned, ...(this.#loose === null ? [] : [this.#loose])].slice(0, most);
  }
}
