import { html, nothing } from 'lit';
import { engineIfLoaded } from '../../engine/engine.js';
import { errorsOf, identifiabilityOf } from '../../engine/fitness.js';
import '../../view/canvas.js';
import { drawErrors } from '../../view/damper/errors.js';
import { drawLoops } from '../../view/damper/loops.js';
import { drawPopulation } from '../../view/damper/population.js';
import { roundLimit } from '../../view/scale.js';
import { boundsTable, genesOf } from './identify/bounds.js';
import { measuredForm } from './identify/measured.js';
import { ranksOf, symbolRuns, writeValue } from './identify/say.js';
import { resultPart } from './identify/result.js';
import { thinned } from './identify/thin.js';
import { Workbench } from './identify/workbench.js';
import { mostOf } from './loops.js';
import { DamperPanel } from './panel.js';
import { damperNames } from './settings.js';

/**
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('../../view/canvas.js').Paint} Paint
 */

/** The page lets others have their turn between two generations. */
const turn = () => new Promise((/** @type {(value: void) => void} */ resolve) => { setTimeout(resolve); });

/** What lies here is still there when one comes back from another lens. */
const bench = new Workbench({
  begin: (spec) => new (engineIfLoaded().Identification)(spec),
  errors: errorsOf, identifiability: identifiabilityOf, turn,
});

/**
 * The workbench on which a damper's values are found: records from a file or made here, the model and its bounds, the generations as
 * they go, and what came of it. Commands: `fitDamper` with the damper that was found.
 */
export class DamperIdentify extends DamperPanel {
  static properties = { ...DamperPanel.properties, isOver: { state: true }, said: { state: true } };

  /** The workbench, for what is drawn from it. */ bench = bench;
  #frame = 0;

  constructor() {
    super();
    /** Whether a file is held over it. */ this.isOver = false;
    /** What came of a file that was asked for. */ this.said = '';
  }

  connectedCallback() {
    super.connectedCallback();
    bench.onChange = () => {
      this.#frame ||= requestAnimationFrame(() => {
        this.#frame = 0;
        this.requestUpdate();
      });
    };
  }

  disconnectedCallback() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    bench.onChange = () => {};
    super.disconnectedCallback();
  }

  /** The table of the model that is fitted. */
  get fitted() {
    return this.tableOf(bench.model);
  }

  /** @param {Voice} voice */
  content(voice) {
    const { fitted } = this;
    if (!fitted) return html``;
    const { fit, isBusy, records } = bench;
    return html`
      <div class="panel-scroll identify ${this.isOver ? 'over' : ''}" tabindex="0" role="group" aria-label=${voice.say('damper.view.identify')} @dragover=${this.#over} @dragleave=${this.#out} @drop=${this.#dropped}>
        ${measuredForm(this, voice)}
        <section>
          <h2>${voice.say('identify.fit')}</h2>
          <div class="identify-row">
            <select class="framed" aria-label=${voice.say('damper.model')} ?disabled=${isBusy} .value=${bench.model} @change=${(/** @type {Event} */ event) => this.#choose(event)}>
              ${damperNames.map((name) => html`<option value=${name} ?selected=${name === bench.model}>${voice.say(`damper.model.${name}`)}</option>`)}
            </select>
            ${this.#number('population', [4, 400], voice)} ${this.#number('generations', [1, 5000], voice)} ${this.#number('seed', [0, 999999], voice)} ${this.#number('seeds', [1, 9], voice)}
          </div>
          ${boundsTable(this, fitted, voice)}
          <div class="identify-row">
            ${isBusy ? html`
              <button type="button" class="primary" @click=${() => (fit?.state === 'paused' ? bench.goOn() : bench.pause())}>${voice.say(fit?.state === 'paused' ? 'identify.goOn' : 'identify.pause')}</button>
              <button type="button" class="framed" @click=${() => bench.stop()}>${voice.say('identify.stop')}</button>`
            : html`<button type="button" class="primary" ?disabled=${records.length === 0} @click=${() => bench.start()}>${voice.say(bench.fits.length > 0 ? 'identify.replay' : 'identify.start')}</button>`}
            <p role="status">${this.#progress(voice)}</p>
          </div>
          ${bench.problem || fit?.problem ? html`<p class="refused" role="alert"><span aria-hidden="true">⚠ </span>${voice.say('identify.failed', { reason: reasonOf(bench.problem ?? fit?.problem) })}</p>` : nothing}
        </section>
        ${records.length > 0 ? html`
          <shimmy-canvas class="identify-loops" .label=${voice.say('identify.loops.name')} .paint=${this.#paintLoops}></shimmy-canvas>` : nothing}
        ${fit ? html`
          <shimmy-canvas class="identify-errors" .label=${voice.say('identify.errors.name', { error: this.#errorInWords(voice) })} .paint=${this.#paintErrors}></shimmy-canvas>
          <shimmy-canvas class="identify-population" .label=${voice.say('identify.population.name')} .paint=${this.#paintPopulation}></shimmy-canvas>` : nothing}
        ${resultPart(this, voice)}
      </div>`;
  }

  /** @param {'population' | 'generations' | 'seed' | 'seeds'} name @param {[number, number]} range @param {Voice} voice */
  #number(name, [least, most], voice) {
    return html`<label>${voice.say(`identify.${name}`)} <input type="text" inputmode="numeric" class="number" ?disabled=${bench.isBusy} .value=${String(bench[name])}
      @change=${(/** @type {Event} */ event) => {
        const field = /** @type {HTMLInputElement} */ (event.target);
        const value = Number(field.value);
        if (Number.isInteger(value) && value >= least && value <= most) bench[name] = value;
        field.value = String(bench[name]);
      }} /></label>`;
  }

  /** @param {Event} event */
  #choose(event) {
    bench.model = /** @type {HTMLSelectElement} */ (event.target).value;
    bench.bounds = {};
    bench.fits = [];
    bench.known = null;
    this.requestUpdate();
  }

  /** @param {Voice} voice */
  #errorInWords = (voice) => {
    const error = bench.fit?.best.at(-1);
    return error === undefined || Number.isNaN(error) ? '–' : `${voice.number(100 * error, 2)} %`;
  };

  /** @param {Voice} voice */
  #progress(voice) {
    const { fit, fits } = bench;
    if (!fit) return bench.records.length === 0 ? voice.say('identify.empty') : '';
    const values = { seed: fit.seed, place: fits.length, seeds: bench.seeds, generation: fit.best.length, error: this.#errorInWords(voice) };
    return voice.say(fit.state === 'running' && fit.last?.polishing ? 'identify.state.polishing' : `identify.state.${fit.state}`, values);
  }

  /** @param {DragEvent} event */
  #over = (event) => {
    event.preventDefault();
    this.isOver = true;
  };

  #out = () => {
    this.isOver = false;
  };

  /** @param {DragEvent} event */
  #dropped = (event) => {
    event.preventDefault();
    this.isOver = false;
    this.open([...(event.dataTransfer?.files ?? [])]);
  };

  /** One file after the other. @param {readonly File[]} files */
  async open(files) {
    for (const file of files) await bench.open(file);
  }

  /** The loops of what is best so far over what was measured. @type {Paint} */
  #paintLoops = (context, size) => {
    const { voice, theme } = this;
    if (!voice || !theme) return;
    const records = thinned(bench.records, 4000);
    const found = bench.fit?.result?.fits ?? bench.known?.fits ?? [];
    const data = records.map((record) => ({ displacement: record.displacement, velocity: record.velocity ?? slopes(record.displacement, record.interval), force: record.force }));
    const loops = found.length === data.length ? data.map((one, i) => ({ ...one, force: found[i].force, label: this.#commandOf(records[i].command, voice), isOpen: true })) : [];
    const most = (/** @type {'displacement' | 'velocity' | 'force'} */ name) => roundLimit(Math.max(1e-12, ...data.map((one) => mostOf(one[name]))));
    drawLoops(context, size, { loops, data, limits: { displacement: most('displacement'), velocity: most('velocity'), force: most('force') } }, theme, voice);
  };

  /** @param {number} command @param {Voice} voice */
  #commandOf(command, voice) {
    return `${voice.number(command, 2).replace(/[.,]?0+$/, '') || '0'} ${this.fitted?.command.unit ?? 'A'}`;
  }

  /** @type {Paint} */
  #paintErrors = (context, size) => {
    const { voice, theme } = this;
    if (!voice || !theme) return;
    drawErrors(context, size, { runs: bench.fits.map(({ best, mean }) => ({ best, mean })), names: { best: voice.say('identify.best'), mean: voice.say('identify.mean') } }, theme, voice);
  };

  /** @type {Paint} */
  #paintPopulation = (context, size) => {
    const { voice, theme, fitted } = this;
    const { fit, known, truth } = bench;
    if (!voice || !theme || !fitted || !fit) return;
    const genes = genesOf(fitted, bench.bounds);
    const width = fitted.parameters.length;
    const individuals = Array.from({ length: fit.errors.length }, (_, i) => genes.map(({ place }) => fit.population[i * width + place]));
    const best = fit.last && genes.map(({ parameter }) => /** @type {NonNullable<typeof fit.last>} */ (fit.last).best[parameter.name]);
    const axes = genes.map(({ parameter, low, high, isLog }) => ({
      name: symbolRuns(parameter.symbol), min: low, max: high, isLog, write: (/** @type {number} */ value) => writeValue(value, voice), isLoose: known?.parameters.find(({ name }) => name === parameter.name)?.fixed === false,
    }));
    const made = truth?.model === bench.model ? genes.map(({ parameter }) => truth.parameters[parameter.name] ?? parameter.default) : null;
    drawPopulation(context, size, { axes, individuals, best, known: made, ranks: ranksOf(fit.errors) }, theme);
  };
}

/** @param {Float64Array} values @param {number} interval */
function slopes(values, interval) {
  const last = values.length - 1;
  return values.map((_, i) => (values[Math.min(last, i + 1)] - values[Math.max(0, i - 1)]) / (interval * (Math.min(last, i + 1) - Math.max(0, i - 1))));
}

/** @param {unknown} error */
const reasonOf = (error) => (error instanceof Error ? error.message : String(error));

customElements.define('shimmy-damper-identify', DamperIdentify);
