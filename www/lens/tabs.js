import { LitElement, html } from 'lit';
import { tell } from '../command.js';
import { lenses } from './lenses.js';

/** @typedef {import('../words/voice.js').Voice} Voice */

/** The row of lenses. Those not built yet are dimmed and say so. Tells the choice by the command `lens`. */
export class LensTabs extends LitElement {
  static properties = { voice: { attribute: false }, lens: { attribute: false } };

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    this.lens = lenses[0].name;
  }

  createRenderRoot() {
    return this;
  }

  render() {
    const { voice } = this;
    if (!voice) return html``;
    return html`<div class="tabs" role="tablist" aria-label=${voice.say('lens.name')}>${lenses.map(({ name, ready }) => {
      const word = voice.say(`lens.${name}`);
      const reason = ready ? '' : voice.say('lens.later', { lens: word });
      return html`
        <button type="button" role="tab" id="tab-${name}" aria-controls="lens-panel" aria-selected=${name === this.lens ? 'true' : 'false'}
          aria-disabled=${ready ? 'false' : 'true'} tabindex=${name === this.lens ? 0 : -1} title=${reason}
          aria-label=${ready ? word : reason}
          @click=${() => ready && tell(this, 'lens', name)} @keydown=${this.#key}>${word}</button>`;
    })}</div>`;
  }

  /** A lens that a story or a link has chosen is in sight, where the row is wider than the screen. @param {Map<string, unknown>} changed */
  updated(changed) {
    const tab = changed.has('lens') && /** @type {HTMLElement | null} */ (this.querySelector('[aria-selected="true"]'));
    const row = tab && tab.parentElement;
    if (!row) return;
    const { offsetLeft, offsetWidth } = tab;
    const isSeen = offsetLeft >= row.scrollLeft && offsetLeft + offsetWidth <= row.scrollLeft + row.clientWidth;
    if (!isSeen) row.scrollLeft = offsetLeft - (row.clientWidth - offsetWidth) / 2;
  }

  /** Arrow keys walk the row, as in every list of tabs. @param {KeyboardEvent} event */
  #key(event) {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    const tabs = [...this.querySelectorAll('button')];
    const at = tabs.indexOf(/** @type {HTMLButtonElement} */ (event.target));
    tabs[(at + step + tabs.length) % tabs.length].focus();
  }
}

customElements.define('shimmy-lens-tabs', LensTabs);
