import { LitElement, html } from 'lit';
import { tell } from './command.js';

/**
 * @typedef {import('./words/voice.js').Voice} Voice
 * @typedef {{ text: string, isAlert: boolean, isStop?: boolean, canUndo?: boolean }} Note `isStop`: stands as long as the run is stopped
 */

/**
 * The strip above the lens: what to try with the motion as it is, or a note in its place while there is something to
 * say.
 */
export class Notice extends LitElement {
  static properties = { voice: { attribute: false }, notes: { attribute: false }, outlook: { attribute: false } };

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    /** @type {Note[]} */ this.notes = [];
    /** @type {import('./engine/engine.js').Outlook | null} */ this.outlook = null;
  }

  createRenderRoot() {
    return this;
  }

  render() {
    const { voice, notes } = this;
    if (!voice) return html``;
    if (notes.length === 0) return html`
      <div class="story">
        <p class="story-title">${voice.say('story.title')}</p>
        <p>${voice.say(`story.${this.outlook?.verdict ?? 'shimmies'}`)}</p>
      </div>`;
    return html`
      <div class="story note">
        <div>${notes.map(({ text, isAlert, canUndo }) => html`<p role=${isAlert ? 'alert' : 'status'}>${text}</p>${canUndo ? html`
          <button type="button" class="framed" @click=${() => tell(this, 'undo')}>${voice.say('header.undo')}</button>` : ''}`)}</div>
        <button type="button" class="plain icon" aria-label=${voice.say('notice.close')} title=${voice.say('notice.close')}
          @click=${() => tell(this, 'closeNotes')}>✕</button>
      </div>`;
  }
}

customElements.define('shimmy-notice', Notice);
