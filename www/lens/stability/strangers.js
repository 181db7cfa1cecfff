import { html, nothing } from 'lit';
import { plainSymbol } from './say.js';

/**
 * A figure or a table of the thesis with a gear that is not the thesis': which values are others, and a way to set them.
 *
 * @typedef {import('../../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

/**
 * What is other than in the thesis, besides what the figure varies itself.
 * @param {readonly Quantity[]} quantities @param {Readonly<Record<string, number>> | undefined} values of the gear @param {readonly string[]} varied
 */
export function strangersOf(quantities, values, varied) {
  return quantities.filter(({ name, parameter }) => !varied.includes(name) && values?.[name] !== parameter.default);
}

/**
 * @param {readonly Quantity[]} others @param {boolean} isSlack whether the stiffness that is varied does nothing
 * @param {(values: Record<string, number>) => void} put @param {Voice} voice
 */
export function strangersNote(others, isSlack, put, voice) {
  if (others.length === 0) return nothing;
  const values = Object.fromEntries(others.map(({ name, parameter }) => [name, parameter.default]));
  return html`
    <p class="table-out strangers">
      <span>${voice.say('beside.strangers', { symbols: others.map(plainSymbol).join(', ') })}${isSlack ? ` ${voice.say('beside.slack')}` : ''}</span>
      <button type="button" class="framed" @click=${() => put(values)}>${voice.say('beside.strangers.set')}</button>
    </p>`;
}
