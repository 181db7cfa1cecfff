import { html } from 'lit';
import { RootsAndSwing } from './roots-and-swing.js';
import { lineInTheory } from './say.js';

/** @typedef {import('./views.js').View} View */

/** Roots and swing alone, as large as the lens. @implements {View} */
export class RootsView {
  #lens;
  #roots;

  /** @param {import('../stability.js').StabilityLens} lens */
  constructor(lens) {
    this.#lens = lens;
    this.#roots = new RootsAndSwing(lens);
  }

  /** @type {View['template']} */
  template(voice) {
    return this.#roots.template(voice);
  }

  /** @type {View['line']} */
  line(voice) {
    const { leavesOut } = this.#lens;
    return html`<p>${leavesOut === 'gap' ? voice.say('roots.line.gap') : lineInTheory(voice.say('roots.line'), leavesOut, voice)}</p>`;
  }

  stale() {
    this.#roots.stale();
  }

  /** @type {View['draw']} */
  draw(scene) {
    this.#roots.draw(scene);
  }
}
