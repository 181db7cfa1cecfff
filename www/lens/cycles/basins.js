import { html, nothing } from 'lit';
import { tell } from '../../command.js';
import { runJob } from '../../engine/workers.js';
import { limitsFor } from '../../run/fit.js';
import { isSameList } from '../../store.js';
import { twoEndings } from '../../story/presets.js';
import { drawBasins, frameOfBasins, placesOfBasins } from '../../view/basins.js';
import '../../view/canvas.js';
import { cellAt } from '../../view/field.js';
import { hatchOf } from '../../view/hatch.js';
import { quantities as shown, valueOf } from '../../view/quantities.js';
import { BesideWork } from './beside-work.js';
import { colorsOfEndings, endingInWords, spread, swingsOn } from './endings.js';
import { CyclePanel } from './panel.js';
import { PlaneHand } from './plane-hand.js';

/**
 * @typedef {import('../../run/scene.js').Scene} Scene
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('../../pkg/shimmy.js').Basins} Result
 * @typedef {import('../../pkg/shimmy.js').BasinsSpec} Spec
 */

const [columns, rows] = [144, 96];
/** The plane is so much wider than the cycle, and no wider than the model is trusted, in rad. */
const [beyond, widest] = [1.3, 0.6];
/** Of a gear without a cycle, in rad and Hz. */
const usual = { angle: 0.2, frequency: 50 };
/** Digits of a start that a hand chooses. */
const digits = 4;
/** What an arrow key adds, as a share of the plane. */
const step = 0.01;

/**
 * Basins: which motion a start ends in, over torsion angle and torsion rate, the tire undeformed. A hand drags the start over them
 * and the run begins anew from there. Commands: `startFrom` with the start, `point` with the values of a gear with two endings.
 */
export class Basins extends CyclePanel {
  static properties = { ...CyclePanel.properties, spoken: { state: true } };

  /** @type {BesideWork<Spec, Result>} */
  #work = new BesideWork((spec, options) => runJob('basins', spec, options), { isSlow: true });
  #image = document.createElement('canvas');
  /** @type {unknown[]} */ #imageOf = [];
  /** Which ending each cell has. @type {Uint8Array} */ #cells = new Uint8Array();
  /** @type {Float32Array | null} */ #hatch = null;
  /** @type {unknown[]} */ #hatchOf = [];
  /** The plane holds while values change and it still serves. @type {{ object: string, limits: { angle: number, rate: number } } | null} */ #held = null;
  #hand = new PlaneHand({
    places: () => this.#places, point: () => this.#start,
    put: (x, y, gesture) => this.#put(x, y, gesture),
    step: (across, up, factor) => {
      const { limits } = this.#held ?? {};
      const { x, y } = this.#start;
      if (limits) this.#put(x + across * factor * step * limits.angle, y + up * factor * step * limits.rate, 'start keys');
    },
    settle: () => tell(this, 'settle'),
    hover: () => {},
  });

  constructor() {
    super();
    /** What the start says of itself. */ this.spoken = '';
    this.#work.onChange = () => this.requestUpdate();
  }

  disconnectedCallback() {
    this.#work.stop();
    super.disconnectedCallback();
  }

  get #canvas() {
    return /** @type {import('../../view/canvas.js').Canvas | null} */ (this.querySelector('.basins-plane shimmy-canvas'));
  }

  get #places() {
    const size = this.#canvas?.size;
    return size && this.theme && this.#held ? placesOfBasins(size, this.theme, this.#held.limits) : null;
  }

  /** Where the run started, in rad and rad/s. */
  get #start() {
    const { torsionAngle: x = 0, torsionRate: y = 0 } = this.scene?.start ?? {};
    return { x, y };
  }

  /** @param {Scene} scene @param {import('../../style/theme.js').Theme} theme */
  draw(scene, theme) {
    super.draw(scene, theme);
    this.#hold(scene);
    const { limits } = this.#held ?? {};
    if (limits && !this.isVeiled) {
      const { object, parameters } = scene;
      const shape = JSON.stringify([object, limits]);
      this.#work.look({
        key: JSON.stringify([shape, parameters]), shape,
        spec: {
          model: object, parameters: { ...parameters },
          x: { state: 'torsionAngle', from: -limits.angle, to: limits.angle, count: columns }, y: { state: 'torsionRate', from: -limits.rate, to: limits.rate, count: rows },
        },
      });
    }
    this.#canvas?.redraw();
    const { ring } = this.#hand;
    const handle = /** @type {HTMLElement | null} */ (this.querySelector('.plane-point'));
    if (ring && handle) Object.assign(handle.style, { left: `${ring.x.toFixed(1)}px`, top: `${ring.y.toFixed(1)}px` });
    if (this.voice) this.spoken = this.#startInWords(this.voice);
  }

  /** A plane that holds the widest cycle there is, as long as it serves. @param {Scene} scene */
  #hold({ object, outlook }) {
    const cycle = this.isVeiled ? null : this.cycle;
    const angle = Math.max(cycle?.amplitude.torsionAngle ?? 0, this.isVeiled ? 0 : Math.min(outlook.amplitude.torsionAngle, widest)) || usual.angle / beyond;
    const before = this.#held;
    if (before?.object === object && angle * 1.05 <= before.limits.angle && angle > 0.25 * before.limits.angle) return;
    const circle = 2 * Math.PI * (cycle?.frequency ?? outlook.frequency ?? usual.frequency);
    const wide = Math.min(beyond * angle, widest);
    const { angle: across, rate } = limitsFor({ angle: wide, rate: circle * wide, deformation: 0 });
    this.#held = { object, limits: { angle: across, rate } };
  }

  render() {
    const { voice, scene } = this;
    return voice && scene ? this.content(voice) : html``;
  }

  /** @param {Voice} voice */
  content(voice) {
    const { isVeiled, theme } = this;
    const { result } = this.#work;
    const colors = result && theme ? colorsOfEndings(result.endings, theme) : [];
    const known = result?.endings.reduce((sum, { cells }) => sum + cells, 0) ?? 0;
    return html`
      <div class="basins">
        <div class="basins-plane hand-plane">
          <shimmy-canvas .label=${voice.say(isVeiled ? 'basins.name.veiled' : 'basins.name')} .paint=${this.#paint}
            @pointerdown=${this.#hand.press} @pointermove=${this.#hand.move} @pointerup=${this.#hand.lift} @pointercancel=${this.#hand.lift}></shimmy-canvas>
          <div class="plane-point" role="slider" tabindex="0" aria-label=${voice.say('basins.start')} aria-description=${voice.say('basins.start.does')} title=${voice.say('basins.start.does')}
            aria-valuenow=${this.#start.x} aria-valuetext=${this.spoken}
            @pointerdown=${this.#hand.grab} @pointermove=${this.#hand.drag} @pointerup=${this.#hand.release} @pointercancel=${this.#hand.release}
            @lostpointercapture=${this.#hand.release} @keydown=${this.#hand.key}></div>
        </div>
        ${isVeiled ? this.veil(voice) : html`
          <ul class="endings" aria-label=${voice.say('basins.endings')}>${result && theme ? result.endings.map((ending, i) => html`
            <li><span class="swatch ${swingsOn(ending) ? 'swings' : ''}" style="background-color: ${colors[i]}"></span>${endingInWords(ending, voice)} <span class="of">${voice.say('basins.share', { share: shareOf(ending.cells / Math.max(1, known), voice) })}</span></li>`)
            : html`<li>${this.#work.isFailed ? voice.say('stability.none') : voice.say('basins.computing')}</li>`}
            ${this.#offersTwo ? html`<li class="of">${voice.say('basins.one')} <button type="button" class="framed" @click=${this.#showTwo}>${voice.say('basins.two')}</button></li>` : nothing}
            ${this.#work.isGoing && result ? html`<li class="of">${voice.say('basins.progress', { share: voice.number(100 * this.#work.fraction, 0) })}
              <button type="button" class="plain" @click=${() => this.#work.cancel()}>${voice.say('basins.cancel')}</button></li>` : nothing}
          </ul>`}
      </div>`;
  }

  /** @param {Voice} voice */
  #startInWords(voice) {
    const { x, y } = this.#start;
    return `${valueOf(shown.torsionAngle, x, 2, voice)}, ${valueOf(shown.torsionRate, y, 1, voice)}`;
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paint = (context, size) => {
    const { voice, theme, scene, isVeiled } = this;
    if (!voice || !theme || !scene || !this.#held) return;
    const { result, isOld } = this.#work;
    const cycle = isVeiled ? null : this.cycle;
    if (result && !isVeiled) this.#make(result, frameOfBasins(size, theme), theme);
    drawBasins(context, size, {
      limits: this.#held.limits, image: result ? this.#image : null, hatch: this.#hatch, isOld,
      cycle: cycle?.orbit ?? null, isCycleStable: cycle?.stable ?? true, trail: scene.orbitPast, state: scene.state, exposed: scene.exposed, start: this.#start, veiled: isVeiled,
    }, theme, voice);
  };

  /** The cells as a picture, and the hatch over it, made anew only where they, or how they look, have changed. @param {Result} result @param {import('../../view/axes.js').Box} frame @param {import('../../style/theme.js').Theme} theme */
  #make(result, frame, theme) {
    if (!isSameList([result, theme], this.#imageOf)) {
      this.#imageOf = [result, theme];
      this.#cells = spread(result.ending, columns);
      const colors = colorsOfEndings(result.endings, theme);
      const context = this.#image.getContext('2d');
      if (!context) return;
      Object.assign(this.#image, { width: columns, height: rows });
      this.#cells.forEach((ending, cell) => {
        context.fillStyle = colors[ending] ?? theme.surface;
        context.fillRect(cell % columns, rows - 1 - Math.floor(cell / columns), 1, 1);
      });
    }
    const laid = [result, theme, ...Object.values(frame)];
    if (isSameList(laid, this.#hatchOf)) return;
    this.#hatchOf = laid;
    const swings = result.endings.map(swingsOn);
    const field = { values: this.#cells, columns, rows };
    this.#hatch = hatchOf(frame, (across, up) => swings[cellAt(field, across, up)] ?? false, theme);
  }

  /** Whether all starts end alike, though this object has gears where they do not. */
  get #offersTwo() {
    const { result, isGoing, isOld } = this.#work;
    return result?.endings.length === 1 && !isGoing && !isOld && Object.keys(twoEndings.parameters).every((name) => this.quantity(name));
  }

  /** All values of such a gear, which one undo takes back. */
  #showTwo = () => this.put({ ...Object.fromEntries(this.quantities.map(({ name, parameter }) => [name, parameter.default])), ...twoEndings.parameters });

  /** The run begins anew from a start. @param {number} x in rad @param {number} y in rad/s @param {string | null} gesture */
  #put(x, y, gesture) {
    const { limits } = this.#held ?? {};
    if (!limits) return;
    const within = (/** @type {number} */ value, /** @type {number} */ limit) => Number(Math.min(Math.max(value, -limit), limit).toPrecision(digits));
    tell(this, 'startFrom', { state: { torsionAngle: within(x, limits.angle), torsionRate: within(y, limits.rate) }, gesture });
  }
}

/** In per cent; what is there at all is more than 0. @param {number} share @param {Voice} voice */
const shareOf = (share, voice) => voice.number(100 * share, share < 0.01 ? 1 : 0);

customElements.define('shimmy-basins', Basins);
