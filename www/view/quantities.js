import { decimalsFor } from '../words/number.js';

/**
 * What plots show: symbol, word and unit of each quantity. Data are in SI units and radians; degrees, millimeters and
 * kilonewtons exist only at the axes. A new quantity is a line in this list.
 *
 * @typedef {import('../words/voice.js').Key} Key
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('./text.js').Run} Run
 * @typedef {{
 *   symbol: string, sub?: string, dotted?: boolean, word: Key, unit: string, perSI: number, color: 'psi' | 'y' | 'force' | 'stable',
 * }} Quantity `perSI`: how many of the unit make one of SI; a unit ° stands at each number, any other at the axis' name
 * @typedef {keyof typeof quantities} QuantityName
 */

const degrees = 180 / Math.PI;

export const quantities = {
  torsionAngle: /** @type {Quantity} */ ({ symbol: 'ψ', word: 'state.torsionAngle', unit: '°', perSI: degrees, color: 'psi' }),
  torsionRate: /** @type {Quantity} */ ({ symbol: 'ψ', dotted: true, word: 'state.torsionRate', unit: 'rad/s', perSI: 1, color: 'psi' }),
  lateralDeformation: /** @type {Quantity} */ ({ symbol: 'y', word: 'state.lateralDeformation', unit: 'mm', perSI: 1000, color: 'y' }),
  slipAngle: /** @type {Quantity} */ ({ symbol: 'α', word: 'forces.slipAngle', unit: '°', perSI: degrees, color: 'y' }),
  sideForce: /** @type {Quantity} */ ({ symbol: 'F', sub: 'y', word: 'forces.sideForce', unit: 'kN', perSI: 1e-3, color: 'force' }),
  aligningMoment: /** @type {Quantity} */ ({ symbol: 'M', sub: 'z', word: 'forces.aligningMoment', unit: 'N m', perSI: 1, color: 'force' }),
  restoringMoment: /** @type {Quantity} */ ({ symbol: 'M', sub: 'k', word: 'forces.restoringMoment', unit: 'kN m', perSI: 1e-3, color: 'psi' }),
  frictionMoment: /** @type {Quantity} */ ({ symbol: 'M', sub: 'f', word: 'forces.frictionMoment', unit: 'N m', perSI: 1, color: 'stable' }),
  frequency: /** @type {Quantity} */ ({ symbol: 'f', word: 'spectrum.frequency', unit: 'Hz', perSI: 1, color: 'psi' }),
  pistonDisplacement: /** @type {Quantity} */ ({ symbol: 'x', word: 'damper.displacement', unit: 'mm', perSI: 1000, color: 'psi' }),
  pistonVelocity: /** @type {Quantity} */ ({ symbol: 'x', dotted: true, word: 'damper.velocity', unit: 'm/s', perSI: 1, color: 'psi' }),
  damperForce: /** @type {Quantity} */ ({ symbol: 'F', word: 'damper.force', unit: 'N', perSI: 1, color: 'force' }),
  damperForceLarge: /** @type {Quantity} */ ({ symbol: 'F', word: 'damper.force', unit: 'kN', perSI: 1e-3, color: 'force' }),
  generation: /** @type {Quantity} */ ({ symbol: 'n', word: 'identify.generation', unit: '', perSI: 1, color: 'psi' }),
  fitError: /** @type {Quantity} */ ({ symbol: 'ε', word: 'identify.error', unit: '%', perSI: 100, color: 'psi' }),
  forceShare: /** @type {Quantity} */ ({ symbol: 'F', word: 'damper.force.share', unit: '%', perSI: 100, color: 'force' }),
  pistonAmplitude: /** @type {Quantity} */ ({ symbol: 'X', word: 'damper.amplitude', unit: 'mm', perSI: 1000, color: 'psi' }),
  dissipated: /** @type {Quantity} */ ({ symbol: 'E', word: 'damper.energy', unit: 'J', perSI: 1, color: 'force' }),
  equivalentDamping: /** @type {Quantity} */ ({ symbol: 'c', sub: 'eq', word: 'damper.equivalent', unit: 'N s/m', perSI: 1, color: 'force' }),
  amplitude: /** @type {Quantity} */ ({ symbol: 'ψ', word: 'spectrum.amplitude', unit: '°', perSI: degrees, color: 'psi' }),
};

/**
 * The name at the end of an axis: `ψ̇ torsion rate, rad/s`, or where there is little room `ψ̇ rad/s`.
 * @param {Quantity} quantity
 * @param {Voice} voice
 * @param {boolean} [isShort]
 * @returns {Run[]}
 */
export function nameOf({ symbol, sub, dotted, word, unit }, voice, isShort = false) {
  const name = { symbol, sub, dotted };
  if (unit === '°') return isShort ? [name] : [name, { text: ` ${voice.say(word)}` }];
  return [name, { text: isShort ? ` ${unit}` : ` ${voice.say(word)}, ${unit}` }];
}

/**
 * A value with its unit: `13.5°`, `36.6 mm`.
 * @param {Quantity} quantity
 * @param {number} value in SI
 * @param {number} decimals as shown
 * @param {Voice} voice
 */
export function valueOf({ unit, perSI }, value, decimals, voice) {
  const number = voice.number(value * perSI, decimals);
  return unit === '°' ? `${number}°` : `${number} ${unit}`;
}

/**
 * Decimals for values on an axis that ends at `limit`: the same for all of them, or a moving number would jump.
 * @param {Quantity} quantity
 * @param {number} limit in SI
 */
export function decimalsUpTo({ perSI }, limit) {
  return decimalsFor(limit * perSI, 3);
}
