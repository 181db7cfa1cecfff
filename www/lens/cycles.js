import { html } from 'lit';
import '../style/cycles.css';
import { CycleWatch, pause } from './cycles/cycle-watch.js';
import { viewNames } from './cycles/settings.js';
import { cycleViews } from './cycles/views.js';
import { PlotLens } from './plot-lens.js';

/**
 * @typedef {import('../run/scene.js').Scene} Scene
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('./cycles/panel.js').CyclePanel} CyclePanel
 */

/**
 * The lens *Cycles*: motions that repeat, in one of several views, each a panel of its own. It follows the gear's limit cycle
 * while values change; the views share that.
 */
export class CyclesLens extends PlotLens {
  static properties = { ...PlotLens.properties, settings: { attribute: false } };

  /** The gear's limit cycle. */
  watch = new CycleWatch();
  #timer = 0;

  constructor() {
    super();
    /** What each lens shows, by its name, and what its views keep besides. @type {Readonly<Record<string, string>>} */
    this.settings = {};
  }

  disconnectedCallback() {
    clearTimeout(this.#timer);
    this.#timer = 0;
    super.disconnectedCallback();
  }

  get views() {
    return viewNames;
  }

  /** @param {string} name @param {Voice} voice */
  nameOfView(name, voice) {
    return voice.say(/** @type {import('../words/voice.js').Key} */ (`cycles.view.${name}`));
  }

  get #view() {
    return cycleViews[/** @type {typeof viewNames[number]} */ (this.view)];
  }

  get fits() {
    return this.#view.fits;
  }

  get #panel() {
    return /** @type {CyclePanel | null} */ (this.querySelector('.stability-panel'));
  }

  /** Of what is hidden nothing is said. @param {Voice} voice */
  line(voice) {
    return html`<p>${this.isVeiled ? '' : voice.say(/** @type {import('../words/voice.js').Key} */ (`cycles.line.${this.view}`))}</p>`;
  }

  /** @param {Voice} voice */
  plot(voice) {
    const { quantities, settings, isVeiled, watch, outlook } = this;
    if (quantities.length < 2) return '';
    // It lies on the page as the lens Stability does.
    return html`
      <div class="stability cycles" data-view=${this.view}>${this.#view.template({ voice, quantities, settings, isVeiled, watch, outlook })}</div>`;
  }

  /** @param {Map<string, unknown>} changed */
  updated(changed) {
    // Where the page scrolls, a view that has been chosen comes in sight with what it shows.
    if (changed.get('shows') !== undefined) requestAnimationFrame(this.#bringInSight);
    if (changed.size > 0 && this.scene && this.theme) this.draw(this.scene, this.theme);
  }

  #bringInSight = () => {
    if (document.documentElement.scrollHeight > window.innerHeight + 1) this.querySelector('.cycles')?.scrollIntoView({ block: 'start' });
  };

  /** @param {Scene} scene @param {Theme} theme */
  draw(scene, theme) {
    this.scene = scene;
    this.theme = theme;
    const isOther = !this.isVeiled && this.#view.needsCycle && this.watch.follow(scene, performance.now());
    // A search that waits for a slower hand is made though no frame comes any more.
    if (this.watch.isOwed && !this.#timer && this.isConnected)
      this.#timer = window.setTimeout(() => {
        this.#timer = 0;
        if (this.scene && this.theme) this.draw(this.scene, this.theme);
      }, pause);
    const panel = this.#panel;
    panel?.draw(scene, theme);
    if (isOther) panel?.requestUpdate();
  }
}

customElements.define('shimmy-cycles-lens', CyclesLens);
