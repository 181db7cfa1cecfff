import { html, unsafeStatic } from 'lit/static-html.js';
import { lineInTheory } from './say.js';

/**
 * A view that is an element of its own, a panel.js, called `shimmy-<name>`: it draws itself when the gear has changed. The line
 * under it is `panel.line.<name>`.
 *
 * @typedef {import('./views.js').View} View
 * @typedef {import('../stability.js').StabilityLens} StabilityLens
 *
 * @param {string} name
 * @returns {new (lens: StabilityLens) => View}
 */
export const panelView = (name) => class {
  #lens;

  /** @param {StabilityLens} lens */
  constructor(lens) {
    this.#lens = lens;
  }

  /** @type {View['template']} */
  template(voice) {
    const { quantities, settings, isVeiled } = this.#lens;
    const tag = unsafeStatic(`shimmy-${name}`);
    return html`<${tag} class="stability-panel" .voice=${voice} .quantities=${quantities} .settings=${settings} .isVeiled=${isVeiled}></${tag}>`;
  }

  /** @type {View['line']} */
  line(voice) {
    // Of what is hidden nothing is said, and nothing to press.
    if (this.#lens.isVeiled) return html`<p></p>`;
    const line = voice.say(/** @type {import('../../words/voice.js').Key} */ (`panel.line.${name}`));
    return html`<p>${lineInTheory(line, this.#lens.leavesOut, voice)}</p>`;
  }

  /** A panel draws itself. */
  stale() {}

  /** @type {View['draw']} */
  draw(scene) {
    const panel = /** @type {import('./panel.js').Panel | null} */ (this.#lens.querySelector('.stability-panel'));
    if (panel && this.#lens.theme) panel.draw(scene, this.#lens.theme);
  }
};
