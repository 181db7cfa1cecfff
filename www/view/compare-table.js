import { LitElement, html, svg } from 'lit';
import { symbolOf } from '../controls/symbol.js';
import { balanceOf, energyWriter } from './energy-balance.js';
import { quantities, valueOf } from './quantities.js';
import { ghostDashes } from './strokes.js';

/**
 * @typedef {import('./energy-balance.js').Energy} Energy
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{ symbol: string, text: string }} Change a value that differs from the run's: `c_Fα`, `18 1/rad`
 * @typedef {{ manner: import('../stage/manner.js').Manner, amplitude: number | null, frequency: number | null, energy: Energy | null }} Becomes
 *   where it has settled: `amplitude` in rad, null where it never does, `frequency` in Hz, `energy` of one cycle
 * @typedef {{ changes: Change[], becomes: Becomes | null }} Compared `becomes`: null where it is to be guessed first, as a
 *   ghost may be the very run
 */

/**
 * The run and its ghosts in numbers: the run first, then the ghosts in the order of their numbers on the plots. Asks for a
 * ghost by a `pin` event, lets one go by an `unpin` event with its place among the ghosts, from 0.
 */
export class CompareTable extends LitElement {
  static properties = { rows: { attribute: false }, voice: { attribute: false } };

  constructor() {
    super();
    /** @type {Compared[]} */ this.rows = [];
    /** @type {Voice | null} */ this.voice = null;
  }

  createRenderRoot() {
    return this;
  }

  render() {
    const { voice, rows } = this;
    if (!voice || rows.length === 0) return html``;
    return html`
      <div class="scroll" role="region" tabindex="0" aria-label=${voice.say('compare.name')}>
        <table>
          <thead>
            <tr>
              <th scope="col">${voice.say('compare.run')}</th>
              <th scope="col">${voice.say('compare.changes')}</th>
              <th scope="col">${voice.say('compare.verdict')}</th>
              <th scope="col" class="figure">${voice.say('compare.amplitude')}</th>
              <th scope="col" class="figure">${voice.say('compare.frequency')}</th>
              <th scope="col" class="figure">${voice.say('compare.energy')}</th>
              <td></td>
            </tr>
          </thead>
          <tbody>${rows.map((row, i) => this.#row(row, i, voice))}</tbody>
        </table>
      </div>
      ${rows.length === 1 ? html`
        <p class="empty">${voice.say('compare.empty')}
          <button type="button" class="framed" @click=${() => this.dispatchEvent(new CustomEvent('pin'))}>${voice.say('compare.pin')}</button></p>` : ''}`;
  }

  /** @param {Compared} row @param {number} number 0 for the run itself @param {Voice} voice */
  #row(row, number, voice) {
    const name = number === 0 ? voice.say('compare.now') : voice.say('compare.ghost', { number });
    return html`
      <tr>
        <th scope="row">${sample(number)}${name}</th>
        <td>${number === 0 ? voice.say('compare.asSet') : changes(row.changes, voice)}</td>
        ${row.becomes ? results(row.becomes, voice) : html`<td colspan="4" class="veil"><span aria-hidden="true">?</span><span class="only-heard">${voice.say('energy.veiled')}</span></td>`}
        <td>${number === 0 ? '' : html`
          <button type="button" class="plain icon" aria-label=${voice.say('compare.unpin', { name })} title=${voice.say('compare.unpin', { name })}
            @click=${() => this.dispatchEvent(new CustomEvent('unpin', { detail: number - 1 }))}><span aria-hidden="true">×</span></button>`}</td>
      </tr>`;
  }
}

/** The run's line, or a ghost's as the plots dash it. @param {number} number 0 for the run itself */
const sample = (number) => html`<svg viewBox="0 0 36 6" width="36" height="6" aria-hidden="true">${number === 0
  ? svg`<path class="live" d="M0 3h36"/>`
  : svg`<path class="ghost" d="M0 3h36" stroke-dasharray=${ghostDashes[(number - 1) % ghostDashes.length].join(' ')} />`}</svg>`;

/** @param {Change[]} list @param {Voice} voice */
function changes(list, voice) {
  if (list.length === 0) return voice.say('compare.start');
  return html`<ul>${list.map(({ symbol, text }) => html`<li>${symbolOf(symbol)} = ${text}</li>`)}</ul>`;
}

/** @param {Becomes} becomes @param {Voice} voice */
function results({ manner, amplitude, frequency, energy }, voice) {
  const { fed, taken, whole } = balanceOf(energy);
  const write = energyWriter(whole, voice);
  const sum = (/** @type {{ value: number }[]} */ parts) => write(parts.reduce((total, { value }) => total + value, 0));
  const shown = (amplitude ?? 0) * quantities.torsionAngle.perSI;
  return html`
    <td class="verdict">${voice.say(`verdict.${manner}`)}</td>
    <td class="figure">${amplitude === null ? '–' : amplitude > 0 ? `±${valueOf(quantities.torsionAngle, amplitude, shown < 2 ? 2 : 1, voice)}` : '0°'}</td>
    <td class="figure">${frequency ? `${voice.number(frequency, 1)} Hz` : '–'}</td>
    <td class="figure">${whole > 0 ? html`+${sum(fed)}<br>−${sum(taken)}` : '–'}</td>`;
}

customElements.define('shimmy-compare-table', CompareTable);
