import { html, nothing } from 'lit';
import { figureTitle } from '../../story/title.js';
import { quantities as shown } from '../../view/quantities.js';
import { plainSymbol } from '../stability/say.js';
import { figureColumn } from './columns.js';
import { ThesisPanel } from './thesis-panel.js';
import { tableNumbers, thesisTables } from './thesis-tables.js';

/**
 * @typedef {import('./thesis-panel.js').Row} Row
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

const tables = /** @type {const} */ ({ all: thesisTables, numbers: tableNumbers, name: 'cycles.view.tables', chosen: 'cycleTable', sorted: 'cycleTableSort' });

/** The tables of the thesis about cycles. */
export class CycleTables extends ThesisPanel {
  get tables() {
    return tables;
  }

  /** @param {string} number @param {Voice} voice */
  titleOf(number, voice) {
    return figureTitle({ id: `Table ${number}`, title: thesisTables[number].title, view: 'table' }, voice);
  }

  /** @param {Voice} voice */
  foreign(voice) {
    return html`<p class="panel-empty">${voice.say('tables.foreign')}</p>`;
  }

  /** Which values are not the thesis', and a way to set them. @param {Voice} voice */
  remark(voice) {
    const { fixed, varied } = this.table;
    const others = this.quantities.filter(({ name, parameter }) => !(name in fixed) && !varied.includes(name) && this.scene?.parameters[name] !== parameter.default);
    if (others.length === 0) return nothing;
    return html`
      <p class="table-out strangers">
        <span>${voice.say('beside.strangers', { symbols: others.map(plainSymbol).join(', ') })}</span>
        <button type="button" class="framed" @click=${() => this.put(Object.fromEntries(others.map(({ name, parameter }) => [name, parameter.default])))}>${voice.say('beside.strangers.set')}</button>
      </p>`;
  }

  /** @param {Voice} voice */
  furtherColumns(voice) {
    const { shows, perGap } = this.table;
    return perGap ? shows.map((state) => perGapColumn(state, voice)) : [];
  }
}

/** An amplitude as a multiple of half of the gap: the same for every gap, were the tire linear. @param {import('./thesis-tables.js').StateName} state @param {Voice} voice */
function perGapColumn(state, voice) {
  const { symbol } = shown[state];
  const [unit, perSI] = state === 'torsionAngle' ? ['1', 1] : ['m/rad', (1000 * Math.PI) / 180];
  return figureColumn({
    name: `${state}PerGap`, unit, head: `${symbol} / ψfp${state === 'torsionAngle' ? '' : ', mm/°'}`, digits: 5, perSI,
    value: (/** @type {Row} */ { spec, answer }) => (answer && spec.freeplayAngle > 0 ? answer.amplitude[state] / spec.freeplayAngle : null),
  }, voice);
}

customElements.define('shimmy-cycle-tables', CycleTables);
