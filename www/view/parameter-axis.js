import { nameOf } from '../controls/quantity.js';
import { axisOf } from './axes.js';

/**
 * An axis along which a parameter of the gear varies, in the unit that the page shows it in.
 *
 * @typedef {import('../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('./text.js').Run} Run
 */

/**
 * @param {Quantity} quantity
 * @param {[number, number]} domain its ends in SI units
 * @param {[number, number]} range their places
 * @param {number} most marks
 * @param {Voice} voice
 * @returns {import('./axes.js').Axis}
 */
export function parameterAxis(quantity, domain, range, most, voice) {
  const { unit } = quantity;
  const [symbol, sub] = quantity.parameter.symbol.split('_');
  const axis = axisOf({ symbol, sub, word: 'parameter.velocity', unit, perSI: quantity.toShown(1), color: 'psi' }, domain, range, most, voice);
  const word = nameOf(quantity, voice).toLocaleLowerCase(voice.language);
  const rest = unit === '' || unit === '°' ? [] : [unit];
  return { ...axis, name: (isShort) => [{ symbol, sub }, { text: isShort ? ` ${rest.join('')}` : ` ${[word, ...rest].join(', ')}` }] };
}
