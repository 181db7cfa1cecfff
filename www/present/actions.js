import { LitElement, html, nothing } from 'lit';
import { tell } from '../command.js';

/** @typedef {import('../words/voice.js').Voice} Voice */

/**
 * What the page's head offers to whoever shows the page to others: predict, pen, and, while a pen is in hand, what a pen
 * needs. Commands: `predict`, `pen`, `penUndo`, `penClear`, `penPin`.
 */
export class Actions extends LitElement {
  static properties = {
    voice: { attribute: false },
    isReady: { attribute: false },
    isPredicting: { attribute: false },
    isDrawing: { attribute: false },
    isPinned: { attribute: false },
  };

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    this.isReady = false;
    this.isPredicting = false;
    /** Whether a pen is in hand. */ this.isDrawing = false;
    /** Whether ink stays though the run goes on. */ this.isPinned = false;
  }

  createRenderRoot() {
    return this;
  }

  render() {
    const { voice } = this;
    if (!voice) return html``;
    const tools = html`
      <span class="pen-tools" role="group" aria-label=${voice.say('pen.tools')}>
        ${this.#button('penUndo', html`<span>${voice.say('pen.undo')}</span>`, voice.say('pen.undo.does'))}
        ${this.#button('penClear', voice.say('pen.clear'), voice.say('pen.clear.does'))}
        ${this.#button('penPin', voice.say('pen.pin'), voice.say('pen.pin.does'), this.isPinned)}
      </span>`;
    return html`
      ${this.isDrawing ? tools : ''}
      ${this.#button('predict', voice.say('header.predict'), voice.say('key.predict.does'), this.isPredicting)}
      ${this.#button('pen', voice.say('header.pen'), voice.say('key.pen.does'), this.isDrawing)}`;
  }

  /** @param {string} command @param {unknown} word @param {string} title @param {boolean} [isPressed] for one that stays pressed */
  #button(command, word, title, isPressed) {
    return html`<button type="button" class="framed ${command}" title=${title} ?disabled=${!this.isReady}
      aria-pressed=${isPressed === undefined ? nothing : isPressed ? 'true' : 'false'} @click=${() => tell(this, command)}>${word}</button>`;
  }
}

customElements.define('shimmy-actions', Actions);
