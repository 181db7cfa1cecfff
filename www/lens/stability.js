import { html } from 'lit';
import { withUnit } from '../controls/quantity.js';
import '../view/canvas.js';
import { drawLinearHistory } from '../view/linear-history.js';
import { pathsThrough } from '../view/root-paths.js';
import { drawRootLocus } from '../view/root-locus.js';
import { drawRoots } from '../view/roots.js';
import { PlotLens } from './plot-lens.js';
import { planeChoices } from './stability/choices.js';
import { locusChoices } from './stability/locus-choices.js';
import { Loci } from './stability/loci.js';
import './stability/plane.js';
import { PlaneMap } from './stability/plane-map.js';
import { RootsLimits } from './stability/roots-limits.js';
import { RootsWalk } from './stability/roots-walk.js';
import { becomesInTheory, crossingInWords, doubling, lowerName, pairInNumbers, pairReadings, plainSymbol, rangeInWords, shortNumber } from './stability/say.js';
import { locusOf, planeOf } from './stability/settings.js';
import { smallSwing } from './stability/small-swing.js';

/**
 * @typedef {import('../run/scene.js').Scene} Scene
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../view/canvas.js').Canvas} Canvas
 * @typedef {import('../view/canvas.js').Paint} Paint
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/** A swing is drawn up to so many times its start: what grows leaves the picture, and the scale stays. */
const historyLimit = 3;

/**
 * The lens *Stability*: what linear theory says of the gear. A plane of two parameters in which the gear is a point to be
 * dragged, the roots that walk with it, and a small swing in its envelope; or the roots' ways as a parameter is swept.
 */
export class StabilityLens extends PlotLens {
  static properties = { ...PlotLens.properties, settings: { attribute: false }, share: { state: true }, said: { state: true }, spoken: { state: true } };

  #map = new PlaneMap();
  #walk = new RootsWalk();
  #limits = new RootsLimits();
  #loci = new Loci();
  /** @type {ReturnType<typeof smallSwing> | null} */ #swing = null;
  /** What was drawn last, so that nothing is drawn twice. @type {unknown[]} */ #drawn = [];
  /** Frames until a coarse map is refined, and which; another begins them anew. */ #patience = 0;
  /** @type {unknown} */ #coarse = null;
  #frame = 0;
  /** @type {{ from: unknown[], plane: import('./stability/settings.js').Plane, locus: import('./stability/settings.js').Locus } | null} */ #settings = null;

  constructor() {
    super();
    /** What each lens shows, by its name; here `plane` and `locus` are of interest. @type {Readonly<Record<string, string>>} */
    this.settings = {};
    /** How much of the plane is stable, in per cent. @type {number | null} */ this.share = null;
    /** What has just happened, for those who do not see it. */ this.said = '';
    /** What the roots and the swing say. */ this.spoken = { roots: '', history: '' };
  }

  disconnectedCallback() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    super.disconnectedCallback();
  }

  get views() {
    return ['plane', 'roots', 'locus'];
  }

  /** @param {string} name @param {Voice} voice */
  nameOfView(name, voice) {
    return voice.say(/** @type {import('../words/voice.js').Key} */ (`stability.view.${name}`));
  }

  get #isGapped() {
    return this.scene?.linear.isGapped ?? false;
  }

  get #plane() {
    return this.#read.plane;
  }

  get #locus() {
    return this.#read.locus;
  }

  /** The settings as they are meant, the same as long as nothing of them has changed. */
  get #read() {
    const { settings: { plane = '', locus = '' }, quantities } = this;
    const from = [plane, locus, quantities];
    if (this.#settings?.from.every((one, i) => one === from[i])) return this.#settings;
    const parameters = quantities.map(({ parameter }) => parameter);
    this.#settings = { from, plane: planeOf(plane, parameters), locus: locusOf(locus, parameters) };
    return this.#settings;
  }

  /** @param {string} name */
  #quantity(name) {
    return this.quantities.find((one) => one.name === name);
  }

  /** @param {Voice} voice */
  line(voice) {
    if (this.view === 'roots') return html`<p>${this.#isGapped ? voice.say('roots.line.gap') : voice.say('roots.line')}</p>`;
    if (this.view === 'locus') {
      const swept = this.#quantity(this.#locus.sweep.parameter);
      const line = swept ? voice.say('locus.line', { sweep: lowerName(swept, voice) }) : '';
      return html`<p>${this.#isGapped ? voice.say('locus.line.gap', { line }) : line}</p>`;
    }
    return html`<p class="share">${this.isVeiled ? '' : this.#shareInWords(voice)}</p>`;
  }

  /** @param {Voice} voice */
  #shareInWords(voice) {
    const { x, y } = this.#plane;
    const [across, up] = [this.#quantity(x.parameter), this.#quantity(y.parameter)];
    if (this.share === null || !across || !up) return voice.say('stability.none');
    const share = voice.say('stability.share', { share: voice.number(this.share, 1), x: rangeInWords(across, x, voice), y: rangeInWords(up, y, voice) });
    return this.#isGapped ? voice.say('stability.share.gap', { share }) : share;
  }

  /** @param {Voice} voice */
  plot(voice) {
    if (this.quantities.length < 2) return '';
    if (this.view === 'locus') {
      return html`
        <div class="stability" data-view="locus">
          ${locusChoices(this, this.#locus, this.quantities, voice)}
          <shimmy-canvas .label=${this.#locusLabel(voice)} .paint=${this.#paintLocus}></shimmy-canvas>
        </div>`;
    }
    const duration = voice.number((this.#swing?.duration ?? 0) * 1000, 0);
    const { roots, history } = this.spoken;
    const rootsLabel = this.isVeiled ? voice.say('roots.name.veiled') : voice.say('roots.name', { reading: roots });
    const historyLabel = this.isVeiled ? voice.say('history.name.veiled') : voice.say('history.name', { duration, reading: history });
    return html`
      <div class="stability" data-view=${this.view}>
        ${this.view === 'plane' ? html`
          ${planeChoices(this, this.#plane, this.quantities, voice)}
          <shimmy-plane .voice=${voice} .quantities=${this.quantities} .plane=${this.#plane} .isVeiled=${this.isVeiled} .label=${this.#planeLabel(voice)}></shimmy-plane>` : ''}
        <div class="roots"><shimmy-canvas .label=${rootsLabel} .paint=${this.#paintRoots}></shimmy-canvas></div>
        <div class="history"><shimmy-canvas .label=${historyLabel} .paint=${this.#paintHistory}></shimmy-canvas></div>
        <p class="only-heard" role="status">${this.isVeiled ? '' : this.said}</p>
      </div>`;
  }

  /** @param {Voice} voice */
  #planeLabel(voice) {
    const { x, y } = this.#plane;
    const [across, up] = [this.#quantity(x.parameter), this.#quantity(y.parameter)];
    if (!across || !up) return '';
    const names = { across: lowerName(across, voice), up: lowerName(up, voice) };
    return this.isVeiled ? voice.say('stability.name.veiled', names) : voice.say('stability.name', { ...names, share: this.#shareInWords(voice) });
  }

  /** @param {Voice} voice */
  #locusLabel(voice) {
    const { sweep, family } = this.#locus;
    const [swept, other] = [this.#quantity(sweep.parameter), this.#quantity(family?.parameter ?? '')];
    if (!swept) return '';
    const values = { sweep: lowerName(swept, voice), from: swept.write(sweep.from, voice), to: swept.write(sweep.to, voice) };
    return family && other ? voice.say('locus.name.family', { ...values, count: family.count, other: lowerName(other, voice) }) : voice.say('locus.name', values);
  }

  /** @param {Map<string, unknown>} changed */
  updated(changed) {
    // Words that follow what was drawn are no reason to draw it again.
    if ([...changed.keys()].every((name) => ['share', 'said', 'spoken', 'outlook', 'ghosts'].includes(name))) return;
    this.#drawn = [];
    if (this.scene && this.theme) this.draw(this.scene, this.theme);
  }

  /** @param {Scene} scene @param {Theme} theme */
  draw(scene, theme) {
    this.scene = scene;
    this.theme = theme;
    const followed = this.#walk.follow(scene, performance.now() / 1000);
    if (followed === 'crossed') this.#announce();
    if (this.view === 'locus') {
      this.#redrawWhere([scene.parameters, this.#loci.look(scene, this.#locus), theme], 'shimmy-canvas');
      return;
    }
    this.#drawPlane(scene, theme);
    if (followed !== 'same' || !this.#swing) this.#swing = this.#swingOf(scene);
    const { roots } = this.#walk;
    // Axes that follow what is veiled would tell of it.
    if (!this.isVeiled) this.#limits.hold(roots, scene.scales);
    this.#redrawWhere([roots, this.#swing, this.#limits.limits, theme, this.isVeiled, this.voice], '.roots shimmy-canvas, .history shimmy-canvas');
    this.#speak(roots);
  }

  /** The map, coarse at first; it is refined once nothing has changed for a frame. @param {Scene} scene @param {Theme} theme */
  #drawPlane(scene, theme) {
    const plane = /** @type {import('./stability/plane.js').PlaneView | null} */ (this.querySelector('shimmy-plane'));
    if (!plane) return;
    const looked = this.isVeiled ? null : this.#map.look(scene, this.#plane);
    plane.draw(scene, looked, theme);
    const share = looked?.share ?? null;
    if (share !== this.share) this.share = share;
    if (!looked?.isCoarse || looked === this.#coarse) return;
    this.#coarse = looked;
    this.#patience = 2;
    if (!this.#frame) this.#frame = requestAnimationFrame(this.#refineSoon);
  }

  #refineSoon = () => {
    this.#frame = 0;
    if (--this.#patience > 0) {
      this.#frame = requestAnimationFrame(this.#refineSoon);
      return;
    }
    this.#map.refine();
    if (this.scene && this.theme) this.#drawPlane(this.scene, this.theme);
  };

  /** @param {Scene} scene */
  #swingOf({ linear }) {
    const { roots } = this.#walk;
    try {
      return roots.length > 0 ? smallSwing(linear, roots) : null;
    } catch {
      return null;
    }
  }

  /** @param {unknown[]} wanted what is to be seen @param {string} where */
  #redrawWhere(wanted, where) {
    if (wanted.length === this.#drawn.length && wanted.every((one, i) => one === this.#drawn[i])) return;
    this.#drawn = wanted;
    for (const canvas of this.querySelectorAll(where)) /** @type {Canvas} */ (canvas).redraw();
  }

  #announce() {
    const { voice } = this;
    const { crossing, roots } = this.#walk;
    if (voice && crossing) this.said = voice.say('roots.said', { crossing: crossingInWords(crossing, voice), what: becomesInTheory(roots, this.#isGapped, voice) });
  }

  /** @param {readonly import('../view/root-paths.js').Root[]} roots */
  #speak(roots) {
    const { voice } = this;
    if (!voice) return;
    const spoken = { roots: pairInNumbers(roots, voice), history: this.#swing ? this.#doublings(this.#swing, voice)[0] : '' };
    if (spoken.roots !== this.spoken.roots || spoken.history !== this.spoken.history) this.spoken = spoken;
  }

  /** How long the swing takes to double or to halve, in fewer and fewer words. @param {{ growthRate: number }} swing @param {Voice} voice */
  #doublings({ growthRate }, voice) {
    const what = doubling(growthRate, voice);
    return this.#isGapped ? [voice.say('stability.linear', { what }), what] : [what];
  }

  /** @type {Paint} */
  #paintRoots = (context, size) => {
    const { voice, theme } = this;
    const { roots, trail, crossing } = this.#walk;
    if (!voice || !theme) return;
    drawRoots(context, size, {
      roots, trail: pathsThrough(trail), crossing: crossing && { at: crossing.at, text: crossingInWords(crossing, voice) },
      readings: pairReadings(roots, voice), limits: this.#limits.limits, veiled: this.isVeiled,
    }, theme, voice);
  };

  /** @type {Paint} */
  #paintHistory = (context, size) => {
    const { voice, theme } = this;
    const swing = this.#swing;
    if (!voice || !theme || !swing) return;
    drawLinearHistory(context, size, { ...swing, limit: historyLimit, readings: this.#doublings(swing, voice), veiled: this.isVeiled }, theme, voice);
  };

  /** @type {Paint} */
  #paintLocus = (context, size) => {
    const { voice, theme, scene } = this;
    const { sweep, family } = this.#locus;
    const found = scene && this.#loci.look(scene, this.#locus);
    const [swept, other] = [this.#quantity(sweep.parameter), this.#quantity(family?.parameter ?? '')];
    if (!voice || !theme || !found || !swept) return;
    drawRootLocus(context, size, {
      ways: found.ways.map(({ value, at, paths }) => ({
        paths, shares: at.map((swept) => (swept - sweep.from) / (sweep.to - sweep.from)),
        label: other && value !== null ? `${plainSymbol(other)} ${shortNumber(other, value, voice)}` : '',
      })),
      roots: this.#walk.roots, limits: found.limits,
      sweep: { symbol: plainSymbol(swept), from: shortNumber(swept, sweep.from, voice), to: withUnit(shortNumber(swept, sweep.to, voice), swept.unit) }, veiled: this.isVeiled,
    }, theme, voice);
  };
}

customElements.define('shimmy-stability-lens', StabilityLens);
