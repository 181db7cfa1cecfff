import { nameOf } from '../controls/quantity.js';

/**
 * @typedef {import('../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/**
 * The values of a run in one line: speed and damping, then what differs from the usual gear.
 * @param {Quantity[]} quantities
 * @param {Readonly<Record<string, number>>} parameters
 * @param {Voice} voice
 */
export function valuesLine(quantities, parameters, voice) {
  const always = ['velocity', 'dampingConstant'];
  const differs = (/** @type {Quantity} */ { name, parameter }) => parameters[name] !== undefined && parameters[name] !== parameter.default;
  const told = [
    ...quantities.filter(({ name }) => always.includes(name)),
    ...quantities.filter((quantity) => !always.includes(quantity.name) && differs(quantity)),
  ];
  // A value and its unit stay on one line.
  return told.map((quantity) => `${nameOf(quantity, voice)} ${quantity.write(parameters[quantity.name] ?? quantity.parameter.default, voice)}`.replaceAll(' ', '\u00a0')).join(' · ');
}
