import { html } from 'lit';
import { PlotLens } from './plot-lens.js';

/**
 * @typedef {import('../run/scene.js').Scene} Scene
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Key} Key
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/** A lens whose views are panels of their own, one of them seen. */
export class PanelLens extends PlotLens {
  static properties = { ...PlotLens.properties, settings: { attribute: false } };

  constructor() {
    super();
    /** What each lens shows, by its name, and what its views keep besides. @type {Readonly<Record<string, string>>} */
    this.settings = {};
  }

  /** By which its look is named. @returns {string} */
  get lens() {
    return '';
  }

  /** @param {string} name @param {Voice} voice */
  nameOfView(name, voice) {
    return voice.say(/** @type {Key} */ (this.wordOfView(name)));
  }

  /** @param {string} _name @returns {string} */
  wordOfView(_name) {
    return '';
  }

  /** The word for what a view is for, in its foot. @param {string} _name @returns {string} */
  wordOfLine(_name) {
    return '';
  }

  /** Of what is hidden nothing is said. @param {Voice} voice */
  line(voice) {
    return html`<p>${this.isVeiled ? '' : voice.say(/** @type {Key} */ (this.wordOfLine(this.view)))}</p>`;
  }

  /** The panel of the view in force. @param {Voice} _voice @returns {unknown} */
  panelOf(_voice) {
    return '';
  }

  /** @param {Voice} voice */
  plot(voice) {
    if (this.quantities.length < 2) return '';
    // It lies on the page as the lens Stability does.
    return html`<div class="stability ${this.lens}" data-view=${this.view}>${this.panelOf(voice)}</div>`;
  }

  get panel() {
    return /** @type {import('./stability/panel.js').Panel | null} */ (this.querySelector('.stability-panel'));
  }

  /** @param {Map<string, unknown>} changed */
  updated(changed) {
    if (changed.size > 0 && this.scene && this.theme) this.draw(this.scene, this.theme);
  }

  /** @param {Scene} scene @param {Theme} theme */
  draw(scene, theme) {
    this.scene = scene;
    this.theme = theme;
    this.panel?.draw(scene, theme);
  }
}
