/**
 * What sets a pinned run apart from the live one: "c = 60", "v = 60 m/s, ψfp = 0.5°". Empty where nothing does.
 *
 * @typedef {import('../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../words/voice.js').Voice} Voice
 */

import { withUnit } from '../controls/quantity.js';
import { decimalsOf } from '../words/number.js';

/** A label has room for so many values; the rest are dots. */
const most = 2;
/** A unit longer than this is left to the dock. */
const longestUnit = 3;

/**
 * @param {Readonly<Record<string, number>>} values of the pinned run, in SI
 * @param {Readonly<Record<string, number>>} others of the live one
 * @param {readonly Quantity[]} quantities
 * @param {Voice} voice
 */
export function ghostLabel(values, others, quantities, voice) {
  const different = quantities.filter(({ name }) => values[name] !== others[name]);
  const words = different.slice(0, most).map((quantity) => {
    const value = quantity.toShown(values[quantity.name]);
    const number = voice.number(value, decimalsOf(value, 0));
    const unit = quantity.unit.length <= longestUnit ? quantity.unit : '';
    return `${quantity.parameter.symbol.replace('_', '')} = ${withUnit(number, unit)}`;
  });
  return [...words, ...(different.length > most ? ['…'] : [])].join(', ');
}

/**
 * What tells which mode a ghost is: "mode 53.8 Hz".
 * @param {import('../run/linear-looks.js').Mode} mode
 * @param {import('../run/linear-looks.js').LeftOut} leavesOut what linear theory does not speak of
 * @param {Voice} voice
 */
export function modeLabel({ eigenvalue: { re, im } }, leavesOut, voice) {
  const what = im > 0 ? voice.say('modes.ghost', { frequency: voice.number(im / (2 * Math.PI), 1) }) : voice.say('modes.ghost.real', { rate: voice.number(re, 1) });
  return leavesOut ? voice.say(`stability.linear.${leavesOut}`, { what }) : what;
}
