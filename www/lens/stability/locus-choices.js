import { html } from 'lit';
import { tell } from '../../command.js';
import { parameterOption } from './option.js';
import { rangeOf, thesisLocus, writeLocus } from './settings.js';

/**
 * What one chooses of a root locus: what is swept, from where to where, for one or some values of another; and figure 5.5.
 *
 * @typedef {import('../../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('./settings.js').Locus} Locus
 */

/** So many loci where one asks for some. */
const some = 6;

/**
 * @param {HTMLElement} host that tells the choice
 * @param {Locus} locus
 * @param {readonly Quantity[]} quantities
 * @param {Voice} voice
 * @param {import('./range-fields.js').RangeFields} ends of what is swept
 * @param {boolean} isThesisGear whether all else is as in the thesis
 */
export function locusChoices(host, locus, quantities, voice, ends, isThesisGear) {
  const { sweep, family } = locus;
  const say = (/** @type {string} */ shows) => tell(host, 'view', { of: 'locus', shows });
  const choose = (/** @type {Partial<Locus>} */ change) => say(writeLocus({ ...locus, ...change }));
  const byName = (/** @type {string} */ name) => quantities.find((one) => one.name === name);
  const chosen = (/** @type {Event} */ event) => byName(/** @type {HTMLSelectElement} */ (event.target).value);
  /** What was swept is no family of itself. @param {Event} event */
  const sweepOther = (event) => {
    const quantity = chosen(event);
    if (quantity) choose({ sweep: rangeOf(quantity.parameter), family: family?.parameter === quantity.name ? null : family });
  };
  return html`
    <div class="plane-choices">
      <button type="button" class="framed" title=${voice.say('locus.thesis.does')} aria-pressed=${writeLocus(locus) === thesisLocus && isThesisGear ? 'true' : 'false'}
        ?disabled=${!byName('velocity') || !byName('casterLength')} @click=${() => say(thesisLocus)}>${voice.say('locus.thesis')}</button>
      <select class="framed" aria-label=${voice.say('locus.sweep')} title=${voice.say('locus.sweep')} .value=${sweep.parameter} @change=${sweepOther}>
        ${quantities.map((quantity) => parameterOption(quantity, sweep.parameter, voice))}
      </select>
      ${ends.fields(sweep, (range) => choose({ sweep: range }), voice)}
      <select class="framed" aria-label=${voice.say('locus.family')} title=${voice.say('locus.family')} .value=${family?.parameter ?? ''}
        @change=${(/** @type {Event} */ event) => {
          const quantity = chosen(event);
          choose({ family: quantity ? { ...rangeOf(quantity.parameter), count: some } : null });
        }}>
        <option value="" ?selected=${!family}>${voice.say('locus.single')}</option>
        ${quantities.filter(({ name }) => name !== sweep.parameter).map((quantity) => parameterOption(quantity, family?.parameter, voice))}
      </select>
      ${ends.why(sweep)}
    </div>`;
}
