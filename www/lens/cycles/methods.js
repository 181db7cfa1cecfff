import { html, nothing } from 'lit';
import { valuesLine } from '../../out/values-line.js';
import '../../view/canvas.js';
import { quantities as shown, valueOf } from '../../view/quantities.js';
import { roundLimit } from '../../view/scale.js';
import { drawThreeMethods } from '../../view/three-methods.js';
import { decimalsFor } from '../../words/number.js';
import { figuresTable } from '../stability/figures-table.js';
import { lowerName } from '../stability/say.js';
import { amplitudeColumn, figureColumn, parameterColumn } from './columns.js';
import { RowsPanel } from './rows-panel.js';
import { digitsOf } from './say.js';
import { methodsBelowOf, methodsBelows } from './settings.js';
import { tableOutButtons } from './table-out.js';
import { methodByMethod, offBy, threeMethods } from './three-methods.js';

/**
 * @typedef {import('./three-methods.js').Answer} Answer
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {{ spec: number, answer: Answer | null, isOld: boolean }} Row `spec`: the speed, in m/s
 */

const methods = /** @type {const} */ (['describing', 'shooting', 'simulation']);
/** Speeds of the curves, in m/s; the table has every other. */
const [from, to, step] = [30, 100, 5];
const speeds = Array.from({ length: (to - from) / step + 1 }, (_, i) => from + i * step);
const isOfTable = (/** @type {{ spec: number }} */ { spec }) => (spec - from) % (2 * step) === 0;
/** The file has more columns than there is room for. */
const spare = ['describingFrequency', 'simulationFrequency'];
const percent = 100;

/**
 * Three methods, one number: the amplitude and the frequency of the gear's cycle by describing functions, by shooting and by
 * simulation, side by side with what sets them apart; and the same over the speed. Commands: `view` with how the table is
 * sorted, `point` with a speed.
 * @extends {RowsPanel<number, Answer>}
 */
export class ThreeMethods extends RowsPanel {
  /** Of the gear as it is, and of which; null while nothing is known. @type {{ key: string, answer: Answer | null } | null} */ #here = null;
  /** What is being asked of the gear, a method a frame. @type {{ key: string, steps: Generator<void, Answer, void> } | null} */ #asking = null;
  #next = 0;
  /** The axis holds while a slider moves. @type {{ scales: object | null, limit: number }} */ #axis = { scales: null, limit: 1 };

  wanted() {
    const { scene } = this;
    if (!scene || !this.quantity('velocity')) return null;
    const others = Object.entries(scene.parameters).filter(([name]) => name !== 'velocity');
    return { key: JSON.stringify([scene.object, others]), shape: 'speeds', specs: speeds };
  }

  /** @param {number} velocity @param {Answer | null} before */
  answer(velocity, before) {
    return this.askCycles((cycles) => threeMethods(cycles, { velocity }, before?.cycle ?? null));
  }

  disconnectedCallback() {
    cancelAnimationFrame(this.#next);
    this.#next = 0;
    super.disconnectedCallback();
  }

  /** @param {import('../../run/scene.js').Scene} scene @param {import('../../style/theme.js').Theme} theme */
  draw(scene, theme) {
    super.draw(scene, theme);
    if (!this.isVeiled && this.#keyOf(scene) !== this.#here?.key) this.#next ||= requestAnimationFrame(this.#ask);
  }

  /** @param {import('../../run/scene.js').Scene} scene */
  #keyOf({ object, parameters }) {
    return JSON.stringify([object, parameters]);
  }

  /** A method more of the gear as it is. One that is asked is asked to the end, though the gear has changed: a hand that drags sees it follow. */
  #ask = () => {
    this.#next = 0;
    const { scene, cycle } = this;
    if (!scene || this.isVeiled || !this.isConnected) return;
    this.#asking ??= { key: this.#keyOf(scene), steps: methodByMethod(scene.cycles, {}, cycle) };
    const { key, steps } = this.#asking;
    try {
      const { done, value } = steps.next();
      if (done) this.#here = { key, answer: value };
    } catch {
      // Values so wild that no number comes of them.
      this.#here = { key, answer: null };
    }
    if (this.#here?.key === key) {
      this.#asking = null;
      this.requestUpdate();
    }
    if (this.#here?.key !== this.#keyOf(scene)) this.#next = requestAnimationFrame(this.#ask);
  };

  /** @param {Voice} voice @param {import('../../run/scene.js').Scene} scene */
  content(voice, scene) {
    const here = this.#here;
    const velocity = this.quantity('velocity');
    const columns = velocity ? this.#columns(velocity, voice) : [];
    const sorting = this.settings.methodsSort ?? '';
    const below = methodsBelowOf(this.settings.methodsBelow ?? '');
    const note = valuesLine(this.quantities.filter(({ name }) => name !== 'velocity'), scene.parameters, voice);
    return html`
      <div class="panel-scroll methods" tabindex="0" role="group" aria-label=${voice.say('cycles.view.methods')}>
        ${here?.answer ? this.#sideBySide(here.answer, voice) : html`<p class="panel-empty">${voice.say(here ? 'stability.none' : 'methods.computing')}</p>`}
        ${velocity ? html`
          <select class="framed ready" aria-label=${voice.say('methods.below')} title=${voice.say('methods.below')} .value=${below}
            @change=${(/** @type {Event} */ event) => this.choose('methodsBelow', /** @type {HTMLSelectElement} */ (event.target).value)}>
            ${methodsBelows.map((one) => html`<option value=${one} ?selected=${one === below}>${voice.say(`methods.below.${one}`)}</option>`)}
          </select>
          ${below === 'curves' ? html`<div class="methods-plot"><shimmy-canvas .label=${voice.say('methods.plot', { from, to })} .paint=${this.#paint}></shimmy-canvas></div>` : html`
          ${figuresTable(this, { caption: voice.say('methods.table', { from, to }), columns: columns.filter(({ name }) => !spare.includes(name)), rows: this.items.filter(isOfTable), of: 'methodsSort', sorting, classOf: ({ spec, isOld }) => [this.isNow({ velocity: spec }) ? 'now' : '', isOld ? 'old' : ''].join(' ') }, voice)}
          <p class="table-out">
            ${tableOutButtons({ said: this.said, take: (format) => this.take(format, { file: 'shimmy-three-methods', title: voice.say('methods.table', { from, to }), note, columns, rows: this.items.filter(isOfTable) }, sorting, voice) }, voice)}
          </p>`}` : nothing}
      </div>`;
  }

  /** @param {Answer} answer @param {Voice} voice */
  #sideBySide(answer, voice) {
    const { shooting } = answer;
    const states = /** @type {const} */ (['torsionAngle', 'lateralDeformation']);
    const value = (/** @type {typeof states[number]} */ name, /** @type {number} */ amplitude) => valueOf(shown[name], amplitude, digitsOf(amplitude * shown[name].perSI), voice);
    const cell = (/** @type {string} */ text, /** @type {number | null} */ share) => html`<td class="figure">${text}${share === null ? nothing : html`<span class="off">${signedPercent(share, voice)}</span>`}</td>`;
    return html`
      <div class="figures-table three" role="region" tabindex="0" aria-label=${voice.say('methods.here')}><table>
        <caption>${voice.say('methods.here')}</caption>
        <thead><tr><td></td>${methods.map((method) => html`<th scope="col" class="figure">${voice.say(`methods.${method}`)}</th>`)}</tr></thead>
        <tbody>
          ${states.map((name) => html`<tr><th scope="row">${shown[name].symbol} <span class="word">${voice.say(`state.${name}`)}</span></th>${methods.map((method) => {
            const number = answer[method];
            return cell(number ? `±${value(name, number[name])}` : voice.say('methods.none'), method === 'shooting' ? null : offBy(number, shooting, name));
          })}</tr>`)}
          <tr><th scope="row">f <span class="word">${voice.say('cycle.frequency').toLocaleLowerCase(voice.language)}</span></th>${methods.map((method) => {
            const number = answer[method];
            return cell(number ? `${voice.number(number.frequency, 3)} Hz` : '–', method === 'shooting' ? null : offBy(number, shooting, 'frequency'));
          })}</tr>
        </tbody>
      </table></div>`;
  }

  /** @param {import('../../controls/quantity.js').Quantity} velocity @param {Voice} voice @returns {import('./table-out.js').OutColumn<Row>[]} */
  #columns(velocity, voice) {
    const press = {
      does: (/** @type {Row} */ { spec }) => voice.say('tables.set', { values: `${lowerName(velocity, voice)} ${velocity.write(spec, voice)}` }),
      set: (/** @type {Row} */ { spec }) => this.setOthers({ velocity: spec }),
    };
    const amplitude = (/** @type {typeof methods[number]} */ method) =>
      amplitudeColumn('torsionAngle', (/** @type {Row} */ { answer }) => answer?.[method]?.torsionAngle ?? null, voice, { name: method, of: voice.say(`methods.${method}.short`) });
    const off = (/** @type {'describing' | 'simulation'} */ method) => figureColumn({
      name: `${method}Off`, unit: '%', head: `Δ ${voice.say(`methods.${method}.short`)}, %`, digits: 2, isSigned: true,
      value: (/** @type {Row} */ { answer }) => { const share = offBy(answer?.[method] ?? null, answer?.shooting ?? null, 'torsionAngle'); return share === null ? null : Number((percent * share).toFixed(5)); },
    }, voice);
    const frequency = (/** @type {typeof methods[number]} */ method) => figureColumn({
      name: `${method}Frequency`, unit: 'Hz', head: `f ${voice.say(`methods.${method}.short`)}, Hz`, digits: 5, value: (/** @type {Row} */ { answer }) => answer?.[method]?.frequency ?? null,
    }, voice);
    return [
      parameterColumn(velocity, (/** @type {Row} */ { spec }) => spec, voice, press),
      amplitude('shooting'), { ...amplitude('describing'), isSpare: true }, off('describing'), { ...amplitude('simulation'), isSpare: true }, off('simulation'), { ...frequency('shooting'), isSpare: true }, frequency('describing'), frequency('simulation'),
    ];
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paint = (context, size) => {
    const { voice, theme, scene, items } = this;
    const quantity = this.quantity('velocity');
    if (!voice || !theme || !scene || !quantity) return;
    const places = items.map(({ spec, answer }) => ({
      value: spec, describing: answer?.describing?.torsionAngle ?? null, shooting: answer?.shooting?.torsionAngle ?? null, simulation: isOfTable({ spec }) ? answer?.simulation?.torsionAngle ?? null : null,
    }));
    this.#hold(places.flatMap(({ describing, shooting, simulation }) => [describing ?? 0, shooting ?? 0, simulation ?? 0]), scene.scales);
    const names = { describing: voice.say('methods.describing'), shooting: voice.say('methods.shooting'), simulation: voice.say('methods.simulation') };
    drawThreeMethods(context, size, { quantity, from, to, now: scene.parameters.velocity, places, limit: this.#axis.limit, names }, theme, voice);
  };

  /** @param {number[]} amplitudes @param {object} scales */
  #hold(amplitudes, scales) {
    const most = Math.max(...amplitudes, 1e-4);
    if (this.#axis.scales === scales && most <= this.#axis.limit && most > 0.25 * this.#axis.limit) return;
    this.#axis = { scales, limit: (roundLimit((most * 180) / Math.PI) * Math.PI) / 180 };
  }
}

/** @param {number} share @param {Voice} voice */
function signedPercent(share, voice) {
  const value = percent * share;
  if (Math.abs(value) < 0.0005) return voice.say('methods.same');
  return voice.say('methods.percent', { share: `${value > 0 ? '+' : ''}${voice.number(value, Math.min(3, decimalsFor(value, 2)))}` });
}

customElements.define('shimmy-methods', ThreeMethods);
