import { LitElement, html } from 'lit';
import { tell } from '../command.js';
import '../view/canvas.js';
import { linear } from '../view/scale.js';
import { textFont } from '../view/text.js';
import { drawRunEnvelope } from '../view/run-envelope.js';
import { drawTimeHistory } from '../view/time-history.js';

/**
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('../view/canvas.js').Size} Size
 * @typedef {import('../view/axes.js').Box} Box
 * @typedef {import('../run/scene.js').Scene} Scene
 */

const degrees = 180 / Math.PI;

/**
 * Time as two lanes: the whole run with what comes, and the instants around now. Dragging either moves the time; so
 * do the arrow keys. Commands: `seek` with the time wanted, `settle` at the end of a drag.
 */
export class Timeline extends LitElement {
  static properties = { voice: { attribute: false }, time: { attribute: false }, angle: { attribute: false } };

  /** @type {{ lane: 'run' | 'moment', x: number, time: number } | null} */ #grip = null;
  /** @type {Scene | null} */ #scene = null;
  /** @type {Theme | null} */ #theme = null;
  /** @type {[number, number]} */ #moment = [-0.08, 0.02];

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    this.time = 0;
    this.angle = 0;
    /** Model time of one arrow key, in s. */
    this.step = 0.001;
  }

  createRenderRoot() {
    return this;
  }

  render() {
    const { voice } = this;
    if (!voice) return html``;
    const valueText = voice.say('timeline.value', {
      time: voice.number(this.time, 3), angle: `${voice.number(this.angle * degrees, 1)}°`,
    });
    const run = this.#scene?.run ?? { from: 0, to: 60 };
    return html`
      <div class="timeline-grip" role="slider" tabindex="0" aria-label=${voice.say('timeline.name')}
        aria-valuemin=${run.from.toFixed(3)} aria-valuemax=${run.to.toFixed(3)} aria-valuenow=${this.time.toFixed(3)} aria-valuetext=${valueText}
        @pointerdown=${this.#grab} @pointermove=${this.#drag} @pointerup=${this.#release} @pointercancel=${this.#release}
        @keydown=${this.#key}>
        <shimmy-canvas aria-hidden="true" .paint=${this.#paint}></shimmy-canvas>
      </div>`;
  }

  /**
   * @param {Scene} scene
   * @param {[number, number]} moment the window of the lower lane, in s around now
   * @param {Theme} theme
   */
  draw(scene, moment, theme) {
    this.#scene = scene;
    this.#theme = theme;
    this.#moment = moment;
    this.#canvas?.redraw();
  }

  get #canvas() {
    return /** @type {import('../view/canvas.js').Canvas | null} */ (this.querySelector('shimmy-canvas'));
  }

  /** @type {import('../view/canvas.js').Paint} */
  #paint = (context, size) => {
    const { voice } = this;
    const scene = this.#scene;
    const theme = this.#theme;
    if (!voice || !scene || !theme) return;
    const { run, moment, hasWords } = lanesOf(size, theme);
    const [from, to] = this.#moment;
    const limit = scene.scales.limits.angle;
    if (run) this.#paintRun(context, run, scene, theme, voice, hasWords);
    drawTimeHistory(context, moment, {
      past: relative(scene.past, scene.time),
      future: scene.future,
      from, to, limit,
      freeplay: scene.parameters.freeplayAngle ?? 0,
      value: scene.state[0],
      frequency: scene.outlook.present.frequency ?? null,
    }, theme, voice, { isSmall: !hasWords });
  };

  /** @param {CanvasRenderingContext2D} context @param {Box} box @param {Scene} scene @param {Theme} theme @param {Voice} voice @param {boolean} hasWords */
  #paintRun(context, box, { run, time }, theme, voice, hasWords) {
    const [from, to] = this.#moment;
    drawRunEnvelope(context, box, { ...run, now: time, bracket: [time + from, time + to] }, theme);
    context.font = textFont(theme, 0.9);
    context.fillStyle = theme.ink2;
    context.textBaseline = 'middle';
    context.textAlign = 'left';
    context.fillText(voice.say('timeline.run'), theme.size * 1.1, (box.top + box.bottom) / 2);
    context.fillText(`${voice.number(run.to, run.to < 10 ? 1 : 0)} s`, box.right + theme.size * 0.5, (box.top + box.bottom) / 2);
    if (!hasWords) return;
    context.textBaseline = 'alphabetic';
    context.textAlign = 'right';
    const words = voice.say('timeline.future');
    if (context.measureText(words).width < (box.right - box.left) * 0.42) context.fillText(words, box.right, box.bottom + theme.size * 1.5);
  }

  /** @param {PointerEvent} event */
  #grab(event) {
    const canvas = this.#canvas;
    const scene = this.#scene;
    if (!canvas || !scene || !this.#theme || event.button !== 0) return;
    const { run } = lanesOf(canvas.size, this.#theme);
    const at = place(event);
    const lane = run && at.y < run.bottom + 8 ? 'run' : 'moment';
    this.#grip = { lane, x: at.x, time: scene.time };
    /** @type {HTMLElement} */ (event.currentTarget).setPointerCapture(event.pointerId);
    if (lane === 'run') this.#drag(event);
  }

  /** @param {PointerEvent} event */
  #drag(event) {
    const grip = this.#grip;
    const scene = this.#scene;
    const canvas = this.#canvas;
    if (!grip || !scene || !canvas || !this.#theme) return;
    const { run, moment } = lanesOf(canvas.size, this.#theme);
    const { x } = place(event);
    if (grip.lane === 'run' && run) {
      this.#seek(linear([run.left, run.right], [scene.run.from, scene.run.to])(x));
      return;
    }
    // The lower lane is taken along like a strip of paper: to the left is on in time.
    const secondsPerPixel = (this.#moment[1] - this.#moment[0]) / (moment.right - moment.left);
    this.#seek(grip.time - (x - grip.x) * secondsPerPixel);
  }

  #release() {
    if (!this.#grip) return;
    this.#grip = null;
    tell(this, 'settle');
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const steps = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
    const tenths = { PageDown: -1, PageUp: 1, Home: -Infinity, End: Infinity }[event.key];
    const scene = this.#scene;
    if (!scene || !(steps || tenths)) return;
    event.preventDefault();
    event.stopPropagation();
    const { from, to } = scene.run;
    // The lane grows when now comes near its end; End stays short of that, or each press would move it.
    const end = from + (to - from) / 1.101;
    const jumped = Math.min(Math.max(scene.time + (tenths ?? 0) * 0.1 * (to - from), from), tenths === Infinity ? end : to);
    this.#seek(steps ? scene.time + steps * this.step * (event.shiftKey ? 10 : 1) : jumped);
    tell(this, 'settle');
  }

  /** @param {number} time */
  #seek(time) {
    tell(this, 'seek', Math.max(0, time));
  }
}

/**
 * Where the lanes are; a low timeline (a phone) has the lower one only.
 * @param {Size} size
 * @param {Theme} theme
 * @returns {{ run: Box | null, moment: Box, hasWords: boolean }}
 */
function lanesOf({ width, height }, theme) {
  const left = theme.size * 4.4;
  const right = width - theme.size * 1.6;
  const bottom = height - theme.size * 1.7;
  if (height < 110) return { run: null, moment: { left, right, top: theme.size * 0.5, bottom }, hasWords: false };
  // The run's lane leaves room for the time at its end.
  const run = { left, right: right - theme.size * 1.6, top: theme.size * 0.6, bottom: theme.size * 0.6 + height * 0.25 };
  // With large type (a projector) the words between the lanes give way to the lanes.
  const hasWords = height > 10 * theme.size;
  return { run, moment: { left, right, top: run.bottom + theme.size * (hasWords ? 2.3 : 1.1), bottom }, hasWords };
}

/** @param {{ time: Float64Array, torsionAngle: Float64Array }} history @param {number} now */
function relative({ time, torsionAngle }, now) {
  return { time: time.map((at) => at - now), torsionAngle };
}

/** @param {PointerEvent} event */
function place(event) {
  const { left, top } = /** @type {HTMLElement} */ (event.currentTarget).getBoundingClientRect();
  return { x: event.clientX - left, y: event.clientY - top };
}

customElements.define('shimmy-timeline', Timeline);
