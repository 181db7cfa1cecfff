/** Why a value was refused, in the language of the page. */

import { withUnit } from './quantity.js';

/**
 * @typedef {import('./quantity.js').Quantity} Quantity
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{ code: string, allowed?: string }} Refusal what the engine says; `not-a-number` and `too-large` are the page's own
 */

/**
 * @param {Refusal} refusal
 * @param {Quantity} quantity
 * @param {string} name of the parameter in words
 * @param {number} kept the value that stays, in SI
 * @param {Voice} voice
 */
export function explain(refusal, quantity, name, kept, voice) {
  const values = { name, kept: quantity.number(kept, voice), allowed: refusal.allowed ?? '' };
  if (refusal.code === 'not-a-number') return voice.say('refused.notANumber', values);
  if (refusal.code === 'too-large') return voice.say('refused.tooLarge', values);
  const [, sign, bound] = refusal.allowed?.match(/^(>|≥) (\S+)/) ?? [];
  if (sign) {
    const limit = withUnit(quantity.number(Number(bound), voice).replace(/[.,]0+$/, ''), quantity.unit);
    return voice.say(sign === '>' ? 'refused.above' : 'refused.atLeast', { ...values, limit });
  }
  return voice.say(refusal.allowed?.startsWith('at most') ? 'refused.tooLarge' : 'refused.other', values);
}
