import '../style/cycles.css';
import { CycleWatch, pause } from './cycles/cycle-watch.js';
import { viewNames } from './cycles/settings.js';
import { cycleViews } from './cycles/views.js';
import { PanelLens } from './panel-lens.js';

/**
 * @typedef {import('../run/scene.js').Scene} Scene
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/**
 * The lens *Cycles*: motions that repeat, in one of several views, each a panel of its own. It follows the gear's limit cycle
 * while values change; the views share that.
 */
export class CyclesLens extends PanelLens {
  /** The gear's limit cycle. */
  watch = new CycleWatch();
  #timer = 0;

  disconnectedCallback() {
    clearTimeout(this.#timer);
    this.#timer = 0;
    super.disconnectedCallback();
  }

  get lens() {
    return 'cycles';
  }

  /** @param {string} name */
  wordOfView(name) {
    return `cycles.view.${name}`;
  }

  /** @param {string} name */
  wordOfLine(name) {
    return `cycles.line.${name}`;
  }

  get views() {
    return viewNames;
  }

  get #view() {
    return cycleViews[/** @type {typeof viewNames[number]} */ (this.view)];
  }

  get fits() {
    return this.#view.fits;
  }

  /** @param {Voice} voice */
  panelOf(voice) {
    const { quantities, settings, isVeiled, watch, outlook } = this;
    return this.#view.template({ voice, quantities, settings, isVeiled, watch, outlook });
  }

  /** @param {Map<string, unknown>} changed */
  updated(changed) {
    // Where the page scrolls, a view that has been chosen comes in sight with what it shows.
    if (changed.get('shows') !== undefined) requestAnimationFrame(this.#bringInSight);
    super.updated(changed);
  }

  #bringInSight = () => {
    if (document.documentElement.scrollHeight > window.innerHeight + 1) this.querySelector('.cycles')?.scrollIntoView({ block: 'start' });
  };

  /** @param {Scene} scene @param {Theme} theme */
  draw(scene, theme) {
    const isOther = !this.isVeiled && this.#view.needsCycle && this.watch.follow(scene, performance.now());
    // A search that waits for a slower hand is made though no frame comes any more.
    if (this.watch.isOwed && !this.#timer && this.isConnected)
      this.#timer = window.setTimeout(() => {
        this.#timer = 0;
        if (this.scene && this.theme) this.draw(this.scene, this.theme);
      }, pause);
    super.draw(scene, theme);
    if (isOther) this.panel?.requestUpdate();
  }
}

customElements.define('shimmy-cycles-lens', CyclesLens);
