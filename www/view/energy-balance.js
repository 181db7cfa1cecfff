import { decimalsFor } from '../words/number.js';

/**
 * What the energy of a cycle says: which elements fed the swing, which took from it, and what is left.
 *
 * @typedef {'tire' | 'damper' | 'treadWidth' | 'friction' | 'mrDamper'} Element
 * @typedef {{ tire: number, damper: number, treadWidth: number, friction?: number, mrDamper?: number, stored: number }} Energy
 *   in J over one cycle: `tire` fed in, the others taken out, `stored` the rise of the swing's own energy
 * @typedef {{ element: Element, value: number }} Part
 * @typedef {{
 *   trend: 'grows' | 'lasts' | 'falls' | 'rests', fed: Part[], taken: Part[], rest: number, whole: number,
 * }} Balance all values positive; `rest`: what one side lacks; `whole`: the longer side
 */

/** A swing whose energy changes by less than this share in a cycle lasts, for all that can be seen. */
const still = 0.005;
/** Less is no motion, in J. */
const least = 1e-12;

/**
 * @param {Energy | null} energy null where nothing swings
 * @returns {Balance}
 */
export function balanceOf(energy) {
  const nothing = /** @type {const} */ ({ trend: 'rests', fed: [], taken: [], rest: 0, whole: 0 });
  if (!energy) return { ...nothing, fed: [], taken: [] };
  const { tire, damper, treadWidth, friction = 0, mrDamper = 0, stored } = energy;
  const flows = /** @type {[Element, number][]} */ ([['tire', tire], ['damper', -damper], ['treadWidth', -treadWidth], ['friction', -friction], ['mrDamper', -mrDamper]]);
  // Any element may stand on either side: a tire takes energy out of a gear that it does not drive.
  const side = (/** @type {1 | -1} */ sign) =>
    flows.filter(([, value]) => sign * value > 0).map(([element, value]) => ({ element, value: sign * value }));
  const [fed, taken] = [side(1), side(-1)];
  const sum = (/** @type {Part[]} */ parts) => parts.reduce((total, { value }) => total + value, 0);
  const whole = Math.max(sum(fed), sum(taken));
  if (!(whole > least)) return { ...nothing, fed: [], taken: [] };
  const trend = Math.abs(stored) <= still * whole ? 'lasts' : stored > 0 ? 'grows' : 'falls';
  return { trend, fed, taken, rest: trend === 'lasts' ? 0 : Math.abs(stored), whole };
}

/** Units of energy, the largest first, and from how many joules on each is used. */
const units = /** @type {const} */ ([['kJ', 1e3, 1e4], ['J', 1, 0.1], ['mJ', 1e-3, 1e-4], ['µJ', 1e-6, 1e-7], ['nJ', 1e-9, 0]]);

/**
 * Writes energies of one balance in one unit, with as many decimals as tell its whole to three digits or more.
 * @param {number} whole in J
 * @param {import('../words/voice.js').Voice} voice
 * @returns {(value: number) => string}
 */
export function energyWriter(whole, voice) {
  const [unit, size] = units.find(([, , from]) => whole >= from) ?? units[units.length - 1];
  const decimals = decimalsFor(whole / size, 3);
  return (value) => `${voice.number(value / size, decimals)} ${unit}`;
}

/**
 * Writes growth rates of one balance with as many decimals as tell its whole to three digits.
 * @param {number} whole in 1/s
 * @param {import('../words/voice.js').Voice} voice
 * @returns {(value: number) => string}
 */
export function rateWriter(whole, voice) {
  const decimals = decimalsFor(whole, 3);
  return (value) => `${voice.number(value, decimals)} ${voice.say('stability.perSecond')}`;
}
