import { html, mathml, nothing } from 'lit';
import { compared, equal, measured, named, number, of, power, product, typeset, written } from '../../controls/mathml.js';
import { symbolOf } from '../../controls/symbol.js';
import { withUnit } from '../../controls/quantity.js';
import { decimalsFor } from '../../words/number.js';
import { Panel } from './panel.js';
import { conditionsOf, digitsApart, signChanges } from './routh-hurwitz.js';
import { inTheory, plainSymbol } from './say.js';

/**
 * @typedef {import('../../controls/mathml.js').Math} Math
 * @typedef {import('../../run/linear-looks.js').RouthArray} RouthArray
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

/** Digits of a critical value as shown; it is set in full, so that the gear is on the boundary. */
const digits = 5;

/**
 * The Routh array as people write it, with the numbers of the gear: its first column, the sign that breaks, the polynomial
 * and the conditions, and the values at which the gear is on the boundary. Command: `point` with a critical value.
 */
export class Routh extends Panel {
  /** @param {Voice} voice */
  content(voice) {
    const array = this.ask((linear) => linear.routhArray());
    if (!array) return html`<p class="panel-empty">${voice.say('stability.none')}</p>`;
    return html`
      <div class="panel-scroll routh" tabindex="0" role="group" aria-label=${voice.say('stability.view.routh')}>
        ${this.#verdict(array, voice)}
        ${table(array, voice)}
        <ul class="routh-formulas" aria-label=${voice.say('routh.conditions')}>
          <li>${typeset(polynomial(array.coefficients, voice))}</li>
          ${conditionsOf(array.coefficients).map((one) => condition(one, voice))}
        </ul>
        ${this.#criticals(voice)}
      </div>`;
  }

  /** @param {RouthArray} array @param {Voice} voice */
  #verdict({ stable, unstableRoots, neutralRoots }, voice) {
    const what = stable ? voice.say('routh.stable')
      : unstableRoots > 0 ? voice.say('routh.unstable', { count: unstableRoots }) : voice.say('routh.neutral', { count: neutralRoots });
    return html`<div role="status"><h2 class=${stable ? '' : 'is-unstable'}>${inTheory(what, this.leavesOut, voice)}</h2></div>`;
  }

  /** Where the gear is on the boundary, for a press. @param {Voice} voice */
  #criticals(voice) {
    const theory = this.ask((linear) => linear.routhHurwitz());
    if (!theory) return nothing;
    const { criticalVelocities, criticalDamping } = theory;
    const of = (/** @type {string[]} */ names, /** @type {number[]} */ values) => {
      const quantity = names.map((name) => this.quantity(name)).find((one) => one !== undefined);
      return quantity ? [{ quantity, values }] : [];
    };
    const rows = [...of(['velocity'], criticalVelocities), ...of(['dampingConstant', 'torsionalDamping'], criticalDamping === null ? [] : [criticalDamping])];
    return html`
      <dl class="routh-criticals">${rows.map(({ quantity, values }) => html`
        <dt>${voice.say(quantity.name === 'velocity' ? 'routh.speeds' : 'routh.damping')}</dt>
        <dd>${values.length === 0 ? voice.say('routh.none') : values.map((exact) => {
          const shown = quantity.toShown(exact);
          const text = withUnit(voice.number(shown, decimalsFor(shown, digits)), quantity.unit);
          const does = voice.say('routh.set', { symbol: plainSymbol(quantity), value: text });
          return html`<button type="button" class="framed" title=${does} aria-label=${does}
            @click=${() => this.put({ [quantity.name]: exact })}>${symbolOf(quantity.parameter.symbol)} = ${text}</button>`;
        })}</dd>`)}
      </dl>`;
  }
}

/** @param {import('./routh-hurwitz.js').Condition} condition @param {Voice} voice */
function condition({ terms, than, value, bound, isMet, isEqual }, voice) {
  const outcome = isEqual ? 'equal' : isMet ? 'met' : 'broken';
  const places = digitsApart(value, bound);
  const wanted = compared(product(...terms.map(coefficient)), '>', than === null ? number('0') : coefficient(than));
  const found = compared(measured(value, voice, places), isEqual ? '=' : isMet ? '>' : '<', measured(bound, voice, places));
  return html`
    <li class=${outcome}>
      ${typeset(mathml`${wanted}<mspace width="0.6em"></mspace><mo>:</mo><mspace width="0.6em"></mspace>${found}`)}
      <span class="mark">${voice.say(`routh.${outcome}`)}</span>
    </li>`;
}

/** @param {RouthArray} array @param {Voice} voice */
function table({ rows, special, replaced }, voice) {
  const degree = rows.length - 1;
  const width = Math.max(...rows.map((row) => row.length));
  const breaks = signChanges(rows.map(([first]) => first));
  return html`
    <table class="routh-array">
      <caption class="only-heard">${voice.say('routh.array')}</caption>
      <tbody>${rows.map((row, i) => html`
        <tr class=${breaks[i] ? 'breaks' : ''}>
          <th scope="row"><i class="symbol">s</i><sup>${degree - i}</sup></th>
          ${Array.from({ length: width }, (_, place) => html`<td class=${place === 0 ? 'first' : ''}>${place < row.length ? typeset(measured(row[place], voice)) : ''}</td>`)}
          <td class="remark">
            ${breaks[i] ? html`<span class="mark">${voice.say('routh.breaks')}</span>` : ''}
            ${special[i] ? html`<span>${voice.say(`routh.${special[i]}`, { came: replaced[i]?.map((entry) => voice.number(entry, entry === 0 ? 0 : decimalsFor(entry, digits))).join('  ') ?? '' })}</span>` : ''}
          </td>
        </tr>`)}</tbody>
    </table>`;
}

/** p(s) = s³ + … @param {readonly number[]} coefficients highest power first @param {Voice} voice */
function polynomial(coefficients, voice) {
  const degree = coefficients.length - 1;
  const terms = coefficients.map((value, i) => {
    const s = degree === i ? null : degree - i === 1 ? written('s') : power(written('s'), String(degree - i));
    const size = measured(Math.abs(value), voice);
    return { sign: value < 0 ? '−' : '+', term: s === null ? size : i === 0 && value === 1 ? s : product(size, s) };
  });
  return equal(of(named('p'), written('s')), ...terms);
}

/** a₂ @param {number} index */
function coefficient(index) {
  return mathml`<msub><mi>a</mi><mn>${index}</mn></msub>`;
}

customElements.define('shimmy-routh', Routh);
