import { nameOf, Quantity } from '../../../controls/quantity.js';
import { decimalsFor } from '../../../words/number.js';

/** @typedef {import('../../../words/voice.js').Voice} Voice */

/** A value in so few digits that a column of them can be read. @param {number} value @param {Voice} voice */
export function writeValue(value, voice) {
  const size = Math.abs(value);
  if (value !== 0 && (size >= 1e5 || size < 1e-3)) return voice.power(Number(value.toPrecision(3)));
  return voice.number(value, Math.min(4, value === 0 ? 0 : decimalsFor(value, 3)));
}

/** A parameter of a damper in words: it is called as it is on a gear. @param {import('../../../controls/quantity.js').Parameter} parameter @param {Voice} voice */
export const parameterName = (parameter, voice) => nameOf(new Quantity({ ...parameter, name: `damper.parameters.${parameter.name}` }), voice).replace('damper.parameters.', '');

/** A symbol of a table as a drawing writes it. @param {string} symbol @returns {import('../../../view/text.js').Run[]} */
export function symbolRuns(symbol) {
  const [letter, sub] = symbol.split('_');
  return [{ symbol: letter, sub }];
}

/** 0 for the least error to 1 for the greatest. @param {Float64Array} errors */
export function ranksOf(errors) {
  const order = Array.from(errors, (_, i) => i).sort((one, other) => errors[one] - errors[other]);
  const ranks = new Float64Array(errors.length);
  order.forEach((individual, place) => { ranks[individual] = place / Math.max(1, errors.length - 1); });
  return ranks;
}
