/**
 * What there is to say of a cycle.
 *
 * @typedef {import('../../run/cycle-looks.js').LimitCycle} LimitCycle
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

import { quantities, valueOf } from '../../view/quantities.js';
import { decimalsFor } from '../../words/number.js';

/** A multiplier that is nearer to 1 than this is the trivial one, of the way along the cycle. */
const trivial = 1e-4;

/** The multipliers of a cycle, the trivial one apart: of those near 1 the nearest. @param {LimitCycle['multipliers']} multipliers */
export function multipliersOf(multipliers) {
  const off = multipliers.map(({ re, im }) => Math.hypot(re - 1, im));
  const nearest = off.indexOf(Math.min(...off));
  return { along: off[nearest] < trivial ? multipliers[nearest] : null, others: multipliers.filter((_, i) => i !== nearest || off[i] >= trivial) };
}

/** What a cycle is: "a stable limit cycle". @param {LimitCycle} cycle @param {Voice} voice */
export function kindOf({ stable, symmetric }, voice) {
  const kind = voice.say(stable ? 'cycle.stable' : 'cycle.unstable');
  return symmetric === false ? voice.say('cycle.asymmetric', { kind }) : kind;
}

/** A state's amplitude with its unit: `±15.2°`. @param {string} name @param {number} value @param {Voice} voice */
export function amplitudeOf(name, value, voice) {
  const quantity = quantities[/** @type {'torsionAngle'} */ (name)];
  return `±${valueOf(quantity, value, digitsOf(value * quantity.perSI), voice)}`;
}

/** Decimals that show four digits. @param {number} value */
export const digitsOf = (value) => Math.min(4, decimalsFor(value, 4));

/** A multiplier: `0.696`, `0.5 ± 0.3i`. @param {{ re: number, im: number }} multiplier @param {Voice} voice */
export function multiplierInWords({ re, im }, voice) {
  const number = (/** @type {number} */ value) => (value !== 0 && Math.abs(value) < 1e-4 ? voice.power(Number(value.toPrecision(2))) : voice.number(value, Math.abs(value) < 0.01 ? 5 : 3));
  return im === 0 ? number(re) : `${number(re)} ± ${number(Math.abs(im))}i`;
}

/** How much of an aside is left after one cycle, in words. @param {LimitCycle} cycle @param {Voice} voice */
export function nearnessInWords({ multipliers, stable }, voice) {
  const { others } = multipliersOf(multipliers);
  const size = Math.max(...others.map(({ re, im }) => Math.hypot(re, im)));
  return voice.say(stable ? 'cycle.nearer' : 'cycle.farther', { factor: voice.number(size, decimalsFor(size, 3)) });
}
