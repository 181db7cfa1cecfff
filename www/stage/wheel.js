import { LitElement, html } from 'lit';
import { tell } from '../command.js';
import { turnOfKey } from './gear/grab.js';

/** @typedef {import('../words/voice.js').Voice} Voice */

const degrees = 180 / Math.PI;

/**
 * The wheel for the keyboard and for screen readers: a slider without a picture of its own, laid over the drawn wheel.
 * ← and → twist it, Enter, Escape and leaving it let go. Commands: `hold` with ψ in rad, `release`, `toggle`.
 */
export class Wheel extends LitElement {
  static properties = {
    voice: { attribute: false },
    angle: { attribute: false },
    farthest: { attribute: false },
    isHeld: { attribute: false },
    isPlaying: { attribute: false },
  };

  /** What the keys have turned it to, in rad. */ #twist = 0;

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    /** ψ in rad. */ this.angle = 0;
    /** As far as it can be turned, in rad. */ this.farthest = 1;
    this.isHeld = false;
    this.isPlaying = false;
    /** ψ at this instant, in rad: between two looks the wheel goes on. */ this.angleNow = () => this.angle;
  }

  createRenderRoot() {
    return this;
  }

  render() {
    const { voice, angle, farthest, isHeld, isPlaying } = this;
    if (!voice) return html``;
    const end = (farthest * degrees).toFixed(1);
    // A wheel that swings has no value that could be read out: by the time it is, it is another.
    const value = isPlaying && !isHeld ? voice.say('wheel.swings') : `${voice.number(angle * degrees, 1)}°`;
    return html`
      <div role="slider" tabindex="0" aria-label=${voice.say('wheel.name')} aria-valuemin="-${end}" aria-valuemax=${end}
        aria-valuenow=${(angle * degrees).toFixed(1)} aria-valuetext=${value} aria-description=${voice.say('wheel.does')}
        @keydown=${this.#key} @focus=${this.#changed} @blur=${this.#blur}></div>`;
  }

  /** Whether the keyboard would turn it. */
  get isFocused() {
    return this.querySelector(':focus-visible') !== null;
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const turn = turnOfKey(event);
    if (turn) this.#turn(turn);
    else if (this.isHeld && (event.key === 'Enter' || event.key === 'Escape')) tell(this, 'release');
    else if (event.key === ' ') tell(this, 'toggle');
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** @param {number} turn in rad */
  #turn(turn) {
    const from = this.isHeld ? this.#twist : this.angleNow();
    this.#twist = Math.min(Math.max(from + turn, -this.farthest), this.farthest);
    tell(this, 'hold', this.#twist);
  }

  #blur() {
    if (this.isHeld) tell(this, 'release');
    this.#changed();
  }

  /** The drawing shows the focus. */
  #changed() {
    this.dispatchEvent(new Event('focus-changed', { bubbles: true }));
  }
}

customElements.define('shimmy-wheel', Wheel);
