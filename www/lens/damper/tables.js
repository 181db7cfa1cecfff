import { html } from 'lit';
import { valuesLine } from '../../out/values-line.js';
import { decimalsOf } from '../../words/number.js';
import { amplitudeColumn, figureColumn, parameterColumn } from '../cycles/columns.js';
import { RowsPanel } from '../cycles/rows-panel.js';
import { tableOutButtons } from '../cycles/table-out.js';
import { settledOf } from '../cycles/thesis-tables.js';
import { figuresTable } from '../stability/figures-table.js';
import { lowerName } from '../stability/say.js';
import { damperOffer } from './offer.js';
import { damperTableNumbers, damperTableOf, damperTables } from './thesis-tables.js';

/**
 * @typedef {import('../cycles/thesis-tables.js').Settled} Settled
 * @typedef {import('../cycles/thesis-tables.js').Values} Values
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('../../words/voice.js').Key} Key
 * @typedef {{ spec: Values, answer: Settled | null, isOld: boolean }} Row
 */

/**
 * The tables of the thesis about the damper on the gear, computed with the damper that is on it and the gear's other values as they
 * are. Commands: `view` with the table and how it is sorted, `point` with the values of a row, `fitDamper` where there is none.
 * @extends {RowsPanel<Values, Settled>}
 */
export class DamperTables extends RowsPanel {
  get #number() {
    return damperTableOf(this.settings.damperTable ?? '');
  }

  get #table() {
    return damperTables[this.#number];
  }

  /** Whether this object has what the table varies. */
  get #isOurs() {
    const { fixed, varied } = this.#table;
    return [...Object.keys(fixed), ...varied].every((name) => this.quantity(name));
  }

  wanted() {
    const { scene } = this;
    if (!scene || !this.#isOurs) return null;
    const { fixed, varied, rows } = this.#table;
    const others = Object.entries(scene.parameters).filter(([name]) => !(name in fixed) && !varied.includes(name));
    return { key: JSON.stringify([scene.object, this.#number, others]), shape: this.#number, specs: rows };
  }

  /** @param {Values} row */
  answer(row) {
    return this.askCycles((cycles) => settledOf(cycles, this.#table, row));
  }

  /** @param {Voice} voice @param {import('../../run/scene.js').Scene} scene */
  content(voice, scene) {
    if (!this.#isOurs) return damperOffer(this, scene.object, voice);
    const { start, fixed } = this.#table;
    const columns = this.#columns(voice);
    const items = this.items.filter(({ spec }) => this.#table.rows.includes(spec));
    const sorting = this.settings.damperTableSort ?? '';
    const titleOf = (/** @type {string} */ number) => `${voice.say('atlas.Table', { number })}: ${voice.say(/** @type {Key} */ (`atlas.table-${number}`))}`;
    const note = voice.say('tables.note', { start: voice.number(start, decimalsOf(start, 0)), values: valuesLine(this.quantities.filter(({ name }) => name in fixed), fixed, voice) });
    return html`
      <div class="panel-scroll cycle-tables" tabindex="0" role="group" aria-label=${voice.say('damper.view.tables')}>
        <select class="framed ready" aria-label=${voice.say('tables.choose')} .value=${this.#number} @change=${(/** @type {Event} */ event) => this.choose('damperTable', /** @type {HTMLSelectElement} */ (event.target).value)}>
          ${damperTableNumbers.map((number) => html`<option value=${number} ?selected=${number === this.#number}>${titleOf(number)}</option>`)}
        </select>
        ${figuresTable(this, { caption: titleOf(this.#number), columns, rows: items, of: 'damperTableSort', sorting, classOf: ({ spec, isOld }) => [this.isNow({ ...fixed, ...spec }) ? 'now' : '', isOld ? 'old' : ''].join(' ') }, voice)}
        <p class="table-out">
          ${tableOutButtons({ said: this.said, take: (format) => this.take(format, { file: `shimmy-table-${this.#number}`, title: titleOf(this.#number), note, columns, rows: items }, sorting, voice) }, voice)}
        </p>
        <p class="theory">${note}</p>
      </div>`;
  }

  /** @param {Voice} voice @returns {import('../cycles/table-out.js').OutColumn<Row>[]} */
  #columns(voice) {
    const { fixed, varied, shows } = this.#table;
    const press = {
      does: (/** @type {Row} */ { spec }) => voice.say('tables.set', { values: this.#inWords({ ...fixed, ...spec }, voice) }),
      set: (/** @type {Row} */ { spec }) => this.setOthers({ ...fixed, ...spec }),
    };
    const verdict = (/** @type {Row} */ { answer }) => (answer ? voice.say(/** @type {Key} */ (`compare.${answer.verdict}`)) : '–');
    return [
      ...varied.flatMap((name, i) => {
        const quantity = this.quantity(name);
        return quantity ? [parameterColumn(quantity, (/** @type {Row} */ { spec }) => spec[name], voice, i === 0 ? press : undefined)] : [];
      }),
      { name: 'becomes', unit: '', head: voice.say('cases.becomes'), title: voice.say('cases.becomes'), isWord: true, value: ({ answer }) => answer?.amplitude.torsionAngle ?? null, csv: ({ answer }) => answer?.verdict ?? null, text: verdict, show: verdict },
      ...shows.map((state) => amplitudeColumn(state, (/** @type {Row} */ { answer }) => answer?.amplitude[state] ?? null, voice)),
      figureColumn({ name: 'frequency', unit: 'Hz', head: 'f, Hz', digits: 5, value: (/** @type {Row} */ { answer }) => answer?.frequency ?? null }, voice),
    ];
  }

  /** @param {Values} row @param {Voice} voice */
  #inWords(row, voice) {
    return Object.entries(row).flatMap(([name, value]) => {
      const quantity = this.quantity(name);
      return quantity ? [`${lowerName(quantity, voice)} ${quantity.write(value, voice)}`] : [];
    }).join(', ');
  }
}

customElements.define('shimmy-damper-tables', DamperTables);
