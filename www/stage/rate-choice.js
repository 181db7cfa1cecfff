import { LitElement, html } from 'lit';
import { tell } from '../command.js';
import { isShownTruly, paceAt, slowRates } from '../run/rate.js';

/**
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('../words/voice.js').Key} Key
 * @typedef {import('../run/clock.js').Mode} Mode
 */

/**
 * How fast time goes, slow, strobe or real, and beside it in words what that makes of a second. Slow, where it is chosen,
 * opens the list of rates. Tells `rate`.
 */
export class RateChoice extends LitElement {
  static properties = {
    voice: { attribute: false },
    isStill: { attribute: false },
    mode: { attribute: false },
    slow: { attribute: false },
    isChosen: { attribute: false },
    frequency: { attribute: false },
    beat: { attribute: false },
    isExplaining: { state: true },
  };

  /** Whether the press that chose Slow has the focus to pass on to its list. */ #passesFocus = false;

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    this.isStill = false;
    /** @type {Mode} */ this.mode = 'slow';
    this.slow = 50;
    this.isChosen = false;
    /** @type {number | null} */ this.frequency = null;
    /** @type {number | null} */ this.beat = null;
    /** Whether it says why only slow is to be had. */
    this.isExplaining = false;
  }

  createRenderRoot() {
    return this;
  }

  render() {
    const { voice } = this;
    if (!voice) return html``;
    return html`
      <div class="segments" role="group" aria-label=${voice.say('clock.rate')}>
        ${this.#slow(voice)}${this.#fast('strobe', voice)}${this.#fast('real', voice)}
      </div>
      <span class="scale" role="status">${this.#words(voice)}</span>`;
  }

  updated() {
    if (this.#passesFocus && this.mode === 'slow') this.querySelector('select')?.focus();
    this.#passesFocus = false;
  }

  /** @param {Voice} voice */
  #slow(voice) {
    const { slow, isChosen } = this;
    const name = voice.say('clock.slow', { slow });
    if (this.mode !== 'slow')
      return html`<button type="button" class="segment" aria-pressed="false" @click=${this.#backToSlow}>${name}</button>`;
    return html`
      <span class="segment slow" data-pressed>
        <span aria-hidden="true">${name}</span>
        <select aria-label=${voice.say('clock.rate')} title=${voice.say('clock.rate.does')} @change=${this.#chosen}>
          <option value="" ?selected=${!isChosen}>${voice.say('clock.auto')}</option>
          ${slowRates.map((rate) => html`<option value=${rate} ?selected=${isChosen && rate === slow}>${this.#rateInWords(rate, voice)}</option>`)}
        </select>
      </span>`;
  }

  /** @param {number} rate @param {Voice} voice */
  #rateInWords(rate, voice) {
    const { cycle, pace } = paceAt(rate, this.frequency);
    const name = voice.say('clock.slow', { slow: rate });
    if (pace === 'too-fast') return voice.say('clock.rate.too-fast', { rate: name });
    return cycle === null ? name : voice.say(`clock.rate.${pace}`, { rate: name, cycle: voice.number(cycle, cycle < 0.95 ? 2 : 1) });
  }

  /** @param {'strobe' | 'real'} mode @param {Voice} voice */
  #fast(mode, voice) {
    const { isStill } = this;
    return html`<button type="button" class="segment ${mode}" aria-pressed=${this.mode === mode} aria-disabled=${isStill}
      title=${voice.say(isStill ? 'clock.still' : `clock.${mode}.does`)} @click=${() => this.#choose(mode)}>${voice.say(`clock.${mode}`)}</button>`;
  }

  /** What a second here is there: in full, and in short where there is little room. @param {Voice} voice */
  #words(voice) {
    const { mode, frequency } = this;
    const both = (/** @type {Key} */ key, /** @type {Record<string, string>} */ values = {}) => html`
      <span class="long">${voice.say(key, values)}</span><span class="short">${voice.say(/** @type {Key} */ (`${key}.short`), values)}</span>`;
    if (this.isStill && this.isExplaining) return both('clock.still');
    if (mode === 'strobe') return both(this.beat ? 'clock.flash' : 'clock.noBeat');
    const slow = mode === 'real' ? 1 : this.slow;
    return isShownTruly(slow, frequency) ? both('clock.scale', { time: duration(1 / slow, voice) }) : both('clock.tooFast');
  }

  /** @param {Mode} mode */
  #choose(mode) {
    if (this.isStill) this.isExplaining = true;
    else tell(this, 'rate', { mode });
  }

  #backToSlow() {
    this.#passesFocus = true;
    tell(this, 'rate', { mode: 'slow' });
  }

  /** @param {Event} event */
  #chosen(event) {
    this.isExplaining = false;
    const { value } = /** @type {HTMLSelectElement} */ (event.target);
    tell(this, 'rate', { mode: 'slow', slow: value === '' ? null : Number(value) });
  }
}

/** @param {number} seconds @param {Voice} voice */
function duration(seconds, voice) {
  // A number and its unit stay on one line.
  return seconds >= 1 ? `${voice.number(seconds, 0)}\u00a0s` : `${voice.number(seconds * 1000, 0)}\u00a0ms`;
}

customElements.define('shimmy-rate', RateChoice);
