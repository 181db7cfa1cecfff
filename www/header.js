import { LitElement, html } from 'lit';
import { tell } from './command.js';
import { otherKeys, shortcuts } from './keys.js';
import { objectChooser } from './object/chooser.js';
import { pythonModel } from './out/python/model.js';
import './out/sheet.js';
import './present/actions.js';
import './story/search-field.js';

/**
 * @typedef {import('./words/voice.js').Voice} Voice
 * @typedef {import('./words/voice.js').Key} Key
 */

const themes = /** @type {const} */ (['system', 'light', 'dark']);
/** Each once: two keys of one pair are one line. */
const keys = [...new Set([...shortcuts.map(({ word }) => word), ...otherKeys])];
const languages = /** @type {const} */ ([['en', 'English'], ['tr', 'Türkçe']]);

/**
 * The page's head: which object, the search, undo and redo, the link, and a menu with language, appearance and keys.
 * Commands: `object`, `open`, `comeBack`, `undo`, `redo`, `resetAll`, `language` and `theme` with the choice.
 */
export class Header extends LitElement {
  static properties = {
    voice: { attribute: false },
    theme: { attribute: false },
    object: { attribute: false },
    stories: { attribute: false },
    canComeBack: { attribute: false },
    canUndo: { attribute: false },
    canRedo: { attribute: false },
    isReady: { attribute: false },
    isVeiled: { attribute: false },
    views: { attribute: false },
    link: { attribute: false },
    said: { attribute: false },
    isPredicting: { attribute: false },
    isDrawing: { attribute: false },
    isPinned: { attribute: false },
  };

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    /** @type {'system' | 'light' | 'dark'} */ this.theme = 'system';
    this.object = '';
    /** @type {readonly import('./story/story.js').Story[]} */ this.stories = [];
    /** Whether what a visitor had before a story is kept. */ this.canComeBack = false;
    this.canUndo = false;
    this.canRedo = false;
    this.isReady = false;
    /** Whether what would tell the future is hidden: files would tell it. */ this.isVeiled = false;
    /** @type {import('./out/sheet.js').View[]} */ this.views = [];
    this.link = '';
    /** What came of the last wish to take something along. */ this.said = '';
    this.isPredicting = false;
    this.isDrawing = false;
    this.isPinned = false;
  }

  createRenderRoot() {
    return this;
  }

  connectedCallback() {
    super.connectedCallback();
    document.addEventListener('pointerdown', this.#leave, true);
  }

  disconnectedCallback() {
    document.removeEventListener('pointerdown', this.#leave, true);
    super.disconnectedCallback();
  }

  /** Opens the menu with its list of keys, or closes it. */
  toggleMenu() {
    const menu = this.#menu;
    if (!menu) return;
    menu.open = !menu.open;
    if (menu.open) menu.querySelector('summary')?.focus();
  }

  render() {
    const { voice } = this;
    if (!voice) return html``;
    const button = (/** @type {Key} */ key, /** @type {string} */ sign, /** @type {boolean} */ isOn, /** @type {string} */ what) => html`
      <button type="button" class="plain icon ${what}" title=${voice.say(key)} aria-label=${voice.say(key)} ?disabled=${!isOn}
        @click=${() => tell(this, what)}>${sign}</button>`;
    return html`
      <span class="brand">Shimmy</span>
      ${objectChooser(this.object, voice, this)}
      <shimmy-search .voice=${voice} .stories=${this.stories}></shimmy-search>
      <span class="spacer"></span>
      ${button('header.undo', '↶', this.canUndo, 'undo')}
      ${button('header.redo', '↷', this.canRedo, 'redo')}
      <shimmy-actions .voice=${voice} .isReady=${this.isReady} .isPredicting=${this.isPredicting} .isDrawing=${this.isDrawing}
        .isPinned=${this.isPinned}></shimmy-actions>
      <shimmy-out-sheet .voice=${voice} .isReady=${this.isReady && !this.isVeiled} .views=${this.views} .link=${this.link} .hasPython=${pythonModel(this.object) !== null} .said=${this.said}></shimmy-out-sheet>
      <details class="menu" @keydown=${this.#key}>
        <summary class="plain icon" title=${voice.say('header.menu')} aria-label=${voice.say('header.menu')}>⋯</summary>
        <div class="menu-sheet">
          ${this.canComeBack ? html`<button type="button" class="framed" @click=${() => tell(this, 'comeBack')}>${voice.say('story.comeBack')}</button>` : ''}
          <div class="menu-actions">
            ${objectChooser(this.object, voice, this)}
            <button type="button" class="framed" ?disabled=${!this.isReady} @click=${() => tell(this, 'pen')}>${voice.say('header.pen')}</button>
            <button type="button" class="framed" ?disabled=${!this.canUndo} @click=${() => tell(this, 'undo')}>↶ ${voice.say('header.undo')}</button>
            <button type="button" class="framed" ?disabled=${!this.canRedo} @click=${() => tell(this, 'redo')}>↷ ${voice.say('header.redo')}</button>
            <button type="button" class="framed" ?disabled=${!this.isReady} @click=${() => tell(this, 'resetAll')}>↺ ${voice.say('dock.reset')}</button>
          </div>
          ${this.#choice('menu.language', 'language', languages.map(([value, word]) => ({ value, word, lang: value })), voice.language)}
          ${this.#choice('menu.theme', 'theme', themes.map((value) => ({ value, word: voice.say(`menu.theme.${value}`), lang: voice.language })), this.theme)}
          <section>
            <h2>${voice.say('menu.keys')}</h2>
            <dl>${keys.map((key) => html`<div><dt><kbd>${voice.say(/** @type {Key} */ (`key.${key}`))}</kbd></dt><dd>${voice.say(/** @type {Key} */ (`key.${key}.does`))}</dd></div>`)}</dl>
          </section>
        </div>
      </details>`;
  }

  /**
   * @param {Key} title
   * @param {string} name
   * @param {{ value: string, word: string, lang: string }[]} options
   * @param {string} chosen
   */
  #choice(title, name, options, chosen) {
    return html`
      <fieldset>
        <legend>${this.voice?.say(title)}</legend>
        ${options.map(({ value, word, lang }) => html`
          <label lang=${lang}><input type="radio" name=${name} value=${value} .checked=${value === chosen}
            @change=${() => tell(this, name, value)} /> ${word}</label>`)}
      </fieldset>`;
  }

  get #menu() {
    return /** @type {HTMLDetailsElement | null} */ (this.querySelector('details.menu'));
  }

  /** A press elsewhere closes the menu. @param {PointerEvent} event */
  #leave = (event) => {
    const menu = this.#menu;
    if (menu?.open && !event.composedPath().includes(menu)) menu.open = false;
  };

  /** @param {KeyboardEvent} event */
  #key(event) {
    const menu = this.#menu;
    if (event.key !== 'Escape' || !menu?.open) return;
    event.preventDefault();
    menu.open = false;
    menu.querySelector('summary')?.focus();
  }
}

customElements.define('shimmy-header', Header);
