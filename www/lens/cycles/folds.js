import { html } from 'lit';
import { tell } from '../../command.js';
import { symbolOf } from '../../controls/symbol.js';
import '../../view/canvas.js';
import { parameterOption } from '../stability/option.js';
import { RangeFields } from '../stability/range-fields.js';
import { lowerName, plainSymbol, rangeInWords } from '../stability/say.js';
import { rangeOf } from '../stability/settings.js';
import { BranchCut } from './branch-cut.js';
import { CyclePanel } from './panel.js';
import { amplitudeOf } from './say.js';
import { foldsOf, writeFolds } from './settings.js';
import { SwingChart } from './swing-chart.js';

/**
 * @typedef {import('../../run/scene.js').Scene} Scene
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

/** From rest a start so wide is a push, as a share of the cycle. */
const wider = 1.05;
const touch = 0.01;

/**
 * Folds: a plane of any two values with the curves at which cycles are born and at which two of them meet; between them two
 * motions are possible, and either can be started. The gear is a point that a hand drags; beneath it the branch along the plane.
 * Commands: `view` with the plane, `point` with both values, `startFrom` with a start.
 */
export class Folds extends CyclePanel {
  static properties = { ...CyclePanel.properties, spoken: { state: true }, hasTwo: { state: true }, isOpen: { state: true } };

  #chart = new SwingChart(this);
  #ends = { x: new RangeFields(this, 'folds-x'), y: new RangeFields(this, 'folds-y') };
  #cut = new BranchCut(() => this.#redraw());

  constructor() {
    super();
    /** What the point says of itself. */ this.spoken = '';
    /** Whether the gear has two motions. */ this.hasTwo = false;
    /** Whether the ends of its sides are seen. */ this.isOpen = false;
  }

  disconnectedCallback() {
    this.#chart.stop();
    this.#cut.stop();
    super.disconnectedCallback();
  }

  get #plane() {
    return foldsOf(this.settings.folds ?? '', this.quantities.map(({ parameter }) => parameter));
  }

  get sides() {
    const { x, y } = this.#plane;
    const [across, up] = [this.quantity(x.parameter), this.quantity(y.parameter)];
    return across && up ? { x: { ...x, quantity: across }, y: { ...y, quantity: up } } : null;
  }

  /** @param {Scene} scene @param {import('../../style/theme.js').Theme} theme */
  draw(scene, theme) {
    super.draw(scene, theme);
    const { sides } = this;
    this.#chart.look(scene);
    if (sides && !this.isVeiled) this.#cut.look(scene, sides.x);
    this.#redraw();
  }

  #redraw() {
    this.#chart.redraw();
    this.hasTwo = !this.isVeiled && this.#chart.hasTwo;
    this.redrawWhere('.folds-branch', [this.settings, this.quantities, this.voice, this.isVeiled, this.theme, ...this.#cut.drawn, this.cycle, this.#chart.point.x, this.scene?.outlook.present.amplitude]);
  }

  render() {
    const { voice, scene } = this;
    return voice && scene ? this.content(voice) : html``;
  }

  /** @param {Voice} voice */
  content(voice) {
    const { sides, isVeiled } = this;
    if (!sides) return html``;
    const { x, y } = sides;
    const ranges = { x: rangeInWords(x.quantity, x, voice), y: rangeInWords(y.quantity, y, voice) };
    return html`
      <div class="folds">
        <div class="plane-choices">
          ${this.#side('y', voice)}
          <button type="button" class="framed icon swap" aria-label=${voice.say('stability.swap')} title=${voice.say('stability.swap')} @click=${() => this.#choose({ x: this.#plane.y, y: this.#plane.x })}>⇄</button>
          ${this.#side('x', voice)}
          <button type="button" class="framed icon" aria-label=${voice.say('folds.ranges')} title=${voice.say('folds.ranges')} aria-expanded=${this.isOpen ? 'true' : 'false'}
            @click=${() => { this.isOpen = !this.isOpen; }}>⋯</button>
          ${this.isOpen ? /** @type {const} */ (['y', 'x']).map((side) => html`
            <span class="ends">${symbolOf(sides[side].quantity.parameter.symbol)} ${this.#ends[side].fields(this.#plane[side], (range) => this.#choose({ [side]: range }), voice)}</span>`) : ''}
          ${this.isOpen ? /** @type {const} */ (['y', 'x']).map((side) => this.#ends[side].why(this.#plane[side])) : ''}
        </div>
        ${this.#chart.template(voice.say(isVeiled ? 'folds.map.veiled' : 'folds.map', ranges), voice)}
        ${isVeiled ? '' : this.#facts(voice)}
        ${isVeiled ? this.veil(voice) : html`<shimmy-canvas class="folds-branch" .label=${voice.say('folds.branch', { across: lowerName(x.quantity, voice) })} .paint=${this.#paintBranch}></shimmy-canvas>`}
      </div>`;
  }

  /** A side of the plane; where the other side has what is chosen they change places. @param {'x' | 'y'} side @param {Voice} voice */
  #side(side, voice) {
    const plane = this.#plane;
    const word = voice.say(side === 'x' ? 'stability.across' : 'stability.up');
    const put = (/** @type {string} */ name) => {
      const quantity = this.quantity(name);
      if (!quantity) return;
      const range = rangeOf(quantity.parameter);
      if (plane[side === 'x' ? 'y' : 'x'].parameter === name) this.#choose({ x: plane.y, y: plane.x });
      else this.#choose({ [side]: range });
    };
    return html`
      <select class="framed" aria-label=${word} title=${word} .value=${plane[side].parameter} @change=${(/** @type {Event} */ event) => put(/** @type {HTMLSelectElement} */ (event.target).value)}>
        ${this.quantities.map((quantity) => parameterOption(quantity, plane[side].parameter, voice))}
      </select>`;
  }

  /** @param {Partial<{ x: import('../../run/linear-looks.js').Range, y: import('../../run/linear-looks.js').Range }>} change */
  #choose(change) {
    this.choose('folds', writeFolds({ ...this.#plane, ...change }));
  }

  /** What there is to choose between, where there is. @param {Voice} voice */
  #facts(voice) {
    const { cycle, sides } = this;
    if (!this.hasTwo || !cycle) return html`<p class="branch-facts">${voice.say('folds.one', { x: plainSymbol(/** @type {NonNullable<typeof sides>} */ (sides).x.quantity), y: plainSymbol(/** @type {NonNullable<typeof sides>} */ (sides).y.quantity) })}</p>`;
    return html`
      <div class="branch-facts">
        <p><b>${voice.say('folds.here', { swing: amplitudeOf('torsionAngle', cycle.amplitude.torsionAngle, voice) })}</b></p>
        <span class="branch-starts">
          <button type="button" class="framed" @click=${() => this.#start(touch)}>${voice.say('folds.start.touch')}</button>
          <button type="button" class="framed" @click=${() => this.#start(Number((wider * cycle.amplitude.torsionAngle).toPrecision(3)))}>${voice.say('folds.start.push')}</button>
        </span>
      </div>`;
  }

  /** @param {number} torsionAngle in rad */
  #start(torsionAngle) {
    tell(this, 'startFrom', { state: { torsionAngle } });
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paintBranch = (context, size) => {
    const { voice, theme, scene, isVeiled, sides, cycle } = this;
    if (voice && theme && scene && sides && !isVeiled) this.#cut.paint(context, size, { scene, side: sides.x, cycle, hasPoints: true }, theme, voice);
  };
}

customElements.define('shimmy-folds', Folds);
