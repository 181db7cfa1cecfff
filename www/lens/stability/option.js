import { html } from 'lit';
import { nameOf } from '../../controls/quantity.js';
import { plainSymbol } from './say.js';

/**
 * A parameter among those that one can choose.
 * @param {import('../../controls/quantity.js').Quantity} quantity
 * @param {string | undefined} selected name of the one that is chosen
 * @param {import('../../words/voice.js').Voice} voice
 */
export const parameterOption = (quantity, selected, voice) =>
  html`<option value=${quantity.name} ?selected=${quantity.name === selected}>${plainSymbol(quantity)} ${nameOf(quantity, voice)}</option>`;
