import { html } from 'lit';
import { tell } from '../../command.js';
import '../../controls/knob.js';
import { Quantity } from '../../controls/quantity.js';
import { isSameList } from '../../store.js';
import { Panel } from '../stability/panel.js';
import { amplitudes, chosenOf, currentsOf, damperOf, damperNames, frequencies, motionOf, writeMotion } from './settings.js';

/**
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('../../words/voice.js').Key} Key
 * @typedef {import('../../run/damper-looks.js').DamperTable} DamperTable
 * @typedef {import('../../run/damper-looks.js').Damper} Damper
 * @typedef {import('../../run/damper-looks.js').Cycle} Cycle
 */

/** @param {string} name @param {string} symbol @param {string} unit @param {{ min: number, max: number, usual: number }} range */
const sliderOf = (name, symbol, unit, { min, max, usual }) =>
  new Quantity({ name, symbol, unit, default: usual, min, max, scale: 'log', doc: '' });
const amplitude = sliderOf('pistonAmplitude', 'X', 'mm', amplitudes);
const frequency = sliderOf('pistonFrequency', 'f', 'Hz', frequencies);

/** What the views of the lens *Damper* share: whose loops, how its piston is moved, at which commands. */
export class DamperPanel extends Panel {
  /** What each picture was drawn from last, by its selector. @type {Map<string, readonly unknown[]>} */ #drawn = new Map();
  /** Answers of the engine, by what they depend on. @type {Map<string, Cycle | null>} */ #cycles = new Map();

  /** A lens of a damper by itself looks at no gear: it is there as soon as the engine is. */
  render() {
    const { voice, scene } = this;
    return voice && scene ? this.content(voice, scene) : html``;
  }

  get dampers() {
    return this.scene?.dampers.tables ?? [];
  }

  /** The table of the damper that is looked at. @returns {DamperTable | null} */
  get table() {
    return this.tableOf(damperOf(this.settings.damperModel ?? ''));
  }

  /** @param {string} name */
  tableOf(name) {
    return this.dampers.find((one) => one.name === name) ?? null;
  }

  get motion() {
    return motionOf(this.settings.damperMotion ?? '');
  }

  get currents() {
    const { table } = this;
    return table ? currentsOf(this.settings.damperCurrents ?? '', table.command) : [];
  }

  get chosen() {
    return chosenOf(this.settings.damperCurrent ?? '', this.currents);
  }

  /** A settled cycle on the bench; null for a motion that the engine refuses. @param {Damper} damper @param {import('./settings.js').Motion} [motion] */
  cycleOf(damper, motion = this.motion) {
    const key = JSON.stringify([damper, motion]);
    const known = this.#cycles.get(key);
    if (known !== undefined) return known;
    if (this.#cycles.size > 200) this.#cycles.clear();
    let cycle = null;
    try {
      cycle = this.scene?.dampers.cycle(damper, motion) ?? null;
    } catch {
      // A motion so wild that no number comes of it.
    }
    this.#cycles.set(key, cycle);
    return cycle;
  }

  /** Draws a picture anew where what it is drawn from has changed. @param {string} selector @param {readonly unknown[]} from */
  redrawWhere(selector, from) {
    if (isSameList(this.#drawn.get(selector) ?? [], from)) return;
    this.#drawn.set(selector, from);
    /** @type {import('../../view/canvas.js').Canvas | null} */ (this.querySelector(selector))?.redraw();
  }

  /** @param {string} of @param {string} shows */
  choose(of, shows) {
    tell(this, 'view', { of, shows });
  }

  /** Which damper. @param {Voice} voice */
  modelChoice(voice) {
    const { table } = this;
    return html`
      <select class="framed damper-model" aria-label=${voice.say('damper.model')} title=${voice.say('damper.model')} .value=${table?.name ?? ''}
        @change=${(/** @type {Event} */ event) => this.choose('damperModel', /** @type {HTMLSelectElement} */ (event.target).value)}>
        ${damperNames.map((name) => html`<option value=${name} ?selected=${name === table?.name}>${voice.say(`damper.model.${name}`)}</option>`)}
      </select>`;
  }

  /** Amplitude and frequency of the bench. @param {Voice} voice */
  motionKnobs(voice) {
    const { motion } = this;
    const set = (/** @type {Partial<typeof motion>} */ change) => { this.choose('damperMotion', writeMotion({ ...motion, ...change })); return null; };
    // What a slider means is told by its name: there is nothing in the gear's tables to explain.
    const own = (/** @type {Event} */ event) => { if (['explain', 'settle'].includes(/** @type {CustomEvent} */ (event).detail.name)) event.stopPropagation(); };
    return html`
      <div class="damper-knobs" @command=${own}>
        <shimmy-knob data-place="damper" data-name="pistonAmplitude" .quantity=${amplitude} .value=${Number((1000 * motion.amplitude).toPrecision(6))} .usual=${amplitudes.usual} .voice=${voice}
          .change=${(/** @type {string} */ _, /** @type {number} */ value) => this.#within(value, amplitudes) ?? set({ amplitude: value / 1000 })}></shimmy-knob>
        <shimmy-knob data-place="damper" data-name="pistonFrequency" .quantity=${frequency} .value=${motion.frequency} .usual=${frequencies.usual} .voice=${voice}
          .change=${(/** @type {string} */ _, /** @type {number} */ value) => this.#within(value, frequencies) ?? set({ frequency: value })}></shimmy-knob>
      </div>`;
  }

  /** Why a typed value is not taken. @param {number} value @param {{ min: number, max: number }} range @returns {import('../../controls/refusal.js').Refusal | null} */
  #within(value, { min, max }) {
    return value >= min && value <= max ? null : { code: 'out-of-range', allowed: `${min} … ${max}` };
  }

  /** A command with its unit: `0.5 A`. @param {number} command @param {Voice} voice */
  commandOf(command, voice) {
    return `${voice.number(command, Math.min(3, (String(command).split('.')[1] ?? '').length))} ${this.table?.command.unit ?? 'A'}`;
  }
}
