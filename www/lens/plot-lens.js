import { LitElement, html } from 'lit';
import { tell } from '../command.js';
import '../view/canvas.js';
import { ghostLabel } from '../stage/ghost-label.js';
import { mannerOf } from '../stage/manner.js';
import { viewsOfLens } from './views.js';

/**
 * @typedef {import('../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {import('../run/scene.js').Scene} Scene
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../view/canvas.js').Size} Size
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/**
 * What lenses of one picture share: the canvas with its last scene, a line under it, "Fit", and where there are several
 * views of one thing a list of them. A lens says which views it has and paints the one that `shows` names.
 */
export class PlotLens extends LitElement {
  static properties = {
    voice: { attribute: false }, shows: { attribute: false }, isVeiled: { attribute: false }, quantities: { attribute: false },
    outlook: { attribute: false }, ghosts: { attribute: false },
  };

  /** @type {Scene | null} */ scene = null;
  /** @type {Theme | null} */ theme = null;

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    /** Which of its views, and what that needs to know besides. */ this.shows = '';
    /** Whether what would tell the future is hidden. */ this.isVeiled = false;
    /** @type {Quantity[]} */ this.quantities = [];
    /** @type {Outlook | null} */ this.outlook = null;
    /** @type {import('../run/ghosts.js').Ghost[]} */ this.ghosts = [];
  }

  createRenderRoot() {
    return this;
  }

  /** Names of its views, the first is the usual one. @type {readonly string[]} */
  get views() {
    return viewsOfLens[this.#name] ?? [];
  }

  /** As the list of lenses has it. */
  get #name() {
    return this.localName.replace(/^shimmy-|-lens$/g, '');
  }

  /** The view shown. */
  get view() {
    const [name] = this.shows.split(',');
    return this.views.includes(name) ? name : this.views[0];
  }

  /** Whether the view shown has a scale that holds, and can be fitted. */
  get fits() {
    return true;
  }

  /** A view in a word. @param {string} _name @param {Voice} _voice */
  nameOfView(_name, _voice) {
    return '';
  }

  /** What the picture is, for those who do not see it. @param {Voice} _voice */
  label(_voice) {
    return '';
  }

  /** The line under the picture. @param {Voice} _voice @returns {unknown} */
  line(_voice) {
    return '';
  }

  /** @param {CanvasRenderingContext2D} _context @param {Size} _size @param {Scene} _scene @param {Theme} _theme @param {Voice} _voice */
  paintScene(_context, _size, _scene, _theme, _voice) {}

  render() {
    const { voice } = this;
    if (!voice) return html``;
    return html`
      <div class="plot">${this.plot(voice)}</div>
      <footer>
        ${this.line(voice)}
        ${this.#choice(voice)}
        ${this.fits ? html`<button type="button" class="framed" title="${voice.say('phase.fit.does')} (0)" @click=${() => tell(this, 'fit')}>${voice.say('phase.fit')}</button>` : ''}
      </footer>`;
  }

  /** @param {Voice} voice @returns {unknown} */
  plot(voice) {
    return html`<shimmy-canvas .label=${this.label(voice)} .paint=${this.paint}></shimmy-canvas>`;
  }

  /** @param {Scene} scene @param {Theme} theme */
  draw(scene, theme) {
    this.scene = scene;
    this.theme = theme;
    this.canvas?.redraw();
  }

  /** @param {Map<string, unknown>} changed */
  updated(changed) {
    // What the engine sees ahead comes with a frame, which is drawn anyway.
    if (['voice', 'shows', 'isVeiled', 'quantities'].some((name) => changed.has(name))) this.canvas?.redraw();
  }

  get canvas() {
    return /** @type {import('../view/canvas.js').Canvas | null} */ (this.querySelector('shimmy-canvas'));
  }

  /** The ghosts of a portrait: each on the cycle it goes to, as far as that may be seen, else where it went. @param {Scene} scene @param {Voice} voice */
  ghostsOf(scene, voice) {
    return scene.ghosts.map((ghost) => ({
      label: this.labelOf(scene, ghost, voice),
      ...(ghost.outlook?.orbit.time.length && !this.isVeiled ? { orbit: ghost.outlook.orbit } : { trail: ghost.orbitPast }),
    }));
  }

  /** What sets a ghost apart, and what becomes of it. @param {Scene} scene @param {Scene['ghosts'][number]} ghost @param {Voice} voice */
  labelOf(scene, ghost, voice) {
    const apart = ghostLabel(ghost.parameters, scene.parameters, this.quantities, voice) || voice.say('compare.same');
    return ghost.outlook && !this.isVeiled ? `${apart} (${voice.say(`compare.${mannerOf(ghost.outlook)}`)})` : apart;
  }

  /** @type {import('../view/canvas.js').Paint} */
  paint = (context, size) => {
    const { voice, scene, theme } = this;
    if (voice && scene && theme) this.paintScene(context, size, scene, theme, voice);
  };

  /** @param {Voice} voice */
  #choice(voice) {
    const { views, view } = this;
    if (views.length < 2) return '';
    const lens = this.#name;
    return html`
      <select class="framed views" aria-label=${voice.say('lens.view')} .value=${view}
        @change=${(/** @type {Event} */ event) => tell(this, 'view', { of: lens, shows: /** @type {HTMLSelectElement} */ (event.target).value })}>
        ${views.map((name) => html`<option value=${name} ?selected=${name === view}>${this.nameOfView(name, voice)}</option>`)}
      </select>`;
  }
}
