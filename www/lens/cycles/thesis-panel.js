import { html, nothing } from 'lit';
import { valuesLine } from '../../out/values-line.js';
import { decimalsOf } from '../../words/number.js';
import { figuresTable } from '../stability/figures-table.js';
import { lowerName } from '../stability/say.js';
import { amplitudeColumn, figureColumn, parameterColumn } from './columns.js';
import { RowsPanel } from './rows-panel.js';
import { tableOutButtons } from './table-out.js';
import { chosenOf, settledOf } from './thesis-tables.js';

/**
 * @typedef {import('./thesis-tables.js').Settled} Settled
 * @typedef {import('./thesis-tables.js').ThesisTable} Table
 * @typedef {import('./thesis-tables.js').Values} Values
 * @typedef {import('../../words/voice.js').Key} Key
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {{ spec: Values, answer: Settled | null, isOld: boolean }} Row
 */

/**
 * Tables of the thesis, one of them seen, computed with the gear's other values as they are. Commands: `view` with the table and how
 * it is sorted, `point` with the values of a row.
 * @extends {RowsPanel<Values, Settled>}
 */
export class ThesisPanel extends RowsPanel {
  /** The tables by number, what they are together, and the settings that choose one and sort it. @returns {{ all: Readonly<Record<string, Table>>, numbers: readonly string[], name: Key, chosen: string, sorted: string }} */
  get tables() {
    throw new Error('a panel of tables says which');
  }

  /** @param {string} _number @param {Voice} _voice @returns {string} */
  titleOf(_number, _voice) {
    return '';
  }

  /** What is said where the gear has not got what a table varies. @param {Voice} _voice @param {import('../../run/scene.js').Scene} _scene @returns {unknown} */
  foreign(_voice, _scene) {
    return nothing;
  }

  /** Between the choice and the table. @param {Voice} _voice @returns {unknown} */
  remark(_voice) {
    return nothing;
  }

  /** Columns before the last. @param {Voice} _voice @returns {import('./table-out.js').OutColumn<Row>[]} */
  furtherColumns(_voice) {
    return [];
  }

  get number() {
    const { numbers, chosen } = this.tables;
    return chosenOf(numbers, this.settings[chosen] ?? '');
  }

  get table() {
    return this.tables.all[this.number];
  }

  /** Whether this object has what the table varies. */
  get #isOurs() {
    const { fixed, varied } = this.table;
    return [...Object.keys(fixed), ...varied].every((name) => this.quantity(name));
  }

  wanted() {
    const { scene } = this;
    if (!scene || !this.#isOurs) return null;
    const { fixed, varied, rows } = this.table;
    const others = Object.entries(scene.parameters).filter(([name]) => !(name in fixed) && !varied.includes(name));
    return { key: JSON.stringify([scene.object, this.number, others]), shape: this.number, specs: rows };
  }

  /** @param {Values} row */
  answer(row) {
    return this.askCycles((cycles) => settledOf(cycles, this.table, row));
  }

  /** @param {Voice} voice @param {import('../../run/scene.js').Scene} scene */
  content(voice, scene) {
    if (!this.#isOurs) return this.foreign(voice, scene);
    const { numbers, name, chosen, sorted } = this.tables;
    const columns = this.#columns(voice);
    // Until its own rows are asked for there are those of the table before, which have other values.
    const items = this.items.filter(({ spec }) => this.table.rows.includes(spec));
    const sorting = this.settings[sorted] ?? '';
    const caption = (/** @type {string} */ number) => `${voice.say('atlas.Table', { number })}: ${this.titleOf(number, voice)}`;
    const note = this.#note(voice);
    return html`
      <div class="panel-scroll cycle-tables" tabindex="0" role="group" aria-label=${voice.say(name)}>
        <select class="framed ready" aria-label=${voice.say('tables.choose')} .value=${this.number}
          @change=${(/** @type {Event} */ event) => this.choose(chosen, /** @type {HTMLSelectElement} */ (event.target).value)}>
          ${numbers.map((number) => html`<option value=${number} ?selected=${number === this.number}>${caption(number)}</option>`)}
        </select>
        ${this.remark(voice)}
        ${figuresTable(this, { caption: caption(this.number), columns, rows: items, of: sorted, sorting, classOf: ({ spec, isOld }) => [this.isNow(this.#valuesOf(spec)) ? 'now' : '', isOld ? 'old' : ''].join(' ') }, voice)}
        <p class="theory units">${columns.filter(({ isSpare }) => !isSpare).map(({ head }) => head.replace(', ', '\u00a0')).join(' · ')}</p>
        <p class="table-out">
          ${tableOutButtons({ said: this.said, take: (format) => this.take(format, { file: `shimmy-table-${this.number}`, title: caption(this.number), note, columns, rows: items }, sorting, voice) }, voice)}
        </p>
        <p class="theory">${note}</p>
      </div>`;
  }

  /** @param {Values} row */
  #valuesOf(row) {
    return { ...this.table.fixed, ...row };
  }

  /** From which start it is, and with what values. @param {Voice} voice */
  #note(voice) {
    const { start, fixed } = this.table;
    const values = valuesLine(this.quantities.filter(({ name }) => name in fixed), fixed, voice);
    return voice.say('tables.note', { start: voice.number(start, decimalsOf(start, 0)), values });
  }

  /** @param {Voice} voice @returns {import('./table-out.js').OutColumn<Row>[]} */
  #columns(voice) {
    const { varied, shows } = this.table;
    const press = {
      does: (/** @type {Row} */ { spec }) => voice.say('tables.set', { values: this.#inWords(spec, voice) }),
      set: (/** @type {Row} */ { spec }) => this.setOthers(this.#valuesOf(spec)),
    };
    const verdict = (/** @type {Row} */ { answer }) => (answer ? voice.say(/** @type {Key} */ (`compare.${answer.verdict}`)) : '–');
    return [
      ...varied.flatMap((name, i) => {
        const quantity = this.quantity(name);
        return quantity ? [parameterColumn(quantity, (/** @type {Row} */ { spec }) => spec[name], voice, i === 0 ? press : undefined)] : [];
      }),
      { name: 'becomes', unit: '', head: voice.say('cases.becomes'), title: voice.say('cases.becomes'), isWord: true, isSpare: shows.length > 1, value: ({ answer }) => answer?.amplitude.torsionAngle ?? null, csv: ({ answer }) => answer?.verdict ?? null, text: verdict, show: verdict },
      ...shows.map((state) => amplitudeColumn(state, (/** @type {Row} */ { answer }) => answer?.amplitude[state] ?? null, voice)),
      ...this.furtherColumns(voice),
      figureColumn({ name: 'frequency', unit: 'Hz', head: 'f, Hz', digits: 5, value: (/** @type {Row} */ { answer }) => answer?.frequency ?? null }, voice),
    ];
  }

  /** @param {Values} row @param {Voice} voice */
  #inWords(row, voice) {
    return Object.entries(this.#valuesOf(row)).flatMap(([name, value]) => {
      const quantity = this.quantity(name);
      return quantity ? [`${lowerName(quantity, voice)} ${quantity.write(value, voice)}`] : [];
    }).join(', ');
  }
}
