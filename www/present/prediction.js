import { LitElement, html } from 'lit';
import { tell } from '../command.js';
import { guesses } from './outcome.js';
import { said } from './said.js';

/**
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('../store.js').State} State
 */

/**
 * Predict and reveal: what becomes of the swing is asked while everything that would tell it is veiled; then the run goes
 * on and shows who was right. A story asks in its own words, and goes on from there. Commands: `guess`, `reveal`,
 * `predictAgain`, `next`, `predict` to leave.
 */
export class Prediction extends LitElement {
  static properties = { voice: { attribute: false }, predict: { attribute: false }, question: { attribute: false } };

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    /** @type {State['predict']} */ this.predict = null;
    /** What a story asks; empty where nobody tells one. */ this.question = '';
  }

  createRenderRoot() {
    return this;
  }

  /** The focus follows: to the panel when it asks, to what comes next when a guess is made. @param {Map<string, unknown>} changed */
  updated(changed) {
    if (!changed.has('predict') || !this.predict) return;
    const { guess, outcome } = this.predict;
    const next = guess && !outcome ? this.querySelector('.reveal') : this.querySelector('.prediction');
    /** @type {HTMLElement | null} */ (next)?.focus({ preventScroll: true });
  }

  render() {
    const { voice, predict } = this;
    if (!voice || !predict) return html``;
    return html`<section class=${predict.outcome ? 'prediction revealed' : 'prediction'} tabindex="-1" aria-label=${voice.say('predict.name')}>
      <p role="status">${predict.outcome ? said(predict, voice) : this.question || voice.say('predict.ask')}</p>
      ${predict.outcome ? this.#after(voice) : this.#asking(predict, voice)}
    </section>`;
  }

  /** @param {NonNullable<State['predict']>} predict @param {Voice} voice */
  #asking({ guess: made }, voice) {
    return html`
      <div class="prediction-choices">
        <div role="group" aria-label=${voice.say('predict.guess')}>${guesses.map((guess, i) => html`
          <button type="button" class="framed" aria-pressed=${made === guess ? 'true' : 'false'} @click=${() => tell(this, 'guess', guess)}>
            <kbd>${i + 1}</kbd> ${voice.say(`predict.${guess}`)}</button>`)}</div>
        <p class="prediction-rule">${voice.say('predict.rule')}</p>
        <button type="button" class="primary reveal" @click=${() => tell(this, 'reveal')}>${voice.say('predict.reveal')}</button>
      </div>`;
  }

  /** @param {Voice} voice */
  #after(voice) {
    return html`
      <div class="prediction-choices">
        <button type="button" class="framed" @click=${() => tell(this, 'predict')}>${voice.say('predict.leave')}</button>
        ${this.question ? html`<button type="button" class="primary" @click=${() => tell(this, 'next')}>${voice.say('story.next')}</button>`
          : html`<button type="button" class="primary" @click=${() => tell(this, 'predictAgain')}>${voice.say('predict.again')}</button>`}
      </div>`;
  }
}

customElements.define('shimmy-prediction', Prediction);
