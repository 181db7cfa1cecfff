/**
 * What linear theory says, in words.
 *
 * @typedef {import('../../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../../run/linear-looks.js').LeftOut} LeftOut
 * @typedef {import('../../run/linear-looks.js').Range} Range
 * @typedef {import('../../view/root-paths.js').Root} Root
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

import { nameOf, withUnit } from '../../controls/quantity.js';
import { decimalsFor, decimalsOf } from '../../words/number.js';

const circle = 2 * Math.PI;

/** The pair that swings and leads the others that do; undefined where none does. @param {readonly Root[]} roots by falling real part */
const pairOf = (roots) => roots.find(({ im }) => im > 0);

/** The rate of growth without its sign: `12.3`. @param {number} rate @param {Voice} voice */
export function rateOf(rate, voice) {
  return voice.number(Math.abs(rate), Math.min(3, decimalsFor(rate, 3)));
}

/**
 * What becomes of a small swing: `grows 12.3 s⁻¹, 52.1 Hz`.
 * @param {readonly Root[]} roots by falling real part
 * @param {Voice} voice
 */
export function becomes(roots, voice) {
  const [leading] = roots;
  if (!leading) return voice.say('stability.none');
  const rate = rateOf(leading.re, voice);
  if (leading.im === 0) return voice.say(leading.re > 0 ? 'stability.aside' : 'stability.creeps', { rate });
  return voice.say(leading.re > 0 ? 'stability.grows' : 'stability.falls', { rate, frequency: voice.number(leading.im / circle, 1) });
}

/** The same, and that it is linear theory where the gear is not linear even for a small swing. @param {readonly Root[]} roots @param {LeftOut} leavesOut @param {Voice} voice */
export function becomesInTheory(roots, leavesOut, voice) {
  return inTheory(becomes(roots, voice), leavesOut, voice);
}

/** Whatever is said, and that it is linear theory, which leaves out what is there. @param {string} what @param {LeftOut} leavesOut @param {Voice} voice */
export function inTheory(what, leavesOut, voice) {
  return leavesOut ? voice.say(`stability.linear.${leavesOut}`, { what }) : what;
}

/** A line under a view, and of what it does not speak. @param {string} line @param {LeftOut} leavesOut @param {Voice} voice */
export function lineInTheory(line, leavesOut, voice) {
  return leavesOut ? voice.say(`panel.${leavesOut}`, { line }) : line;
}

/** The same in signs instead of words, for where there is little room. @param {readonly Root[]} roots @param {LeftOut} leavesOut @param {Voice} voice */
export function becomesInSigns(roots, leavesOut, voice) {
  const [leading] = roots;
  if (!leading) return voice.say('stability.none');
  const rate = signed(leading.re, voice);
  if (leavesOut) return voice.say('stability.linear.short', { rate });
  return leading.im === 0 ? `${rate} ${voice.say('stability.perSecond')}` : voice.say('stability.signed', { rate, frequency: voice.number(leading.im / circle, 1) });
}

/** The same in fewer and fewer words: that it is linear theory goes last. @param {readonly Root[]} roots @param {LeftOut} leavesOut @param {Voice} voice */
export function becomesBriefly(roots, leavesOut, voice) {
  if (roots.length === 0) return [becomes(roots, voice)];
  const [whole, signs] = [becomesInTheory(roots, leavesOut, voice), becomesInSigns(roots, leavesOut, voice)];
  if (!leavesOut) return [whole, signs, `${signed(roots[0].re, voice)} ${voice.say('stability.perSecond')}`];
  return [whole, voice.say('stability.linear.brief', { what: becomes(roots, voice) }), signs, voice.say('panel.theory')];
}

/** A rate of growth with its sign. @param {number} rate @param {Voice} voice */
export const signed = (rate, voice) => (rate > 0 ? '+' : rate < 0 ? '−' : '') + rateOf(rate, voice);

/** The pair in numbers: `52.1 Hz · +12.3 s⁻¹ · ζ −0.038`; where a wheel turns aside sooner than it swings, what it does so by. @param {readonly Root[]} roots @param {Voice} voice */
export function pairInNumbers(roots, voice) {
  const pair = pairOf(roots);
  const turnsAside = roots.length > 0 && roots[0].im === 0 && roots[0].re > 0;
  if (!pair || turnsAside) return roots.length > 0 ? voice.say('roots.real', { rate: signed(roots[0].re, voice) }) : '';
  const ratio = -pair.re / Math.hypot(pair.re, pair.im);
  return voice.say('roots.pair', { frequency: voice.number(pair.im / circle, 1), rate: signed(pair.re, voice), ratio: voice.number(ratio, 3) });
}

/** The same in fewer and fewer words. @param {readonly Root[]} roots @param {Voice} voice */
export function pairReadings(roots, voice) {
  const whole = pairInNumbers(roots, voice);
  const parts = whole.split(' · ');
  if (parts.length < 2) return roots.length > 0 ? [whole, `${signed(roots[0].re, voice)} ${voice.say('stability.perSecond')}`] : [whole];
  return [whole, parts.slice(0, 2).join(' · '), parts[0]];
}

/** A crossing: `Hopf, 50.1 Hz`. @param {import('./roots-walk.js').Crossing} crossing @param {Voice} voice */
export function crossingInWords({ kind, at }, voice) {
  return kind === 'hopf' ? voice.say('roots.hopf', { frequency: voice.number(at.im / circle, 1) }) : voice.say('roots.divergence');
}

/** How long a swing takes to double or to halve. @param {number} growthRate @param {Voice} voice */
export function doubling(growthRate, voice) {
  const time = millisecondsOf(growthRate, voice);
  return time ? voice.say(growthRate > 0 ? 'history.doubles' : 'history.halves', { time }) : voice.say('history.lasts');
}

/** The same in signs: `× 2: 81 ms`. @param {number} growthRate @param {Voice} voice */
export function doublingInSigns(growthRate, voice) {
  const time = millisecondsOf(growthRate, voice);
  return time && `${voice.say(growthRate > 0 ? 'cases.doubles' : 'cases.halves', { time })} ms`;
}

/** @param {number} growthRate @param {Voice} voice */
function millisecondsOf(growthRate, voice) {
  const time = (Math.LN2 / Math.abs(growthRate)) * 1000;
  return time < 1e5 ? voice.number(time, decimalsFor(time, 2)) : '';
}

/** A symbol with a value and its unit: `v 80.0 m/s`. @param {Quantity} quantity @param {number} value @param {Voice} voice */
export function valueInWords(quantity, value, voice) {
  return `${plainSymbol(quantity)} ${quantity.write(value, voice)}`;
}

/** A range: `v 0.5 … 100 m/s`. @param {Quantity} quantity @param {Range} range @param {Voice} voice */
export function rangeInWords(quantity, { from, to }, voice) {
  const range = voice.say('stability.range', { symbol: plainSymbol(quantity), from: shortNumber(quantity, from, voice), to: withUnit(shortNumber(quantity, to, voice), quantity.unit) });
  // A range is one word to a line's end.
  return range.replaceAll(' ', '\u00a0');
}

/** A value without needless zeros: `0.5`, `100`. @param {Quantity} quantity @param {number} value @param {Voice} voice */
export function shortNumber(quantity, value, voice) {
  const shown = quantity.toShown(value);
  return voice.number(shown, Math.min(4, decimalsOf(shown, 0)));
}

/** A symbol as plain text: `I_z` is `Iz`. @param {Quantity} quantity */
export const plainSymbol = (quantity) => quantity.parameter.symbol.replace('_', '');

/** A parameter's name within a sentence. @param {Quantity} quantity @param {Voice} voice */
export const lowerName = (quantity, voice) => nameOf(quantity, voice).toLocaleLowerCase(voice.language);
