import { html } from 'lit';
import { tell } from '../../command.js';
import { download } from '../../out/download.js';
import '../../view/canvas.js';
import { drawLinearNonlinear } from '../../view/linear-nonlinear.js';
import { roundLimit } from '../../view/scale.js';
import { decimalsOf } from '../../words/number.js';
import { casesColumns, casesCsv } from './cases.js';
import { figuresTable, sorted } from './figures-table.js';
import { fittingSpan, headroom, largest, wantedSpan } from './history-span.js';
import { Panel } from './panel.js';
import { becomesInTheory, doubling, inTheory } from './say.js';
import { historiesOf, historySpans, historyStates, writeHistories } from './settings.js';

/**
 * @typedef {import('../../run/linear-histories.js').Case} Case
 * @typedef {import('../../run/linear-histories.js').Histories} Histories
 * @typedef {import('../../run/scene.js').Scene} Scene
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

/** Samples of 2 s show a swing of some 50 Hz well. */
const samplesPerSecond = 2000;
/** An axis stays while what is on it reaches this share of it. */
const filled = 0.25;

/**
 * Linear theory and the gear in full, from one start, on one plot; and what linear theory says of the thesis' cases. Commands:
 * `view` with the state and the span, `point` with the values of a case.
 */
export class LinearAndNonlinear extends Panel {
  static properties = { ...Panel.properties, said: { state: true } };

  /** @type {Histories | null} */ #histories = null;
  /** The axis holds while a slider moves. @type {{ scales: object | null, state: string, limit: number }} */ #axis = { scales: null, state: '', limit: 1 };

  /** Of the histories shown, in s. */ #span = 0;

  constructor() {
    super();
    /** What came of a wish to take the table along. */ this.said = '';
  }

  get #shown() {
    return historiesOf(this.settings.histories ?? '');
  }

  /** @param {Voice} voice @param {Scene} scene */
  content(voice, scene) {
    const { state, duration: chosen } = this.#shown;
    const duration = this.#span = chosen ?? this.ask((linear) => fittingSpan(wantedSpan(linear, state), this.#span)) ?? historySpans[0];
    this.#histories = this.ask((linear) => linear.histories(duration, Math.max(400, Math.round(duration * samplesPerSecond))));
    if (this.#histories) this.#hold(this.#histories, state, scene.scales);
    const cases = this.ask((linear) => linear.cases()) ?? [];
    const choose = (/** @type {string} */ name, /** @type {number | null} */ span) => tell(this, 'view', { of: 'histories', shows: writeHistories({ state: name, duration: span }) });
    const columns = casesColumns(voice, (one) => this.#set(one));
    const sorting = this.settings.casesSort ?? '';
    return html`
      <div class="panel-scroll histories" tabindex="0" role="group" aria-label=${voice.say('stability.view.histories')}>
        <div class="plane-choices">
          <select class="framed" aria-label=${voice.say('histories.state')} .value=${state} @change=${(/** @type {Event} */ event) => choose(/** @type {HTMLSelectElement} */ (event.target).value, chosen)}>
            ${historyStates.map((name) => html`<option value=${name} ?selected=${name === state}>${name === 'torsionAngle' ? 'ψ' : 'y'} ${voice.say(`state.${name}`)}</option>`)}
          </select>
          <select class="framed" aria-label=${voice.say('histories.span')} .value=${chosen === null ? '' : String(chosen)} @change=${(/** @type {Event} */ event) => { const { value } = /** @type {HTMLSelectElement} */ (event.target); choose(state, value === '' ? null : Number(value)); }}>
            <option value="" ?selected=${chosen === null}>${voice.say('histories.fits', { duration: voice.number(duration, decimalsOf(duration, 0)) })}</option>
            ${historySpans.map((span) => html`<option value=${String(span)} ?selected=${span === chosen}>${voice.say('histories.seconds', { duration: voice.number(span, decimalsOf(span, 0)) })}</option>`)}
          </select>
          <span class="theory">${this.#histories ? voice.say('histories.start', { start: this.#start(voice) }) : ''}</span>
        </div>
        ${this.#histories
          ? html`<div class="both-histories"><shimmy-canvas .label=${this.#label(voice)} .paint=${this.#paint}></shimmy-canvas></div>`
          : html`<p class="panel-empty">${voice.say('histories.foreign')}</p>`}
        ${figuresTable(this, { caption: voice.say('cases.table'), columns, rows: cases, of: 'casesSort', sorting, classOf: (one) => (this.#isNow(one) ? 'now' : '') }, voice)}
        <p class="table-out">
          <span>${voice.say('cases.table')}</span>
          <button type="button" class="framed" @click=${() => this.#takeAlong(sorted(cases, columns, sorting), voice)}>${voice.say('table.csv')}</button>
          <span role="status">${this.said}</span>
        </p>
      </div>`;
  }

  /** @param {Histories} histories @param {typeof historyStates[number]} state @param {object} scales */
  #hold({ linear, nonlinear }, state, scales) {
    const [full, theory] = [largest(nonlinear[state]), largest(linear[state])];
    const wanted = Math.max(full, Math.min(theory, headroom * full));
    const { limit } = this.#axis;
    if (this.#axis.scales === scales && this.#axis.state === state && full <= limit && wanted >= filled * limit) return;
    this.#axis = { scales, state, limit: roundLimit(wanted || 1e-3) };
  }

  /** @param {Voice} voice */
  #start(voice) {
    const angle = this.#histories?.initial.torsionAngle ?? 0;
    return voice.number(angle, decimalsOf(angle, 0));
  }

  /** What linear theory says, in fewer and fewer words. @param {Voice} voice */
  #readings(voice) {
    const roots = this.ask((linear) => linear.eigenvalues()) ?? [];
    if (roots.length === 0) return [voice.say('stability.none')];
    const what = becomesInTheory(roots, this.leavesOut, voice);
    const times = doubling(roots[0].re, voice);
    return [`${what} · ${times}`, what, inTheory(times, this.leavesOut, voice)];
  }

  /** @param {Voice} voice */
  #label(voice) {
    const { state } = this.#shown;
    return voice.say('histories.name', {
      state: voice.say(`state.${state}`), duration: voice.number(this.#span, decimalsOf(this.#span, 0)), start: this.#start(voice), reading: this.#readings(voice)[0],
    });
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paint = (context, size) => {
    const { voice, theme } = this;
    const histories = this.#histories;
    const { state } = this.#shown;
    if (!voice || !theme || !histories) return;
    drawLinearNonlinear(context, size, {
      time: histories.linear.time, linear: histories.linear[state], nonlinear: histories.nonlinear[state], state, duration: this.#span, limit: this.#axis.limit, readings: this.#readings(voice),
    }, theme, voice);
  };

  /** What of a case this gear has. @param {Case} one */
  #valuesOf({ parameters }) {
    const now = this.scene?.parameters ?? {};
    return Object.fromEntries(Object.entries(parameters).filter(([name]) => name in now));
  }

  /** @param {Case} one */
  #isNow(one) {
    return Object.entries(this.#valuesOf(one)).every(([name, value]) => this.scene?.parameters[name] === value);
  }

  /** Only what is another is set: what follows others need not be parted from them. @param {Case} one */
  #set(one) {
    const values = Object.fromEntries(Object.entries(this.#valuesOf(one)).filter(([name, value]) => this.scene?.parameters[name] !== value));
    if (Object.keys(values).length > 0) this.put(values);
  }

  /** @param {readonly Case[]} cases @param {Voice} voice */
  async #takeAlong(cases, voice) {
    const name = 'shimmy-linear-cases.csv';
    const outcome = await download(new Blob([casesCsv(cases)], { type: 'text/csv' }), name);
    this.said = outcome === 'cancelled' ? '' : voice.say(`out.${outcome}`, { file: name });
  }
}

customElements.define('shimmy-histories', LinearAndNonlinear);
