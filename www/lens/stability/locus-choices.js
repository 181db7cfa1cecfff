import { html } from 'lit';
import { tell } from '../../command.js';
import { nameOf } from '../../controls/quantity.js';
import { explain } from '../../controls/refusal.js';
import { parseNumber } from '../../words/number.js';
import { parameterOption } from './option.js';
import { rangeOf, thesisLocus, writeLocus } from './settings.js';

/**
 * What one chooses of a root locus: what is swept, from where to where, for one or some values of another; and figure 5.5.
 *
 * @typedef {import('../../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('./settings.js').Locus} Locus
 * @typedef {{ end: 'from' | 'to', text: string, why: string }} Refused what was typed for an end, and why it is not taken
 * @typedef {(parameter: string, value: number) => import('../../controls/refusal.js').Refusal | null} Check what the engine says of a value
 */

/** So many loci where one asks for some. */
const some = 6;

/**
 * @param {HTMLElement} host that tells the choice
 * @param {Locus} locus
 * @param {readonly Quantity[]} quantities
 * @param {Voice} voice
 * @param {{ refused: Refused | null, refuse: (refused: Refused | null) => void, check: Check }} judge
 */
export function locusChoices(host, locus, quantities, voice, { refused, refuse, check }) {
  const { sweep, family } = locus;
  const say = (/** @type {string} */ shows) => tell(host, 'view', { of: 'locus', shows });
  const choose = (/** @type {Partial<Locus>} */ change) => say(writeLocus({ ...locus, ...change }));
  const byName = (/** @type {string} */ name) => quantities.find((one) => one.name === name);
  const swept = byName(sweep.parameter);
  const chosen = (/** @type {Event} */ event) => byName(/** @type {HTMLSelectElement} */ (event.target).value);
  /** What was swept is no family of itself. @param {Event} event */
  const sweepOther = (event) => {
    const quantity = chosen(event);
    if (quantity) choose({ sweep: rangeOf(quantity.parameter), family: family?.parameter === quantity.name ? null : family });
  };
  /** Why a value is no end, in words; none where it is one. @param {Quantity} quantity @param {'from' | 'to'} end @param {number} value in SI */
  const whyNot = (quantity, end, value) => {
    const refusal = Number.isNaN(value) ? { code: 'not-a-number' } : !Number.isFinite(value) ? { code: 'too-large' } : check(quantity.name, value);
    if (refusal) return explain(refusal, quantity, nameOf(quantity, voice), sweep[end], voice);
    const next = { ...sweep, [end]: value };
    return next.from < next.to ? '' : voice.say('locus.refused.order');
  };
  /** @param {'from' | 'to'} end */
  const field = (end) => {
    const text = refused?.end === end ? refused.text : swept?.number(sweep[end], voice) ?? '';
    return html`
      <input type="text" inputmode="decimal" class="number" aria-label=${voice.say(`locus.${end}`)} title=${voice.say(`locus.${end}`)} .value=${text}
        aria-invalid=${refused?.end === end ? 'true' : 'false'} aria-describedby="locus-why"
        @change=${(/** @type {Event} */ event) => {
          const { value: typed } = /** @type {HTMLInputElement} */ (event.target);
          if (!swept) return;
          const value = swept.toSI(parseNumber(typed));
          const why = whyNot(swept, end, value);
          refuse(why ? { end, text: typed, why } : null);
          if (!why) choose({ sweep: { ...sweep, [end]: value } });
        }} />`;
  };
  return html`
    <div class="plane-choices">
      <button type="button" class="framed" title=${voice.say('locus.thesis.does')} aria-pressed=${writeLocus(locus) === thesisLocus ? 'true' : 'false'}
        ?disabled=${!byName('velocity') || !byName('casterLength')} @click=${() => say(thesisLocus)}>${voice.say('locus.thesis')}</button>
      <select class="framed" aria-label=${voice.say('locus.sweep')} title=${voice.say('locus.sweep')} .value=${sweep.parameter} @change=${sweepOther}>
        ${quantities.map((quantity) => parameterOption(quantity, sweep.parameter, voice))}
      </select>
      <span class="range">${field('from')} … ${field('to')} <span class="unit">${swept?.unit}</span></span>
      <select class="framed" aria-label=${voice.say('locus.family')} title=${voice.say('locus.family')} .value=${family?.parameter ?? ''}
        @change=${(/** @type {Event} */ event) => {
          const quantity = chosen(event);
          choose({ family: quantity ? { ...rangeOf(quantity.parameter), count: some } : null });
        }}>
        <option value="" ?selected=${!family}>${voice.say('locus.single')}</option>
        ${quantities.filter(({ name }) => name !== sweep.parameter).map((quantity) => parameterOption(quantity, family?.parameter, voice))}
      </select>
      <p class="why-refused" id="locus-why" role="alert">${refused ? html`<span aria-hidden="true">⚠ </span>${refused.why}` : ''}</p>
    </div>`;
}
