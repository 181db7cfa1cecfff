import { html } from 'lit';
import { tell } from '../../command.js';
import { fittingsOf } from '../../object/fittings.js';
import { damperNames } from './settings.js';

/**
 * What a view says of a gear that has no damper, and the buttons that give it one.
 * @param {EventTarget} host @param {string} object @param {import('../../words/voice.js').Voice} voice
 */
export function damperOffer(host, object, voice) {
  const { damper } = fittingsOf(object);
  // The simple form holds at one command: it has none to vary.
  const offered = damperNames.filter((name) => name !== 'bouc-wen');
  return html`
    <div class="panel-empty damper-offer">
      <p>${voice.say(damper === 'none' ? 'calm.none' : 'calm.uncommanded')}</p>
      ${offered.map((name) => html`<button type="button" class="framed" @click=${() => tell(host, 'fitDamper', { model: name, parameters: {} })}>${voice.say(`damper.model.${name}`)}</button>`)}
    </div>`;
}

