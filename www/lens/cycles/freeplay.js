import { html } from 'lit';
import '../../view/canvas.js';
import { ForceLaws } from '../force-laws.js';
import { parameterOption } from '../stability/option.js';
import { plainSymbol, rangeInWords } from '../stability/say.js';
import { BranchCut } from './branch-cut.js';
import { CyclePanel } from './panel.js';
import { gapBelowOf, gapBelows, gapParameter, gapRanges } from './settings.js';
import { SwingChart } from './swing-chart.js';

/**
 * @typedef {import('../../run/scene.js').Scene} Scene
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

/**
 * Freeplay: how widely the gear swings in the end over the gap and the speed, or the damping, with the gear as a point that a hand
 * drags; and beneath it the branch over the gap, with the straight line of small rattles, or the law with the gap in it. Commands:
 * `view` with what is to the right and what is beneath, `point` with both values.
 */
export class Freeplay extends CyclePanel {
  static properties = { ...CyclePanel.properties, spoken: { state: true } };

  #chart = new SwingChart(this);
  #cut = new BranchCut(() => this.#redraw());
  #laws = new ForceLaws();

  constructor() {
    super();
    /** What the point says of itself. */ this.spoken = '';
  }

  disconnectedCallback() {
    this.#chart.stop();
    this.#cut.stop();
    super.disconnectedCallback();
  }

  get sides() {
    const { x, y } = gapRanges(this.settings.gapMap ?? '', this.quantities.map(({ parameter }) => parameter));
    const [across, up] = [x && this.quantity(x.parameter), y && this.quantity(y.parameter)];
    return x && y && across && up ? { x: { ...x, quantity: across }, y: { ...y, quantity: up } } : null;
  }

  /** @param {Scene} scene @param {import('../../style/theme.js').Theme} theme */
  draw(scene, theme) {
    super.draw(scene, theme);
    const { sides } = this;
    this.#chart.look(scene);
    if (sides && !this.isVeiled) this.#cut.look(scene, sides.y);
    this.#redraw();
  }

  #redraw() {
    this.#chart.redraw();
    this.redrawWhere('.gap-branch', [this.settings, this.quantities, this.voice, this.isVeiled, this.theme, ...this.#cut.drawn, this.cycle, this.#chart.point.y, this.scene?.outlook.present.amplitude]);
    /** @type {import('../../view/canvas.js').Canvas | null} */ (this.querySelector('.gap-law'))?.redraw();
  }

  render() {
    const { voice, scene } = this;
    return voice && scene ? this.content(voice) : html``;
  }

  /** @param {Voice} voice */
  content(voice) {
    const { sides, isVeiled } = this;
    if (!sides) return html`<p class="panel-empty">${voice.say('gap.foreign')}</p>`;
    const { x, y } = sides;
    // On a projector there is room for one picture, the map unless another is chosen.
    const below = gapBelowOf(this.settings.gapBelow ?? ((this.theme?.line ?? 1) > 1 ? 'map' : ''));
    return html`
      <div class="gap" data-below=${below}>
        <div class="plane-choices">
          <span>${voice.say('gap.over', { gap: plainSymbol(y.quantity) })}</span>
          <select class="framed" aria-label=${voice.say('stability.across')} .value=${x.parameter}
            @change=${(/** @type {Event} */ event) => this.choose('gapMap', /** @type {HTMLSelectElement} */ (event.target).value)}>
            ${this.quantities.filter(({ name }) => name !== gapParameter).map((one) => parameterOption(one, x.parameter, voice))}
          </select>
          <select class="framed" aria-label=${voice.say('gap.below')} title=${voice.say('gap.below')} .value=${below}
            @change=${(/** @type {Event} */ event) => this.choose('gapBelow', /** @type {HTMLSelectElement} */ (event.target).value)}>
            ${gapBelows.map((one) => html`<option value=${one} ?selected=${one === below}>${voice.say(`gap.below.${one}`)}</option>`)}
          </select>
        </div>
        ${this.#chart.template(voice.say(isVeiled ? 'gap.map.veiled' : 'gap.map', { x: rangeInWords(x.quantity, x, voice), y: rangeInWords(y.quantity, y, voice) }), voice)}
        ${below === 'map' ? '' : below === 'law' ? html`<shimmy-canvas class="gap-below gap-law" .label=${voice.say('gap.law')} .paint=${this.#paintLaw}></shimmy-canvas>`
          : isVeiled ? this.veil(voice) : html`<shimmy-canvas class="gap-below gap-branch" .label=${voice.say('gap.branch')} .paint=${this.#paintBranch}></shimmy-canvas>`}
      </div>`;
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paintBranch = (context, size) => {
    const { voice, theme, scene, isVeiled, sides, cycle } = this;
    if (voice && theme && scene && sides && !isVeiled) this.#cut.paint(context, size, { scene, side: sides.y, cycle }, theme, voice);
  };

  /** The law moves with the gear, and tells nothing of what comes. @type {import('../../view/canvas.js').Paint} */
  #paintLaw = (context, size) => {
    const { voice, theme, scene } = this;
    if (voice && theme && scene) this.#laws.paint(context, size, { scene, shown: ['restoringMoment'] }, theme, voice);
  };
}

customElements.define('shimmy-freeplay', Freeplay);
