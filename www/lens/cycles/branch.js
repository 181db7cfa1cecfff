import { html, nothing } from 'lit';
import { tell } from '../../command.js';
import { runJob } from '../../engine/workers.js';
import { guessOf, stateAt } from '../../run/cycle-looks.js';
import '../../view/canvas.js';
import { drawBifurcation } from '../../view/bifurcation.js';
import { drawMultipliers } from '../../view/multipliers.js';
import { quantities as shown, valueOf } from '../../view/quantities.js';
import { roundLimit } from '../../view/scale.js';
import { parameterOption } from '../stability/option.js';
import { plainSymbol, rangeInWords } from '../stability/say.js';
import { BesideWork } from './beside-work.js';
import { along, cycleAt, heights, heightsOf, highest, nearest, nearestTo, roundValue, slopeOfSmall } from './branches.js';
import { criticalityInWords, lineOf, pointsOf, restOf, stopsOf } from './diagram.js';
import { OrbitPicture } from './orbit-picture.js';
import { CyclePanel } from './panel.js';
import { amplitudeOf, digitsOf, kindOf, multiplierInWords, multipliersOf } from './say.js';
import { branchOf, lookOf, orbitOf, writeBranch } from './settings.js';

/** How far the axis goes while its limit would tell how wide the cycles are, in what is shown. */
const veiledLimit = 20;

/**
 * @typedef {import('../../run/scene.js').Scene} Scene
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('./branches.js').Place} Place
 */

/** A press that moves no further than this is a click, in px; and so near to a branch it must be. */
const widestClick = 6;
const reach = 70;
/** Stops of a simulated sweep, each way. */
const stops = 41;
/** Beside a cycle: so much smaller or larger than it. */
const beside = 0.03;
/** An axis stays while what is on it reaches this share of it. */
const filled = 0.3;

/**
 * The bifurcation diagram: branches of cycles over a value of the gear, which rides on it. A click on a branch puts the gear on
 * that cycle; from there it can be started just inside or just outside. Commands: `view` with what varies, `motion` with a cycle.
 */
export class Branch extends CyclePanel {
  static properties = { ...CyclePanel.properties, heard: { state: true } };

  /** @type {BesideWork<import('../../pkg/shimmy.js').BifurcationSpec, import('../../pkg/shimmy.js').Bifurcation>} */
  #work = new BesideWork((spec, options) => runJob('bifurcation', spec, options));
  /** @type {BesideWork<import('../../pkg/shimmy.js').SweepSpec, import('../../pkg/shimmy.js').Sweep>} */
  #sweep = new BesideWork((spec, options) => runJob('sweep', spec, options));
  #picture = new OrbitPicture();
  /** Where a hand can meet the branches, as they were drawn last. @type {import('../../view/bifurcation.js').Places | null} */ #places = null;
  /** Where keys have walked to. @type {Place | null} */ #cursor = null;
  /** @type {{ x: number, y: number } | null} */ #press = null;
  /** @type {{ scales: object | null, of: string, limit: number }} */ #axis = { scales: null, of: '', limit: 1 };

  constructor() {
    super();
    /** What the cursor is on, for those who do not see it. */ this.heard = '';
    this.#work.onChange = () => {
      this.#cursor = null;
      this.requestUpdate();
    };
    this.#sweep.onChange = () => this.requestUpdate();
  }

  disconnectedCallback() {
    this.#work.stop();
    this.#sweep.stop();
    super.disconnectedCallback();
  }

  get #branch() {
    return branchOf(this.settings.branch ?? '', this.quantities.map(({ parameter }) => parameter));
  }

  get #isSweeping() {
    return this.settings.branchSweep === 'on';
  }

  /** What the diagram depends on. */
  get #others() {
    const { scene } = this;
    const { range } = this.#branch;
    const others = Object.entries(scene?.parameters ?? {}).filter(([name]) => name !== range.parameter);
    return JSON.stringify([scene?.object, range, others]);
  }

  /** @param {Scene} scene @param {import('../../style/theme.js').Theme} theme */
  draw(scene, theme) {
    super.draw(scene, theme);
    if (!this.isVeiled) {
      const { range, height } = this.#branch;
      const shape = JSON.stringify([scene.object, range]);
      const gear = { model: scene.object, parameters: { ...scene.parameters } };
      this.#work.look({ key: this.#others, shape, spec: { ...gear, ...range } });
      if (this.#isSweeping && height !== 'frequency') this.#sweep.look({ key: this.#others + height, shape: shape + height, spec: { ...gear, over: { ...range, count: stops }, measure: height } });
    }
    this.#picture.hold(scene, this.isVeiled ? null : this.cycle);
    const { result, isOld, isFailed } = this.#work;
    this.redrawWhere('.branch-plane shimmy-canvas', [
      result, isOld, isFailed, this.#sweep.result, this.#sweep.isOld, this.#cursor, this.cycle, this.settings, this.quantities, this.voice, this.isVeiled, theme,
      scene.scales, scene.parameters[this.#branch.range.parameter], scene.outlook.present.amplitude,
    ]);
    /** @type {import('../../view/canvas.js').Canvas | null} */ (this.querySelector('.branch-orbit'))?.redraw();
  }

  render() {
    const { voice, scene } = this;
    return voice && scene ? this.content(voice) : html``;
  }

  /** @param {Voice} voice */
  content(voice) {
    const { isVeiled } = this;
    const { range, height } = this.#branch;
    const quantity = this.quantity(range.parameter);
    if (!quantity) return html``;
    const cycle = isVeiled ? null : this.cycle;
    const choose = (/** @type {Partial<import('./settings.js').Branch>} */ change) => this.choose('branch', writeBranch({ range, height, ...change }));
    const pick = (/** @type {Event} */ event) => /** @type {HTMLSelectElement} */ (event.target).value;
    return html`
      <div class="branch">
        <div class="plane-choices">
          <select class="framed" aria-label=${voice.say('branch.varies')} title=${voice.say('branch.varies')} .value=${range.parameter}
            @change=${(/** @type {Event} */ event) => { const one = this.quantity(pick(event)); if (one) choose({ range: { parameter: one.name, from: one.parameter.min, to: one.parameter.max } }); }}>
            ${this.quantities.map((one) => parameterOption(one, range.parameter, voice))}
          </select>
          <select class="framed" aria-label=${voice.say('stability.up')} title=${voice.say('stability.up')} .value=${height}
            @change=${(/** @type {Event} */ event) => choose({ height: /** @type {typeof height} */ (pick(event)) })}>
            ${heights.map((one) => html`<option value=${one} ?selected=${one === height}>${one === 'frequency' ? 'f' : shown[one].symbol}${one === 'torsionRate' ? '\u0307' : ''} ${voice.say(shown[one].word)}</option>`)}
          </select>
          <button type="button" class="framed sweep" aria-pressed=${this.#isSweeping ? 'true' : 'false'} title=${voice.say('branch.sweep.does')}
            @click=${() => this.choose('branchSweep', this.#isSweeping ? 'off' : 'on')}>${voice.say('branch.sweep')} ▸◂</button>
        </div>
        <div class="branch-plane" role="application" tabindex="0" aria-label=${voice.say('branch.does')} title=${voice.say('branch.does')}
          @pointerdown=${this.#pressed} @pointerup=${this.#released} @keydown=${this.#key} @blur=${this.#left}>
          <shimmy-canvas .label=${this.#label(quantity, voice)} .paint=${this.#paint}></shimmy-canvas>
        </div>
        <p class="only-heard" role="status">${isVeiled ? '' : this.heard}</p>
        ${isVeiled ? this.veil(voice) : this.#facts(cycle, quantity, voice)}
        <shimmy-canvas class="branch-orbit" .label=${voice.say('branch.orbit')} .paint=${this.#paintOrbit}></shimmy-canvas>
        <shimmy-canvas class="multipliers" .label=${voice.say(isVeiled ? 'cycle.multipliers.veiled' : 'cycle.multipliers.name', { list: multipliersOf(cycle?.multipliers ?? []).others.map((one) => multiplierInWords(one, voice)).join('; ') || '–' })} .paint=${this.#paintMultipliers}></shimmy-canvas>
      </div>`;
  }

  /** @param {import('../../run/cycle-looks.js').LimitCycle | null} cycle @param {import('../../controls/quantity.js').Quantity} quantity @param {Voice} voice */
  #facts(cycle, quantity, voice) {
    const { result: diagram, isOld } = this.#work;
    const hopfs = diagram && !isOld ? criticalityInWords(diagram, quantity, voice) : [];
    const reads = hopfs.length === 0 ? nothing : html`<p class="branch-reads">${hopfs.map(({ name, means, how }) => html`${name}<span class="spare">: ${means}</span> ${how}. `)}</p>`;
    if (!cycle) return html`<div class="branch-facts"><p>${voice.say('cycle.none')}</p>${reads}</div>`;
    return html`
      <div class="branch-facts">
        ${reads}
        <p><b class=${cycle.stable ? '' : 'is-unstable'}>${kindOf(cycle, voice)}</b> ${amplitudeOf('torsionAngle', cycle.amplitude.torsionAngle, voice)} · ${voice.number(cycle.frequency ?? NaN, 2)} Hz</p>
        <span class="branch-starts">
          <button type="button" class="framed" @click=${() => this.#start(1)}>${voice.say('branch.start.on')}</button>
          <button type="button" class="framed" @click=${() => this.#start(1 - beside)}>${voice.say('branch.start.inside')}</button>
          <button type="button" class="framed" @click=${() => this.#start(1 + beside)}>${voice.say('branch.start.outside')}</button>
        </span>
      </div>`;
  }

  /** Puts the run on the cycle, or a little beside it. @param {number} factor */
  #start(factor) {
    const { cycle } = this;
    if (!cycle) return;
    const state = Object.fromEntries(Object.entries(stateAt(cycle.orbit, 0)).map(([name, value]) => [name, factor * value]));
    tell(this, 'motion', { values: {}, state });
  }

  /** @param {import('../../controls/quantity.js').Quantity} quantity @param {Voice} voice */
  #label(quantity, voice) {
    const { range } = this.#branch;
    const across = rangeInWords(quantity, range, voice);
    if (this.isVeiled) return voice.say('branch.name.veiled', { across });
    const { result: diagram } = this.#work;
    const points = diagram ? this.#pointsOf(diagram, voice).map(({ texts }) => texts[0]).join('; ') : '';
    return voice.say('branch.name', { across, count: diagram?.cycles.length ?? 0, points: points || voice.say('branch.points.none') });
  }

  /** @param {import('../../pkg/shimmy.js').Bifurcation} diagram @param {Voice} voice */
  #pointsOf(diagram, voice) {
    const quantity = this.quantity(diagram.parameter);
    return quantity ? pointsOf(diagram, { height: this.#branch.height, quantity, isRubbed: this.scene?.linear.isRubbed ?? false }, voice) : [];
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paint = (context, size) => {
    const { voice, theme, scene, isVeiled } = this;
    const { range, height } = this.#branch;
    const quantity = this.quantity(range.parameter);
    if (!voice || !theme || !scene || !quantity) return;
    const { result: diagram, isOld, isFailed } = this.#work;
    const cycle = isVeiled ? null : this.cycle;
    const up = cycle && (height === 'frequency' ? cycle.frequency : cycle.amplitude[height]);
    const motion = !isVeiled && height === 'torsionAngle' ? scene.outlook.present.amplitude : null;
    if (!isVeiled) this.#hold(Math.max(diagram ? highest(diagram, height) : 0, cycle && cycle.amplitude.torsionAngle < 0.8 ? up ?? 0 : 0), height, scene.scales);
    const lines = diagram?.cycles.map((_, i) => lineOf(diagram, i, height)) ?? [];
    const slope = diagram && height === 'torsionAngle' ? slopeOfSmall(diagram) : null;
    const cursor = this.#cursor && lines[this.#cursor.branch] ? { across: lines[this.#cursor.branch].across[this.#cursor.index], up: lines[this.#cursor.branch].up[this.#cursor.index] } : null;
    this.#places = drawBifurcation(context, size, {
      quantity, from: range.from, to: range.to, height, limit: isVeiled ? veiledLimit / shown[height].perSI : this.#axis.limit, branches: lines,
      rest: diagram && restOf(diagram, height, scene.parameters['friction.moment'] ?? 0),
      points: diagram ? this.#pointsOf(diagram, voice) : [],
      law: slope === null ? null : { slope, text: voice.say('branch.law', { slope: voice.number(slope, 2) }) },
      sweep: this.#isSweeping && this.#sweep.result && !this.#sweep.isOld && height !== 'frequency' ? stopsOf(this.#sweep.result) : [],
      now: { value: scene.parameters[range.parameter], motion, cycle: cycle && up ? { up, stable: cycle.stable ?? true } : null },
      cursor, isOld: isOld && diagram !== null, veiled: isVeiled,
      message: isVeiled ? '' : isFailed ? voice.say('stability.none') : diagram === null ? voice.say('branch.computing') : diagram.cycles.length === 0 && !isOld ? voice.say('branch.none') : '',
    }, theme, voice);
  };

  /** @param {number} most @param {import('./branches.js').Height} height @param {object} scales */
  #hold(most, height, scales) {
    const perSI = shown[height].perSI;
    const of = `${height} ${this.#branch.range.parameter}`;
    const isServing = most <= this.#axis.limit && most >= filled * this.#axis.limit;
    if (this.#axis.scales === scales && this.#axis.of === of && (isServing || most === 0)) return;
    if (this.#axis.of === of && isServing) this.#axis.scales = scales;
    else this.#axis = { scales, of, limit: roundLimit(Math.max(most, 1e-4 / perSI) * perSI) / perSI };
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paintOrbit = (context, size) => {
    const { voice, theme, scene, isVeiled } = this;
    if (!voice || !theme || !scene) return;
    this.#picture.paint(context, size, { scene, cycle: isVeiled ? null : this.cycle, name: orbitOf(this.settings.cycleOrbit ?? '').name, look: lookOf(this.settings.cycleOrbit ?? ''), veiled: isVeiled }, theme, voice);
  };

  /** @type {import('../../view/canvas.js').Paint} */
  #paintMultipliers = (context, size) => {
    const { voice, theme, isVeiled } = this;
    if (!voice || !theme) return;
    drawMultipliers(context, size, { ...multipliersOf((isVeiled ? null : this.cycle)?.multipliers ?? []), veiled: isVeiled }, theme, voice);
  };

  /** @param {PointerEvent} event */
  #pressed(event) {
    this.#press = event.button === 0 ? { x: event.clientX, y: event.clientY } : null;
  }

  /** @param {PointerEvent} event */
  #released(event) {
    const press = this.#press;
    this.#press = null;
    const { result: diagram } = this.#work;
    if (!press || !diagram || !this.#places || this.isVeiled || Math.hypot(event.clientX - press.x, event.clientY - press.y) > widestClick) return;
    const { left, top } = /** @type {HTMLElement} */ (event.currentTarget).getBoundingClientRect();
    const place = nearest(diagram, this.#branch.height, this.#places, { x: event.clientX - left, y: event.clientY - top });
    if (place && place.distance <= reach) this.#go(place);
  }

  /** Puts the gear on the cycle at a place; its value in no more digits than one reads. @param {Place} place */
  #go({ branch, index }) {
    const { result: diagram } = this.#work;
    if (!diagram) return;
    const on = diagram.cycles[branch];
    const values = { [diagram.parameter]: roundValue(this.quantity(diagram.parameter), on[diagram.parameter][index]) };
    const followed = cycleAt(on, index);
    // Of the round value the cycle is a little another: an unstable one would be left at once.
    const guess = guessOf(this.askCycles((cycles) => cycles.near(followed, values))) ?? followed;
    this.watch?.expect(guess);
    tell(this, 'motion', { values, state: guess.state });
  }

  /** Arrow keys walk along a branch or to another one, Enter goes there. @param {KeyboardEvent} event */
  #key(event) {
    const { result: diagram } = this.#work;
    const [by, to] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] ?? [0, 0];
    const isGoing = event.key === 'Enter' && this.#cursor !== null;
    if (!diagram || this.isVeiled || diagram.cycles.length === 0 || !(by || to || isGoing)) return;
    event.preventDefault();
    event.stopPropagation();
    if (isGoing && this.#cursor) {
      this.#go(this.#cursor);
      return;
    }
    const { cycles, parameter } = diagram;
    const before = this.#cursor ?? this.#beginning(diagram);
    const branch = to ? (before.branch + to + cycles.length) % cycles.length : before.branch;
    const on = cycles[branch];
    // Right is where the value rises, whichever way the branch was walked.
    const rises = on[parameter][on[parameter].length - 1] >= on[parameter][0] ? 1 : -1;
    const index = to ? nearestTo(on, parameter, cycles[before.branch][parameter][before.index]) : this.#cursor ? along(on, before.index, by * rises * (event.shiftKey ? 5 : 1)) : before.index;
    this.#cursor = { branch, index };
    this.#tellCursor(on, index);
    this.requestUpdate();
  }

  /** Where keys begin: where the gear is. @param {import('../../pkg/shimmy.js').Bifurcation} diagram @returns {Place} */
  #beginning({ cycles, parameter }) {
    return { branch: 0, index: nearestTo(cycles[0], parameter, this.scene?.parameters[parameter] ?? 0) };
  }

  /** @param {import('../../pkg/shimmy.js').CycleBranch} branch @param {number} index */
  #tellCursor(branch, index) {
    const { voice } = this;
    const { range, height } = this.#branch;
    const quantity = this.quantity(range.parameter);
    if (!voice || !quantity) return;
    const up = heightsOf(branch, height)[index];
    this.heard = voice.say('branch.cursor', {
      across: `${plainSymbol(quantity)} ${quantity.write(quantity.snapped(branch[range.parameter][index]), voice)}`,
      up: valueOf(shown[height], up, digitsOf(up * shown[height].perSI), voice), kind: voice.say(branch.stable[index] ? 'branch.key.stable' : 'branch.key.unstable'),
    });
  }

  #left = () => {
    this.#cursor = null;
    this.requestUpdate();
  };
}

customElements.define('shimmy-branch', Branch);
