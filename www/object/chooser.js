import { html } from 'lit';
import { tell } from '../command.js';
import { fittingsOf } from './fittings.js';
import { objects } from './objects.js';

/**
 * The list of objects; those that are not built yet are dimmed and say so. Tells the command `object`.
 * @param {string} object the one in force
 * @param {import('../words/voice.js').Voice} voice
 * @param {EventTarget} element where it is told
 */
export function objectChooser(object, voice, element) {
  const { gear } = fittingsOf(object);
  const choose = (/** @type {Event} */ event) => tell(element, 'object', /** @type {HTMLSelectElement} */ (event.target).value);
  return html`
    <select class="framed object" aria-label=${voice.say('object.name')} @change=${choose}>
      ${objects.map(({ group, of }) => html`<optgroup label=${voice.say(`object.${group}`)}>${of.map((one) => {
        const word = voice.say(`object.${one.name}`);
        return html`<option value=${one.name} .selected=${one.name === gear} ?disabled=${!('ready' in one)}>${
          'ready' in one ? word : voice.say('object.later', { object: word })}</option>`;
      })}</optgroup>`)}
    </select>`;
}
