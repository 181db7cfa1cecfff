import { html } from 'lit';
import { Quantity } from '../../controls/quantity.js';
import { symbolOf } from '../../controls/symbol.js';
import { refusedIn, rollNames, rollParameters } from './settings.js';

/**
 * What makes the landing, to be typed or stepped by arrow keys. What cannot be is kept in its field, and why it cannot stands beneath.
 *
 * @typedef {import('./settings.js').RollValues} RollValues
 * @typedef {import('./settings.js').RollName} RollName
 * @typedef {import('../../words/voice.js').Voice} Voice
 */
export class RollFields {
  #host;
  /** @type {{ of: RollValues, name: RollName, text: string, why: string } | null} */ #refused = null;

  /** @param {{ requestUpdate: () => void, velocityUnit: import('../../controls/unit.js').VelocityUnit }} host */
  constructor(host) {
    this.#host = host;
  }

  /** @param {RollName} name */
  #quantity(name) {
    return new Quantity(rollParameters[name], this.#host.velocityUnit);
  }

  /** @param {RollValues} roll @param {(roll: RollValues) => void} choose @param {unknown} more that stands behind the fields @param {Voice} voice */
  template(roll, choose, more, voice) {
    const refused = this.#refused && rollNames.every((name) => this.#refused?.of[name] === roll[name]) ? this.#refused : null;
    return html`
      <div class="roll-head">
        <div class="roll-fields">${rollNames.map((name) => this.#field(name, roll, refused, choose, voice))}${more}</div>
        <p class="why-refused" id="roll-why" role="alert">${refused ? html`<span aria-hidden="true">⚠ </span>${refused.why}` : ''}</p>
      </div>`;
  }

  /** @param {RollName} name @param {RollValues} roll @param {{ name: RollName, text: string } | null} refused @param {(roll: RollValues) => void} choose @param {Voice} voice */
  #field(name, roll, refused, choose, voice) {
    const quantity = this.#quantity(name);
    const isRefused = refused?.name === name;
    const word = voice.say(`landing.${name}`);
    const take = (/** @type {number} */ value, /** @type {string} */ text) => {
      const next = { ...roll, [name]: value };
      const reason = Number.isFinite(value) ? refusedIn(next) : 'number';
      this.#refused = reason ? { of: roll, name, text, why: voice.say(`landing.refused.${reason}`) } : null;
      this.#host.requestUpdate();
      if (!reason) choose(next);
    };
    return html`
      <label class="roll-field" data-name=${name} title=${voice.say(`landing.${name}.does`)}>
        ${symbolOf(quantity.parameter.symbol)}<span class="word">${word}</span>
        <input type="text" inputmode="decimal" class="number" aria-label=${word} aria-description=${voice.say(`landing.${name}.does`)} aria-invalid=${isRefused ? 'true' : 'false'} aria-describedby="roll-why"
          .value=${isRefused ? refused.text : quantity.number(roll[name], voice)}
          @change=${(/** @type {Event} */ event) => {
            const { value: text } = /** @type {HTMLInputElement} */ (event.target);
            take(quantity.toSI(quantity.read(text)), text);
          }}
          @keydown=${(/** @type {KeyboardEvent} */ event) => {
            const steps = { ArrowUp: 1, ArrowDown: -1 }[event.key];
            if (!steps) return;
            event.preventDefault();
            const value = quantity.stepped(roll[name], steps * (event.shiftKey ? 10 : 1));
            take(value, quantity.number(value, voice));
          }} />
        <span class="unit">${quantity.unit}</span>
      </label>`;
  }
}
