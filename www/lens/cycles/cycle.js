import { html, nothing } from 'lit';
import { tell } from '../../command.js';
import { symbolOf } from '../../controls/symbol.js';
import '../../view/canvas.js';
import { drawMultipliers } from '../../view/multipliers.js';
import { Turning } from '../turning.js';
import { OrbitPicture } from './orbit-picture.js';
import { CyclePanel } from './panel.js';
import { amplitudeOf, kindOf, multiplierInWords, multipliersOf, nearnessInWords } from './say.js';
import { lookOf, orbitOf, orbitViews } from './settings.js';

/**
 * @typedef {import('../../run/cycle-looks.js').LimitCycle} LimitCycle
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

/** The run is on the cycle when it goes to one as wide as it, to this share. */
const same = 0.02;
const symbols = /** @type {const} */ ({ torsionAngle: 'ψ', torsionRate: 'ψ̇', lateralDeformation: 'y' });

/**
 * The limit cycle of the gear as it is: its orbit with the motion on its way to it, how wide and how fast it is, and what
 * becomes of an aside in one turn. Commands: `view` with how the orbit is drawn.
 */
export class Cycle extends CyclePanel {
  #turning = new Turning(
    () => lookOf(this.settings.cycleOrbit ?? ''),
    (degrees) => tell(this, 'view', { of: 'cycleOrbit', shows: `space,${degrees}` }),
    () => { if (this.scene && this.theme) this.draw(this.scene, this.theme); },
  );
  #picture = new OrbitPicture();

  get #orbit() {
    return orbitOf(this.settings.cycleOrbit ?? '');
  }

  render() {
    const { voice, scene } = this;
    return voice && scene ? this.content(voice) : html``;
  }

  /** @param {Voice} voice */
  content(voice) {
    const { isVeiled } = this;
    const cycle = isVeiled ? null : this.cycle;
    const { name } = this.#orbit;
    // The circle and the orbit change places where that is chosen.
    const isCircle = name === 'multipliers';
    const circle = { label: this.#multipliersInWords(cycle, voice), paint: this.#paintMultipliers };
    const orbit = { label: this.#label(cycle, voice), paint: this.#paintOrbit };
    const [large, small] = isCircle ? [circle, orbit] : [orbit, circle];
    const canvas = html`<shimmy-canvas class="cycle-orbit" .label=${large.label} .paint=${large.paint}></shimmy-canvas>`;
    return html`
      <div class="cycle">
        <div class="cycle-picture">
          ${name === 'space' ? html`<div class="turntable" tabindex="0" role="application" aria-label=${voice.say('phase.turn')} title=${voice.say('phase.turn')}
            @pointerdown=${this.#turning.grab} @pointermove=${this.#turning.drag} @pointerup=${this.#turning.release} @pointercancel=${this.#turning.release} @keydown=${this.#turning.key}>${canvas}</div>` : canvas}
          <select class="framed orbit-view" aria-label=${voice.say('cycle.drawn')} .value=${name}
            @change=${(/** @type {Event} */ event) => tell(this, 'view', { of: 'cycleOrbit', shows: /** @type {HTMLSelectElement} */ (event.target).value })}>
            ${orbitViews.map((one) => html`<option value=${one} ?selected=${one === name}>${voice.say(`cycle.orbit.${one}`)}</option>`)}
          </select>
        </div>
        <shimmy-canvas class="multipliers" .label=${small.label} .paint=${small.paint}></shimmy-canvas>
        ${isVeiled ? this.veil(voice) : this.#facts(cycle, voice)}
      </div>`;
  }

  /** @param {LimitCycle | null} cycle @param {Voice} voice */
  #facts(cycle, voice) {
    if (!cycle) return html`<div class="cycle-facts"><div role="status"><h2>${this.#isFar ? voice.say('stability.none') : voice.say('cycle.none')}</h2></div></div>`;
    const { amplitude, frequency, period } = cycle;
    const { along, others } = multipliersOf(cycle.multipliers);
    return html`
      <div class="cycle-facts">
        <div role="status"><h2 class=${cycle.stable ? '' : 'is-unstable'}>${kindOf(cycle, voice)}</h2></div>
        <dl>
          <div><dt>${voice.say('cycle.frequency')}</dt><dd>${voice.number(frequency ?? NaN, 3)} Hz <span class="spare">${voice.number(1000 * (period ?? NaN), 3)} ms</span></dd></div>
          ${Object.entries(amplitude).map(([name, value]) => html`
            <div class=${name === 'torsionAngle' ? '' : 'spare'}><dt>${symbolOf(symbols[/** @type {'torsionAngle'} */ (name)] ?? '')} ${voice.say(/** @type {import('../../words/voice.js').Key} */ (`state.${name}`))}</dt><dd>${amplitudeOf(name, value, voice)}${name === 'torsionAngle' ? html` <span class="spare">${voice.number(value, 5)} rad</span>` : nothing}</dd></div>`)}
          <div><dt>${voice.say('cycle.multipliers')}</dt><dd>${others.filter(({ im }) => im >= 0).map((one) => multiplierInWords(one, voice)).join('; ')}${along ? html` <span class="spare">${voice.say('cycle.trivial')}</span>` : nothing}</dd></div>
        </dl>
        <p class="spare">${nearnessInWords(cycle, voice)}</p>
        ${this.#elsewhere(cycle, voice)}
      </div>`;
  }

  /** What to do where the run goes to another motion than the one shown. @param {LimitCycle} cycle @param {Voice} voice */
  #elsewhere({ amplitude }, voice) {
    const { outlook } = this;
    if (!outlook || this.watch?.isOwed) return nothing;
    const goal = outlook.verdict === 'shimmies' || outlook.verdict === 'rattles' ? outlook.amplitude.torsionAngle : 0;
    if (Math.abs(goal - amplitude.torsionAngle) <= same * amplitude.torsionAngle) return nothing;
    if (goal === 0) return html`<p>${voice.say(outlook.verdict === 'grows' ? 'cycle.run.grows' : 'cycle.run.rests')}</p>`;
    return html`<p>${voice.say('cycle.run.other', { amplitude: amplitudeOf('torsionAngle', goal, voice) })}
      <button type="button" class="framed" @click=${this.#follow}>${voice.say('cycle.run.follow')}</button></p>`;
  }

  #follow = () => {
    if (!this.scene || !this.watch) return;
    this.watch.goTo(this.scene, null, performance.now());
    this.requestUpdate();
  };

  /** Whether nothing could be computed. */
  get #isFar() {
    return this.watch?.cycle === null && !this.watch.isOwed;
  }

  /** @param {LimitCycle | null} cycle @param {Voice} voice */
  #label(cycle, voice) {
    if (this.isVeiled) return voice.say('cycle.name.veiled');
    if (!cycle) return voice.say('cycle.name.none');
    return voice.say('cycle.name', { kind: kindOf(cycle, voice), amplitude: amplitudeOf('torsionAngle', cycle.amplitude.torsionAngle, voice), frequency: voice.number(cycle.frequency ?? NaN, 1) });
  }

  /** @param {LimitCycle | null} cycle @param {Voice} voice */
  #multipliersInWords(cycle, voice) {
    if (this.isVeiled) return voice.say('cycle.multipliers.veiled');
    const list = cycle ? multipliersOf(cycle.multipliers).others.map((one) => multiplierInWords(one, voice)).join('; ') : '–';
    return voice.say('cycle.multipliers.name', { list });
  }

  /** The motion itself goes on each frame. @param {import('../../run/scene.js').Scene} scene @param {import('../../style/theme.js').Theme} theme */
  draw(scene, theme) {
    super.draw(scene, theme);
    this.#picture.hold(scene, this.isVeiled ? null : this.cycle);
    const moving = this.#orbit.name === 'multipliers' ? '.multipliers' : '.cycle-orbit';
    /** @type {import('../../view/canvas.js').Canvas | null} */ (this.querySelector(moving))?.redraw();
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paintOrbit = (context, size) => {
    const { voice, theme, scene, isVeiled } = this;
    if (!voice || !theme || !scene) return;
    this.#picture.paint(context, size, { scene, cycle: isVeiled ? null : this.cycle, name: this.#orbit.name, look: this.#turning.look, veiled: isVeiled }, theme, voice);
  };

  /** @type {import('../../view/canvas.js').Paint} */
  #paintMultipliers = (context, size) => {
    const { voice, theme, isVeiled } = this;
    if (!voice || !theme) return;
    drawMultipliers(context, size, { ...multipliersOf((isVeiled ? null : this.cycle)?.multipliers ?? []), veiled: isVeiled }, theme, voice);
  };
}

customElements.define('shimmy-cycle', Cycle);
