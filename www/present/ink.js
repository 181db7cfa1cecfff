import { Stopwatch } from './stopwatch.js';

/**
 * What a pen drew, each stroke on its view. While the run goes on ink fades, unless it is pinned.
 *
 * @typedef {import('./stroke.js').Point} Point
 * @typedef {{ view: string, points: readonly Point[], strength: number }} Stroke `strength`: 1 for fresh ink, 0 for none
 */

/** How long ink takes to fade, in s. */
const fading = 1.5;

export class Ink {
  /** Whether ink stays though the run goes on. */
  isPinned = false;
  /** The views that are on the screen. @type {readonly string[]} */ shown = [];
  /** @type {readonly Stroke[]} */ #strokes = [];
  #watch = new Stopwatch();

  /** All strokes, the first drawn first; another list after each change. */
  get strokes() {
    return this.#strokes;
  }

  /** What was drawn on a view. @param {string} view */
  of(view) {
    return this.#strokes.filter((stroke) => stroke.view === view);
  }

  /** @param {string} view @param {readonly Point[]} points */
  add(view, points) {
    if (points.length > 0) this.#strokes = [...this.#strokes, { view, points, strength: 1 }];
  }

  /** What stays if it is left alone: fading ink does not. */
  get lasting() {
    return this.#strokes.filter(({ strength }) => this.isPinned || strength === 1);
  }

  /** What was drawn elsewhere takes the place of what was here; it stays. @param {readonly { view: string, points: readonly Point[] }[]} drawn */
  bring(drawn) {
    this.#strokes = drawn.map(({ view, points }) => ({ view, points, strength: 1 }));
    this.isPinned = drawn.length > 0;
  }

  /** Takes back the last stroke of those that are seen. */
  undo() {
    const last = this.#strokes.findLastIndex(({ view }) => this.shown.includes(view));
    if (last >= 0) this.#strokes = this.#strokes.filter((_, i) => i !== last);
  }

  /** Takes back all strokes that are seen. */
  clear() {
    this.#strokes = this.#strokes.filter(({ view }) => !this.shown.includes(view));
  }

  /**
   * Lets a frame go by.
   * @param {number} now wall time in s, on any steady scale
   * @param {boolean} isPlaying whether the run goes on
   */
  elapse(now, isPlaying) {
    const passed = this.#watch.elapse(now, isPlaying && !this.isPinned);
    if (passed === 0 || this.#strokes.length === 0) return;
    this.#strokes = this.#strokes
      .map((stroke) => ({ ...stroke, strength: stroke.strength - passed / fading }))
      .filter(({ strength }) => strength > 0);
  }
}
