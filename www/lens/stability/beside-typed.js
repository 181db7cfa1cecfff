import { nameOf } from '../../controls/quantity.js';
import { reasonOf } from '../../controls/refusal.js';
import { parseList } from '../../words/list.js';
import { mostPlanes } from './beside-settings.js';

/**
 * What was typed as a list of values, as the comparison that it makes, or why it makes none.
 *
 * @typedef {import('../../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../../controls/refusal.js').Refusal} Refusal
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('./beside-settings.js').Beside} Beside
 *
 * @param {string} typed
 * @param {{ beside: Beside, at: number, quantity: Quantity }} list which of the lists of which comparison, and of what
 * @param {(values: Record<string, number>) => unknown} compute throws what the engine refuses
 * @param {Voice} voice
 * @returns {Beside | string}
 */
export function readTyped(typed, { beside, at, quantity }, compute, voice) {
  const { values: shown, stranger } = parseList(typed);
  if (stranger !== null) return voice.say('beside.refused.notANumber', { text: stranger });
  const values = [...new Set(shown.map((value) => quantity.toSI(value)))];
  if (values.length === 0) return voice.say('beside.refused.empty');
  const lists = beside.lists.map((list, i) => (i === at ? { ...list, values } : list));
  if (lists.reduce((count, one) => count * one.values.length, 1) > mostPlanes) return voice.say('beside.refused.many', { count: mostPlanes });
  for (const value of values) {
    const refusal = Number.isFinite(value) ? refusalOf(() => compute({ [quantity.name]: value })) : { code: 'too-large' };
    if (refusal) return whyRefused(refusal, quantity, value, voice);
  }
  return { ...beside, lists };
}

/** @param {() => unknown} task @returns {Refusal | null} */
function refusalOf(task) {
  try {
    task();
    return null;
  } catch (error) {
    return /** @type {Refusal} */ (error);
  }
}

/** @param {Refusal} refusal @param {Quantity} quantity @param {number} value @param {Voice} voice */
function whyRefused(refusal, quantity, value, voice) {
  const { reason, limit } = reasonOf(refusal, quantity, voice);
  return voice.say(`beside.refused.${reason}`, { name: nameOf(quantity, voice), value: quantity.write(value, voice), allowed: refusal.allowed ?? '', limit });
}
