import { html } from 'lit';
import { nameOf } from '../../controls/quantity.js';
import { explain } from '../../controls/refusal.js';
import { writeRange } from './settings.js';

/**
 * Where the range of a parameter begins and ends, to be typed. What is no end is kept in its field, and why it is none stands
 * beneath, as long as the range is the one it was typed for.
 *
 * @typedef {import('../../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../../run/linear-looks.js').Range} Range
 * @typedef {import('../../words/voice.js').Voice} Voice
 */
export class RangeFields {
  #lens;
  #id;
  /** @type {{ of: string, end: 'from' | 'to', text: string, why: string } | null} */ #refused = null;

  /** @param {Pick<import('../stability.js').StabilityLens, 'quantity' | 'scene' | 'requestUpdate'>} lens @param {string} id of the fields, one of their own on the page */
  constructor(lens, id) {
    this.#lens = lens;
    this.#id = id;
  }

  /** The two fields. @param {Range} range @param {(range: Range) => void} choose @param {Voice} voice */
  fields(range, choose, voice) {
    const quantity = this.#lens.quantity(range.parameter);
    return html`<span class="range">${this.#field('from', range, choose, voice)} … ${this.#field('to', range, choose, voice)} <span class="unit">${quantity?.unit}</span></span>`;
  }

  /** Why what was typed is not taken. @param {Range} range */
  why(range) {
    const refused = this.#refusedOf(range);
    return html`<p class="why-refused" id=${`${this.#id}-why`} role="alert">${refused ? html`<span aria-hidden="true">⚠ </span>${refused.why}` : ''}</p>`;
  }

  /** @param {'from' | 'to'} end @param {Range} range @param {(range: Range) => void} choose @param {Voice} voice */
  #field(end, range, choose, voice) {
    const quantity = this.#lens.quantity(range.parameter);
    if (!quantity) return '';
    const refused = this.#refusedOf(range);
    const isRefused = refused?.end === end;
    const name = voice.say('range.end', { name: nameOf(quantity, voice), end: voice.say(`range.${end}`) });
    return html`
      <input type="text" inputmode="decimal" class="number" aria-label=${name} title=${name} .value=${isRefused ? refused.text : quantity.number(range[end], voice)}
        aria-invalid=${isRefused ? 'true' : 'false'} aria-describedby=${`${this.#id}-why`}
        @change=${(/** @type {Event} */ event) => {
          const { value: text } = /** @type {HTMLInputElement} */ (event.target);
          const next = { ...range, [end]: quantity.toSI(quantity.read(text)) };
          const why = this.#whyNot(quantity, end, next, range, voice);
          this.#refused = why ? { of: writeRange(range), end, text, why } : null;
          this.#lens.requestUpdate();
          if (!why) choose(next);
        }} />`;
  }

  /** Why a value is no end, in words; '' where it is one. @param {Quantity} quantity @param {'from' | 'to'} end @param {Range} next @param {Range} range @param {Voice} voice */
  #whyNot(quantity, end, next, range, voice) {
    const value = next[end];
    const refusal = Number.isNaN(value) ? { code: 'not-a-number' } : !Number.isFinite(value) ? { code: 'too-large' } : this.#check(quantity.name, value);
    if (refusal) return explain(refusal, quantity, nameOf(quantity, voice), range[end], voice);
    return next.from < next.to ? '' : voice.say('range.refused.order');
  }

  /** What the engine says of a value. @param {string} parameter @param {number} value in SI */
  #check(parameter, value) {
    try {
      this.#lens.scene?.linear.eigenvalues({ [parameter]: value });
      return null;
    } catch (error) {
      return /** @type {import('../../controls/refusal.js').Refusal} */ (error);
    }
  }

  /** @param {Range} range */
  #refusedOf(range) {
    return this.#refused?.of === writeRange(range) ? this.#refused : null;
  }
}
