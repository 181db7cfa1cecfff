import { html, nothing } from 'lit';
import { tell } from '../../command.js';
import { runJob } from '../../engine/workers.js';
import '../../view/canvas.js';
import { roundLimit } from '../../view/scale.js';
import { drawSwingMap, placesOfSwingMap } from '../../view/swing-map.js';
import { decimalsFor, parseNumber } from '../../words/number.js';
import { BesideWork } from '../cycles/beside-work.js';
import { PlaneHand } from '../cycles/plane-hand.js';
import { plainSymbol, rangeInWords } from '../stability/say.js';
import { amplitudeAt, CalmPicture } from './calm/picture.js';
import { commandFor } from './calm/needed.js';
import { damperOffer } from './offer.js';
import { DamperPanel } from './panel.js';
import { calmAcross, pushOf } from './settings.js';

/**
 * @typedef {import('../../run/scene.js').Scene} Scene
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('../../pkg/shimmy.js').Basins} Basins
 */

const degree = Math.PI / 180;
const command = 'damper.command';
/** Cells of the map, coarse first. */
const [columns, rows] = [36, 28];

/**
 * The damper on the gear: how widely it swings in the end over the current and the speed, or the gap, from a push of a size; and
 * which current calms it where it is now. The gear is a point that a hand drags. Commands: `view` with what is to the right and
 * the push, `point` with values, `fitting` where there is no damper.
 */
export class DamperCalm extends DamperPanel {
  static properties = { ...DamperPanel.properties, spoken: { state: true }, refused: { state: true } };

  /** @type {BesideWork<import('../../pkg/shimmy.js').BasinsSpec, Basins>} */
  #map = new BesideWork((spec, options) => runJob('basins', spec, options), { isSlow: true });
  /** @type {BesideWork<import('./calm/needed.js').Asked, import('./calm/needed.js').Needed>} */
  #needed = new BesideWork((asked, { signal }) => commandFor(asked, (spec) => runJob('basins', spec, { signal })));
  #picture = new CalmPicture();
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
    /** A push that was not taken. */ this.refused = '';
    this.#map.onChange = () => this.requestUpdate();
    this.#needed.onChange = () => this.requestUpdate();
  }

  disconnectedCallback() {
    this.#map.stop();
    this.#needed.stop();
    super.disconnectedCallback();
  }

  /** What is to the right and upward; null where there is no damper, or nothing of that name. */
  get #sides() {
    const range = (/** @type {string} */ name) => {
      const quantity = this.quantity(name);
      return quantity ? { parameter: name, from: quantity.parameter.min, to: quantity.parameter.max, quantity } : null;
    };
    const [x, y] = [range(calmAcross(this.settings.damperMap ?? '')), range(command)];
    return x && y ? { x, y } : null;
  }

  /** The push that motions begin with, in rad. */
  get #push() {
    return pushOf(this.settings.damperPush ?? '');
  }

  get #canvas() {
    return /** @type {import('../../view/canvas.js').Canvas | null} */ (this.querySelector('.calm-map shimmy-canvas'));
  }

  get #places() {
    const sides = this.#sides;
    const size = this.#canvas?.size;
    return sides && size && this.theme ? placesOfSwingMap(size, this.theme, sides.x, sides.y) : null;
  }

  get #point() {
    const sides = this.#sides;
    const parameters = this.scene?.parameters ?? {};
    return { x: parameters[sides?.x.parameter ?? ''] ?? 0, y: parameters[command] ?? 0 };
  }

  /** @param {Scene} scene @param {import('../../style/theme.js').Theme} theme */
  draw(scene, theme) {
    const before = this.scene;
    super.draw(scene, theme);
    if (!before) this.requestUpdate();
    const sides = this.#sides;
    if (sides && !this.isVeiled) {
      const { x, y } = sides;
      const push = this.#push;
      const others = (/** @type {string[]} */ names) => JSON.stringify([scene.object, push, Object.entries(scene.parameters).filter(([name]) => !names.includes(name)), names]);
      const gear = { model: scene.object, parameters: { ...scene.parameters }, initial: { torsionAngle: push } };
      const axis = (/** @type {typeof x} */ { parameter, from, to }, /** @type {number} */ count) => ({ parameter, from, to, count });
      this.#map.look({ key: others([x.parameter, command]), shape: JSON.stringify([scene.object, x.parameter]), spec: { ...gear, x: axis(x, columns), y: axis(y, rows) } });
      this.#needed.look({ key: others([command]), shape: scene.object, spec: { gear, command: { from: y.from, to: y.to }, velocity: scene.parameters.velocity } });
    }
    this.#redraw();
  }

  #redraw() {
    const { x, y } = this.#point;
    this.redrawWhere('.calm-map shimmy-canvas', [this.#map.result, this.#map.isOld, this.settings, this.quantities, this.voice, this.isVeiled, this.theme, this.#hover, x, y]);
    const { ring } = this.#hand;
    const handle = /** @type {HTMLElement | null} */ (this.querySelector('.plane-point'));
    if (ring && handle) Object.assign(handle.style, { left: `${ring.x.toFixed(1)}px`, top: `${ring.y.toFixed(1)}px` });
    if (this.voice) this.spoken = this.#readings(this.#point, this.voice)[0];
  }

  /** @param {Voice} voice @param {Scene} scene */
  content(voice, scene) {
    const sides = this.#sides;
    if (!sides) return damperOffer(this, scene.object, voice);
    const { x, y } = sides;
    const does = voice.say('stability.point.does');
    return html`
      <div class="calm">
        <div class="plane-choices">
          <select class="framed" aria-label=${voice.say('calm.across')} .value=${x.parameter} @change=${(/** @type {Event} */ event) => this.choose('damperMap', /** @type {HTMLSelectElement} */ (event.target).value)}>
            ${['velocity', 'freeplayAngle'].filter((name) => this.quantity(name)).map((name) => html`<option value=${name} ?selected=${name === x.parameter}>${voice.say(/** @type {'calm.over.velocity'} */ (`calm.over.${name}`))}</option>`)}
          </select>
          <label>${voice.say('calm.push')} <input type="text" inputmode="decimal" class="number" aria-invalid=${this.refused ? 'true' : 'false'} .value=${this.refused || voice.number(this.#push / degree, 2)} @change=${this.#typed} /> °</label>
        </div>
        <div class="calm-map hand-plane">
          <shimmy-canvas .label=${voice.say(this.isVeiled ? 'gap.map.veiled' : 'gap.map', { x: rangeInWords(x.quantity, x, voice), y: rangeInWords(y.quantity, y, voice) })} .paint=${this.#paint}
            @pointerdown=${this.#hand.press} @pointermove=${this.#hand.move} @pointerup=${this.#hand.lift} @pointercancel=${this.#hand.lift} @pointerleave=${this.#hand.leave}></shimmy-canvas>
          <div class="plane-point" role="slider" tabindex="0" aria-label=${voice.say('stability.point')} aria-description=${does} title=${does}
            aria-valuemin=${x.from} aria-valuemax=${x.to} aria-valuenow=${this.#point.x} aria-valuetext=${this.spoken}
            @pointerdown=${this.#hand.grab} @pointermove=${this.#hand.drag} @pointerup=${this.#hand.release} @pointercancel=${this.#hand.release}
            @lostpointercapture=${this.#hand.release} @keydown=${this.#hand.key}></div>
        </div>
        ${this.isVeiled ? this.veil(voice) : html`
          <p class="calm-answer" role="status">${this.#answer(sides, voice)}</p>
          ${this.#map.isGoing ? html`<p class="damper-rate">${voice.say('basins.progress', { share: voice.number(100 * this.#map.fraction, 0) })} <button type="button" class="plain" @click=${() => this.#map.cancel()}>${voice.say('basins.cancel')}</button></p>` : nothing}`}
      </div>`;
  }

  /** @param {Event} event */
  #typed = (event) => {
    const { value } = /** @type {HTMLInputElement} */ (event.target);
    const push = parseNumber(value) * degree;
    const isTaken = push > 0 && push <= 1;
    this.refused = isTaken ? '' : value;
    if (isTaken) this.choose('damperPush', String(Number(push.toPrecision(6))));
  };

  /** Which command calms the gear where it is. @param {{ y: { from: number, to: number, quantity: import('../../controls/quantity.js').Quantity } }} sides @param {Voice} voice */
  #answer({ y }, voice) {
    const { result, isOld, isFailed } = this.#needed;
    const velocity = this.quantity('velocity');
    if (isFailed) return voice.say('stability.none');
    if (!result || !velocity || !this.scene) return voice.say('calm.asking');
    const where = { speed: velocity.write(this.scene.parameters.velocity, voice), push: `${voice.number(this.#push / degree, 2)}°` };
    if (result.command === null) return voice.say('calm.never', { ...where, most: y.quantity.write(y.to, voice) });
    const needed = y.quantity.write(result.command, voice);
    return html`<span class=${isOld ? 'old' : ''}>${result.command <= y.from ? voice.say('calm.always', where) : voice.say('calm.needs', { ...where, command: needed })}</span>
      <button type="button" class="framed" @click=${() => this.put({ [command]: /** @type {number} */ (result.command) })}>${voice.say('calm.set', { command: needed })}</button>`;
  }

  /** What becomes of a gear at a point of the map. @param {{ x: number, y: number }} point @param {Voice} voice */
  #readings({ x, y }, voice) {
    const sides = this.#sides;
    if (!sides) return [''];
    const named = (/** @type {typeof sides.x} */ { quantity }, /** @type {number} */ value) => `${plainSymbol(quantity)} ${quantity.write(quantity.snapped(value), voice)}`;
    const where = [named(sides.x, x), named(sides.y, y)];
    const { result } = this.#map;
    const amplitude = result && !this.isVeiled ? amplitudeAt(result, columns, rows, (x - sides.x.from) / (sides.x.to - sides.x.from), (y - sides.y.from) / (sides.y.to - sides.y.from)) : null;
    if (amplitude === null) return [where.join(', ')];
    const what = amplitude === 0 ? voice.say('gap.rests') : amplitude > 1 ? voice.say('basins.divergence') : `±${voice.number(amplitude / degree, Math.min(2, decimalsFor(amplitude / degree, 3)))}°`;
    return [voice.say('stability.reading', { x: where[0], y: where[1], what }), what];
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paint = (context, size) => {
    const { voice, theme, isVeiled } = this;
    const sides = this.#sides;
    if (!voice || !theme || !sides) return;
    const { result, isOld } = this.#map;
    const places = placesOfSwingMap(size, theme, sides.x, sides.y);
    const most = result ? result.amplitude.reduce((high, value) => (value < 1 ? Math.max(high, value) : high), degree) : degree;
    const limit = Math.min(30, roundLimit(most / degree / 1.12)) * degree;
    const made = result && !isVeiled ? this.#picture.of(context, result, { columns, rows, limit, frame: places.frame, isWhole: !this.#map.isGoing, calm: voice.say('gap.rests') }, theme) : null;
    const read = this.#hover ? { x: places.valueX(this.#hover.x), y: places.valueY(this.#hover.y) } : this.#point;
    drawSwingMap(context, size, { ...sides, image: made?.image ?? null, isOld, sheet: made?.sheet ?? null, curves: [], limit, point: this.#point, readings: this.#readings(read, voice), veiled: isVeiled }, theme, voice);
  };

  /** @param {number} x in SI @param {number} y @param {string | null} gesture */
  #put(x, y, gesture) {
    const sides = this.#sides;
    if (!sides) return;
    const within = (/** @type {typeof sides.x} */ { from, to, quantity }, /** @type {number} */ value) => Math.min(Math.max(quantity.snapped(value), from), to);
    tell(this, 'point', { values: { [sides.x.parameter]: within(sides.x, x), [command]: within(sides.y, y) }, gesture });
  }

  /** @param {number} across in steps @param {number} up @param {number} factor */
  #step(across, up, factor) {
    const sides = this.#sides;
    if (!sides) return;
    const { x, y } = this.#point;
    this.#put(sides.x.quantity.stepped(x, across * factor), sides.y.quantity.stepped(y, up * factor), 'calm keys');
  }
}

customElements.define('shimmy-damper-calm', DamperCalm);
