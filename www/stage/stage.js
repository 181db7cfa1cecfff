import { LitElement, html } from 'lit';
import '../view/canvas.js';
import './timeline.js';
import './transport.js';
import './verdict.js';
import { kickImpulse } from '../run/session.js';
import { gearEn, gearTr } from '../words/gear.js';
import { gearAtRest } from './at-rest.js';
import { drawGear, trackLength } from './gear/draw.js';

/**
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {import('../run/scene.js').Scene} Scene
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 */

const gearWords = { en: gearEn, tr: gearTr };

/** "Starting the engine" is said only to those who wait this long, in ms. */
const patience = 300;
const framesPerSecond = 60;

/** The gear, its verdict over it, and the clock under it. */
export class Stage extends LitElement {
  static properties = {
    voice: { attribute: false },
    isVeiled: { attribute: false },
    isReady: { attribute: false },
    isPlaying: { attribute: false },
    mode: { attribute: false },
    slow: { attribute: false },
    views: { attribute: false },
    step: { attribute: false },
    failure: { attribute: false },
    isStopped: { attribute: false },
    outlook: { attribute: false },
    time: { attribute: false },
    frequency: { attribute: false },
    occasion: { attribute: false },
    isSlowToStart: { state: true },
  };

  /** @type {Scene | null} */ #scene = null;
  /** @type {Theme | null} */ #theme = null;

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    /** Whether what would tell the future is hidden. */
    this.isVeiled = false;
    this.isReady = false;
    this.isPlaying = false;
    /** @type {import('../run/clock.js').Mode} */ this.mode = 'slow';
    this.slow = 50;
    /** What the timeline shows, among others. @type {Readonly<Record<string, string>>} */ this.views = {};
    this.step = 0.001;
    this.failure = '';
    /** Whether the run has left what can be computed. */
    this.isStopped = false;
    /** @type {Outlook | null} */ this.outlook = null;
    this.time = 0;
    /** @type {number | null} */ this.frequency = null;
    /** Counts the changes that a hand has ended. */
    this.occasion = 0;
    this.isSlowToStart = false;
    setTimeout(() => { this.isSlowToStart = true; }, patience);
  }

  createRenderRoot() {
    return this;
  }

  render() {
    const { voice } = this;
    if (!voice) return html``;
    return html`
      <div class="gear" role="group" aria-label=${voice.say('stage.name')}>
        <shimmy-canvas .label=${voice.say('stage.gear')} .paint=${this.#paint}></shimmy-canvas>
        <shimmy-verdict .voice=${voice} .outlook=${this.outlook} .occasion=${this.occasion} .message=${this.#message(voice)}></shimmy-verdict>
      </div>
      <shimmy-transport role="group" aria-label=${voice.say('clock.name')} .voice=${voice} .isPlaying=${this.isPlaying} .isReady=${this.isReady}
        .slow=${this.slow} .frequency=${this.frequency} .kickImpulse=${kickImpulse}></shimmy-transport>
      <shimmy-timeline .voice=${voice} .time=${this.time} .angle=${this.#scene?.state[0] ?? 0} .step=${this.step}></shimmy-timeline>`;
  }

  /** What the drawings of the stage need of the session. */
  get wanted() {
    const size = this.#canvas?.size ?? { width: 836, height: 500 };
    return {
      moment: this.#moment,
      trackLength: trackLength(size, { layout: layoutName(), parameters: this.#scene?.parameters ?? gearAtRest.parameters }),
      stretches: Math.max(60, Math.round(size.width / 3)),
    };
  }

  /** @param {Scene} scene @param {Theme} theme */
  draw(scene, theme) {
    this.#scene = scene;
    this.#theme = theme;
    this.#canvas?.redraw();
    /** @type {import('./timeline.js').Timeline | null} */ (this.querySelector('shimmy-timeline'))?.draw(scene, this.#moment, theme);
  }

  /** @param {Theme} theme */
  drawAtRest(theme) {
    this.#theme = theme;
    this.#canvas?.redraw();
  }

  get #canvas() {
    return /** @type {import('../view/canvas.js').Canvas | null} */ (this.querySelector('.gear shimmy-canvas'));
  }

  /** The window around now: five seconds of what is seen, a hundred milliseconds at least. @returns {[number, number]} */
  get #moment() {
    const span = Math.max(0.1, 2.5 / this.slow);
    return [-0.8 * span, 0.2 * span];
  }

  /** @type {import('../view/canvas.js').Paint} */
  #paint = (context, size) => {
    const theme = this.#theme;
    if (!theme || !this.voice) return;
    drawGear(context, size, this.#gearScene(), theme, gearWords[this.voice.language]);
  };

  /** @returns {import('./gear/scene.js').Scene} */
  #gearScene() {
    const scene = this.#scene;
    const layout = layoutName();
    if (!scene) return { ...gearAtRest, layout };
    const { state, parameters, forces, track, roll, extremes, trail, scales } = scene;
    return {
      state, parameters, forces, track, roll, extremes, trail, layout,
      exposure: parameters.velocity / (this.slow * framesPerSecond),
      magnification: scales.magnification,
      forceScale: scales.forces,
    };
  }

  /** @param {Voice} voice */
  #message(voice) {
    if (this.failure) return voice.say('engine.refused', { reason: this.failure });
    if (this.isStopped) return voice.say('verdict.stopped');
    return !this.isReady && this.isSlowToStart ? voice.say('engine.starting') : '';
  }
}

const topViewOnly = matchMedia('(max-width: 699px), (max-height: 639px)');
const projector = matchMedia('(min-width: 1000px) and (max-width: 1099px) and (min-height: 640px)');

/** @returns {import('./gear/scene.js').LayoutName} the layout in force, as style/layout.css has it */
function layoutName() {
  return topViewOnly.matches ? 'phone' : projector.matches ? 'projector' : 'desktop';
}

customElements.define('shimmy-stage', Stage);
