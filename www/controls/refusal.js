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
  const { reason, limit } = reasonOf(refusal, quantity, voice);
  return voice.say(`refused.${reason}`, { name, kept: quantity.number(kept, voice), allowed: refusal.allowed ?? '', limit });
}

/**
 * Which of the reasons that the page has words for it is, and the limit in words, '' where there is none.
 * @param {Refusal} refusal
 * @param {Quantity} quantity
 * @param {Voice} voice
 * @returns {{ reason: 'notANumber' | 'tooLarge' | 'above' | 'atLeast' | 'other', limit: string }}
 */
export function reasonOf({ code, allowed = '' }, quantity, voice) {
  if (code === 'not-a-number') return { reason: 'notANumber', limit: '' };
  if (code === 'too-large' || allowed.startsWith('at most')) return { reason: 'tooLarge', limit: '' };
  const [, sign, bound] = allowed.match(/^(>|≥) (\S+)/) ?? [];
  if (!sign) return { reason: 'other', limit: '' };
  return { reason: sign === '>' ? 'above' : 'atLeast', limit: withUnit(quantity.number(Number(bound), voice).replace(/[.,]0+$/, ''), quantity.unit) };
}
