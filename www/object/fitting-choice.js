import { html } from 'lit';
import { tell } from '../command.js';
import { fittingsOf } from './fittings.js';

/**
 * The choice of a damper for the gear. Tells the command `fitting`.
 * @param {readonly string[]} names what there is, beside none
 * @param {string} object
 * @param {import('../words/voice.js').Voice} voice
 * @param {EventTarget} element where it is told
 */
export function damperChoice(names, object, voice, element) {
  const now = fittingsOf(object).damper;
  const choose = (/** @type {Event} */ event) => tell(element, 'fitting', { damper: /** @type {HTMLSelectElement} */ (event.target).value });
  return html`
    <select class="framed fitting" aria-label=${voice.say('fitting.damper')} @change=${choose}>
      ${['none', ...names].map((name) => html`<option value=${name} .selected=${name === now}>${voice.say(/** @type {'damper.none'} */ (`damper.${name}`))}</option>`)}
    </select>`;
}
