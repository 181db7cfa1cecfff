import { LitElement, html, svg } from 'lit';
import { tell } from '../command.js';
import { isShownTruly, slowRates } from '../run/rate.js';

/** @typedef {import('../words/voice.js').Voice} Voice */

/**
 * Play, pause, step, back to the start, the rate, a kick. Tells the command that was pressed.
 */
export class Transport extends LitElement {
  static properties = {
    voice: { attribute: false },
    isPlaying: { attribute: false },
    isReady: { attribute: false },
    slow: { attribute: false },
    frequency: { attribute: false },
    kickImpulse: { attribute: false },
  };

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    this.isPlaying = false;
    this.isReady = false;
    this.slow = 50;
    /** @type {number | null} Hz */ this.frequency = null;
    this.kickImpulse = 0;
  }

  createRenderRoot() {
    return this;
  }

  render() {
    const { voice, isPlaying, isReady, slow } = this;
    if (!voice) return html``;
    const press = (/** @type {string} */ what) => () => tell(this, what);
    // Without motion a run is walked through, not watched.
    const [leads, follows] = stillness.matches ? ['primary', 'framed'] : ['framed', 'primary'];
    const start = voice.say('clock.start');
    const time = duration(1 / slow, voice);
    return html`
      <button type="button" class="framed icon start" title=${start} aria-label=${start} ?disabled=${!isReady} @click=${press('start')}>
        <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path d="M2 2h2.5v12H2zM14 2v12L5.5 8z" /></svg>
      </button>
      <button type="button" class="framed step" aria-label=${voice.say('clock.back')} ?disabled=${!isReady} @click=${press('back')}>◂ <span>${voice.say('clock.step')}</span></button>
      <button type="button" class="${follows} play" aria-label=${voice.say(isPlaying ? 'clock.pause' : 'clock.play')} ?disabled=${!isReady} @click=${press('toggle')}>
        <svg viewBox="0 0 16 16" width="14" height="14" aria-hidden="true">${isPlaying
          ? svg`<path d="M2 1h4v14H2zM10 1h4v14h-4z" />`
          : svg`<path d="M3 1l11 7-11 7z" />`}</svg>
        <span>${voice.say(isPlaying ? 'clock.pause' : 'clock.play')}</span>
      </button>
      <button type="button" class="${leads} step" aria-label=${voice.say('clock.on')} ?disabled=${!isReady} @click=${press('on')}><span>${voice.say('clock.step')}</span> ▸</button>
      <select class="framed" aria-label=${voice.say('clock.rate')} .value=${String(slow)} @change=${this.#chosen}>
        ${slowRates.map((rate) => this.#option(rate, voice))}
      </select>
      <span class="scale"><span class="long">${voice.say('clock.scale', { time })}</span><span class="short" aria-hidden="true">1 s = ${time}</span></span>
      <button type="button" class="framed kick" title=${voice.say('clock.kick.does', { impulse: this.kickImpulse })} ?disabled=${!isReady} @click=${press('kick')}>${voice.say('clock.kick')}</button>`;
  }

  /** @param {number} rate @param {Voice} voice */
  #option(rate, voice) {
    const name = rate === 1 ? voice.say('clock.real') : voice.say('clock.slow', { slow: rate });
    const isTrue = isShownTruly(rate, this.frequency);
    return html`<option value=${rate} ?selected=${rate === this.slow} ?disabled=${!isTrue && rate !== this.slow}>
      ${isTrue ? name : voice.say('clock.tooFast', { rate: name })}</option>`;
  }

  /** @param {Event} event */
  #chosen(event) {
    const slow = Number(/** @type {HTMLSelectElement} */ (event.target).value);
    tell(this, 'rate', { mode: 'slow', slow });
  }
}

const stillness = matchMedia('(prefers-reduced-motion: reduce)');

/** @param {number} seconds @param {Voice} voice */
function duration(seconds, voice) {
  return seconds >= 1 ? `${voice.number(seconds, 0)} s` : `${voice.number(seconds * 1000, 0)} ms`;
}

customElements.define('shimmy-transport', Transport);
