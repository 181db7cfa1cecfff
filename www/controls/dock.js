import { LitElement, html } from 'lit';
import { tell } from '../command.js';
import './knob.js';
import { nameOf } from './quantity.js';
import { symbolOf } from './symbol.js';

/**
 * @typedef {import('./quantity.js').Quantity} Quantity
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/** The knobs that are at hand where no story chooses others, the most telling first. An object that lacks one has the next. */
export const usualKnobs = ['velocity', 'damper.command', 'dampingConstant', 'casterLength', 'freeplayAngle', 'torsionalStiffness'];
const mostKnobs = 4;
/** A projector shows few things, and those large: where a gear has had a gap, that and what cures it. */
const mostOnProjector = 2;
const knobsOfGap = ['freeplayAngle', 'dampingConstant'];

/** Numbers from here on need a wider field. */
const widest = 1e5;

const oneAtATime = matchMedia('(max-width: 999px), (max-width: 1099px) and (max-height: 639px)');
const projector = matchMedia('(min-width: 1000px) and (max-width: 1099px) and (min-height: 640px)');

/**
 * The knobs under the stage. On a phone one large slider, and chips that choose which value it sets.
 * Commands: `drawer`, `resetAll`, and those of its knobs.
 */
export class Dock extends LitElement {
  static properties = {
    quantities: { attribute: false },
    values: { attribute: false },
    links: { attribute: false },
    usual: { attribute: false },
    knobs: { attribute: false },
    unstable: { attribute: false },
    swings: { attribute: false },
    explained: { attribute: false },
    voice: { attribute: false },
    isVeiled: { attribute: false },
    isOpen: { attribute: false },
    chosen: { state: true },
  };

  /** Whether the gear has had a gap since it, or the story, was chosen. */ #hasHadGap = false;

  constructor() {
    super();
    /** @type {Quantity[]} */ this.quantities = [];
    /** @type {Readonly<Record<string, number>>} */ this.values = {};
    /** Which values follow others. @type {Readonly<Record<string, boolean>>} */ this.links = {};
    /** @type {Readonly<Record<string, number>>} */ this.usual = {};
    /** The knobs that a story is about, before the usual ones. @type {readonly string[]} */ this.knobs = [];
    /** Where the gear is unstable as one value varies. @type {(name: string) => import('./scent.js').Unstable | null} */
    this.unstable = () => null;
    /** How widely the gear swings as one value varies. @type {(name: string) => import('../run/swing-scent.js').Swings | null} */
    this.swings = () => null;
    /** The parameter that is explained just now. @type {string | null} */ this.explained = null;
    /** @type {Voice | null} */ this.voice = null;
    /** Whether what would tell the future is hidden. */
    this.isVeiled = false;
    /** Whether the drawer with all values is open. */
    this.isOpen = false;
    /** @type {import('./knob.js').Change} */ this.change = () => null;
    /** The one that a phone shows; null for the story's choice. @type {string | null} */ this.chosen = null;
  }

  createRenderRoot() {
    return this;
  }

  connectedCallback() {
    super.connectedCallback();
    for (const layout of [oneAtATime, projector]) layout.addEventListener('change', this.#relaid);
  }

  disconnectedCallback() {
    for (const layout of [oneAtATime, projector]) layout.removeEventListener('change', this.#relaid);
    super.disconnectedCallback();
  }

  /** @param {Map<string, unknown>} changed */
  willUpdate(changed) {
    if (changed.has('knobs')) this.chosen = null;
    // Which stays so when a hand closes the gap, or its knob would go from under the hand.
    if (changed.has('knobs') || changed.has('quantities')) this.#hasHadGap = false;
    if ((this.values.freeplayAngle ?? 0) > 0) this.#hasHadGap = true;
  }

  render() {
    const { voice, values } = this;
    if (!voice) return html``;
    const atHand = this.#atHand;
    const chosen = this.#chosenOf(atHand);
    const shown = oneAtATime.matches ? atHand.filter(({ name }) => name === chosen) : atHand.slice(0, projector.matches ? mostOnProjector : mostKnobs);
    const count = this.quantities.length;
    const isOpen = this.isOpen ? 'true' : 'false';
    return html`
      <div class="chips" role="group" aria-label=${voice.say('dock.choose')}>
        ${atHand.map((quantity) => html`
          <button type="button" aria-pressed=${chosen === quantity.name ? 'true' : 'false'}
            @click=${() => { this.chosen = quantity.name; }}>
            <span class="only-heard">${nameOf(quantity, voice)}</span> ${symbolOf(quantity.parameter.symbol)} ${short(values[quantity.name], quantity, voice)}
          </button>`)}
        <button type="button" aria-expanded=${isOpen} @click=${() => tell(this, 'drawer')}>${voice.say('dock.all.short', { count })}</button>
      </div>
      ${shown.map((quantity) => this.#knob(quantity, voice))}
      <div class="dock-more">
        <button type="button" class="framed" aria-expanded=${isOpen} @click=${() => tell(this, 'drawer')}>
          ${voice.say('dock.all', { count })} ${this.isOpen ? '▾' : '▴'}
        </button>
        <button type="button" class="plain" @click=${() => tell(this, 'resetAll')}>↺ ${voice.say('dock.reset')}</button>
      </div>`;
  }

  /** The knobs that the dock may show: the story's, then the usual ones, as far as the object has them. */
  get #atHand() {
    const ofGap = projector.matches && this.#hasHadGap && this.knobs.length === 0 ? knobsOfGap : [];
    const names = [...new Set([...this.knobs, ...ofGap, ...usualKnobs])];
    return names.flatMap((name) => this.quantities.filter((quantity) => quantity.name === name)).slice(0, mostKnobs);
  }

  /** Which one a phone shows: the one that was pressed, else the story's, else the damping, which is the cure. @param {Quantity[]} atHand */
  #chosenOf(atHand) {
    const wishes = [this.chosen, this.knobs[0], 'dampingConstant', atHand[0]?.name];
    return wishes.find((wish) => atHand.some(({ name }) => name === wish)) ?? null;
  }

  /** @param {Quantity} quantity @param {Voice} voice */
  #knob(quantity, voice) {
    const { name } = quantity;
    return html`
      <shimmy-knob data-place="dock" data-name=${name} ?data-wide=${quantity.max >= widest}
        .quantity=${quantity} .value=${this.values[name]} .usual=${this.usual[name]} .links=${this.links} .voice=${voice}
        .unstable=${this.isVeiled ? null : this.unstable(name)} .swings=${this.isVeiled ? null : this.swings(name)} .isExplained=${this.explained === name} .change=${this.change}></shimmy-knob>`;
  }

  #relaid = () => this.requestUpdate();
}

/**
 * A value short enough for a chip.
 * @param {number} value @param {Quantity} quantity @param {Voice} voice
 */
function short(value, quantity, voice) {
  const shown = Number(quantity.toShown(value).toPrecision(3));
  const decimals = (String(shown).split('.')[1] ?? '').length;
  return voice.number(shown, decimals) + (quantity.unit === '°' ? '°' : '');
}

customElements.define('shimmy-dock', Dock);
