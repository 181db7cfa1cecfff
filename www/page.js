import { LitElement, html } from 'lit';
import './header.js';
import './notice.js';
import './controls/dock.js';
import './controls/drawer.js';
import './lens/phase.js';
import './lens/tabs.js';
import './stage/stage.js';
import { Quantity, nameOf } from './controls/quantity.js';
import { loadEngine } from './engine/engine.js';
import { keep, recall } from './keep.js';
import { lenses } from './lens/lenses.js';
import { readLink, writeLink } from './link.js';
import { noteOn } from './notice.js';
import { openingObject, openingParameters, openingRun } from './opening.js';
import { Session } from './session.js';
import { settlingTime } from './stage/fit.js';
import { Clock } from './stage/clock.js';
import { slowRateFor } from './stage/rate.js';
import { Store } from './store.js';
import { readTheme } from './style/theme.js';
import { languages, voiceOf } from './words/voice.js';

/**
 * @typedef {import('./engine/engine.js').Engine} Engine
 * @typedef {import('./engine/engine.js').Model} Model
 * @typedef {import('./store.js').State} State
 * @typedef {import('./notice.js').Note} Note
 */

/** How often the engine looks ahead while nothing but time changes, and words and numbers follow, in ms. */
const outlookPause = 250;

/**
 * The page: header, stage, lens, dock. It owns store, clock and session, runs the frames, and passes what they hold to
 * the elements, which answer by events.
 */
export class Page extends LitElement {
  static properties = { isDrawerOpen: { state: true }, isShared: { state: true }, notes: { state: true }, failure: { state: true } };

  /** @type {Engine | null} */ #engine = null;
  /** @type {Model | null} */ #table = null;
  /** @type {Session | null} */ #session = null;
  /** @type {Quantity[]} */ #quantities = [];
  /** @type {Record<string, number>} */ #usual = {};
  #clock = new Clock(slowRateFor(null));
  #store = new Store(firstState());
  #frame = 0;
  /** The last picture with no value far beyond its slider. @type {import('./session.js').Scene | null} */ #soundScene = null;
  /** The failure that a note tells of. @type {unknown} */ #toldOf = null;
  #outlookAt = -Infinity;
  /** @type {import('./engine/engine.js').Outlook | null} */ #shown = null;
  /** Counts the changes that a hand has ended: each is a reason to speak. */ #occasion = 0;
  #linkTimer = 0;
  /** @type {import('./style/theme.js').Theme | null} */ #theme = null;

  constructor() {
    super();
    this.isDrawerOpen = false;
    this.isShared = false;
    /** @type {Note[]} */ this.notes = [];
    /** Why there is no engine. */
    this.failure = '';
    this.#store.subscribe((state, before) => this.#stateChanged(state, before));
  }

  createRenderRoot() {
    return this;
  }

  connectedCallback() {
    super.connectedCallback();
    this.#dress();
    for (const query of ['(prefers-color-scheme: dark)', '(min-width: 1000px)', '(min-width: 1100px)'])
      matchMedia(query).addEventListener('change', () => this.#redress());
    document.fonts.addEventListener('loadingdone', () => this.#redraw());
    window.addEventListener('hashchange', () => this.#openLink(location.hash));
    window.addEventListener('keydown', (event) => this.#key(event));
    document.addEventListener('visibilitychange', () => this.#wake());
    this.#open();
  }

  get #voice() {
    return voiceOf(this.#store.state.language);
  }

  render() {
    const voice = this.#voice;
    const { parameters, lens, theme } = this.#store.state;
    const session = this.#session;
    const change = this.#change;
    return html`
      <shimmy-header role="banner" .voice=${voice} .theme=${theme} .canUndo=${this.#store.canUndo} .canRedo=${this.#store.canRedo}
        .isReady=${session !== null} .isShared=${this.isShared}
        @undo=${() => this.#walk('undo')} @redo=${() => this.#walk('redo')} @share=${this.#share} @reset-all=${this.#resetAll}
        @language=${(/** @type {CustomEvent} */ event) => this.#store.update({ language: event.detail })}
        @theme=${(/** @type {CustomEvent} */ event) => this.#store.update({ theme: event.detail })}></shimmy-header>
      <main>
        <shimmy-stage .voice=${voice} .isReady=${session !== null} .isPlaying=${this.#clock.isPlaying} .slow=${this.#clock.slow}
          .step=${this.#clock.step} .failure=${this.failure}
          @transport=${(/** @type {CustomEvent} */ event) => this.#transport(event.detail)}
          @rate=${(/** @type {CustomEvent} */ event) => this.#store.update({ clock: { slow: event.detail } })}
          @seek=${(/** @type {CustomEvent} */ event) => this.#seek(event.detail)} @settle=${this.#settle}></shimmy-stage>
        <section class="lens" aria-label=${voice.say('lens.name')}>
          <shimmy-notice .voice=${voice} .notes=${this.notes} @undo=${() => this.#walk('undo')} @close=${() => { this.notes = []; }}></shimmy-notice>
          <shimmy-lens-tabs .voice=${voice} .lens=${lens}
            @lens=${(/** @type {CustomEvent} */ event) => this.#store.update({ lens: event.detail })}></shimmy-lens-tabs>
          <shimmy-phase-lens id="lens-panel" role="tabpanel" aria-labelledby="tab-${lens}" .voice=${voice}
            @fit=${this.#fit}></shimmy-phase-lens>
          ${this.isDrawerOpen ? html`<shimmy-drawer role="region" aria-label=${voice.say('dock.all', { count: this.#quantities.length })} .voice=${voice} .quantities=${this.#quantities}
            .values=${parameters} .usual=${this.#usual} .change=${change} @settle=${this.#settle}
            @close=${this.#toggleDrawer}></shimmy-drawer>` : ''}
        </section>
        <shimmy-dock role="region" aria-label=${voice.say('dock.name')} .voice=${voice} .quantities=${this.#quantities} .values=${parameters}
          .usual=${this.#usual} .change=${change} .isOpen=${this.isDrawerOpen}
          @settle=${this.#settle} @drawer=${this.#toggleDrawer} @reset-all=${this.#resetAll}></shimmy-dock>
      </main>`;
  }

  updated() {
    this.#wake();
  }

  async #open() {
    try {
      const engine = await loadEngine();
      this.#engine = engine;
      this.#setTable(engine);
      this.#openLink(location.hash) || this.#openLink(location.search) || this.#openLink(recall().link ?? '') || this.#openFirst();
      this.#begin(engine);
    } catch (error) {
      this.failure = error instanceof Error ? error.message : String(error);
    }
  }

  /** @param {Engine} engine */
  #setTable(engine) {
    const table = engine.models().find(({ name }) => name === openingObject);
    if (!table) throw new Error(`no model ${openingObject}`);
    this.#table = table;
    this.#quantities = table.parameters.map((parameter) => new Quantity(parameter));
    this.#usual = Object.fromEntries(table.parameters.map(({ name, default: usual }) => [name, openingParameters[name] ?? usual]));
  }

  #openFirst() {
    this.#store.follow({ parameters: this.#usual, run: openingRun });
    return true;
  }

  /** @param {Engine} engine */
  #begin(engine) {
    this.#session = new Session(engine, this.#store);
    this.#setRate();
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) this.#session.seek(settlingTime(this.#session.outlook.envelope));
    else this.#clock.play();
    this.requestUpdate();
  }

  /**
   * Opens what an address carries, and notes what could not be read.
   * @param {string} text
   * @returns {boolean} whether it carried an experiment
   */
  #openLink(text) {
    const table = this.#table;
    if (!table || (this.#session && text === writeLink(this.#store.state, table))) return false;
    const read = readLink(text, table, (parameters, initial) => this.#accepts(parameters, initial));
    if (!read) return false;
    // A damaged link without a start would open on a wheel at rest, and say nothing of why.
    const isBare = read.problems.length > 0 && Object.keys(read.state.run.initial).length === 0;
    const state = isBare ? { ...read.state, run: openingRun } : read.state;
    if (this.#session) this.#store.update(state);
    else this.#store.follow(state);
    const note = noteOn(read.problems, this.#voice);
    if (note && isBare) note.text += ` ${this.#voice.say('link.start')}`;
    this.notes = note ? [note] : [];
    return true;
  }

  /** @param {Record<string, number>} parameters @param {Record<string, number>} initial */
  #accepts(parameters, initial) {
    try {
      if (this.#engine) new this.#engine.Simulator({ model: openingObject, parameters, initial }).free();
      return true;
    } catch {
      return false;
    }
  }

  /** @type {import('./controls/knob.js').Change} */
  #change = (name, value, gesture) => this.#session?.set(name, value, gesture || null) ?? null;

  /** @param {State} state @param {State} before */
  #stateChanged(state, before) {
    if (state.theme !== before.theme || state.language !== before.language) this.#redress();
    if (state.clock !== before.clock || state.run !== before.run) this.#setRate();
    clearTimeout(this.#linkTimer);
    this.#linkTimer = window.setTimeout(() => this.#remember(), 300);
    this.requestUpdate();
  }

  /** The whole state into the address and into what the browser keeps. */
  #remember() {
    if (!this.#table || !this.#session) return;
    const { state } = this.#store;
    const link = writeLink(state, this.#table);
    if (link !== location.hash) history.replaceState(null, '', link);
    keep({ link, language: state.language, theme: state.theme });
  }

  async #share() {
    this.#remember();
    try {
      await navigator.clipboard.writeText(location.href);
      this.isShared = true;
      setTimeout(() => { this.isShared = false; }, 2000);
    } catch {
      // Without a clipboard the address itself is shown, to be copied by hand.
      this.notes = [{ text: location.href, isAlert: false }];
    }
  }

  /** @param {string} what */
  #transport(what) {
    const session = this.#session;
    if (!session) return;
    if (what === 'toggle') this.#clock.isPlaying ? this.#clock.pause() : this.#clock.play();
    if (what === 'on' || what === 'back') {
      this.#clock.pause();
      this.#seek(session.time + (what === 'on' ? this.#clock.step : -this.#clock.step));
    }
    if (what === 'start') {
      this.notes = [];
      session.restart();
      this.#setRate();
    }
    if (what === 'kick') session.kick();
    this.#outlookAt = -Infinity;
    this.requestUpdate();
  }

  /** The rate by hand, else the one for the motion that the run settles on. */
  #setRate() {
    const { frequency, present } = this.#session?.outlook ?? {};
    this.#clock.slow = this.#store.state.clock.slow ?? slowRateFor(frequency ?? present?.frequency ?? null);
  }

  /** @param {number} time */
  #seek(time) {
    this.#session?.seek(time);
    this.notes = [];
    this.requestUpdate();
  }

  #settle = () => {
    this.#session?.settle();
    this.#occasion++;
    this.#outlookAt = -Infinity;
    this.requestUpdate();
  };

  #fit = () => {
    this.#session?.fit();
    this.#wake();
  };

  /** @param {'undo' | 'redo'} direction */
  #walk(direction) {
    this.#store[direction]();
    this.notes = [];
    this.#settle();
  }

  #toggleDrawer = () => {
    this.isDrawerOpen = !this.isDrawerOpen;
    if (!this.isDrawerOpen) this.updateComplete.then(() => /** @type {HTMLElement | null} */ (this.querySelector('.dock-more button'))?.focus());
  };

  #resetAll = () => {
    this.#store.update({ parameters: this.#usual, run: { ...openingRun }, clock: { slow: null } });
  };

  /** @param {KeyboardEvent} event */
  #key(event) {
    const isWriting = event.target instanceof HTMLInputElement && event.target.type === 'text';
    if (!this.#session || event.defaultPrevented || isWriting) return;
    if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === 'z') {
      event.preventDefault();
      this.#walk(event.shiftKey ? 'redo' : 'undo');
      return;
    }
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    // A key that the focused element uses itself is its own.
    const isUsed = event.target instanceof HTMLElement && event.target.matches('button, select, summary, input, [role="slider"]');
    const does = {
      ' ': isUsed ? null : () => this.#transport('toggle'),
      ArrowLeft: isUsed ? null : () => this.#transport('back'),
      ArrowRight: isUsed ? null : () => this.#transport('on'),
      r: () => this.#transport('start'),
      k: () => this.#transport('kick'),
      0: () => this.#fit(),
      '?': () => /** @type {import('./header.js').Header | null} */ (this.querySelector('shimmy-header'))?.toggleMenu(),
    }[event.key];
    if (!does) return;
    event.preventDefault();
    does();
  }

  /** Language and appearance onto the document. */
  #dress() {
    const { language, theme } = this.#store.state;
    const root = document.documentElement;
    root.lang = language;
    document.title = this.#voice.say('page.title');
    document.querySelector('meta[name="description"]')?.setAttribute('content', this.#voice.say('page.description'));
    if (theme === 'system') delete root.dataset.theme;
    else root.dataset.theme = theme;
  }

  #redress() {
    this.#dress();
    this.#redraw();
  }

  #redraw() {
    this.#theme = null;
    this.#wake();
  }

  /** One frame will be drawn; more follow while the clock plays. */
  #wake() {
    if (!this.#frame) this.#frame = requestAnimationFrame((now) => this.#tick(now));
  }

  /** @param {number} now in ms */
  #tick(now) {
    this.#frame = 0;
    this.#theme ??= readTheme(this);
    const stage = /** @type {import('./stage/stage.js').Stage | null} */ (this.querySelector('shimmy-stage'));
    if (!stage) return;
    const session = this.#session;
    if (!session) {
      stage.drawAtRest(this.#theme);
      return;
    }
    if (!session.failure) {
      try {
        this.#run(session, stage, this.#theme, now);
      } catch (error) {
        session.failure = error;
      }
    }
    this.#tellOfStop(session, stage, this.#theme);
    if (this.#clock.isPlaying) this.#wake();
  }

  /**
   * @param {Session} session
   * @param {import('./stage/stage.js').Stage} stage
   * @param {import('./style/theme.js').Theme} theme
   * @param {number} now in ms
   */
  #run(session, stage, theme, now) {
    session.advance(this.#clock.elapse(now / 1000));
    this.#look(session, now);
    const scene = session.scene(stage.wanted);
    if (this.#wildValues(scene.parameters).length === 0) this.#soundScene = scene;
    this.#draw(scene, stage, theme);
  }

  /**
   * @param {import('./session.js').Scene} scene
   * @param {import('./stage/stage.js').Stage} stage
   * @param {import('./style/theme.js').Theme} theme
   */
  #draw(scene, stage, theme) {
    stage.draw(scene, theme);
    this.#lens?.draw(scene, theme);
  }

  get #lens() {
    return /** @type {import('./lens/phase.js').PhaseLens | null} */ (this.querySelector('shimmy-phase-lens'));
  }

  /** @param {Readonly<Record<string, number>>} parameters */
  #wildValues(parameters) {
    return this.#quantities.filter((quantity) => quantity.isFar(parameters[quantity.name]));
  }

  /**
   * Looks ahead at once after a change, now and then otherwise; words and numbers follow.
   * @param {Session} session @param {number} now in ms
   */
  #look(session, now) {
    const isDue = now - this.#outlookAt >= outlookPause;
    if (session.isStale || (isDue && this.#clock.isPlaying && !session.outlook.settled)) session.refresh();
    // A hand that lets go has the session look ahead by itself, so the outlook is asked for and not who made it.
    if (!isDue && session.outlook === this.#shown) return;
    this.#shown = session.outlook;
    if (isDue) this.#outlookAt = now;
    const { seen } = session;
    for (const element of this.querySelectorAll('shimmy-stage, shimmy-phase-lens, shimmy-notice'))
      Object.assign(element, { outlook: seen, time: session.time, frequency: session.frequency, occasion: this.#occasion });
  }

  /**
   * A run that left what can be computed stands at its last good picture and says why, until something changes.
   * @param {Session} session
   * @param {import('./stage/stage.js').Stage} stage
   * @param {import('./style/theme.js').Theme} theme
   */
  #tellOfStop(session, stage, theme) {
    stage.isStopped = session.failure !== null;
    if (session.failure) {
      this.#shown = null;
      if (this.#lens) this.#lens.outlook = null;
      stage.frequency = this.#soundScene?.outlook.present.frequency ?? null;
      if (this.#soundScene) this.#draw(this.#soundScene, stage, theme);
      else stage.drawAtRest(theme);
    }
    if (session.failure === this.#toldOf && !(session.failure && this.#clock.isPlaying)) return;
    this.#toldOf = session.failure;
    if (session.failure) this.#clock.pause();
    const others = this.notes.filter(({ isStop }) => !isStop);
    this.notes = session.failure ? [{ text: this.#whyStopped(session), isAlert: true, isStop: true, canUndo: this.#store.canUndo }] : others;
  }

  /** @param {Session} session */
  #whyStopped(session) {
    const voice = this.#voice;
    const { parameters } = this.#store.state;
    const time = voice.number(session.time, 3);
    const cause = this.#wildValues(parameters)
      .map((quantity) => `${nameOf(quantity, voice)} = ${quantity.write(parameters[quantity.name], voice)}`).join(', ');
    return cause ? voice.say('engine.stopped.by', { time, cause }) : voice.say('engine.stopped', { time });
  }
}

/** @returns {State} language and theme as kept, or as the browser has them; the experiment waits for the engine */
function firstState() {
  const kept = recall();
  const language = kept.language ?? navigator.language.slice(0, 2);
  const theme = kept.theme;
  return {
    object: openingObject,
    parameters: {},
    run: openingRun,
    clock: { slow: null },
    lens: lenses[0].name,
    language: Object.hasOwn(languages, language) ? /** @type {State['language']} */ (language) : 'en',
    theme: theme === 'light' || theme === 'dark' ? theme : 'system',
  };
}

customElements.define('shimmy-page', Page);
