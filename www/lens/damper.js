import { html } from 'lit';
import '../style/damper.css';
import { viewNames } from './damper/settings.js';
import { damperViews } from './damper/views.js';
import { PlotLens } from './plot-lens.js';

/**
 * @typedef {import('../run/scene.js').Scene} Scene
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/** The lens *Damper*: magnetorheological dampers by themselves, fitted to measured records, in one of several views, each a panel of its own. */
export class DamperLens extends PlotLens {
  static properties = { ...PlotLens.properties, settings: { attribute: false } };

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
    return voice.say(/** @type {import('../words/voice.js').Key} */ (`damper.view.${name}`));
  }

  get #view() {
    return damperViews[/** @type {typeof viewNames[number]} */ (this.view)];
  }

  get fits() {
    return this.#view.fits;
  }

  /** Of what is hidden nothing is said. @param {Voice} voice */
  line(voice) {
    return html`<p>${this.isVeiled ? '' : voice.say(/** @type {import('../words/voice.js').Key} */ (`damper.line.${this.view}`))}</p>`;
  }

  /** @param {Voice} voice */
  plot(voice) {
    const { quantities, settings, isVeiled } = this;
    // It lies on the page as the lens Stability does.
    return html`<div class="stability damper" data-view=${this.view}>${this.#view.template({ voice, quantities, settings, isVeiled })}</div>`;
  }

  /** @param {Map<string, unknown>} changed */
  updated(changed) {
    if (changed.size > 0 && this.scene && this.theme) this.draw(this.scene, this.theme);
  }

  /** @param {Scene} scene @param {Theme} theme */
  draw(scene, theme) {
    this.scene = scene;
    this.theme = theme;
    /** @type {import('./damper/panel.js').DamperPanel | null} */ (this.querySelector('.stability-panel'))?.draw(scene, theme);
  }
}

customElements.define('shimmy-damper-lens', DamperLens);
