import { html } from 'lit';
import { tell } from '../command.js';
import { veil } from '../present/veil.js';
import { drawDeformationPortrait } from '../view/deformation-portrait.js';
import { firstLook } from '../view/look.js';
import { drawOrbit } from '../view/orbit.js';
import { drawPhasePortrait } from '../view/phase-portrait.js';
import { roundStep } from '../view/scale.js';
import { drawSpectrum, wordsOfPeak } from '../view/spectrum.js';
import { destination, orbitLabel } from './destination.js';
import { PlotLens } from './plot-lens.js';
import { Turning } from './turning.js';

/**
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {import('../run/scene.js').Scene} Scene
 * @typedef {import('../view/look.js').Look} Look
 * @typedef {import('../words/voice.js').Voice} Voice
 */

const degrees = 180 / Math.PI;
/** The spectrum shows the beat and its odd harmonics up to the fifth. */
const harmonicsShown = 5.5;

/**
 * The lens *Phase*: the motion in its state space, as ψ̇ over ψ, y over ψ, the whole orbit that a hand can turn, or by its
 * frequencies; and in one line the motion it settles on.
 */
export class PhaseLens extends PlotLens {
  static properties = { ...PlotLens.properties, time: { attribute: false } };

  #turning = new Turning(
    () => this.#keptLook,
    (degrees) => tell(this, 'view', { of: 'phase', shows: `orbit,${degrees}` }),
    () => this.canvas?.redraw(),
  );

  constructor() {
    super();
    /** Of the run, as it was told last, in s. */ this.time = 0;
  }

  /** Time alone changes only what is said of a spectrum. @param {Map<string, unknown>} changed */
  shouldUpdate(changed) {
    return changed.size > 1 || !changed.has('time') || this.view.startsWith('spectrum');
  }

  /** @param {string} name @param {Voice} voice */
  nameOfView(name, voice) {
    return voice.say(/** @type {import('../words/voice.js').Key} */ (`phase.view.${name}`));
  }

  /** @param {Voice} voice */
  label(voice) {
    const name = voice.say(/** @type {import('../words/voice.js').Key} */ (this.view === 'portrait' ? 'phase.name' : `phase.name.${this.view}`));
    const peak = this.view.startsWith('spectrum') ? this.scene?.spectrum()?.peak : null;
    return peak ? `${name} ${voice.say('phase.peak', { peak: wordsOfPeak(peak, this.scene?.scales.limits.angle ?? 0, voice) })}` : name;
  }

  /** @param {Voice} voice */
  line(voice) {
    const { interval } = this.view.startsWith('spectrum') && this.scene ? { interval: this.scene.spectrumSpan } : { interval: 0 };
    if (interval > 0) return html`<p>${voice.say('phase.spectrum.over', { time: voice.number(interval * 1000, 0) })}</p>`;
    return html`<p class="destination">${this.isVeiled ? veil(voice) : this.outlook ? destination(this.outlook, voice) : ''}</p>`;
  }

  /** @param {Voice} voice */
  plot(voice) {
    if (this.view !== 'orbit') return super.plot(voice);
    return html`<div class="turntable" tabindex="0" role="application" aria-label=${voice.say('phase.turn')} title=${voice.say('phase.turn')}
      @pointerdown=${this.#turning.grab} @pointermove=${this.#turning.drag} @pointerup=${this.#turning.release} @pointercancel=${this.#turning.release}
      @keydown=${this.#turning.key}>${super.plot(voice)}</div>`;
  }

  /** @type {PlotLens['paintScene']} */
  paintScene(context, size, scene, theme, voice) {
    if (this.view.startsWith('spectrum')) {
      this.#paintSpectrum(context, size, scene, theme, voice);
      return;
    }
    const { outlook, scales, orbitPast, state, parameters } = scene;
    const motion = {
      limits: scales.limits,
      trail: orbitPast,
      orbit: outlook.orbit,
      orbitLabel: orbitLabel(outlook, voice),
      state,
      exposed: scene.exposed,
      freeplay: parameters.freeplayAngle ?? 0,
      ghosts: this.ghostsOf(scene, voice),
      veiled: this.isVeiled,
    };
    if (this.view === 'orbit') drawOrbit(context, size, { ...motion, look: this.#turning.look }, theme, voice);
    else if (this.view === 'deformation') drawDeformationPortrait(context, size, motion, theme, voice);
    else drawPhasePortrait(context, size, motion, theme, voice);
  }

  /** @type {PlotLens['paintScene']} */
  #paintSpectrum(context, size, scene, theme, voice) {
    const spectrum = scene.spectrum() ?? { frequency: new Float64Array(), amplitude: new Float64Array(), peak: null };
    const beat = scene.frequency ?? 50;
    const limits = { frequency: Math.ceil((harmonicsShown * beat) / roundStep(beat)) * roundStep(beat), amplitude: scene.scales.limits.angle };
    drawSpectrum(context, size, { spectrum, limits, isLogarithmic: this.view === 'spectrum-log' }, theme, voice);
  }

  /** As the state has it. @returns {Look} */
  get #keptLook() {
    const [, yaw, pitch] = this.shows.split(',').map(Number);
    return Number.isFinite(yaw) && Number.isFinite(pitch) ? { yaw: yaw / degrees, pitch: pitch / degrees } : firstLook;
  }
}

customElements.define('shimmy-phase-lens', PhaseLens);
