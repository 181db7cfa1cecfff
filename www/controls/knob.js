import { LitElement, html, nothing } from 'lit';
import { tell } from '../command.js';
import { chainsOf } from './chains.js';
import { nameOf } from './quantity.js';
import { explain } from './refusal.js';
import { scentOf } from './scent.js';
import { livesBeyond, sparklineOf, swingsInWords } from './sparkline.js';
import { symbolOf } from './symbol.js';
import { labelsOf, trackOf } from './track.js';
import { isVelocityUnit, nextVelocityUnit } from './unit.js';

/**
 * @typedef {import('./quantity.js').Quantity} Quantity
 * @typedef {import('./refusal.js').Refusal} Refusal
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {(name: string, value: number, gesture: string) => Refusal | null} Change
 */

/** The slider's own scale is 0 … `places`; a native range needs whole steps to reach its ends. */
const places = 1000;

/**
 * One parameter: symbol, name, exact number, unit, reset, and below them the slider, whose track tells where the gear
 * shimmies. Made from the parameter's line in the engine's table. A value that the engine refuses is explained beneath;
 * the run keeps the last good one.
 *
 * Commands: `settle` at the end of a gesture; `explain` with the parameter's name; `velocityUnit`; `toggleLink`.
 */
export class Knob extends LitElement {
  static properties = {
    quantity: { attribute: false },
    value: { attribute: false },
    usual: { attribute: false },
    unstable: { attribute: false },
    swings: { attribute: false },
    links: { attribute: false },
    isExplained: { attribute: false },
    voice: { attribute: false },
    refusal: { state: true },
    track: { state: true },
  };

  /** Told of the track's width, so that drawing asks for no layout. */
  #observer = new ResizeObserver(([{ target, contentRect }]) => {
    this.track = { width: contentRect.width, size: parseFloat(getComputedStyle(target).fontSize) };
  });

  constructor() {
    super();
    /** @type {Quantity | null} */ this.quantity = null;
    /** @type {Voice | null} */ this.voice = null;
    /** The value in force, in SI. */
    this.value = 0;
    /** The value that "reset" brings back, in SI. */
    this.usual = 0;
    /** Where the gear is unstable along the slider; null where nothing is to be said of it. @type {import('./scent.js').Unstable | null} */
    this.unstable = null;
    /** How widely it swings along the slider; null where that is not known. @type {import('../run/swing-scent.js').Swings | null} */
    this.swings = null;
    /** Which values follow others. @type {import('../run/links.js').Links} */ this.links = {};
    /** Whether it is explained just now. */
    this.isExplained = false;
    /** @type {Refusal | null} */ this.refusal = null;
    this.track = { width: 0, size: 0 };
    /** @type {Change} */ this.change = () => null;
  }

  createRenderRoot() {
    return this;
  }

  disconnectedCallback() {
    this.#observer.disconnect();
    super.disconnectedCallback();
  }

  /** @param {Map<string, unknown>} changed */
  willUpdate(changed) {
    // A value that came from elsewhere (undo, a moved time, the slider) ends the complaint about one that did not; so does
    // another unit.
    if (['value', 'quantity'].some((name) => changed.has(name) && changed.get(name) !== undefined)) this.refusal = null;
  }

  render() {
    const { quantity, voice, unstable, swings } = this;
    if (!quantity || !voice) return html``;
    const name = nameOf(quantity, voice);
    const id = `knob-${quantity.name}-${this.dataset.place}`;
    const reset = voice.say('knob.reset', { name, value: quantity.write(this.usual, voice) });
    const isOnlySmall = unstable !== null && livesBeyond(swings, unstable.intervals, quantity);
    const scent = unstable && scentOf(isOnlySmall ? { ...unstable, isOnlySmall } : unstable, quantity, voice);
    const foretold = [scent?.inWords ?? '', swingsInWords(swings, quantity, voice)].filter((words) => words !== '').join('. ');
    return html`
      <div class="knob-line">
        <button type="button" class="name" title=${voice.say('knob.explain', { name })} aria-haspopup="dialog"
          aria-expanded=${this.isExplained ? 'true' : 'false'} @click=${() => tell(this, 'explain', quantity.name)}>
          ${symbolOf(quantity.parameter.symbol)} <span>${name}</span></button>
        <input id=${id} class="number" type="text" inputmode="decimal" autocomplete="off" spellcheck="false"
          aria-label=${voice.say('knob.number', { name })} aria-invalid=${this.refusal ? 'true' : 'false'}
          aria-describedby="${id}-refusal" .value=${quantity.number(this.value, voice)}
          @change=${this.#typed} @keydown=${this.#numberKey} @focus=${selectAll} />
        ${this.#unit(quantity, name, voice)}
        <button type="button" class="reset" title=${reset} aria-label=${reset} ?disabled=${this.value === this.usual}
          @click=${() => this.#set(this.usual)}>↺</button>
      </div>
      ${chainsOf(quantity.name, this.links, voice)}
      <div class="slide" title=${swings ? voice.say('spark.does') : nothing}>
        ${sparklineOf(swings, quantity)}
        ${trackOf(scent)}
        <input id="${id}-slider" class="slider" type="range" min="0" max=${places} step="1" aria-label=${name}
          aria-valuetext=${quantity.write(this.value, voice)} aria-description=${foretold || nothing}
          .value=${String(quantity.placeOf(this.value) * places)}
          @input=${this.#dragged} @change=${this.#settle} @keydown=${this.#sliderKey} />
      </div>
      ${labelsOf(scent, this.track)}
      <p id="${id}-refusal" class="refusal ${this.refusal ? 'refused' : 'noted'}" role="alert">${this.#complaint(quantity, name, voice)}</p>`;
  }

  updated() {
    const track = this.querySelector('.track');
    if (track) this.#observer.observe(track);
  }

  /** The unit; that of a speed can be chosen. @param {Quantity} quantity @param {string} name @param {Voice} voice */
  #unit({ unit }, name, voice) {
    if (!isVelocityUnit(unit)) return html`<span class="unit">${unit}</span>`;
    const next = nextVelocityUnit(unit);
    const title = voice.say('knob.unit', { name, unit, next });
    return html`<button type="button" class="unit" title=${title} aria-label=${title} @click=${() => tell(this, 'velocityUnit', next)}>${unit}</button>`;
  }

  /** @param {Quantity} quantity @param {string} name @param {Voice} voice */
  #complaint(quantity, name, voice) {
    if (this.refusal) return explain(this.refusal, quantity, name, this.value, voice);
    if (!quantity.isFar(this.value)) return '';
    return voice.say('knob.far', { min: quantity.number(quantity.toSI(quantity.min), voice), max: quantity.write(quantity.toSI(quantity.max), voice) });
  }

  /** @param {Event} event */
  #dragged(event) {
    if (!this.quantity) return;
    const place = Number(/** @type {HTMLInputElement} */ (event.target).value) / places;
    this.#set(this.quantity.valueAt(place), 'drag');
  }

  /** @param {Event} event */
  #typed(event) {
    const { quantity, voice } = this;
    if (!quantity || !voice) return;
    const field = /** @type {HTMLInputElement} */ (event.target);
    const shown = quantity.read(field.value);
    if (Number.isNaN(shown)) {
      this.refusal = { code: 'not-a-number' };
      return;
    }
    if (!Number.isFinite(shown)) {
      this.refusal = { code: 'too-large' };
      return;
    }
    // What stands there already is no new value, however it is written: it would lose the digits that are not shown.
    if (shown !== quantity.read(quantity.number(this.value, voice))) this.#set(quantity.toSI(shown));
    else this.refusal = null;
    if (!this.refusal) field.value = quantity.number(quantity.toSI(shown), voice);
  }

  /** @param {KeyboardEvent} event */
  #numberKey(event) {
    if (event.key === 'Escape') {
      this.refusal = null;
      const field = /** @type {HTMLInputElement} */ (event.target);
      if (this.quantity && this.voice) field.value = this.quantity.number(this.value, this.voice);
    }
    this.#arrow(event, { ArrowUp: 1, ArrowDown: -1 });
  }

  /** @param {KeyboardEvent} event */
  #sliderKey(event) {
    this.#arrow(event, { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 });
  }

  /** @param {KeyboardEvent} event @param {Record<string, number>} keys how many steps each key is */
  #arrow(event, keys) {
    const steps = keys[event.key];
    if (!steps || !this.quantity) return;
    event.preventDefault();
    this.#set(this.quantity.stepped(this.value, steps * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1)), 'keys');
  }

  /**
   * @param {number} value in SI
   * @param {string} [gesture] a single change settles at once
   */
  #set(value, gesture) {
    if (!this.quantity) return;
    this.refusal = this.change(this.quantity.name, value, gesture ? `${this.quantity.name} ${gesture}` : '');
    if (gesture !== 'drag') this.#settle();
    this.requestUpdate();
  }

  #settle() {
    tell(this, 'settle');
  }
}

/** @param {Event} event */
function selectAll(event) {
  /** @type {HTMLInputElement} */ (event.target).select();
}

customElements.define('shimmy-knob', Knob);
