/**
 * Mathematics as MathML, piece by piece: what the typeset equations are put together from.
 *
 * @typedef {import('lit').TemplateResult<3>} Math a piece of MathML
 */

import { html, mathml } from 'lit';
import { decimalsFor } from '../words/number.js';

/** @param {Math} math */
export function typeset(math) {
  return html`<math displaystyle="true"><mrow>${math}</mrow></math>`;
}

/** @param {string} symbol `I_z` */
export function written(symbol) {
  const [letter, sub] = symbol.split('_');
  return sub ? mathml`<msub><mi>${letter}</mi><mi>${sub}</mi></msub>` : mathml`<mi>${letter}</mi>`;
}

/** @param {string} name of a function */
export function named(name) {
  return mathml`<mi class="upright">${name}</mi>`;
}

/** @param {string} digits */
export function number(digits) {
  return mathml`<mn>${digits}</mn>`;
}

/** @param {Math} math */
export function dotted(math) {
  return mathml`<mover accent="true">${math}<mo class="dots">.</mo></mover>`;
}

/** @param {Math} math */
export function twiceDotted(math) {
  return mathml`<mover accent="true">${math}<mo class="dots">¨</mo></mover>`;
}

/** @param {Math} math */
export function square(math) {
  return power(math, '2');
}

/** @param {Math} math @param {string} exponent with its sign */
export function power(math, exponent) {
  return mathml`<msup><mrow>${math}</mrow><mn>${exponent}</mn></msup>`;
}

/** @param {Math} math @param {Math} exponent */
export function raised(math, exponent) {
  return mathml`<msup><mrow>${math}</mrow><mrow>${exponent}</mrow></msup>`;
}

/**
 * A number of any size: from a million on, and below a thousandth, as a power of ten.
 * @param {number} value
 * @param {import('../words/voice.js').Voice} voice
 * @param {number} [digits] that are significant
 */
export function measured(value, voice, digits = 5) {
  const size = Math.abs(value);
  if (size < 1e6 && Number.isInteger(value)) return signed(voice.number(value, 0));
  if (size >= 1e-3 && size < 1e6) return signed(voice.number(value, decimalsFor(value, digits)));
  const [mantissa, exponent] = value.toExponential(digits - 1).split('e');
  const tens = power(number('10'), exponent.replace('+', '').replace('-', '−'));
  return mathml`${signed(voice.number(Number(mantissa), digits - 1))}<mo>·</mo>${tens}`;
}

/** A sign is no part of the digits. @param {string} digits */
function signed(digits) {
  return digits.startsWith('−') ? negative(number(digits.slice(1))) : number(digits);
}

/** @param {Math} above @param {Math} below */
export function fraction(above, below) {
  return mathml`<mfrac><mrow>${above}</mrow><mrow>${below}</mrow></mfrac>`;
}

/** @param {Math[]} factors */
export function product(...factors) {
  return mathml`${factors.map((factor, i) => (i === 0 ? factor : mathml`<mspace width="0.18em"></mspace>${factor}`))}`;
}

/** @param {Math[]} factors */
export function plus(...factors) {
  return { sign: '+', term: product(...factors) };
}

/** @param {Math[]} factors */
export function minus(...factors) {
  return { sign: '−', term: product(...factors) };
}

/** @param {Math} math */
export function negative(math) {
  return mathml`<mo form="prefix">−</mo>${math}`;
}

/** @param {Math} left @param {(Math | { sign: string, term: Math })[]} terms a sum */
export function equal(left, ...terms) {
  return mathml`${left}<mo>=</mo>${terms.map((one, i) => {
    if (!('sign' in one)) return one;
    if (i === 0) return one.sign === '+' ? one.term : negative(one.term);
    return mathml`<mo>${one.sign}</mo>${one.term}`;
  })}`;
}

/** @param {Math} left @param {string} relation @param {Math} right */
export function compared(left, relation, right) {
  return mathml`${left}<mo>${relation}</mo>${right}`;
}

/** @param {Math} math */
export function bracketed(math) {
  return mathml`<mrow><mo form="prefix" stretchy="false">(</mo>${math}<mo form="postfix" stretchy="false">)</mo></mrow>`;
}

/** A function's value. @param {Math} what @param {Math} argument */
export function of(what, argument) {
  return mathml`${what}<mo form="prefix" stretchy="false">(</mo>${argument}<mo form="postfix" stretchy="false">)</mo>`;
}

/** @param {Math} math */
export function size(math) {
  return mathml`<mo form="prefix" stretchy="false">|</mo>${math}<mo form="postfix" stretchy="false">|</mo>`;
}

/** @param {Math} math */
export function sign(math) {
  return product(named('sgn'), math);
}

/** @param {[Math, Math][]} rows a value, and where it holds */
export function cases(...rows) {
  return mathml`<mtable class="cases" displaystyle="true">${rows.map(([value, where]) => mathml`
    <mtr><mtd>${value}</mtd><mtd>${where}</mtd></mtr>`)}</mtable>`;
}
