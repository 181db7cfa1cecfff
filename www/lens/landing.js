import { html } from 'lit';
import { runJob } from '../engine/workers.js';
import '../style/landing.css';
import { cases } from './landing/cases.js';
import { RollSet } from './landing/roll-set.js';
import { viewNames } from './landing/settings.js';
import { landingViews } from './landing/views.js';
import { PlotLens } from './plot-lens.js';

/** @typedef {import('../words/voice.js').Voice} Voice */

/** The lens *Landing*: a gear that rolls out from touchdown on, in one of several views, each a panel of its own. */
export class LandingLens extends PlotLens {
  static properties = { ...PlotLens.properties, settings: { attribute: false } };

  #rolls = new RollSet(cases, runJob);

  constructor() {
    super();
    /** What each lens shows, by its name, and what its views keep besides. @type {Readonly<Record<string, string>>} */
    this.settings = {};
  }

  get views() {
    return viewNames;
  }

  /** @param {string} name @param {Voice} voice */
  nameOfView(name, voice) {
    return voice.say(/** @type {import('../words/voice.js').Key} */ (`landing.view.${name}`));
  }

  get fits() {
    return false;
  }

  /** Of what is hidden nothing is said. @param {Voice} voice */
  line(voice) {
    return html`<p>${this.isVeiled ? '' : voice.say(/** @type {import('../words/voice.js').Key} */ (`landing.line.${this.view}`))}</p>`;
  }

  /** @param {Voice} voice */
  plot(voice) {
    const { quantities, settings, isVeiled } = this;
    if (quantities.length < 2) return '';
    const view = landingViews[/** @type {typeof viewNames[number]} */ (this.view)];
    // It lies on the page as the lens Stability does.
    return html`<div class="stability landing" data-view=${this.view}>${view({ voice, quantities, settings, isVeiled, rolls: this.#rolls })}</div>`;
  }

  /** @param {Map<string, unknown>} changed */
  updated(changed) {
    if (changed.size > 0 && this.scene && this.theme) this.draw(this.scene, this.theme);
  }

  /** @param {import('../run/scene.js').Scene} scene @param {import('../style/theme.js').Theme} theme */
  draw(scene, theme) {
    this.scene = scene;
    this.theme = theme;
    /** @type {import('./stability/panel.js').Panel | null} */ (this.querySelector('.stability-panel'))?.draw(scene, theme);
  }
}

customElements.define('shimmy-landing-lens', LandingLens);
