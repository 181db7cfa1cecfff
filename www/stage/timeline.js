import { LitElement, html } from 'lit';
import { tell } from '../command.js';
import '../view/canvas.js';
import { cursorWords } from '../view/cursors.js';
import { linear } from '../view/scale.js';
import { joined } from '../view/time-history.js';
import { drawTimeline, limitOf, since } from './draw-timeline.js';
import { ghostLabel } from './ghost-label.js';
import { lanesOf } from './lanes.js';
import { ReadingCursors } from './reading-cursors.js';

/**
 * @typedef {import('../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('../view/time-history.js').StateName} StateName
 * @typedef {import('../run/scene.js').Scene} Scene
 */

const degrees = 180 / Math.PI;
/** What the lower lane can show, the first unless another is asked for. */
const states = /** @type {const} */ (['torsionAngle', 'torsionRate', 'lateralDeformation']);
/** A press that moves no further than this is a click, in px. */
const widestClick = 4;
/** One arrow key moves a cursor by this share of the lane. */
const cursorStep = 0.01;

/**
 * Time as two lanes: the whole run with what comes, and the instants around now. Dragging either moves the time; so do
 * the arrow keys. Over the lower lane the mouse reads, a click pins what it reads, a second gives the difference; with the
 * keys Enter brings such a cursor and pins it, Escape takes all away.
 * Commands: `seek` with the time wanted, `settle` at the end of a drag, `view` for another state, `toggle`.
 */
export class Timeline extends LitElement {
  static properties = {
    voice: { attribute: false }, time: { attribute: false }, angle: { attribute: false }, shown: { attribute: false },
    quantities: { attribute: false }, isVeiled: { attribute: false }, reading: { state: true },
  };

  /** @type {{ pointer: number, lane: 'run' | 'moment', x: number, time: number, isClick: boolean } | null} */ #grip = null;
  #cursors = new ReadingCursors();
  /** Whether the arrow keys move the cursor instead of the time. */ #isReading = false;
  /** @type {Scene | null} */ #scene = null;
  /** The time last asked for, until it is drawn: keys come faster than frames. @type {number | null} */ #sought = null;
  /** @type {Theme | null} */ #theme = null;
  /** @type {[number, number]} */ #moment = [-0.08, 0.02];
  /** What sets each ghost apart. @type {string[]} */ #labels = [];

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    this.time = 0;
    this.angle = 0;
    /** Which state the lower lane shows; '' for the first. */ this.shown = '';
    /** @type {Quantity[]} */ this.quantities = [];
    /** Whether what would tell the future is hidden. */ this.isVeiled = false;
    /** Model time of one arrow key, in s. */ this.step = 0.001;
    /** What the keys' cursor reads. */ this.reading = '';
  }

  createRenderRoot() {
    return this;
  }

  willUpdate() {
    const { voice, quantities } = this;
    const scene = this.#scene;
    this.#labels = voice && scene ? scene.ghosts.map(({ parameters }) => ghostLabel(parameters, scene.parameters, quantities, voice)) : [];
  }

  render() {
    const { voice } = this;
    if (!voice) return html``;
    const valueText = voice.say('timeline.value', {
      time: voice.number(this.time, 3), angle: `${voice.number(this.angle * degrees, 1)}°`,
    });
    const run = this.#scene?.run ?? { from: 0, to: 60 };
    return html`
      <div class="timeline-grip" role="slider" tabindex="0" aria-label=${voice.say('timeline.name')} aria-description=${voice.say('timeline.does')}
        aria-valuemin=${run.from.toFixed(3)} aria-valuemax=${run.to.toFixed(3)} aria-valuenow=${this.time.toFixed(3)} aria-valuetext=${this.reading || valueText}
        @pointerdown=${this.#grab} @pointermove=${this.#move} @pointerup=${this.#release} @pointercancel=${this.#release}
        @lostpointercapture=${this.#release} @pointerleave=${this.#leave} @keydown=${this.#key} @blur=${this.#endReading}>
        <shimmy-canvas aria-hidden="true" .paint=${this.#paint}></shimmy-canvas>
      </div>
      <label class="shown" title=${voice.say('timeline.shown')}>
        <select aria-label=${voice.say('timeline.shown')} @change=${this.#choose}>
          ${states.map((state) => html`<option value=${state} ?selected=${state === this.#state}>${voice.say(`state.${state}`)}</option>`)}
        </select>
      </label>`;
  }

  /** @param {Map<string, unknown>} changed */
  updated(changed) {
    // Time and angle come with a frame, which is drawn anyway.
    if (['voice', 'shown', 'quantities', 'isVeiled', 'reading'].some((name) => changed.has(name))) this.#canvas?.redraw();
  }

  /**
   * @param {Scene} scene
   * @param {[number, number]} moment the window of the lower lane, in s around now
   * @param {Theme} theme
   */
  draw(scene, moment, theme) {
    this.#scene = scene;
    this.#sought = null;
    this.#theme = theme;
    this.#moment = moment;
    this.#canvas?.redraw();
  }

  get #canvas() {
    return /** @type {import('../view/canvas.js').Canvas | null} */ (this.querySelector('shimmy-canvas'));
  }

  /** @returns {StateName} */
  get #state() {
    return states.find((state) => state === this.shown) ?? states[0];
  }

  get #lanes() {
    const size = this.#canvas?.size;
    return size && this.#theme ? lanesOf(size, this.#theme) : null;
  }

  /** What can be read, in s around now. @returns {[number, number]} */
  get #window() {
    const [from, to] = this.#moment;
    const scene = this.#scene;
    return [scene ? Math.max(from, scene.past.time[0] - scene.time) : from, this.isVeiled ? 0 : to];
  }

  /** @type {import('../view/canvas.js').Paint} */
  #paint = (context, size) => {
    const { voice } = this;
    const scene = this.#scene;
    const theme = this.#theme;
    if (!voice || !scene || !theme) return;
    const lanes = lanesOf(size, theme);
    this.toggleAttribute('data-words', lanes.hasWords);
    const cursors = scene.fan ? [] : this.#cursors.at(scene.time, this.#window);
    drawTimeline(context, lanes, { scene, moment: this.#moment, shown: this.#state, cursors, labels: this.#labels, isVeiled: this.isVeiled }, theme, voice);
  };

  /** @param {PointerEvent} event */
  #grab(event) {
    const scene = this.#scene;
    const lanes = this.#lanes;
    if (!scene || !lanes || this.#grip || event.button !== 0) return;
    const at = place(event);
    const lane = lanes.run && at.y < lanes.run.bottom + 8 ? 'run' : 'moment';
    this.#grip = { pointer: event.pointerId, lane, x: at.x, time: scene.time, isClick: lane === 'moment' };
    /** @type {HTMLElement} */ (event.currentTarget).setPointerCapture(event.pointerId);
    if (lane === 'run') this.#drag(at.x);
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const grip = this.#grip;
    const { x, y } = place(event);
    if (!grip) {
      if (event.pointerType === 'mouse') this.#hover(x, y);
      return;
    }
    if (grip.pointer !== event.pointerId) return;
    if (grip.isClick && Math.abs(x - grip.x) < widestClick) return;
    if (grip.isClick) this.#cursors.takeLoose();
    grip.isClick = false;
    this.#drag(x);
  }

  /** @param {number} x */
  #drag(x) {
    const grip = this.#grip;
    const scene = this.#scene;
    const lanes = this.#lanes;
    if (!grip || !scene || !lanes) return;
    if (grip.lane === 'run' && lanes.run) {
      this.#seek(linear([lanes.run.left, lanes.run.right], [scene.run.from, scene.run.to])(x));
      return;
    }
    // The lower lane is taken along like a strip of paper: to the left is on in time.
    const secondsPerPixel = (this.#moment[1] - this.#moment[0]) / (lanes.moment.right - lanes.moment.left);
    this.#seek(grip.time - (x - grip.x) * secondsPerPixel);
  }

  /** @param {PointerEvent} event */
  #release(event) {
    const grip = this.#grip;
    if (grip?.pointer !== event.pointerId) return;
    this.#grip = null;
    if (!grip.isClick) tell(this, 'settle');
    else if (event.type === 'pointerup') this.#pinAt(grip.x);
  }

  /** The mouse reads where it is over the lower lane. @param {number} x @param {number} y */
  #hover(x, y) {
    const offset = this.#offsetAt(x, y);
    if (offset === null) this.#leave();
    else this.#cursors.put(offset, this.#window);
    this.#canvas?.redraw();
  }

  #leave() {
    if (this.#isReading || this.#grip) return;
    this.#cursors.takeLoose();
    this.#canvas?.redraw();
  }

  /** The time under a point of the lower lane, in s from now; null beside it. @param {number} x @param {number} [y] */
  #offsetAt(x, y) {
    const lanes = this.#lanes;
    if (!lanes) return null;
    const { left, right, top, bottom } = lanes.moment;
    if (x < left || x > right || (y !== undefined && (y < top - 8 || y > bottom + 8))) return null;
    return linear([left, right], this.#moment)(x);
  }

  /** @param {number} x */
  #pinAt(x) {
    const offset = this.#offsetAt(x);
    if (offset === null || !this.#scene) return;
    const [from, to] = this.#window;
    this.#cursors.takeLoose();
    this.#cursors.pin(Math.min(Math.max(offset, from), to), this.#scene.time, [from, to]);
    this.#canvas?.redraw();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (event.altKey || event.metaKey || !this.#scene) return;
    const isTaken = this.#cursorKey(event) || (!event.ctrlKey && this.#timeKey(event));
    if (!isTaken) return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** Enter brings the cursor and pins it (while something is veiled it reveals), Ctrl with an arrow brings it too, Escape takes all away. @param {KeyboardEvent} event */
  #cursorKey({ key, ctrlKey, shiftKey }) {
    const scene = this.#scene;
    if (!scene) return false;
    const [from, to] = this.#window;
    const steps = { ArrowLeft: -1, ArrowRight: 1, Home: -Infinity, End: Infinity }[key];
    if (key === 'Escape' && !this.#cursors.isEmpty) {
      this.#cursors.clear();
      this.#isReading = false;
    } else if (key === 'Enter' && this.#isReading) {
      this.#cursors.pinLoose(scene.time, [from, to]);
    } else if (key === 'Enter' && !this.isVeiled) {
      this.#isReading = true;
      this.#cursors.put(0, [from, to]);
    } else if (steps && (this.#isReading || ctrlKey)) {
      this.#isReading = true;
      this.#cursors.move(steps * cursorStep * (this.#moment[1] - this.#moment[0]) * (shiftKey ? 10 : 1), [from, to]);
    } else {
      return false;
    }
    this.#read();
    return true;
  }

  /** @param {KeyboardEvent} event */
  #timeKey({ key, shiftKey }) {
    const scene = this.#scene;
    if (key === ' ') tell(this, 'toggle');
    const steps = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[key];
    if (!scene || !(steps || key === 'Home' || key === 'End')) return key === ' ';
    const { from, to } = scene.run;
    // The lane grows when now comes near its end; End stays short of that, or each press would move it.
    const end = from + (to - from) / 1.101;
    const step = (steps ?? 0) * this.step * (shiftKey ? 10 : 1);
    this.#seek(steps ? (this.#sought ?? scene.time) + step : key === 'Home' ? from : end);
    tell(this, 'settle');
    return true;
  }

  /** What the keys' cursor reads is said. */
  #read() {
    const { voice } = this;
    const scene = this.#scene;
    if (!voice || !scene) return;
    const state = this.#state;
    const past = since(scene.past, scene.time);
    const history = this.isVeiled ? past : joined(past, scene.future, state);
    const cursors = this.#cursors.at(scene.time, this.#window);
    this.reading = this.#isReading ? cursorWords(cursors, history, state, scene.scales.limits[limitOf[state]], voice) : '';
    this.#canvas?.redraw();
  }

  #endReading() {
    this.#isReading = false;
    this.reading = '';
    this.#cursors.takeLoose();
    this.#canvas?.redraw();
  }

  /** @param {Event} event */
  #choose(event) {
    tell(this, 'view', { of: 'timeline', shows: /** @type {HTMLSelectElement} */ (event.target).value });
  }

  /** @param {number} time */
  #seek(time) {
    this.#sought = Math.max(0, time);
    tell(this, 'seek', this.#sought);
  }
}

/** @param {PointerEvent} event */
function place(event) {
  const { left, top } = /** @type {HTMLElement} */ (event.currentTarget).getBoundingClientRect();
  return { x: event.clientX - left, y: event.clientY - top };
}

customElements.define('shimmy-timeline', Timeline);
