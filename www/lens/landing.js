import { runJob } from '../engine/workers.js';
import '../style/landing.css';
import { cases } from './landing/cases.js';
import { RollSet } from './landing/roll-set.js';
import { viewNames } from './landing/settings.js';
import { landingViews } from './landing/views.js';
import { PanelLens } from './panel-lens.js';

/** The lens *Landing*: a gear that rolls out from touchdown on, in one of several views. */
export class LandingLens extends PanelLens {
  #rolls = new RollSet(cases, runJob);

  get lens() {
    return 'landing';
  }

  /** @param {string} name */
  wordOfView(name) {
    return `landing.view.${name}`;
  }

  /** @param {string} name */
  wordOfLine(name) {
    return `landing.line.${name}`;
  }

  get views() {
    return viewNames;
  }

  get fits() {
    return false;
  }

  /** @param {import('../words/voice.js').Voice} voice */
  panelOf(voice) {
    const { quantities, settings, isVeiled } = this;
    return landingViews[/** @type {typeof viewNames[number]} */ (this.view)]({ voice, quantities, settings, isVeiled, rolls: this.#rolls });
  }
}

customElements.define('shimmy-landing-lens', LandingLens);
