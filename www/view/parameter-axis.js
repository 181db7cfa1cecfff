import { nameOf } from '../controls/quantity.js';
import { axisOf } from './axes.js';

/**
 * An axis along which a parameter of the gear varies, in the unit that the page shows it in.
 *
 * @typedef {import('../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('./text.js').Run} Run
 */

/** Numbers from here on are told in thousands, or they would not fit beside the axis. */
const large = 10_000;

/**
 * @param {Quantity} quantity
 * @param {[number, number]} domain its ends in SI units
 * @param {[number, number]} range their places
 * @param {number} most marks
 * @param {Voice} voice
 * @returns {import('./axes.js').Axis}
 */
export function parameterAxis(quantity, domain, range, most, voice) {
  const isLarge = Math.max(...domain.map((end) => Math.abs(quantity.toShown(end)))) >= large && quantity.unit.startsWith('N');
  const unit = isLarge ? `k${quantity.unit}` : quantity.unit;
  const perSI = quantity.toShown(1) / (isLarge ? 1000 : 1);
  const [symbol, sub] = quantity.parameter.symbol.split('_');
  const axis = axisOf({ symbol, sub, word: 'parameter.velocity', unit, perSI, color: 'psi' }, domain, range, most, voice);
  const word = nameOf(quantity, voice).toLocaleLowerCase(voice.language);
  const rest = unit === '' || unit === '°' ? [] : [unit];
  return { ...axis, name: (isShort) => [{ symbol, sub }, { text: isShort ? ` ${rest.join('')}` : ` ${[word, ...rest].join(', ')}` }] };
}
