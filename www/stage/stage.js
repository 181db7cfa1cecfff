import { LitElement, html } from 'lit';
import './gear-view.js';
import './timeline.js';
import './transport.js';
import './verdict.js';
import { isShownTruly } from '../run/rate.js';
import { kickImpulse } from '../run/session.js';

/**
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {import('../run/scene.js').Scene} Scene
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/** "Starting the engine" is said only to those who wait this long, in ms. */
const patience = 300;
const framesPerSecond = 60;

/** @param {Readonly<Record<string, string>>} views @returns {number | null} null where each run chooses */
const chosenMagnification = (views) => (views.magnification ? Number(views.magnification) : null);

/** The gear, its verdict over it, and the clock under it. */
export class Stage extends LitElement {
  static properties = {
    voice: { attribute: false },
    isVeiled: { attribute: false },
    isBig: { attribute: false },
    isReady: { attribute: false },
    isPlaying: { attribute: false },
    isStill: { attribute: false },
    isHeld: { attribute: false },
    isChosen: { attribute: false },
    mode: { attribute: false },
    slow: { attribute: false },
    quantities: { attribute: false },
    ghostCount: { attribute: false },
    isHeard: { attribute: false },
    views: { attribute: false },
    eigenmode: { attribute: false },
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

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    /** Whether what would tell the future is hidden. */
    this.isVeiled = false;
    /** Whether the verdict takes the room of the side view. */
    this.isBig = false;
    this.isReady = false;
    this.isPlaying = false;
    /** Whether less motion is asked for. */ this.isStill = false;
    /** Whether a hand holds the wheel. */ this.isHeld = false;
    /** @type {import('../run/clock.js').Mode} */ this.mode = 'slow';
    this.slow = 50;
    /** Whether a hand has chosen the slow rate. */ this.isChosen = false;
    /** @type {import('../controls/quantity.js').Quantity[]} */ this.quantities = [];
    this.ghostCount = 0;
    /** Whether the swing is to be heard. */ this.isHeard = false;
    /** What the timeline shows, among others. @type {Readonly<Record<string, string>>} */ this.views = {};
    /** The mode that moves as a ghost on the gear, by its name; null where none does. @type {string | null} */ this.eigenmode = null;
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
    const angle = this.#scene?.state[0] ?? 0;
    return html`
      <div class="gear" role="group" aria-label=${voice.say('stage.name')}>
        <shimmy-gear .voice=${voice} .isReady=${this.isReady} .isHeld=${this.isHeld} .isPlaying=${this.isPlaying} .isBig=${this.isBig}
          .quantities=${this.quantities} .magnification=${chosenMagnification(this.views)} .eigenmode=${this.eigenmode} .angle=${angle}></shimmy-gear>
        <shimmy-verdict .voice=${voice} .outlook=${this.outlook} .isHeld=${this.isHeld} .angle=${angle}
          .occasion=${this.occasion} .isVeiled=${this.isVeiled} .message=${this.#message(voice)}></shimmy-verdict>
      </div>
      <shimmy-transport role="group" aria-label=${voice.say('clock.name')} .voice=${voice} .isPlaying=${this.isPlaying} .isReady=${this.isReady}
        .isStill=${this.isStill} .mode=${this.mode} .slow=${this.slow} .isChosen=${this.isChosen} .frequency=${this.frequency}
        .beat=${this.#beat} .kickImpulse=${kickImpulse} .ghostCount=${this.ghostCount} .isHeard=${this.isHeard}></shimmy-transport>
      <shimmy-timeline .voice=${voice} .time=${this.time} .angle=${angle} .step=${this.step}
        .shown=${this.views.timeline ?? ''} .quantities=${this.quantities} .isVeiled=${this.isVeiled}></shimmy-timeline>`;
  }

  /** What the drawings of the stage need of the session. */
  get wanted() {
    return { moment: this.#moment, trackLength: this.#gear?.trackLength ?? 1, stretches: Math.max(60, Math.round((this.#gear?.size.width ?? 836) / 3)) };
  }

  /** What is drawn now. */
  get scene() {
    return this.#scene;
  }

  /** @param {Scene} scene @param {Theme} theme */
  draw(scene, theme) {
    this.#scene = scene;
    this.#gear?.draw(scene, this.#frame, theme);
    /** @type {import('./timeline.js').Timeline | null} */ (this.querySelector('shimmy-timeline'))?.draw(scene, this.#moment, theme);
  }

  /** @param {Theme} theme */
  drawAtRest(theme) {
    this.#gear?.draw(null, this.#frame, theme);
  }

  get #gear() {
    return /** @type {import('./gear-view.js').GearView | null} */ (this.querySelector('shimmy-gear'));
  }

  /** What the strobe can lock to, in Hz. */
  get #beat() {
    return this.outlook?.present.frequency ?? null;
  }

  /** Model time of a frame, in s; of the strobe, that of a flash. */
  get #frame() {
    const frame = 1 / framesPerSecond;
    if (this.mode === 'slow') return frame / this.slow;
    return this.mode === 'strobe' && this.#beat ? Math.max(frame, 1 / this.#beat) : frame;
  }

  /** The window around now: two and a half seconds of what is seen where it can be seen, a hundred milliseconds at least. @returns {[number, number]} */
  get #moment() {
    const isSeen = this.mode === 'slow' && isShownTruly(this.slow, this.frequency);
    const span = isSeen ? Math.max(0.1, 2.5 / this.slow) : 0.1;
    return [-0.8 * span, 0.2 * span];
  }

  /** @param {Voice} voice */
  #message(voice) {
    if (this.failure) return voice.say('engine.refused', { reason: this.failure });
    if (this.isStopped) return voice.say('verdict.stopped');
    return !this.isReady && this.isSlowToStart ? voice.say('engine.starting') : '';
  }
}

customElements.define('shimmy-stage', Stage);
