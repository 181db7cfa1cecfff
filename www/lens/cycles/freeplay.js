import { html } from 'lit';
import { tell } from '../../command.js';
import { runJob } from '../../engine/workers.js';
import { isSameList } from '../../store.js';
import { drawBifurcation } from '../../view/bifurcation.js';
import '../../view/canvas.js';
import { valueIn } from '../../view/field.js';
import { colorsOfSwings, paintPixels } from '../../view/map-colors.js';
import { numberedLines } from '../../view/map-sheet.js';
import { roundLimit } from '../../view/scale.js';
import { drawSwingMap, placesOfSwingMap } from '../../view/swing-map.js';
import { decimalsFor } from '../../words/number.js';
import { ForceLaws } from '../force-laws.js';
import { parameterOption } from '../stability/option.js';
import { lowerName, plainSymbol, rangeInWords } from '../stability/say.js';
import { BesideWork } from './beside-work.js';
import { highest, slopeOfSmall } from './branches.js';
import { lineOf, restOf } from './diagram.js';
import { CyclePanel } from './panel.js';
import { PlaneHand } from './plane-hand.js';
import { gapBelowOf, gapBelows, gapParameter, gapRanges } from './settings.js';
import { SwingPlane } from './swing-plane.js';

/**
 * @typedef {import('../../run/scene.js').Scene} Scene
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

const degree = Math.PI / 180;
/** Lines of equal swing, in degrees. */
const levels = [0.5, 1, 2, 3, 5, 10, 15, 20, 30];

/**
 * Freeplay: how widely the gear swings in the end over the gap and the speed, or the damping, with the gear as a point that a hand
 * drags; and beneath it the branch over the gap, with the straight line of small rattles. Commands: `view` with what is to the
 * right, `point` with both values.
 */
export class Freeplay extends CyclePanel {
  static properties = { ...CyclePanel.properties, spoken: { state: true } };

  #plane = new SwingPlane((spec, options) => runJob('bifurcation', spec, options));
  /** @type {BesideWork<import('../../pkg/shimmy.js').BifurcationSpec, import('../../pkg/shimmy.js').Bifurcation>} */
  #work = new BesideWork((spec, options) => runJob('bifurcation', spec, options));
  #laws = new ForceLaws();
  #image = document.createElement('canvas');
  /** What the image was made from. @type {unknown[]} */ #imageOf = [];
  /** @type {Pick<import('../../view/map-sheet.js').MapSheet, 'lines' | 'numbers'> | null} */ #sheet = null;
  /** @type {unknown[]} */ #sheetOf = [];
  /** Where the mouse reads, in px. @type {{ x: number, y: number } | null} */ #hover = null;
  #hand = new PlaneHand({
    places: () => this.#places, point: () => this.#point,
    put: (x, y, gesture) => this.#put(x, y, gesture), step: (across, up, factor) => this.#step(across, up, factor),
    settle: () => tell(this, 'settle'),
    hover: (at) => {
      this.#hover = at;
      this.#redraw();
    },
  });

  constructor() {
    super();
    /** What the point says of itself. */ this.spoken = '';
    this.#plane.onChange = () => this.#redraw();
    this.#work.onChange = () => this.#redraw();
  }

  disconnectedCallback() {
    this.#plane.stop();
    this.#work.stop();
    super.disconnectedCallback();
  }

  get #sides() {
    const { x, y } = gapRanges(this.settings.gapMap ?? '', this.quantities.map(({ parameter }) => parameter));
    const [across, up] = [x && this.quantity(x.parameter), y && this.quantity(y.parameter)];
    return x && y && across && up ? { x: { ...x, quantity: across }, y: { ...y, quantity: up } } : null;
  }

  get #canvas() {
    return /** @type {import('../../view/canvas.js').Canvas | null} */ (this.querySelector('.gap-map shimmy-canvas'));
  }

  get #places() {
    const sides = this.#sides;
    const size = this.#canvas?.size;
    return sides && size && this.theme ? placesOfSwingMap(size, this.theme, sides.x, sides.y) : null;
  }

  get #point() {
    const sides = this.#sides;
    const parameters = this.scene?.parameters ?? {};
    return { x: parameters[sides?.x.parameter ?? ''] ?? 0, y: parameters[sides?.y.parameter ?? ''] ?? 0 };
  }

  /** @param {Scene} scene @param {import('../../style/theme.js').Theme} theme */
  draw(scene, theme) {
    super.draw(scene, theme);
    const sides = this.#sides;
    if (!sides || this.isVeiled) {
      this.#redraw();
      return;
    }
    const { x, y } = sides;
    const others = (/** @type {string[]} */ names) => JSON.stringify([scene.object, Object.entries(scene.parameters).filter(([name]) => !names.includes(name)), names]);
    const gear = { model: scene.object, parameters: { ...scene.parameters } };
    this.#plane.look({ key: others([x.parameter, y.parameter]), shape: JSON.stringify([scene.object, x.parameter]), gear, x: rangeOf(x), y: rangeOf(y) });
    this.#work.look({ key: others([gapParameter]), shape: scene.object, spec: { ...gear, ...rangeOf(y) } });
    this.#redraw();
  }

  #redraw() {
    const { x, y } = this.#point;
    const always = [this.settings, this.quantities, this.voice, this.isVeiled, this.theme];
    const { amplitudes, isOld, share } = this.#plane;
    this.redrawWhere('.gap-map shimmy-canvas', [...always, amplitudes, isOld, share, this.#hover, x, y]);
    this.redrawWhere('.gap-branch', [...always, this.#work.result, this.#work.isOld, this.#work.isFailed, this.cycle, y, this.scene?.outlook.present.amplitude]);
    /** @type {import('../../view/canvas.js').Canvas | null} */ (this.querySelector('.gap-law'))?.redraw();
    const { ring } = this.#hand;
    const handle = /** @type {HTMLElement | null} */ (this.querySelector('.plane-point'));
    if (ring && handle) Object.assign(handle.style, { left: `${ring.x.toFixed(1)}px`, top: `${ring.y.toFixed(1)}px` });
    if (this.voice) this.spoken = this.#readings(this.#point, this.voice)[0];
  }

  render() {
    const { voice, scene } = this;
    return voice && scene ? this.content(voice) : html``;
  }

  /** @param {Voice} voice */
  content(voice) {
    const sides = this.#sides;
    if (!sides) return html`<p class="panel-empty">${voice.say('gap.foreign')}</p>`;
    const { x, y } = sides;
    const below = gapBelowOf(this.settings.gapBelow ?? '');
    const does = voice.say('stability.point.does', { across: lowerName(x.quantity, voice), up: lowerName(y.quantity, voice) });
    return html`
      <div class="gap">
        <div class="plane-choices">
          <span>${voice.say('gap.over', { gap: plainSymbol(y.quantity) })}</span>
          <select class="framed" aria-label=${voice.say('stability.across')} .value=${x.parameter}
            @change=${(/** @type {Event} */ event) => tell(this, 'view', { of: 'gapMap', shows: /** @type {HTMLSelectElement} */ (event.target).value })}>
            ${this.quantities.filter(({ name }) => name !== gapParameter).map((one) => parameterOption(one, x.parameter, voice))}
          </select>
          <select class="framed" aria-label=${voice.say('gap.below')} title=${voice.say('gap.below')} .value=${below}
            @change=${(/** @type {Event} */ event) => this.choose('gapBelow', /** @type {HTMLSelectElement} */ (event.target).value)}>
            ${gapBelows.map((one) => html`<option value=${one} ?selected=${one === below}>${voice.say(`gap.below.${one}`)}</option>`)}
          </select>
        </div>
        <div class="gap-map hand-plane">
          <shimmy-canvas .label=${voice.say(this.isVeiled ? 'gap.map.veiled' : 'gap.map', { x: rangeInWords(x.quantity, x, voice), y: rangeInWords(y.quantity, y, voice) })} .paint=${this.#paintMap}
            @pointerdown=${this.#hand.press} @pointermove=${this.#hand.move} @pointerup=${this.#hand.lift} @pointercancel=${this.#hand.lift} @pointerleave=${this.#hand.leave}></shimmy-canvas>
          <div class="plane-point" role="slider" tabindex="0" aria-label=${voice.say('stability.point')} aria-description=${does} title=${does}
            aria-valuemin=${x.from} aria-valuemax=${x.to} aria-valuenow=${this.#point.x} aria-valuetext=${this.spoken}
            @pointerdown=${this.#hand.grab} @pointermove=${this.#hand.drag} @pointerup=${this.#hand.release} @pointercancel=${this.#hand.release}
            @lostpointercapture=${this.#hand.release} @keydown=${this.#hand.key}></div>
        </div>
        ${below === 'law' ? html`<shimmy-canvas class="gap-below gap-law" .label=${voice.say('gap.law')} .paint=${this.#paintLaw}></shimmy-canvas>`
          : this.isVeiled ? this.veil(voice) : html`<shimmy-canvas class="gap-below gap-branch" .label=${voice.say('gap.branch')} .paint=${this.#paintBranch}></shimmy-canvas>`}
      </div>`;
  }

  /** What becomes of a gear at a point of the map. @param {{ x: number, y: number }} point @param {Voice} voice */
  #readings({ x, y }, voice) {
    const sides = this.#sides;
    const { amplitudes } = this.#plane;
    if (!sides) return [''];
    const where = [[sides.x, x], [sides.y, y]].map(([side, value]) => {
      const { quantity } = /** @type {typeof sides.x} */ (side);
      return `${plainSymbol(quantity)} ${quantity.write(quantity.snapped(/** @type {number} */ (value)), voice)}`;
    }).join(', ');
    if (this.isVeiled || !amplitudes) return [where];
    const share = (/** @type {typeof sides.x} */ { from, to }, /** @type {number} */ value) => (value - from) / (to - from);
    const amplitude = valueIn(amplitudes, share(sides.x, x), share(sides.y, y)) / degree;
    const what = amplitude < 0.005 ? voice.say('gap.rests') : `±${voice.number(amplitude, Math.min(2, decimalsFor(amplitude, 3)))}°`;
    return [voice.say('stability.reading', { x: where.split(', ')[0], y: where.split(', ')[1], what }), what];
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paintMap = (context, size) => {
    const { voice, theme, scene, isVeiled } = this;
    const sides = this.#sides;
    if (!voice || !theme || !scene || !sides) return;
    const { amplitudes, isOld, share } = this.#plane;
    const places = placesOfSwingMap(size, theme, sides.x, sides.y);
    const limit = amplitudes ? this.#limit(amplitudes.values) : 1;
    if (amplitudes && !isVeiled) this.#make(context, places.frame, amplitudes, limit, share, theme, voice);
    const read = this.#hover ? { x: places.valueX(this.#hover.x), y: places.valueY(this.#hover.y) } : this.#point;
    drawSwingMap(context, size, {
      ...sides, image: amplitudes ? this.#image : null, isOld, sheet: this.#sheet, limit, point: this.#point, readings: this.#readings(read, voice), veiled: isVeiled,
    }, theme, voice);
  };

  /** @param {Float64Array} values */
  #limit(values) {
    const most = values.reduce((high, value) => Math.max(high, value), 0.1 * degree);
    return Math.min(30, roundLimit(most / degree / 1.12)) * degree;
  }

  /** Image and lines, made anew only where something has changed; lines once all is there. @param {CanvasRenderingContext2D} context @param {import('../../view/axes.js').Box} frame @param {import('./swing-plane.js').Amplitudes} amplitudes @param {number} limit @param {number} share @param {import('../../style/theme.js').Theme} theme @param {Voice} voice */
  #make(context, frame, amplitudes, limit, share, theme, voice) {
    if (!isSameList([amplitudes, theme, limit], this.#imageOf)) {
      this.#imageOf = [amplitudes, theme, limit];
      const { columns, rows } = amplitudes;
      const on = this.#image.getContext('2d');
      if (!on) return;
      Object.assign(this.#image, { width: columns, height: rows });
      const pixels = on.createImageData(columns, rows);
      paintPixels(amplitudes, colorsOfSwings(limit, theme), pixels.data);
      on.putImageData(pixels, 0, 0);
    }
    const laid = [amplitudes, theme, voice, ...Object.values(frame)];
    if (isSameList(laid, this.#sheetOf)) return;
    this.#sheetOf = laid;
    const marks = levels.filter((level) => level * degree < limit * 2).map((level) => ({ value: level * degree, text: `${voice.number(level, level < 1 ? 1 : 0)}°` }));
    this.#sheet = share < 1 ? null : numberedLines(context, frame, amplitudes, marks, [], theme);
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paintBranch = (context, size) => {
    const { voice, theme, scene, isVeiled } = this;
    const sides = this.#sides;
    const { result: diagram, isOld, isFailed } = this.#work;
    if (!voice || !theme || !scene || !sides || isVeiled) return;
    const slope = diagram && slopeOfSmall(diagram);
    const most = diagram ? highest(diagram, 'torsionAngle') : 0;
    const { cycle } = this;
    drawBifurcation(context, size, {
      quantity: sides.y.quantity, from: sides.y.from, to: sides.y.to, height: 'torsionAngle', limit: roundLimit(Math.max(most / degree, 0.1)) * degree,
      rest: diagram && restOf(diagram, 'torsionAngle', scene.parameters['friction.moment'] ?? 0),
      branches: diagram?.cycles.map((_, i) => lineOf(diagram, i, 'torsionAngle')) ?? [],
      points: [], law: slope === null ? null : { slope, text: voice.say('branch.law', { slope: voice.number(slope, 2) }) }, sweep: [],
      now: { value: this.#point.y, motion: scene.outlook.present.amplitude, cycle: cycle && { up: cycle.amplitude.torsionAngle, stable: cycle.stable ?? true } },
      cursor: null, isOld: isOld && diagram !== null, veiled: false,
      message: isFailed ? voice.say('stability.none') : diagram === null ? voice.say('branch.computing') : diagram.cycles.length === 0 && !isOld ? voice.say('branch.none') : '',
    }, theme, voice);
  };

  /** The law moves with the gear, and tells nothing of what comes. @type {import('../../view/canvas.js').Paint} */
  #paintLaw = (context, size) => {
    const { voice, theme, scene } = this;
    if (voice && theme && scene) this.#laws.paint(context, size, { scene, shown: ['restoringMoment'] }, theme, voice);
  };

  /** @param {number} x in SI @param {number} y @param {string | null} gesture */
  #put(x, y, gesture) {
    const sides = this.#sides;
    if (!sides) return;
    const within = (/** @type {typeof sides.x} */ { from, to, quantity }, /** @type {number} */ value) => Math.min(Math.max(quantity.snapped(value), from), to);
    tell(this, 'point', { values: { [sides.x.parameter]: within(sides.x, x), [sides.y.parameter]: within(sides.y, y) }, gesture });
  }

  /** @param {number} across @param {number} up @param {number} factor */
  #step(across, up, factor) {
    const sides = this.#sides;
    if (!sides) return;
    const { parameter, quantity, from, to } = across ? sides.x : sides.y;
    const value = this.scene?.parameters[parameter] ?? 0;
    const next = quantity.stepped(value, (across || up) * factor);
    tell(this, 'point', { values: { [parameter]: Math.min(Math.max(next, Math.min(from, value)), Math.max(to, value)) }, gesture: `point keys ${parameter}` });
  }
}

/** @param {import('../../run/linear-looks.js').Range} side */
const rangeOf = ({ parameter, from, to }) => ({ parameter, from, to });

customElements.define('shimmy-freeplay', Freeplay);
