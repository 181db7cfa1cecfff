import { LitElement, html } from 'lit';
import './header.js';
import './controls/dock.js';
import './controls/drawer.js';
import './controls/explanation.js';
import './lens/tabs.js';
import './lens/why.js';
import './present/prediction.js';
import './stage/stage.js';
import './story/strip.js';
import { App } from './app.js';
import { loadEngine } from './engine/engine.js';
import { mapTiles, runJob } from './engine/workers.js';
import { keep, recall } from './keep.js';
import { shortcutOf, writesNoNumber } from './keys.js';
import { lensElement } from './lens/elements.js';
import { Loop } from './loop.js';
import { materialOf } from './out/from-page.js';
import { grant } from './out/grant.js';
import { linkOfFile } from './out/link-of-file.js';
import { viewsOf } from './out/views.js';
import { modeOnGear } from './run/modes.js';
import { readTheme } from './style/theme.js';
import { Teller } from './story/telling.js';

/** These have the room for themselves. */
const withoutWhy = ['compare', 'stability', 'cycles', 'damper', 'landing'];
const stillness = matchMedia('(prefers-reduced-motion: reduce)');

/**
 * The page: header, stage, lens, dock. It shows what the app holds, carries commands to it, keeps the address, and has the
 * frames drawn.
 */
export class Page extends LitElement {
  static properties = { said: { state: true }, address: { state: true } };

  /** Long work beside the page. */ work = { runJob, mapTiles };
  #app = new App();
  #loop = new Loop(this.#app, this);
  #teller = new Teller();
  #linkTimer = 0;
  /** What language and appearance the document has. */ #dressed = '';
  /** The field in which something is being typed. @type {EventTarget | null} */ #typing = null;
  /** What had the focus when a space was the page's. @type {EventTarget | null} */ #spaced = null;

  constructor() {
    super();
    /** What came of the last wish to take something along. */ this.said = '';
    /** The page's address with its state, as it was written last. */ this.address = '';
    this.#app.onChange = () => this.#changed();
    this.#app.follow = (spec) => runJob('bifurcation', spec);
  }

  createRenderRoot() {
    return this;
  }

  connectedCallback() {
    super.connectedCallback();
    this.#dress();
    for (const query of ['(prefers-color-scheme: dark)', '(min-width: 1000px)', '(min-width: 1100px)'])
      matchMedia(query).addEventListener('change', () => this.#loop.redress());
    stillness.addEventListener('change', () => this.#app.beStill(stillness.matches));
    document.fonts.addEventListener('loadingdone', () => this.#loop.redress());
    // Not from the address as it is: the page may have written its own state there in between.
    window.addEventListener('hashchange', ({ newURL }) => this.#app.openLink(new URL(newURL).hash));
    window.addEventListener('pagehide', () => this.#remember());
    window.addEventListener('keydown', (event) => this.#key(event));
    // What is typed is the field's until it is entered or left.
    window.addEventListener('input', ({ target }) => { this.#typing = target; }, true);
    for (const kind of ['change', 'focusout']) window.addEventListener(kind, () => { this.#typing = null; }, true);
    // Some browsers press a button as the key goes up.
    window.addEventListener('keyup', (event) => {
      if (event.key === ' ' && this.#spaced === event.target) event.preventDefault();
      this.#spaced = null;
    }, true);
    window.addEventListener('pointerdown', () => this.toggleAttribute('data-pointed', true), true);
    window.addEventListener('keydown', ({ key }) => key === 'Tab' && this.toggleAttribute('data-pointed', false), true);
    // A clicker's keys come before a slider that has the focus from a mouse.
    window.addEventListener('keydown', (event) => {
      if (['PageUp', 'PageDown'].includes(event.key)) this.#key(event);
    }, true);
    for (const kind of ['pointerdown', 'keydown', 'wheel']) window.addEventListener(kind, () => this.#endAct(), { capture: true, passive: true });
    document.addEventListener('visibilitychange', () => this.#loop.wake());
    this.addEventListener('command', (event) => this.#carryOut(/** @type {CustomEvent} */ (event).detail));
    this.#open();
  }

  render() {
    const app = this.#app;
    const { voice, session, clock, store, quantities } = app;
    const { object, parameters, links, lens, views, theme, predict, isBig, clock: rate } = app.state;
    const explained = quantities.find(({ name }) => name === app.explained);
    const change = this.#change;
    const { isVeiled } = app;
    const telling = this.#teller.tell(app);
    return html`
      <shimmy-header role="banner" .voice=${voice} .theme=${theme} .object=${object} .stories=${app.stories} .canComeBack=${app.left !== null}
        .canUndo=${store.canUndo} .canRedo=${store.canRedo} .isReady=${session !== null} .views=${viewsOf(app.state).map(({ name, element, title }) => ({ name, element, title: title(voice), hasLines: true }))}
        .isVeiled=${isVeiled} .link=${this.address} .said=${this.said}
        .isPredicting=${predict !== null} .isDrawing=${app.isDrawing} .isPinned=${app.ink.isPinned}></shimmy-header>
      <main>
        <shimmy-stage .voice=${voice} .isReady=${session !== null} .isPlaying=${clock.isPlaying} .isStill=${app.isStill}
          .isHeld=${session?.isHeld ?? false} .mode=${clock.mode} .slow=${clock.slow} .isChosen=${rate.slow !== null} .step=${clock.step}
          .quantities=${quantities} .ghostCount=${app.state.ghosts.length} .isHeard=${app.sound.isOn} .views=${views} .failure=${app.failure} .isVeiled=${isVeiled}
          .isBig=${isBig} .eigenmode=${isVeiled ? null : modeOnGear(app.state)}></shimmy-stage>
        <section class="lens" aria-label=${voice.say('lens.name')}>
          ${predict && app.notes.length === 0 ? html`<shimmy-prediction .voice=${voice} .predict=${predict}
            .question=${telling?.isQuestion ? telling.sentence : ''}></shimmy-prediction>` : html`
            <shimmy-strip ?data-waits=${this.#isActing} .voice=${voice} .notes=${app.notes} .telling=${telling}
              .canComeBack=${app.left !== null} .isVeiled=${isVeiled} .isCommanded=${'damper.command' in parameters}></shimmy-strip>`}
          ${this.#isActing ? html`<p class="opening-line" role="status">${app.act?.moment === 'wheel' ? '' : voice.say('act.sentence')}</p>` : ''}
          <shimmy-lens-tabs .voice=${voice} .lens=${lens}></shimmy-lens-tabs>
          ${lensElement(lens, { voice, shows: views[lens] ?? '', views, isVeiled, quantities }, this.#lensArrived)}
          ${withoutWhy.includes(lens) ? '' : html`<shimmy-why .voice=${voice} .isVeiled=${isVeiled}></shimmy-why>`}
          ${app.isDrawerOpen ? html`<shimmy-drawer role="region" aria-label=${voice.say('dock.all', { count: app.settable.length })} .voice=${voice}
            .object=${object} .fittings=${app.fittings} .quantities=${app.settable} .values=${parameters} .links=${links} .usual=${app.usual} .change=${change}
            .unstable=${app.unstable} .swings=${app.swings} .explained=${app.explained} .isVeiled=${isVeiled}></shimmy-drawer>` : ''}
          ${explained ? html`<shimmy-explanation role="dialog" aria-labelledby="explanation-name" .quantity=${explained} .model=${object}
            .voice=${voice}></shimmy-explanation>` : ''}
        </section>
        <shimmy-dock role="region" aria-label=${voice.say('dock.name')} .voice=${voice} .knobs=${app.knobs} .quantities=${app.settable} .values=${parameters}
          .links=${links} .usual=${app.usual} .change=${change} .unstable=${app.unstable} .swings=${app.swings} .explained=${app.explained} .isOpen=${app.isDrawerOpen}
          .isVeiled=${isVeiled} ?data-breathes=${app.act?.moment === 'breath'}></shimmy-dock>
      </main>`;
  }

  updated() {
    const { state, isDrawing } = this.#app;
    this.toggleAttribute('data-big', state.isBig);
    this.toggleAttribute('data-pen', isDrawing);
    this.#loop.wake();
  }

  /** Whether the first seconds have the strip above the lens to themselves. */
  get #isActing() {
    const { act, notes } = this.#app;
    return act !== null && act.moment !== 'over' && notes.length === 0;
  }

  async #open() {
    const app = this.#app;
    try {
      const engine = await loadEngine();
      app.open(engine, [location.hash, location.search, recall().link ?? ''], { isStill: stillness.matches });
    } catch (error) {
      app.failure = error instanceof Error ? error.message : String(error);
      this.requestUpdate();
    }
  }

  /** It gets its first frame, as it stands, and what has been seen ahead. */
  #lensArrived = () => {
    this.#app.isLookDue = true;
    this.requestUpdate();
  };

  /** @type {import('./controls/knob.js').Change} */
  #change = (name, value, gesture) => this.#app.session?.set(name, value, gesture || null) ?? null;

  #changed() {
    this.#dress();
    clearTimeout(this.#linkTimer);
    this.#linkTimer = window.setTimeout(() => this.#remember(), 300);
    this.requestUpdate();
  }

  /** @param {{ name: string, value: unknown }} command */
  #carryOut({ name, value }) {
    if (name === 'out') {
      this.#takeAlong(/** @type {import('./out/sheet.js').Wish} */ (value));
      return;
    }
    if (name === 'openFile') {
      const { link, said } = linkOfFile(/** @type {{ name: string, text: string }} */ (value), this.#app.voice);
      this.said = said;
      if (link) this.#app.openLink(link);
      return;
    }
    const wasOpen = this.#app.isDrawerOpen;
    this.#app.run(name, value);
    if (wasOpen && !this.#app.isDrawerOpen)
      this.updateComplete.then(() => /** @type {HTMLElement | null} */ (this.querySelector('.dock-more button'))?.focus());
    this.#loop.wake();
  }

  /** The whole state into the address and into what the browser keeps. */
  #remember() {
    const { link, state } = this.#app;
    if (!link) return;
    this.address = addressWith(link);
    if (link !== location.hash) history.replaceState(null, '', link);
    keep({ link, language: state.language, theme: state.theme, velocityUnit: state.velocityUnit });
  }

  /** @param {import('./out/sheet.js').Wish} wish */
  async #takeAlong(wish) {
    this.#remember();
    this.said = '';
    const material = materialOf(this.#app, wish, this, readTheme(this), this.address);
    if (material) this.said = await grant(wish, material, this.#app.voice);
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    // A clicker has no key that writes.
    const isClicked = ['PageUp', 'PageDown'].includes(event.key);
    const field = event.target instanceof HTMLInputElement && ['text', 'search'].includes(event.target.type) ? event.target : null;
    const isNumberAtRest = field?.matches('.number') && field !== this.#typing;
    const isWriting = field && !isClicked && !(isNumberAtRest && writesNoNumber(event));
    if (!this.#app.session || event.defaultPrevented || isWriting) return;
    if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === 'z') {
      event.preventDefault();
      const walk = event.shiftKey ? 'redo' : 'undo';
      this.#carryOut({ name: this.#app.isDrawing ? 'penUndo' : walk, value: undefined });
      return;
    }
    if (event.key === '?') {
      event.preventDefault();
      /** @type {import('./header.js').Header | null} */ (this.querySelector('shimmy-header'))?.toggleMenu();
      return;
    }
    if (event.key === '/') {
      event.preventDefault();
      /** @type {import('./story/search-field.js').SearchField | null} */ (this.querySelector('shimmy-search'))?.open();
      return;
    }
    const shortcut = shortcutOf(event, this.#app.isVeiled);
    if (!shortcut) return;
    event.preventDefault();
    event.stopPropagation();
    if (event.key === ' ') this.#spaced = event.target;
    this.#carryOut({ name: shortcut.command, value: shortcut.value });
  }

  /** A visitor did something. */
  #endAct() {
    if (!this.#app.act) return;
    this.#app.act = null;
    this.requestUpdate();
  }

  /** Language and appearance onto the document, where they have changed. */
  #dress() {
    const { voice, state } = this.#app;
    const dressed = `${state.language} ${state.theme}`;
    if (dressed === this.#dressed) return;
    this.#dressed = dressed;
    const root = document.documentElement;
    root.lang = state.language;
    document.title = voice.say('page.title');
    document.querySelector('meta[name="description"]')?.setAttribute('content', voice.say('page.description'));
    if (state.theme === 'system') delete root.dataset.theme;
    else root.dataset.theme = state.theme;
    this.#loop.redress();
  }
}

/** The page's address with its state; of a file on this machine its name alone. @param {string} link */
function addressWith(link) {
  const { protocol, origin, pathname } = location;
  return (protocol === 'file:' ? pathname.slice(pathname.lastIndexOf('/') + 1) : origin + pathname) + link;
}

customElements.define('shimmy-page', Page);
