/**
 * The frames: time goes by, the engine looks ahead, and what is on the screen is drawn.
 *
 * @typedef {import('./app.js').App} App
 * @typedef {import('./run/scene.js').Scene} Scene
 * @typedef {import('./run/session.js').Session} Session
 * @typedef {import('./style/theme.js').Theme} Theme
 * @typedef {import('./stage/stage.js').Stage} Stage
 * @typedef {import('./lens/lenses.js').LensElement} LensElement
 */

import { nameOf } from './controls/quantity.js';
import { showInk } from './present/pen-layers.js';
import { readTheme } from './style/theme.js';

/** How often the engine looks ahead while nothing but time changes, and words and numbers follow, in ms. */
const outlookPause = 250;

export class Loop {
  #app;
  #host;
  #frame = 0;
  /** @type {Theme | null} */ #theme = null;
  /** The last picture with no value far beyond its slider. @type {Scene | null} */ #soundScene = null;
  /** The failure that a note tells of. @type {unknown} */ #toldOf = null;
  #lookedAt = -Infinity;
  /** @type {unknown} */ #shown = null;

  /**
   * @param {App} app
   * @param {HTMLElement} host the element in which stage and lens are
   */
  constructor(app, host) {
    this.#app = app;
    this.#host = host;
  }

  /** One frame will be drawn; more follow while the clock plays. */
  wake() {
    if (!this.#frame) this.#frame = requestAnimationFrame((now) => this.#tick(now));
  }

  /** Colors or faces have changed. */
  redress() {
    this.#theme = null;
    this.wake();
  }

  get #stage() {
    return /** @type {Stage | null} */ (this.#host.querySelector('shimmy-stage'));
  }

  get #lens() {
    const panel = /** @type {LensElement | null} */ (this.#host.querySelector('#lens-panel'));
    // One that is still on its way draws nothing.
    return panel && 'draw' in panel ? panel : null;
  }

  /** @param {number} now in ms */
  #tick(now) {
    this.#frame = 0;
    this.#theme ??= readTheme(this.#host);
    const { session, clock } = this.#app;
    const stage = this.#stage;
    if (!stage) return;
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
    this.#present(now / 1000, this.#theme);
    if (clock.isPlaying) this.wake();
  }

  /** @param {Session} session @param {Stage} stage @param {Theme} theme @param {number} now in ms */
  #run(session, stage, theme, now) {
    const { clock } = this.#app;
    session.advance(clock.elapse(now / 1000));
    this.#look(session, now);
    // A wheel in a hand stands still, however fast time goes.
    const isBlurred = clock.isPlaying && !session.isHeld && clock.isTooFast(session.frequency);
    const exposure = isBlurred ? clock.exposure : 0;
    const scene = session.scene({ ...stage.wanted, exposure, duration: this.#app.duration });
    if (this.#wildValues(scene.parameters).length === 0) this.#soundScene = scene;
    this.#draw(scene, stage, theme);
    // A wheel that stands still, in a hand or in time, is silent.
    this.#app.sound.hear(clock.isPlaying && !session.isHeld && !this.#app.isVeiled ? scene.orbitPast : null, now);
  }

  /** What is shown to others besides the run: the first seconds go on, ink fades. @param {number} now in s @param {Theme} theme */
  #present(now, theme) {
    const app = this.#app;
    const { isPlaying } = app.clock;
    if (app.act?.elapse(now, isPlaying)) app.onChange();
    app.ink.elapse(now, isPlaying);
    showInk(this.#host, app, theme);
  }

  /** @param {Scene} scene @param {Stage} stage @param {Theme} theme */
  #draw(scene, stage, theme) {
    stage.draw(scene, theme);
    this.#lens?.draw(scene, theme);
  }

  /** @param {Readonly<Record<string, number>>} parameters */
  #wildValues(parameters) {
    return this.#app.quantities.filter((quantity) => quantity.isFar(parameters[quantity.name]));
  }

  /**
   * Looks ahead at once after a change, now and then otherwise; words and numbers follow.
   * @param {Session} session @param {number} now in ms
   */
  #look(session, now) {
    const app = this.#app;
    const isDue = app.isLookDue || now - this.#lookedAt >= outlookPause;
    if (session.isStale || (isDue && (session.isHeld || (app.clock.isPlaying && (session.isLanding || !session.outlook.settled))))) session.refresh();
    // A hand that lets go has the session look ahead by itself, so the outlook is asked for and not who made it.
    if (!isDue && session.outlook === this.#shown) return;
    this.#shown = session.outlook;
    if (isDue) {
      this.#lookedAt = now;
      session.ghosts.refresh();
    }
    app.isLookDue = false;
    app.lockStrobe();
    const { seen, time, frequency, ghosts } = session;
    // A wheel in a hand does not swing, and where it goes is the hand's affair.
    const energy = session.isHeld ? null : session.energy;
    for (const element of this.#host.querySelectorAll('shimmy-stage, shimmy-strip, shimmy-why, #lens-panel'))
      Object.assign(element, { outlook: app.isVeiled ? null : seen, energy: app.isVeiled ? null : energy, time, frequency, occasion: app.occasion, ghosts: ghosts.all });
  }

  /**
   * A run that left what can be computed stands at its last good picture and says why, until something changes.
   * @param {Session} session @param {Stage} stage @param {Theme} theme
   */
  #tellOfStop(session, stage, theme) {
    const app = this.#app;
    stage.isStopped = session.failure !== null;
    if (session.failure) {
      this.#shown = null;
      if (this.#lens) this.#lens.outlook = null;
      stage.frequency = this.#soundScene?.frequency ?? null;
      this.#drawStopped(stage, theme);
    }
    if (session.failure === this.#toldOf && !(session.failure && app.clock.isPlaying)) return;
    this.#toldOf = session.failure;
    if (session.failure) app.clock.pause();
    const others = app.notes.filter(({ isStop }) => !isStop);
    app.notes = session.failure ? [{ text: this.#whyStopped(session), isAlert: true, isStop: true, canUndo: app.store.canUndo }] : others;
    app.onChange();
  }

  /** The last good picture; where the drawing itself is what failed, the gear at rest. @param {Stage} stage @param {Theme} theme */
  #drawStopped(stage, theme) {
    try {
      if (this.#soundScene) {
        this.#draw(this.#soundScene, stage, theme);
        return;
      }
    } catch {
      this.#soundScene = null;
    }
    stage.drawAtRest(theme);
  }

  /** @param {Session} session */
  #whyStopped(session) {
    const { voice, state } = this.#app;
    const time = voice.number(session.time, 3);
    const cause = this.#wildValues(state.parameters)
      .map((quantity) => `${nameOf(quantity, voice)} = ${quantity.write(state.parameters[quantity.name], voice)}`).join(', ');
    return cause ? voice.say('engine.stopped.by', { time, cause }) : voice.say('engine.stopped', { time });
  }
}
