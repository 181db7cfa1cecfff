import { html, nothing } from 'lit';
import { valuesLine } from '../../out/values-line.js';
import { figureTitle } from '../../story/title.js';
import { quantities as shown } from '../../view/quantities.js';
import { decimalsOf } from '../../words/number.js';
import { figuresTable } from '../stability/figures-table.js';
import { lowerName, plainSymbol } from '../stability/say.js';
import { amplitudeColumn, figureColumn, parameterColumn } from './columns.js';
import { RowsPanel } from './rows-panel.js';
import { tableOutButtons } from './table-out.js';
import { settledOf, tableNumbers, tableOf, thesisTables } from './thesis-tables.js';

/**
 * @typedef {import('./thesis-tables.js').Settled} Settled
 * @typedef {import('./thesis-tables.js').Values} Values
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('../../words/voice.js').Key} Key
 * @typedef {{ spec: Values, answer: Settled | null, isOld: boolean }} Row
 */

/**
 * The tables of the thesis about cycles, computed with the gear's other values as they are. Commands: `view` with the table and
 * how it is sorted, `point` with the values of a row.
 * @extends {RowsPanel<Values, Settled>}
 */
export class CycleTables extends RowsPanel {
  get #number() {
    return tableOf(this.settings.cycleTable ?? '');
  }

  get #table() {
    return thesisTables[this.#number];
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

  /** @param {Voice} voice */
  content(voice) {
    if (!this.#isOurs) return html`<p class="panel-empty">${voice.say('tables.foreign')}</p>`;
    const columns = this.#columns(voice);
    // Until its own rows are asked for there are those of the table before, which have other values.
    const items = this.items.filter(({ spec }) => this.#table.rows.includes(spec));
    const sorting = this.settings.cycleTableSort ?? '';
    const caption = `${voice.say('atlas.Table', { number: this.#number })}: ${this.#title(this.#number, voice)}`;
    return html`
      <div class="panel-scroll cycle-tables" tabindex="0" role="group" aria-label=${voice.say('cycles.view.tables')}>
        <select class="framed ready" aria-label=${voice.say('tables.choose')} .value=${this.#number}
          @change=${(/** @type {Event} */ event) => this.choose('cycleTable', /** @type {HTMLSelectElement} */ (event.target).value)}>
          ${tableNumbers.map((number) => html`<option value=${number} ?selected=${number === this.#number}>${voice.say('atlas.Table', { number })}: ${this.#title(number, voice)}</option>`)}
        </select>
        ${this.#strangers(voice)}
        ${figuresTable(this, { caption, columns, rows: items, of: 'cycleTableSort', sorting, classOf: ({ spec, isOld }) => [this.isNow(this.#valuesOf(spec)) ? 'now' : '', isOld ? 'old' : ''].join(' ') }, voice)}
        <p class="theory units">${columns.filter(({ isSpare }) => !isSpare).map(({ head }) => head.replace(', ', '\u00a0')).join(' · ')}</p>
        <p class="table-out">
          ${tableOutButtons({ said: this.said, take: (format) => this.take(format, { file: `shimmy-table-${this.#number}`, title: caption, note: this.#note(voice), columns, rows: items }, sorting, voice) }, voice)}
        </p>
        <p class="theory">${this.#note(voice)}</p>
      </div>`;
  }

  /** @param {Values} row */
  #valuesOf(row) {
    return { ...this.#table.fixed, ...row };
  }

  /** @param {string} number @param {Voice} voice */
  #title(number, voice) {
    return figureTitle({ id: `Table ${number}`, title: thesisTables[number].title, view: 'table' }, voice);
  }

  /** From which start it is, and with what values. @param {Voice} voice */
  #note(voice) {
    const { start, fixed } = this.#table;
    const values = valuesLine(this.quantities.filter(({ name }) => name in fixed), fixed, voice);
    return voice.say('tables.note', { start: voice.number(start, decimalsOf(start, 0)), values });
  }

  /** Which values are not the thesis', and a way to set them. @param {Voice} voice */
  #strangers(voice) {
    const { fixed, varied } = this.#table;
    const others = this.quantities.filter(({ name, parameter }) => !(name in fixed) && !varied.includes(name) && this.scene?.parameters[name] !== parameter.default);
    if (others.length === 0) return nothing;
    return html`
      <p class="table-out strangers">
        <span>${voice.say('beside.strangers', { symbols: others.map(plainSymbol).join(', ') })}</span>
        <button type="button" class="framed" @click=${() => this.put(Object.fromEntries(others.map(({ name, parameter }) => [name, parameter.default])))}>${voice.say('beside.strangers.set')}</button>
      </p>`;
  }

  /** @param {Voice} voice @returns {import('./table-out.js').OutColumn<Row>[]} */
  #columns(voice) {
    const { varied, shows, perGap } = this.#table;
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
      ...(perGap ? shows.map((state) => this.#perGap(state, voice)) : []),
      figureColumn({ name: 'frequency', unit: 'Hz', head: 'f, Hz', digits: 5, value: (/** @type {Row} */ { answer }) => answer?.frequency ?? null }, voice),
    ];
  }

  /** An amplitude as a multiple of half of the gap: the same for every gap, were the tire linear. @param {import('./thesis-tables.js').StateName} state @param {Voice} voice */
  #perGap(state, voice) {
    const { symbol } = shown[state];
    const [unit, perSI] = state === 'torsionAngle' ? ['1', 1] : ['m/rad', (1000 * Math.PI) / 180];
    return figureColumn({
      name: `${state}PerGap`, unit, head: `${symbol} / ψfp${state === 'torsionAngle' ? '' : ', mm/°'}`, digits: 5, perSI,
      value: (/** @type {Row} */ { spec, answer }) => (answer && spec.freeplayAngle > 0 ? answer.amplitude[state] / spec.freeplayAngle : null),
    }, voice);
  }

  /** @param {Values} row @param {Voice} voice */
  #inWords(row, voice) {
    return Object.entries(this.#valuesOf(row)).flatMap(([name, value]) => {
      const quantity = this.quantity(name);
      return quantity ? [`${lowerName(quantity, voice)} ${quantity.write(value, voice)}`] : [];
    }).join(', ');
  }
}

customElements.define('shimmy-cycle-tables', CycleTables);
