import { LitElement, html } from 'lit';
import { tell } from '../command.js';
import { languages, voiceOf } from '../words/voice.js';
import { indexOf, search } from './search.js';
import { gistOf, lookOf, titleOf } from './title.js';

/**
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('./story.js').Story} Story
 */

/**
 * One field that finds every story: a combobox over a list in groups. Where there is little room it is folded behind a
 * button. Tells the command `open` with the story's name.
 */
export class SearchField extends LitElement {
  static properties = {
    voice: { attribute: false },
    stories: { attribute: false },
    isOpen: { state: true },
    query: { state: true },
    active: { state: true },
  };

  /** @type {import('./search.js').Indexed[] | null} */ #index = null;

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    /** @type {readonly Story[]} */ this.stories = [];
    this.isOpen = false;
    this.query = '';
    /** The name of the story that Enter opens. */ this.active = '';
  }

  createRenderRoot() {
    return this;
  }

  connectedCallback() {
    super.connectedCallback();
    document.addEventListener('pointerdown', this.#leave);
    this.addEventListener('focusout', ({ relatedTarget }) => {
      if (relatedTarget instanceof Node && !this.contains(relatedTarget)) this.close();
    });
  }

  disconnectedCallback() {
    document.removeEventListener('pointerdown', this.#leave);
    super.disconnectedCallback();
  }

  /** Opens the list and takes the keys. */
  async open() {
    this.isOpen = true;
    await this.updateComplete;
    this.#input?.focus();
    this.#input?.select();
  }

  close() {
    this.isOpen = false;
  }

  /** @param {Map<string, unknown>} changed */
  willUpdate(changed) {
    if (changed.has('stories')) this.#index = null;
    const found = this.isOpen ? this.#found.filter(({ isReady }) => isReady) : [];
    if (!found.some(({ name }) => name === this.active)) this.active = found[0]?.name ?? '';
  }

  render() {
    const { voice } = this;
    if (!voice) return html``;
    const name = voice.say('search.name');
    const label = voice.say('search.open');
    return html`
      <button type="button" class="plain icon search-fold" title="${label} (/)" aria-label=${label} aria-expanded=${this.isOpen ? 'true' : 'false'}
        @click=${this.open}>${glass}</button>
      <div class="search-box" ?data-open=${this.isOpen}>
        <div class="search-line">
          <span aria-hidden="true">${glass}</span>
          <input type="search" role="combobox" aria-label=${name} placeholder=${name} autocomplete="off" spellcheck="false"
            aria-expanded=${this.isOpen ? 'true' : 'false'} aria-controls="search-list" aria-autocomplete="list"
            aria-activedescendant=${this.isOpen && this.active ? idOf(this.active) : ''} .value=${this.query}
            @input=${this.#typed} @keydown=${this.#key} @click=${() => { this.isOpen = true; }} />
          <kbd aria-hidden="true">/</kbd>
          <button type="button" class="plain icon search-close" aria-label=${voice.say('search.close')} @click=${this.#leaveByHand}>✕</button>
        </div>
        <div id="search-list" class="search-list" role="listbox" aria-label=${voice.say('search.results')} ?hidden=${!this.isOpen}
          @pointerdown=${(/** @type {Event} */ event) => event.preventDefault()}>
          ${this.isOpen ? this.#groups(voice) : ''}
        </div>
        ${this.isOpen && this.#found.length === 0 ? html`<p class="search-none" role="status">${voice.say('search.none')}</p>` : ''}
      </div>`;
  }

  updated() {
    this.querySelector('[role="option"][aria-selected="true"]')?.scrollIntoView({ block: 'nearest' });
  }

  /** The groups in order, each with what was found in it. @param {Voice} voice */
  #groups(voice) {
    /** @type {Map<string, Story[]>} */
    const groups = new Map();
    for (const story of this.#found) {
      const group = groupOf(story, voice);
      groups.set(group, [...(groups.get(group) ?? []), story]);
    }
    return [...groups].map(([group, stories]) => html`
      <div role="group" aria-label=${group}>
        <p class="search-group" aria-hidden="true">${group}</p>
        ${stories.map((story) => this.#row(story, voice))}
      </div>`);
  }

  /** @param {Story} story @param {Voice} voice */
  #row(story, voice) {
    const { name, isReady, entry } = story;
    const aside = isReady ? entry && lookOf(entry, voice) : voice.say('search.later');
    return html`
      <div role="option" id=${idOf(name)} aria-selected=${name === this.active ? 'true' : 'false'} aria-disabled=${isReady ? 'false' : 'true'}
        @click=${() => isReady && this.#choose(name)}>
        <b>${titleOf(story, voice)}</b> <span>${gistOf(story, voice)}</span> ${aside ? html`<i>${aside}</i>` : ''}
      </div>`;
  }

  get #input() {
    return this.querySelector('input');
  }

  get #found() {
    this.#index ??= indexOf(this.stories, Object.keys(languages).map((language) => voiceOf(/** @type {Voice['language']} */ (language))));
    return search(this.#index, this.query).map(({ story }) => story);
  }

  /** @param {Event} event */
  #typed(event) {
    this.query = /** @type {HTMLInputElement} */ (event.target).value;
    this.active = '';
    this.isOpen = true;
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const { key } = event;
    const step = { ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8 }[key];
    if (step) {
      event.preventDefault();
      if (this.isOpen) this.#move(step);
      this.isOpen = true;
    } else if (key === 'Enter' && this.isOpen && this.active) {
      event.preventDefault();
      this.#choose(this.active);
    } else if (key === 'Escape') {
      event.preventDefault();
      this.#escape();
    }
  }

  /** To another row that can be opened; one step goes around the ends. @param {number} step */
  #move(step) {
    const names = this.#found.filter(({ isReady }) => isReady).map(({ name }) => name);
    const to = names.indexOf(this.active) + step;
    const at = Math.abs(step) === 1 ? (to + names.length) % names.length : Math.min(Math.max(to, 0), names.length - 1);
    this.active = names[at] ?? '';
  }

  /** @param {string} name */
  #choose(name) {
    this.query = '';
    this.close();
    this.#input?.blur();
    tell(this, 'open', name);
  }

  /** First the list, then the field. */
  #escape() {
    if (this.isOpen) this.#leaveByHand();
    else this.#input?.blur();
    this.query = '';
  }

  #leaveByHand() {
    this.close();
    const fold = /** @type {HTMLElement | null} */ (this.querySelector('.search-fold'));
    if (fold?.offsetParent) fold.focus();
  }

  /** A press elsewhere closes the list. @param {PointerEvent} event */
  #leave = (event) => {
    if (this.isOpen && !event.composedPath().includes(this)) this.close();
  };
}

const glass = html`<svg viewBox="0 0 16 16" width="16" height="16"><path d="M7 1.5a5.5 5.5 0 1 0 3.4 9.8l3.2 3.2 1-1-3.2-3.2A5.5 5.5 0 0 0 7 1.5zm0 1.5a4 4 0 1 1 0 8 4 4 0 0 1 0-8z" /></svg>`;

/** @param {string} name */
function idOf(name) {
  return `story-${name}`;
}

/** @param {Story} story @param {Voice} voice */
function groupOf({ entry }, voice) {
  if (!entry) return voice.say('search.presets');
  const chapter = entry.id.match(/ (\d+)\./)?.[1];
  return chapter ? voice.say('search.chapter', { chapter }) : voice.say('search.appendices');
}

customElements.define('shimmy-search', SearchField);
