import { html } from 'lit';
import '../view/canvas.js';
import { PlotLens } from './plot-lens.js';
import { RootsWalk, isStable } from './stability/roots-walk.js';
import { crossingInWords, inTheory } from './stability/say.js';
import { viewNames } from './stability/settings.js';
import { stabilityViews } from './stability/views.js';

/**
 * @typedef {import('../run/scene.js').Scene} Scene
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/** What changes without being seen in a picture. */
const unseen = ['said', 'outlook', 'ghosts'];

/** Views with nothing to fit: an array, shapes as shares, planes with ranges that are chosen. */
const withoutScale = ['modes', 'routh', 'beside'];

/**
 * The lens *Stability*: what linear theory says of the gear, in one of several views. It follows the roots as values change
 * and tells when a pair crosses the axis; the views share that.
 */
export class StabilityLens extends PlotLens {
  static properties = { ...PlotLens.properties, settings: { attribute: false }, said: { state: true } };

  /** The roots, and the way they have come. */
  walk = new RootsWalk();
  /** @type {Map<string, import('./stability/views.js').View>} */ #made = new Map();

  constructor() {
    super();
    /** What each lens shows, by its name, and what its views keep besides. @type {Readonly<Record<string, string>>} */
    this.settings = {};
    /** What has just happened, for those who do not see it. */ this.said = '';
  }

  get views() {
    return viewNames;
  }

  /** @param {string} name @param {Voice} voice */
  nameOfView(name, voice) {
    return voice.say(/** @type {import('../words/voice.js').Key} */ (`stability.view.${name}`));
  }

  get fits() {
    return !withoutScale.includes(this.view);
  }

  /** Whether linear theory speaks of a swing inside the gap alone. */
  get isGapped() {
    return this.scene?.linear.isGapped ?? false;
  }

  /** What of this gear linear theory leaves out. */
  get leavesOut() {
    return this.scene?.linear.leavesOut ?? null;
  }

  /** A parameter of this gear. @param {string} name */
  quantity(name) {
    return this.quantities.find((one) => one.name === name);
  }

  /** The view in force, made when it is first looked at. */
  get #shown() {
    const { view } = this;
    const made = this.#made.get(view) ?? new stabilityViews[/** @type {typeof viewNames[number]} */ (view)](this);
    this.#made.set(view, made);
    return made;
  }

  /** @param {Voice} voice */
  line(voice) {
    return this.quantities.length > 1 ? this.#shown.line(voice) : '';
  }

  /** @param {Voice} voice */
  plot(voice) {
    if (this.quantities.length < 2) return '';
    return html`
      <div class="stability" data-view=${this.view}>
        ${this.#shown.template(voice)}
        <p class="only-heard" role="status">${this.isVeiled ? '' : this.said}</p>
      </div>`;
  }

  /** What stays true however far the walk goes on, so without a number. @param {readonly import('../view/root-paths.js').Root[]} roots @param {Voice} voice */
  #becomes(roots, voice) {
    return inTheory(voice.say(isStable(roots) ? 'roots.falls' : 'roots.grows'), this.leavesOut, voice);
  }

  /** @param {Map<string, unknown>} changed */
  updated(changed) {
    if ([...changed.keys()].every((name) => unseen.includes(name))) return;
    this.#shown.stale();
    if (this.scene && this.theme) this.draw(this.scene, this.theme);
  }

  /** @param {Scene} scene @param {Theme} theme */
  draw(scene, theme) {
    const left = this.leavesOut;
    this.scene = scene;
    this.theme = theme;
    const { voice } = this;
    const followed = this.walk.follow(scene, performance.now() / 1000);
    const { crossing, roots } = this.walk;
    if (followed === 'crossed' && crossing && voice)
      this.said = voice.say('roots.said', { crossing: crossingInWords(crossing, voice), what: this.#becomes(roots, voice) });
    else if (followed === 'changed' && !crossing) this.said = '';
    if (left !== this.leavesOut) this.requestUpdate();
    if (this.quantities.length > 1) this.#shown.draw(scene);
  }
}

customElements.define('shimmy-stability-lens', StabilityLens);
