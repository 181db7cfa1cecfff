import { html } from 'lit';

/**
 * Stands where something is to be guessed before it is seen: a hatched box with a question mark.
 * @param {import('../words/voice.js').Voice} voice
 */
export function veil(voice) {
  return html`<span class="veil" role="img" aria-label=${voice.say('predict.veiled')}>?</span>`;
}
