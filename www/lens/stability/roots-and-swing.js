import { html } from 'lit';
import { isSameList } from '../../store.js';
import { drawLinearHistory } from '../../view/linear-history.js';
import { pathsOf } from '../../view/root-paths.js';
import { drawRoots } from '../../view/roots.js';
import { RootsLimits } from './roots-limits.js';
import { crossingInWords, doubling, doublingInSigns, inTheory, pairInNumbers, pairReadings } from './say.js';
import { smallSwing } from './small-swing.js';

/**
 * @typedef {import('../stability.js').StabilityLens} StabilityLens
 * @typedef {import('../../run/scene.js').Scene} Scene
 * @typedef {import('../../view/canvas.js').Canvas} Canvas
 * @typedef {import('../../view/canvas.js').Paint} Paint
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

/** The roots with the way they have come, and beside them a small swing in its envelope. */
export class RootsAndSwing {
  #lens;
  #limits = new RootsLimits();
  /** @type {ReturnType<typeof smallSwing> | null} */ #swing = null;
  /** The roots that the swing is of. @type {unknown} */ #swingOf = null;
  /** What was drawn last, so that nothing is drawn twice. @type {unknown[]} */ #drawn = [];
  #spoken = { roots: '', history: '' };

  /** @param {StabilityLens} lens */
  constructor(lens) {
    this.#lens = lens;
  }

  /** @param {Voice} voice */
  template(voice) {
    const { isVeiled } = this.#lens;
    const { roots, history } = this.#spoken;
    const duration = voice.number((this.#swing?.duration ?? 0) * 1000, 0);
    const rootsLabel = isVeiled ? voice.say('roots.name.veiled') : voice.say('roots.name', { reading: roots });
    const historyLabel = isVeiled ? voice.say('history.name.veiled') : voice.say('history.name', { duration, reading: history });
    return html`
      <div class="roots"><shimmy-canvas .label=${rootsLabel} .paint=${this.#paintRoots}></shimmy-canvas></div>
      <div class="history"><shimmy-canvas .label=${historyLabel} .paint=${this.#paintHistory}></shimmy-canvas></div>`;
  }

  /** Something but words has changed: all is to be drawn again. */
  stale() {
    this.#drawn = [];
  }

  /** @param {Scene} scene */
  draw(scene) {
    const lens = this.#lens;
    const { roots } = lens.walk;
    if (roots !== this.#swingOf) {
      this.#swing = swingOf(scene, roots);
      this.#swingOf = roots;
    }
    // Axes that follow what is veiled would tell of it.
    if (!lens.isVeiled) this.#limits.hold(roots, scene.scales);
    const wanted = [roots, this.#limits.limits, lens.theme];
    if (isSameList(wanted, this.#drawn)) return;
    this.#drawn = wanted;
    for (const canvas of lens.querySelectorAll('.roots shimmy-canvas, .history shimmy-canvas')) /** @type {Canvas} */ (canvas).redraw();
    this.#speak();
  }

  #speak() {
    const { voice, walk } = this.#lens;
    if (!voice) return;
    const spoken = { roots: pairInNumbers(walk.roots, voice), history: this.#doublings(voice)[0] };
    if (spoken.roots === this.#spoken.roots && spoken.history === this.#spoken.history) return;
    this.#spoken = spoken;
    this.#lens.requestUpdate();
  }

  /** How long the swing takes to double or to halve, in fewer and fewer words. @param {Voice} voice */
  #doublings(voice) {
    if (!this.#swing) return [''];
    const what = doubling(this.#swing.growthRate, voice);
    const brief = doublingInSigns(this.#swing.growthRate, voice);
    const whole = inTheory(what, this.#lens.leavesOut, voice);
    return whole === what ? [what, brief] : [whole, what, brief];
  }

  /** @type {Paint} */
  #paintRoots = (context, size) => {
    const { voice, theme, walk, isVeiled } = this.#lens;
    const { roots, trail, crossing } = walk;
    if (!voice || !theme) return;
    drawRoots(context, size, {
      roots, trail: pathsOf(trail), crossing: crossing && { at: crossing.at, text: crossingInWords(crossing, voice) },
      readings: pairReadings(roots, voice), limits: this.#limits.limits, veiled: isVeiled,
    }, theme, voice);
  };

  /** @type {Paint} */
  #paintHistory = (context, size) => {
    const { voice, theme, isVeiled } = this.#lens;
    const swing = this.#swing;
    if (!voice || !theme || !swing) return;
    drawLinearHistory(context, size, { ...swing, readings: this.#doublings(voice), veiled: isVeiled }, theme, voice);
  };
}

/** @param {Scene} scene @param {readonly import('../../view/root-paths.js').Root[]} roots */
function swingOf({ linear }, roots) {
  try {
    return roots.length > 0 ? smallSwing(linear, roots) : null;
  } catch {
    // Values so wild that the swing leaves the numbers: none is drawn.
    return null;
  }
}
