/**
 * A mode's shape as one reads it: each state beside the torsion angle.
 *
 * @typedef {import('../../run/linear-looks.js').Mode} Mode
 * @typedef {import('../../view/phasors.js').Arm} Arm
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

import { html } from 'lit';
import { quantities } from '../../view/quantities.js';

const degree = Math.PI / 180;
/** Less than this is no angle that one can see, in degrees. */
const seen = 0.05;

/** How each state's phasor is drawn and called: measured by what makes it comparable with the angle. */
const states = /** @type {const} */ ([
  { name: 'torsionAngle', color: 'psi', form: 'solid', plain: 'ψ', label: html`<i class="symbol psi">ψ</i>` },
  { name: 'torsionRate', color: 'psi', form: 'dotted', plain: 'ψ̇/ω', label: html`<i class="symbol psi">ψ̇</i>` },
  { name: 'lateralDeformation', color: 'y', form: 'ringed', plain: 'y/σ', label: html`<i class="symbol y">y</i>` },
]);

/**
 * The states of a mode in their order, with how much of each goes with one degree of the torsion angle.
 * @param {Mode} mode
 */
export function statesOf({ shape }) {
  return states.filter(({ name }) => name in shape).map((state) => {
    const { perSI, unit } = quantities[state.name];
    return { ...state, unit, perDegree: shape[state.name].amplitude * degree * perSI };
  });
}

/**
 * The phasors: ψ as 1, ψ̇ over the frequency, y over the relaxation length, which is the slip angle.
 * @param {Mode} mode @param {Readonly<Record<string, number>>} parameters @param {Voice} voice
 * @returns {Arm[]}
 */
export function armsOf(mode, parameters, voice) {
  const { shape, eigenvalue, naturalFrequency } = mode;
  const beat = eigenvalue.im > 0 ? eigenvalue.im : 2 * Math.PI * naturalFrequency;
  const sizes = { torsionAngle: 1, torsionRate: beat || 1, lateralDeformation: parameters.relaxationLength ?? shape.lateralDeformation.amplitude };
  const over = { torsionAngle: [], torsionRate: [{ text: '/' }, eigenvalue.im > 0 ? { symbol: 'ω' } : { text: '|s|' }], lateralDeformation: [{ text: '/' }, { symbol: 'σ' }] };
  return statesOf(mode).map(({ name, color, form }, i) => {
    const { symbol, dotted } = quantities[name];
    return {
      re: shape[name].re / sizes[name], im: shape[name].im / sizes[name], color, form,
      name: [{ symbol, dotted }, ...over[name], ...(i === 0 ? [] : [{ text: ` ${voice.number(shape[name].amplitude / sizes[name], 2)}` }])],
      phase: phaseOf(mode, name, voice),
    };
  });
}

/** By how much a state lags behind the torsion angle, in words; nothing for that itself. @param {Mode} mode @param {string} name @param {Voice} voice */
export function phaseOf({ shape, reference, eigenvalue }, name, voice) {
  if (name === reference) return '';
  const lag = shape[name].lag / degree;
  if (eigenvalue.im === 0) return voice.say(Math.abs(lag) > 90 ? 'modes.opposite' : 'modes.together');
  const angle = voice.number(Math.abs(lag), 0);
  return Math.abs(lag) < seen ? voice.say('modes.together') : voice.say(lag > 0 ? 'modes.lags' : 'modes.leads', { angle });
}
