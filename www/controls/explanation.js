import { LitElement, html, nothing } from 'lit';
import { tell } from '../command.js';
import { docOf } from '../words/docs.js';
import { followed } from '../run/links.js';
import { equationsOf, legendOf, relationOf, symbolInMath } from './equations.js';
import { nameOf, withUnit } from './quantity.js';
import { symbolOf } from './symbol.js';

/**
 * @typedef {import('./quantity.js').Quantity} Quantity
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/**
 * What one parameter is: its meaning, its usual value, its slider's range, and the model's equations with its symbol lit.
 * It lies over the lens and never over the gear. A press elsewhere and Escape close it.
 *
 * Command: `explain` with null, to be closed.
 */
export class Explanation extends LitElement {
  static properties = {
    quantity: { attribute: false },
    model: { attribute: false },
    voice: { attribute: false },
  };

  /** What had the focus before. @type {Element | null} */ #from = null;

  constructor() {
    super();
    /** @type {Quantity | null} */ this.quantity = null;
    /** The model whose equations it shows, by its name in the engine's table. */ this.model = '';
    /** @type {Voice | null} */ this.voice = null;
    this.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      this.#close();
    });
  }

  createRenderRoot() {
    return this;
  }

  connectedCallback() {
    super.connectedCallback();
    this.#from = document.activeElement;
    document.addEventListener('pointerdown', this.#leave);
  }

  disconnectedCallback() {
    document.removeEventListener('pointerdown', this.#leave);
    super.disconnectedCallback();
  }

  render() {
    const { quantity, voice } = this;
    if (!quantity || !voice) return html``;
    const { name, symbol, default: usual } = quantity.parameter;
    const range = `${quantity.number(quantity.toSI(quantity.min), voice)} … ${withUnit(quantity.number(quantity.toSI(quantity.max), voice), quantity.unit)}`;
    const relations = Object.keys(followed).filter((follower) => follower === name || followed[follower].includes(name));
    return html`
      <header>
        <h2 id="explanation-name">${symbolOf(symbol)} ${nameOf(quantity, voice)}</h2>
        <button type="button" class="framed" @click=${this.#close}>${voice.say('dock.close')}</button>
      </header>
      <div class="explanation-text" tabindex="0" role="group" aria-labelledby="explanation-name">
        <p>${docOf(quantity.parameter, voice.language)}</p>
        <dl class="explanation-values">
          <div><dt>${voice.say('explanation.usual')}</dt><dd>${quantity.write(usual, voice)}</dd></div>
          <div><dt>${voice.say('explanation.range')}</dt><dd>${range}</dd></div>
          ${relations.length > 0 ? html`
            <div><dt>${voice.say('explanation.linked')}</dt><dd>${relations.map((follower) => relationOf(follower, symbol, voice))}</dd></div>` : nothing}
        </dl>
        <ul class="equations" aria-label=${voice.say('explanation.equations')}>
          ${equationsOf(this.model, symbol, voice).map((equation) => html`<li>${equation}</li>`)}
        </ul>
        <dl class="legend">
          ${legendOf(this.model).map((entry) => html`<div><dt>${symbolInMath(entry.symbol)}</dt><dd>${voice.say(entry.word)}</dd></div>`)}
        </dl>
      </div>`;
  }

  firstUpdated() {
    this.querySelector('button')?.focus();
  }

  /** Closed from within, the focus goes back to where it came from. */
  #close() {
    const from = /** @type {HTMLElement | null} */ (this.#from);
    tell(this, 'explain', null);
    // What it came from may be hidden as long as this is open.
    requestAnimationFrame(() => from?.focus());
  }

  /** A press elsewhere closes it; a name's own press says what it opens. @param {PointerEvent} event */
  #leave = (event) => {
    const path = event.composedPath();
    if (path.includes(this) || path.some((place) => place instanceof Element && place.matches('.name'))) return;
    tell(this, 'explain', null);
  };
}

customElements.define('shimmy-explanation', Explanation);
