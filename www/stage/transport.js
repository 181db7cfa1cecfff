import { LitElement, html, svg } from 'lit';
import { tell } from '../command.js';
import { mostGhosts } from '../run/ghosts.js';
import './rate-choice.js';

/** @typedef {import('../words/voice.js').Voice} Voice */

/** What is said, from much room to little: see style/clock.css. */
const rooms = ['all', 'short', 'bare', 'few', 'none'];

/**
 * Play, pause, step, back to the start, how fast time goes and what that is called, a kick, a ghost. Tells the command
 * that was pressed.
 */
export class Transport extends LitElement {
  static properties = {
    voice: { attribute: false },
    isPlaying: { attribute: false },
    isReady: { attribute: false },
    isStill: { attribute: false },
    mode: { attribute: false },
    slow: { attribute: false },
    isChosen: { attribute: false },
    frequency: { attribute: false },
    beat: { attribute: false },
    kickImpulse: { attribute: false },
    ghostCount: { attribute: false },
    isHeard: { attribute: false },
  };

  #observer = new ResizeObserver(() => this.#fit());
  /** What was fitted last: measuring makes the browser lay out the page. */ #fitted = '';

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    this.isPlaying = false;
    this.isReady = false;
    /** Without motion a run is walked through, not watched. */
    this.isStill = false;
    /** @type {import('../run/clock.js').Mode} */ this.mode = 'slow';
    this.slow = 50;
    /** Whether a hand has chosen the slow rate. */
    this.isChosen = false;
    /** Of the motion, in Hz. @type {number | null} */ this.frequency = null;
    /** What the strobe can lock to, in Hz. @type {number | null} */ this.beat = null;
    this.kickImpulse = 0;
    this.ghostCount = 0;
    /** Whether the swing is to be heard. */ this.isHeard = false;
  }

  createRenderRoot() {
    return this;
  }

  connectedCallback() {
    super.connectedCallback();
    // Words are measured anew in the page's own typeface.
    document.fonts.ready.then(() => this.#fit());
    this.#observer.observe(this);
  }

  disconnectedCallback() {
    this.#observer.disconnect();
    super.disconnectedCallback();
  }

  updated() {
    // Its words may be others now; they are there only when the rate has been drawn.
    /** @type {import('./rate-choice.js').RateChoice | null} */ (this.querySelector('shimmy-rate'))?.updateComplete.then(() => this.#fitWhereOther());
  }

  render() {
    const { voice, isPlaying, isReady } = this;
    if (!voice) return html``;
    const [leads, follows] = this.isStill ? ['primary', 'framed'] : ['framed', 'primary'];
    const start = voice.say('clock.start');
    const does = voice.say(isPlaying ? 'clock.pause' : 'clock.play');
    return html`
      <button type="button" class="framed icon start" title=${start} aria-label=${start} ?disabled=${!isReady} @click=${this.#press('start')}>
        <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path d="M2 2h2.5v12H2zM14 2v12L5.5 8z" /></svg>
      </button>
      <button type="button" class="framed step back" aria-label=${voice.say('clock.back')} ?disabled=${!isReady} @click=${this.#press('back')}>◂ <span>${voice.say('clock.step')}</span></button>
      <button type="button" class="${follows} play" aria-label=${does} ?disabled=${!isReady} @click=${this.#press('toggle')}>
        <svg viewBox="0 0 16 16" width="14" height="14" aria-hidden="true">${isPlaying
          ? svg`<path d="M2 1h4v14H2zM10 1h4v14h-4z" />`
          : svg`<path d="M3 1l11 7-11 7z" />`}</svg>
        <span>${does}</span>
      </button>
      <button type="button" class="${leads} step on" aria-label=${voice.say('clock.on')} ?disabled=${!isReady} @click=${this.#press('on')}><span>${voice.say('clock.step')}</span> ▸</button>
      <shimmy-rate .voice=${voice} .isStill=${this.isStill} .mode=${this.mode} .slow=${this.slow} .isChosen=${this.isChosen}
        .frequency=${this.frequency} .beat=${this.beat}></shimmy-rate>
      <button type="button" class="framed icon sound" title="${voice.say('sound.does')} (M)" aria-label=${voice.say('sound.hear')} aria-pressed=${this.isHeard ? 'true' : 'false'} ?disabled=${!isReady} @click=${this.#press('sound')}>
        <svg viewBox="0 0 16 16" width="18" height="18" aria-hidden="true"><path d="M1 5.5h2.6L7.5 2v12L3.6 10.5H1z" />${this.isHeard
          ? svg`<path class="waves" d="M9.8 5.6a3.4 3.4 0 0 1 0 4.8M12 3.4a6.5 6.5 0 0 1 0 9.2" />`
          : svg`<path class="waves" d="M10 5.8l4.4 4.4M14.4 5.8l-4.4 4.4" />`}</svg>
      </button>
      <button type="button" class="framed kick" title=${voice.say('clock.kick.does', { impulse: this.kickImpulse })} ?disabled=${!isReady} @click=${this.#press('kick')}>${voice.say('clock.kick')}</button>
      ${this.#pin(voice)}`;
  }

  /** Fits where the words have become others. */
  #fitWhereOther() {
    const words = this.textContent ?? '';
    if (words === this.#fitted) return;
    this.#fitted = words;
    this.#fit();
  }

  /** As many words as there is room for: none is cut. */
  #fit() {
    const scale = this.querySelector('.scale');
    if (!scale) return;
    for (const room of rooms) {
      this.dataset.room = room;
      // Two lines at most, where the words may break.
      if (scale.clientWidth > 0 && scale.scrollWidth <= scale.clientWidth && scale.clientHeight < 0.75 * this.clientHeight) return;
    }
  }

  /** A full sheet takes no more ghosts, and the command says so. @param {Voice} voice */
  #pin(voice) {
    const { ghostCount } = this;
    const name = voice.say('clock.pin') + (ghostCount > 0 ? ` (${ghostCount})` : '');
    const does = voice.say(ghostCount < mostGhosts ? 'clock.pin.does' : 'clock.pin.full', { count: mostGhosts });
    return html`<button type="button" class="framed pin" title=${does} aria-disabled=${ghostCount >= mostGhosts}
      ?disabled=${!this.isReady} @click=${this.#press('pin')}>${name}</button>`;
  }

  /** @param {string} what */
  #press(what) {
    return () => tell(this, what);
  }
}

customElements.define('shimmy-transport', Transport);
