import { LitElement, html, svg } from 'lit';
import { veil } from '../present/veil.js';
import { mannerOf } from './manner.js';
import { heldLine, numbersOf, wordOf } from './verdict-line.js';

/**
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/** How long a spoken verdict stands before the next may be spoken, in ms. */
const shortestSilence = 2000;
/** How long it is left to be heard, in ms: later its numbers are those of another moment, and what is seen is read instead. */
const heardFor = 5000;

/**
 * One word and two numbers: what the motion does, how wide, how fast, where it heads. All of it from the engine's
 * outlook. A screen reader hears it when the word changes, the motion settles or a hand lets go, not at every number.
 */
export class Verdict extends LitElement {
  static properties = {
    outlook: { attribute: false }, voice: { attribute: false }, message: { attribute: false }, occasion: { attribute: false },
    isVeiled: { attribute: false }, isHeld: { attribute: false }, angle: { attribute: false }, spoken: { state: true },
  };

  #spokenKey = '';
  #spokenAt = -Infinity;
  /** @type {ReturnType<typeof setTimeout> | undefined} */ #later;

  constructor() {
    super();
    /** @type {Outlook | null} */ this.outlook = null;
    /** @type {Voice | null} */ this.voice = null;
    /** Said instead of a verdict: the engine is starting, or refused to. */
    this.message = '';
    /** Counts the changes that a hand has ended. */
    this.occasion = 0;
    /** Whether a hand holds the wheel: then the motion is the hand's, and there is none to judge. */ this.isHeld = false;
    /** ψ now, in rad. */ this.angle = 0;
    /** Whether it is to be guessed first. */
    this.isVeiled = false;
    this.spoken = '';
  }

  createRenderRoot() {
    return this;
  }

  willUpdate() {
    if (this.isVeiled) this.#hush();
    else if (this.outlook && this.voice && !this.isHeld) this.#speak(this.outlook, this.voice);
  }

  disconnectedCallback() {
    clearTimeout(this.#later);
    super.disconnectedCallback();
  }

  render() {
    const { outlook, voice } = this;
    if (!voice) return html``;
    if (this.message) return html`<p class="verdict-message" role="status">${this.message}</p>`;
    if (this.isHeld) return html`
      <h1 data-verdict="held">${icon('held')}<span>${voice.say('verdict.held')}</span></h1>
      <p class="verdict-numbers">${heldLine(this.angle, voice)}</p>`;
    if (this.isVeiled) return html`<h1 class="verdict-veil">${veil(voice)}</h1>`;
    if (!outlook) return html``;
    const manner = mannerOf(outlook);
    return html`
      <h1 data-verdict=${manner}>${icon(manner)}<span>${voice.say(wordOf(outlook))}</span></h1>
      <p class="verdict-numbers">${numbersOf(outlook, voice).map(({ text, isExtra }, i) => html`
        <span class=${isExtra ? 'extra' : ''}>${i ? html`<span class="dot">·</span> ` : ''}${text}</span>`)}</p>
      <p class="only-heard" aria-live="polite">${this.spoken}</p>`;
  }

  /** What was spoken is heard no more; the next verdict is spoken at once. */
  #hush() {
    clearTimeout(this.#later);
    this.#spokenKey = '';
    this.#spokenAt = -Infinity;
    this.spoken = '';
  }

  /** @param {Outlook} outlook @param {Voice} voice */
  #speak(outlook, voice) {
    const manner = mannerOf(outlook);
    const key = `${voice.language} ${manner} ${outlook.settled} ${outlook.held} ${this.occasion}`;
    if (key === this.#spokenKey) return;
    clearTimeout(this.#later);
    const wait = this.#spokenAt + shortestSilence - performance.now();
    if (wait > 0) {
      this.#later = setTimeout(() => this.requestUpdate(), wait);
      return;
    }
    this.#spokenKey = key;
    this.#spokenAt = performance.now();
    this.spoken = [voice.say(wordOf(outlook)), ...numbersOf(outlook, voice).map(({ text }) => text)].join(', ');
    this.#later = setTimeout(() => { this.spoken = ''; }, heardFor);
  }
}

/** @param {import('./manner.js').Manner | 'held'} manner */
function icon(manner) {
  const line = {
    shimmies: svg`<path class="unstable" d="M2 15c3 0 3-4 5-4s3 9 6 9 3-16 6-16 3 12 6 12"/>`,
    grows: svg`<path class="unstable" d="M2 13c2 0 2-3 4-3s3 8 6 8 3-14 6-14 3 18 8 18"/>`,
    'dies-out': svg`<path class="stable" d="M2 4c4 0 3 16 7 16s4-11 7-11 3 5 5 5 2-2 5-2"/>`,
    rattles: svg`<path class="gap" d="M3 2v20M25 2v20"/><path class="psi" d="M6 14l5-6 6 8 5-6"/>`,
    held: svg`<path class="psi" d="M8 22c-3-4-6-7-6-9 0-2 2-2 3-1l3 3V5c0-2 3-2 3 0v6-8c0-2 3-2 3 0v8-7c0-2 3-2 3 0v8-5c0-2 3-2 3 0v8c0 4-2 6-3 7"/>`,
    creeps: svg`<path class="stable" d="M2 4c2 11 8 15 24 16"/>`,
    stops: svg`<path class="stable" d="M2 20c3 0 4-14 8-14s5 6 7 6h9"/>`,
    rests: svg`<path class="stable" d="M2 12h24"/>`,
  }[manner];
  return html`<svg viewBox="0 0 28 24" width="28" height="24" aria-hidden="true">${line}</svg>`;
}

customElements.define('shimmy-verdict', Verdict);
