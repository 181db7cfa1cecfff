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
export const usualKnobs = ['velocity', 'dampingConstant', 'casterLength', 'freeplayAngle', 'torsionalStiffness'];
const mostKnobs = 4;

/**
 * The knobs under the stage. On a phone one large slider, and chips that choose which value it sets.
 * Commands: `drawer`, `resetAll`.
 */
export class Dock extends LitElement {
  static properties = {
    knobs: { attribute: false },
    quantities: { attribute: false },
    values: { attribute: false },
    links: { attribute: false },
    usual: { attribute: false },
    voice: { attribute: false },
    isVeiled: { attribute: false },
    isOpen: { attribute: false },
    chosen: { state: true },
  };

  constructor() {
    super();
    /** The knobs that a story is about, before the usual ones. @type {readonly string[]} */ this.knobs = [];
    /** @type {Quantity[]} */ this.quantities = [];
    /** @type {Readonly<Record<string, number>>} */ this.values = {};
    /** Which values follow others. @type {Readonly<Record<string, boolean>>} */ this.links = {};
    /** @type {Readonly<Record<string, number>>} */ this.usual = {};
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

  /** @param {Map<string, unknown>} changed */
  willUpdate(changed) {
    if (changed.has('knobs')) this.chosen = null;
  }

  render() {
    const { voice, quantities, values, usual } = this;
    if (!voice) return html``;
    const names = [...new Set([...this.knobs, ...usualKnobs])];
    const shown = names.flatMap((name) => quantities.filter((quantity) => quantity.name === name)).slice(0, mostKnobs);
    const chosen = this.chosen ?? this.knobs[0] ?? 'dampingConstant';
    const count = quantities.length;
    return html`
      <div class="chips" role="group" aria-label=${voice.say('dock.choose')}>
        ${shown.map((quantity) => html`
          <button type="button" aria-pressed=${chosen === quantity.name ? 'true' : 'false'}
            @click=${() => { this.chosen = quantity.name; }}>
            <span class="only-heard">${nameOf(quantity, voice)}</span> ${symbolOf(quantity.parameter.symbol)} ${short(values[quantity.name], quantity, voice)}
          </button>`)}
        <button type="button" aria-expanded=${this.isOpen ? 'true' : 'false'} @click=${() => tell(this, 'drawer')}>
          ${voice.say('dock.all.short', { count })}
        </button>
      </div>
      ${shown.map((quantity) => html`
        <shimmy-knob data-place="dock" data-name=${quantity.name} ?data-chosen=${chosen === quantity.name}
          .quantity=${quantity} .value=${values[quantity.name]} .usual=${usual[quantity.name]} .voice=${voice}
          .change=${this.change}></shimmy-knob>`)}
      <div class="dock-more">
        <button type="button" class="framed" aria-expanded=${this.isOpen ? 'true' : 'false'} @click=${() => tell(this, 'drawer')}>
          ${voice.say('dock.all', { count })} ${this.isOpen ? '▾' : '▴'}
        </button>
        <button type="button" class="plain" @click=${() => tell(this, 'resetAll')}>↺ ${voice.say('dock.reset')}</button>
      </div>`;
  }
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
