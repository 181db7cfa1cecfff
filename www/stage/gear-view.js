import { LitElement, html } from 'lit';
import { tell } from '../command.js';
import '../view/canvas.js';
import { magnifications } from '../run/fit.js';
import { ModeGhost } from '../run/mode-ghost.js';
import { gearEn, gearTr } from '../words/gear.js';
import { gearAtRest } from './at-rest.js';
import { drawGear, sheetFor, trackLength } from './gear/draw.js';
import { grabTarget, isOnWheel } from './gear/grab.js';
import { LARGEST_ANGLE } from './gear/pose.js';
import { ghostLabel, modeLabel } from './ghost-label.js';
import { Hand } from './hand.js';
import { layoutName, watchLayout } from './layout.js';
import './wheel.js';

/**
 * @typedef {import('../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../run/scene.js').Scene} Scene
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('./gear/grab.js').Point} Point
 */

const gearWords = { en: gearEn, tr: gearTr };
/** A finger that goes so far sideways, in px, and less than half as far up or down, turns to the other view. */
const shortestSwipe = 40;

/**
 * The gear, and the hand on its wheel: a mouse or a finger that presses on the tire twists it. On a phone, which has room
 * for one view, a swipe beside the wheel or two buttons show the other.
 * Commands: `hold` with ψ in rad, `release`, for a tap `letBe` and `kick`, and `magnify`.
 */
export class GearView extends LitElement {
  static properties = {
    voice: { attribute: false },
    isReady: { attribute: false },
    isHeld: { attribute: false },
    isPlaying: { attribute: false },
    quantities: { attribute: false },
    magnification: { attribute: false },
    angle: { attribute: false },
    isBig: { attribute: false },
    eigenmode: { attribute: false },
    layout: { state: true },
    isFromSide: { state: true },
  };

  /** @type {Scene | null} */ #scene = null;
  /** @type {Theme | null} */ #theme = null;
  /** Model time of a frame, in s. */ #frame = 0;
  #hand = new Hand();
  /** Where a mouse is. @type {Point | null} */ #mouse = null;
  /** Where a finger beside the wheel came down. @type {{ pointer: number, at: Point } | null} */ #swipe = null;
  /** What sets each ghost apart. @type {string[]} */ #labels = [];
  #modes = new ModeGhost();
  /** @type {import('./gear/scene.js').Ghost | null} */ #modeGhost = null;
  #endWatch = () => {};

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    this.isReady = false;
    this.isHeld = false;
    this.isPlaying = false;
    /** @type {Quantity[]} */ this.quantities = [];
    /** Chosen by hand; null where each run chooses. @type {number | null} */ this.magnification = null;
    /** The mode that moves as a ghost, by its name; null where none does. @type {string | null} */ this.eigenmode = null;
    /** ψ as it was told last, in rad. */ this.angle = 0;
    /** Whether the verdict takes the room of the side view. */ this.isBig = false;
    this.layout = layoutName();
    this.isFromSide = false;
  }

  createRenderRoot() {
    return this;
  }

  connectedCallback() {
    super.connectedCallback();
    this.addEventListener('pointerdown', this.#press);
    this.addEventListener('pointermove', this.#move);
    for (const end of /** @type {const} */ (['pointerup', 'pointercancel', 'lostpointercapture'])) this.addEventListener(end, this.#lift);
    this.addEventListener('pointerleave', this.#leave);
    // A finger on the wheel keeps the page from scrolling, one beside it does not; no style can tell them apart.
    this.addEventListener('touchstart', this.#touch, { passive: false });
    this.addEventListener('focus-changed', this.#redraw);
    window.addEventListener('blur', this.#letGo);
    document.addEventListener('visibilitychange', this.#letGo);
    this.#endWatch = watchLayout(() => {
      this.layout = layoutName();
      this.isFromSide = false;
    });
  }

  disconnectedCallback() {
    window.removeEventListener('blur', this.#letGo);
    document.removeEventListener('visibilitychange', this.#letGo);
    this.#endWatch();
    super.disconnectedCallback();
  }

  /** @param {Map<string, unknown>} changed */
  willUpdate(changed) {
    // Something else has taken the wheel out of the hand.
    if (changed.get('isHeld') && !this.isHeld) this.#hand.drop();
    const { voice, quantities } = this;
    const scene = this.#scene;
    this.#labels = voice && scene ? scene.ghosts.map(({ parameters }) => ghostLabel(parameters, scene.parameters, quantities, voice)) : [];
  }

  render() {
    const { voice } = this;
    if (!voice) return html``;
    return html`
      <shimmy-canvas .label=${voice.say('stage.gear')} .paint=${this.#paint}></shimmy-canvas>
      ${this.isReady && !this.isFromSide ? [this.#wheel(voice), this.#magnify(voice)] : ''}
      ${this.layout === 'phone' ? this.#pager(voice) : ''}`;
  }

  /** @param {Map<string, unknown>} changed */
  updated(changed) {
    this.#place();
    // All else comes with a frame, which is drawn anyway.
    if (['layout', 'isFromSide', 'isBig', 'voice'].some((name) => changed.has(name))) this.#redraw();
  }

  /** Of the drawing, in CSS pixels. */
  get size() {
    return this.#canvas?.size ?? { width: 836, height: 500 };
  }

  /** How much of the ground behind is seen, in m. */
  get trackLength() {
    return trackLength(this.size, { layout: this.#drawnLayout, parameters: this.#scene?.parameters ?? gearAtRest.parameters });
  }

  /**
   * @param {Scene | null} scene null before there is a run
   * @param {number} frame model time of a frame, in s
   * @param {Theme} theme
   */
  draw(scene, frame, theme) {
    this.#scene = scene;
    this.#frame = frame;
    this.#theme = theme;
    this.#modeGhost = scene && this.eigenmode !== null ? this.#ghostOfMode(scene, this.eigenmode) : null;
    this.#redraw();
    this.#showCursor();
  }

  get #canvas() {
    return /** @type {import('../view/canvas.js').Canvas | null} */ (this.querySelector('shimmy-canvas'));
  }

  get #wheelElement() {
    return /** @type {import('./wheel.js').Wheel | null} */ (this.querySelector('shimmy-wheel'));
  }

  /** @param {Voice} voice */
  #wheel(voice) {
    const { magnification } = this.#gearScene();
    return html`<shimmy-wheel .voice=${voice} .angle=${this.angle} .angleNow=${() => this.#scene?.state[0] ?? 0}
      .farthest=${LARGEST_ANGLE / magnification} .isHeld=${this.isHeld} .isPlaying=${this.isPlaying}></shimmy-wheel>`;
  }

  /** At the foot of the top view, over the words that say how it is drawn. @param {Voice} voice */
  #magnify(voice) {
    const { magnification } = this;
    const factor = (/** @type {number} */ by) => voice.say('magnify.by', { factor: by });
    const now = factor(this.#gearScene().magnification);
    return html`
      <label class="magnify" title=${voice.say('magnify.name')}>
        <select aria-label=${voice.say('magnify.name')} @change=${this.#magnified}>
          <option value="" ?selected=${magnification === null}>${voice.say('magnify.auto', { now })}</option>
          ${magnifications.map((by) => html`<option value=${by} ?selected=${by === magnification}>${factor(by)}</option>`)}
        </select>
      </label>`;
  }

  /** @param {Voice} voice */
  #pager(voice) {
    const page = (/** @type {boolean} */ isFromSide, /** @type {string} */ name) => html`
      <button type="button" aria-label=${name} title=${name} aria-pressed=${this.isFromSide === isFromSide} @click=${() => this.#turnTo(isFromSide)}></button>`;
    return html`<div class="pager" role="group" aria-label=${voice.say('pager.name')}>
      ${page(false, voice.say('pager.top'))}${page(true, voice.say('pager.side'))}</div>`;
  }

  /** @type {import('../view/canvas.js').Paint} */
  #paint = (context, size) => {
    if (this.#theme && this.voice) drawGear(context, size, this.#gearScene(), this.#theme, gearWords[this.voice.language]);
  };

  /** @returns {import('./gear/scene.js').LayoutName} */
  get #drawnLayout() {
    if (this.isFromSide) return 'phone-side';
    return this.isBig && this.layout !== 'phone' ? 'big' : this.layout;
  }

  #redraw = () => this.#canvas?.redraw();

  /** @returns {import('./gear/scene.js').Scene} */
  #gearScene() {
    const scene = this.#scene;
    const layout = this.#drawnLayout;
    if (!scene) return { ...gearAtRest, layout };
    const { state, parameters, forces, track, roll, extremes, trail, fan, scales } = scene;
    return {
      state, parameters, forces, track, roll, extremes, trail, fan, layout,
      ghosts: [...scene.ghosts.map((ghost, i) => ({ ...ghost, label: this.#labels[i] ?? '' })), ...(this.#modeGhost ? [this.#modeGhost] : [])],
      held: this.isHeld,
      focused: this.#wheelElement?.isFocused ?? false,
      exposure: parameters.velocity * this.#frame,
      magnification: scales.magnification,
      forceScale: scales.forces,
    };
  }

  /** @param {Scene} scene @param {string} name @returns {import('./gear/scene.js').Ghost | null} */
  #ghostOfMode(scene, name) {
    const { voice } = this;
    const ghost = this.#modes.look(scene, name);
    if (!ghost || !voice) return null;
    return { ...ghost, isMode: true, label: modeLabel(ghost.mode, scene.linear.leavesOut, voice) };
  }

  /** Lays the wheel for the keyboard over the drawn one, and the magnification over the foot of the top view. */
  #place() {
    const wheel = this.#wheelElement;
    if (!wheel) return;
    const scene = this.#gearScene();
    const { box } = grabTarget(this.size, scene);
    Object.assign(wheel.style, { left: `${box.x}px`, top: `${box.y}px`, width: `${box.width}px`, height: `${box.height}px` });
    this.style.setProperty('--foot', `${this.size.height - sheetFor(this.size, scene).band.bottom}px`);
  }

  /** @param {Event} event */
  #magnified(event) {
    const { value } = /** @type {HTMLSelectElement} */ (event.target);
    tell(this, 'magnify', value === '' ? null : Number(value));
  }

  /** @param {boolean} isFromSide */
  #turnTo(isFromSide) {
    this.#letGo();
    this.isFromSide = isFromSide;
  }

  /** Where a pointer is on the canvas, if there is a wheel that it could take. @param {{ clientX: number, clientY: number }} event */
  #reach({ clientX, clientY }) {
    const canvas = this.#canvas;
    if (!canvas || !this.#scene || !this.isReady || this.isFromSide) return null;
    const { left, top } = canvas.getBoundingClientRect();
    return { point: { x: clientX - left, y: clientY - top }, size: canvas.size, scene: this.#gearScene() };
  }

  /** @param {PointerEvent} event */
  #press = (event) => {
    if (event.button !== 0 || !isOnPicture(event)) return;
    const reach = this.#reach(event);
    if (reach && this.#hand.press(event.pointerId, reach.point, event.timeStamp, reach.size, reach.scene)) {
      this.setPointerCapture(event.pointerId);
      tell(this, 'hold', reach.scene.state[0]);
      this.#showCursor();
    } else if (this.layout === 'phone' && !this.#hand.isHolding) {
      this.#swipe = { pointer: event.pointerId, at: { x: event.clientX, y: event.clientY } };
    }
  };

  /** @param {PointerEvent} event */
  #move = (event) => {
    const reach = this.#reach(event);
    if (!reach) return;
    if (event.pointerType === 'mouse') this.#mouse = isOnPicture(event) || this.#hand.isHolding ? reach.point : null;
    const angle = this.#hand.move(event.pointerId, reach.point, reach.size, reach.scene);
    if (angle !== null) tell(this, 'hold', angle);
    this.#showCursor();
  };

  /** @param {PointerEvent} event */
  #lift = (event) => {
    const end = this.#hand.lift(event.pointerId, event.timeStamp);
    if (end === 'tap' && event.type === 'pointerup') {
      tell(this, 'letBe');
      tell(this, 'kick');
    } else if (end) {
      tell(this, 'release');
    }
    if (this.#swipe?.pointer === event.pointerId) this.#endSwipe(event);
    this.#showCursor();
  };

  /** @param {PointerEvent} event */
  #endSwipe({ type, clientX, clientY }) {
    const { x, y } = this.#swipe?.at ?? { x: clientX, y: clientY };
    this.#swipe = null;
    const [across, along] = [clientX - x, clientY - y];
    if (type === 'pointerup' && Math.abs(across) >= shortestSwipe && Math.abs(along) < Math.abs(across) / 2) this.#turnTo(across < 0);
  }

  #leave = () => {
    this.#mouse = null;
  };

  /** @param {TouchEvent} event */
  #touch = (event) => {
    const reach = isOnPicture(event) ? this.#reach(event.changedTouches[0]) : null;
    if (this.#hand.isHolding || (reach && isOnWheel(reach.size, reach.scene, reach.point))) event.preventDefault();
  };

  #letGo = () => {
    if (!this.#hand.isHolding) return;
    this.#hand.drop();
    tell(this, 'release');
  };

  /** The wheel moves under a mouse that does not, so this is asked in every frame. */
  #showCursor() {
    const mouse = this.#mouse;
    const size = this.#canvas?.size;
    const isOver = mouse && size && this.#scene && !this.isFromSide && isOnWheel(size, this.#gearScene(), mouse);
    const cursor = this.#hand.isHolding ? 'grabbing' : isOver ? 'grab' : '';
    if (this.style.cursor !== cursor) this.style.cursor = cursor;
  }
}

/** Whether an event is on the drawing, and on no button over it. @param {Event} event */
const isOnPicture = ({ target }) => target instanceof HTMLCanvasElement;

customElements.define('shimmy-gear', GearView);
