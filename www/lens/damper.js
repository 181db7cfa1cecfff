import '../style/damper.css';
import { viewNames } from './damper/settings.js';
import { damperViews } from './damper/views.js';
import { PanelLens } from './panel-lens.js';

/** The lens *Damper*: magnetorheological dampers by themselves, fitted to measured records, in one of several views. */
export class DamperLens extends PanelLens {
  get lens() {
    return 'damper';
  }

  /** @param {string} name */
  wordOfView(name) {
    return `damper.view.${name}`;
  }

  /** @param {string} name */
  wordOfLine(name) {
    return `damper.line.${name}`;
  }

  get views() {
    return viewNames;
  }

  get #view() {
    return damperViews[/** @type {typeof viewNames[number]} */ (this.view)];
  }

  get fits() {
    return this.#view.fits;
  }

  /** @param {import('../words/voice.js').Voice} voice */
  panelOf(voice) {
    const { quantities, settings, isVeiled } = this;
    return this.#view.template({ voice, quantities, settings, isVeiled });
  }
}

customElements.define('shimmy-damper-lens', DamperLens);
