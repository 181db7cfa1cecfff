import { LitElement, html } from 'lit';
import { tell } from '../command.js';

/**
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('../words/voice.js').Key} Key
 * @typedef {{ name: string, title: string, element: string, hasLines: boolean }} View `element`: its canvas, a selector;
 *   `hasLines`: it can be had as SVG, too
 * @typedef {{ what: 'link' | import('./file-of.js').Format, view: string }} Wish
 */

const runFormats = /** @type {const} */ (['csv', 'json', 'python']);

/**
 * The button *Share* with the sheet under it: the link, the run as files, each view on screen as a picture, and a
 * saved run to open. Commands: `out` with a wish, `openFile` with `{ name, text }`. `said` tells what came of it.
 */
export class OutSheet extends LitElement {
  static properties = {
    voice: { attribute: false },
    views: { attribute: false },
    link: { attribute: false },
    hasPython: { attribute: false },
    isReady: { attribute: false },
    said: { attribute: false },
    isSaidBefore: { state: true },
  };

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    /** @type {View[]} */ this.views = [];
    this.link = '';
    this.hasPython = true;
    this.isReady = false;
    this.said = '';
    /** Whether what came of a wish was told before the sheet was opened: it stands no longer. */
    this.isSaidBefore = false;
  }

  createRenderRoot() {
    return this;
  }

  connectedCallback() {
    super.connectedCallback();
    document.addEventListener('pointerdown', this.#leave);
  }

  disconnectedCallback() {
    document.removeEventListener('pointerdown', this.#leave);
    super.disconnectedCallback();
  }

  /** @param {Map<string, unknown>} changed */
  willUpdate(changed) {
    if (changed.has('said')) this.isSaidBefore = false;
  }

  render() {
    const { voice } = this;
    if (!voice) return html``;
    const views = this.views.filter(({ element }) => document.querySelector(element)?.checkVisibility());
    const formats = runFormats.filter((format) => format !== 'python' || this.hasPython);
    return html`
      <details class="out" @keydown=${this.#key} @toggle=${this.#opened}>
        <summary class="framed">
          <svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true"><path d="M10 12.5v-10M6.5 5.5 10 2l3.5 3.5M6 9H4v8.5h12V9h-2"/></svg>
          <span>${voice.say('out.title')}</span>
        </summary>
        <div class="out-sheet">
          <section>
            <h2>${voice.say('out.link')}</h2>
            <p>${voice.say('out.link.does')}</p>
            <div class="out-link">
              <input type="text" readonly .value=${this.link} aria-label=${voice.say('out.link')} @focus=${selectAll} />
              <button type="button" class="primary" ?disabled=${!this.isReady} @click=${() => this.#wish('link')}>${voice.say('out.link.copy')}</button>
            </div>
          </section>
          <section>
            <h2>${voice.say('out.run')}</h2>
            <p>${voice.say('out.run.does')}</p>
            <ul>${formats.map((format) => html`
              <li><button type="button" class="out-file plain" ?disabled=${!this.isReady} @click=${() => this.#wish(format)}>
                <b>${voice.say(`out.${format}`)}</b> <span>${voice.say(`out.${format}.does`)}</span>
              </button></li>`)}</ul>
          </section>
          ${views.length > 0 ? this.#pictures(views, voice) : ''}
          <section>
            <label class="framed out-open" title=${voice.say('out.open.does')}>
              ${voice.say('out.open')}
              <input type="file" class="only-heard" accept=".json,application/json" ?disabled=${!this.isReady} @change=${this.#open} />
            </label>
          </section>
          <p class="out-said" role="status">${this.isSaidBefore ? '' : this.said}</p>
        </div>
      </details>`;
  }

  /** @param {View[]} views that are on the screen @param {Voice} voice */
  #pictures(views, voice) {
    const button = (/** @type {View} */ { name, title }, /** @type {'png' | 'svg'} */ format) => html`
      <button type="button" class="framed" ?disabled=${!this.isReady} @click=${() => this.#wish(format, name)}
        aria-label=${voice.say('out.picture.as', { view: title, format: voice.say(`out.${format}`) })}>${voice.say(`out.${format}`)}</button>`;
    return html`
      <section>
        <h2>${voice.say('out.pictures')}</h2>
        <ul>${views.map((view) => html`
          <li class="out-picture"><span>${view.title}</span> ${button(view, 'png')} ${view.hasLines ? button(view, 'svg') : ''}</li>`)}</ul>
      </section>`;
  }

  get #details() {
    return this.querySelector('details');
  }

  /** What is on the screen is known when the sheet is opened. @param {Event} event */
  #opened(event) {
    if (!(/** @type {HTMLDetailsElement} */ (event.target).open)) return;
    this.isSaidBefore = true;
    this.requestUpdate();
  }

  /** @param {Wish['what']} what @param {string} [view] */
  #wish(what, view = '') {
    tell(this, 'out', /** @type {Wish} */ ({ what, view }));
  }

  /** @param {Event} event */
  async #open(event) {
    const input = /** @type {HTMLInputElement} */ (event.target);
    const file = input.files?.[0];
    if (!file) return;
    const text = await file.text();
    // The same file may be chosen again.
    input.value = '';
    tell(this, 'openFile', { name: file.name, text });
  }

  /** A press elsewhere closes the sheet. @param {PointerEvent} event */
  #leave = (event) => {
    const details = this.#details;
    if (details?.open && !event.composedPath().includes(details)) details.open = false;
  };

  /** @param {KeyboardEvent} event */
  #key(event) {
    const details = this.#details;
    if (event.key !== 'Escape' || !details?.open) return;
    event.preventDefault();
    details.open = false;
    details.querySelector('summary')?.focus();
  }
}

/** @param {FocusEvent} event */
function selectAll(event) {
  /** @type {HTMLInputElement} */ (event.target).select();
}

customElements.define('shimmy-out-sheet', OutSheet);
