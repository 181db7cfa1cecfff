import { html } from 'lit';
import { gapParameter } from '../../view/stability-map.js';
import { planeChoices } from './choices.js';
import './plane.js';
import { PlaneMap } from './plane-map.js';
import { RangeFields } from './range-fields.js';
import { RootsAndSwing } from './roots-and-swing.js';
import { lowerName, rangeInWords } from './say.js';
import { planeOf } from './settings.js';

/**
 * @typedef {import('../../run/scene.js').Scene} Scene
 * @typedef {import('./views.js').View} View
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

/** The plane, and beneath it the roots and the swing of its point. @implements {View} */
export class PlaneView {
  #lens;
  #roots;
  #ends;
  #map = new PlaneMap();
  /** How much of the plane is stable, in per cent. @type {number | null} */ #share = null;
  /** Whether its choices are unfolded. */ #isOpen = false;
  /** What is read off a picture that has no room for it. */ #reading = '';
  /** The coarse map that was drawn last, and waits to be refined. @type {unknown} */ #coarse = null;
  /** @type {{ text: string, quantities: unknown, plane: import('./settings.js').Plane } | null} */ #read = null;

  /** @param {import('../stability.js').StabilityLens} lens */
  constructor(lens) {
    this.#lens = lens;
    this.#roots = new RootsAndSwing(lens);
    this.#ends = { x: new RangeFields(lens, 'plane-x'), y: new RangeFields(lens, 'plane-y') };
  }

  /** As the settings have it, the same as long as they are. */
  get #plane() {
    const { settings, quantities } = this.#lens;
    const { plane: text = '' } = settings;
    if (this.#read?.text !== text || this.#read.quantities !== quantities)
      this.#read = { text, quantities, plane: planeOf(text, quantities.map(({ parameter }) => parameter)) };
    return this.#read.plane;
  }

  /** @type {View['template']} */
  template(voice) {
    const { quantities, isVeiled } = this.#lens;
    return html`
      ${planeChoices(this.#lens, this.#plane, quantities, voice, { isOpen: this.#isOpen, toggle: this.#toggle }, this.#ends)}
      ${this.#reading ? html`<p class="plane-reading" aria-hidden="true">${this.#reading}</p>` : ''}
      <shimmy-plane .voice=${voice} .quantities=${quantities} .plane=${this.#plane} .isVeiled=${isVeiled} .label=${this.#label(voice)} @read=${this.#tell}></shimmy-plane>
      ${this.#roots.template(voice)}`;
  }

  /** @type {View['line']} */
  line(voice) {
    if (this.#lens.isVeiled) return html`<p class="share"></p>`;
    return html`<p class="share"><span class="full">${this.#shareInWords(voice)}</span><span class="brief">${this.#shareInBrief(voice)}</span></p>`;
  }

  #toggle = () => {
    this.#isOpen = !this.#isOpen;
    this.#lens.requestUpdate();
  };

  #tell = (/** @type {CustomEvent<string>} */ { detail }) => {
    this.#reading = detail;
    this.#lens.requestUpdate();
  };

  stale() {
    this.#roots.stale();
  }

  /** @type {View['draw']} */
  draw(scene) {
    this.#drawPlane(scene);
    this.#roots.draw(scene);
  }

  /** @param {Scene} scene */
  #drawPlane(scene) {
    const lens = this.#lens;
    const element = /** @type {import('./plane.js').Plane | null} */ (lens.querySelector('shimmy-plane'));
    if (!element || !lens.theme) return;
    const looked = lens.isVeiled ? null : this.#map.look(scene, this.#plane);
    element.draw(scene, looked, lens.theme);
    const share = looked?.share ?? null;
    if (share !== this.#share) {
      this.#share = share;
      lens.requestUpdate();
    }
    if (!looked?.isCoarse || looked === this.#coarse) return;
    this.#coarse = looked;
    // Behind the drawing of the next frame: a hand that moves on has had a coarse map anew by then, and waits for no fine one.
    requestAnimationFrame(() => setTimeout(() => this.#refine(looked)));
  }

  /** @param {unknown} coarse */
  #refine(coarse) {
    if (coarse !== this.#coarse || !this.#lens.isConnected) return;
    this.#map.refine();
    if (this.#lens.scene) this.#drawPlane(this.#lens.scene);
  }

  /** @param {Voice} voice */
  #shareInWords(voice) {
    const { x, y } = this.#plane;
    const [across, up] = [this.#lens.quantity(x.parameter), this.#lens.quantity(y.parameter)];
    if (this.#share === null || !across || !up) return voice.say('stability.none');
    const share = voice.say('stability.share', { share: voice.number(this.#share, 1), x: rangeInWords(across, x, voice), y: rangeInWords(up, y, voice) });
    if (this.#isGapped) return voice.say('stability.share.gap', { share });
    return this.#lens.scene?.linear.isRubbed ? voice.say('stability.share.frictionless', { share }) : share;
  }

  /** The same for a foot that is short of room. @param {Voice} voice */
  #shareInBrief(voice) {
    const { x, y } = this.#plane;
    const [across, up] = [this.#lens.quantity(x.parameter), this.#lens.quantity(y.parameter)];
    if (this.#share === null || !across || !up) return voice.say('stability.none');
    return voice.say(this.#isGapped ? 'stability.share.brief.gap' : 'stability.share.brief',
      { share: voice.number(this.#share, 1), x: rangeInWords(across, x, voice), y: rangeInWords(up, y, voice) });
  }

  /** Whether of all the plane, or all but an edge of it, linear theory speaks inside the gap. */
  get #isGapped() {
    const { x, y } = this.#plane;
    return this.#lens.isGapped || [x, y].some(({ parameter }) => parameter === gapParameter);
  }

  /** @param {Voice} voice */
  #label(voice) {
    const { x, y } = this.#plane;
    const [across, up] = [this.#lens.quantity(x.parameter), this.#lens.quantity(y.parameter)];
    if (!across || !up) return '';
    const names = { across: lowerName(across, voice), up: lowerName(up, voice) };
    return this.#lens.isVeiled ? voice.say('stability.name.veiled', names) : voice.say('stability.name', { ...names, share: this.#shareInWords(voice) });
  }
}
