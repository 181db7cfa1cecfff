import { html } from 'lit';
import { ForceLaws, isRubbed } from './force-laws.js';
import { PlotLens } from './plot-lens.js';

/**
 * @typedef {import('../view/forces.js').Shown} Shown
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/** The lens *Forces*: what drives and what holds the swing, each law with the point where the gear is now. Dry friction has a law where there is any. */
export class ForcesLens extends PlotLens {
  #laws = new ForceLaws();
  /** Whether there was any friction when it was drawn last. */
  #rubbed = false;

  get views() {
    return super.views.filter((name) => this.#rubbed || name !== 'frictionMoment');
  }

  /** @param {string} name @param {Voice} voice */
  nameOfView(name, voice) {
    return voice.say(/** @type {import('../words/voice.js').Key} */ (`forces.view.${name}`));
  }

  /** @param {Voice} voice */
  label(voice) {
    return voice.say(this.#rubbed ? 'forces.name.rubbed' : 'forces.name');
  }

  /** @param {Voice} voice */
  line(voice) {
    return html`<p>${voice.say(this.#isLimited ? 'forces.limited' : 'forces.growing')}</p>`;
  }

  /** Whether the side force meets its limit within a cycle: of the cycle, as the instant changes too fast to be read. */
  get #isLimited() {
    const { scene } = this;
    const [low, high] = scene?.lastCycle()?.slipAngle ?? [0, 0];
    const limit = scene?.laws({ samples: 2 }).kinks.sideForceLimitAngle ?? Infinity;
    return Math.max(high, -low) > limit;
  }

  /** @type {PlotLens['draw']} */
  draw(scene, theme) {
    const rubs = isRubbed(scene);
    if (rubs !== this.#rubbed) {
      this.#rubbed = rubs;
      this.requestUpdate();
    }
    super.draw(scene, theme);
  }

  /** @type {PlotLens['paintScene']} */
  paintScene(context, size, scene, theme, voice) {
    const { view, views } = this;
    this.#laws.paint(context, size, {
      scene, shown: /** @type {Shown[]} */ (view === 'all' ? views.filter((name) => name !== 'all') : [view]), labelOf: (ghost) => this.labelOf(scene, ghost, voice),
    }, theme, voice);
  }
}

customElements.define('shimmy-forces-lens', ForcesLens);
