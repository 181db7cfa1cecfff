/**
 * The page without its elements: store, clock, engine, session, notes, and the commands that change them. Elements show
 * what it holds and tell it commands; a test can do both without a browser.
 */

import { Quantity } from './controls/quantity.js';
import { isVelocityUnit } from './controls/unit.js';
import { modelsOf } from './engine/models.js';
import { clockCommands, handsOff } from './commands/clock.js';
import { controlCommands } from './commands/controls.js';
import { landingCommands } from './commands/landing.js';
import { damperCommands } from './commands/damper.js';
import { experimentCommands } from './commands/experiment.js';
import { carriedOut, presentCommands } from './commands/present.js';
import { storyCommands } from './commands/story.js';
import { viewCommands } from './commands/view.js';
import { recall } from './keep.js';
import { lenses } from './lens/lenses.js';
import { noteOn } from './link/note.js';
import { readLink, storyIn, strangersIn } from './link/read.js';
import { writeLink } from './link/write.js';
import { fitted } from './object/fittings.js';
import { openingObject, openingParameters, openingRun } from './opening.js';
import { settlingTime } from './run/fit.js';
import { Ink } from './present/ink.js';
import { OpeningAct } from './present/opening-act.js';
import { Clock } from './run/clock.js';
import { lands, slowingTime } from './run/landing.js';
import { LinearTheory } from './run/linear-theory.js';
import { linksThatHold } from './run/links.js';
import { slowRateFor } from './run/rate.js';
import { Session } from './run/session.js';
import { SwingScent } from './run/swing-scent.js';
import { Sound } from './sound/sound.js';
import { Store } from './store.js';
import { figuresOf } from './story/atlas.js';
import { leave, told } from './story/player.js';
import { presets } from './story/presets.js';
import { languages, voiceOf } from './words/voice.js';

/**
 * @typedef {import('./engine/engine.js').Engine} Engine
 * @typedef {import('./engine/engine.js').Model} Model
 * @typedef {import('./story/strip.js').Note} Note
 * @typedef {import('./store.js').State} State
 * @typedef {(value?: any) => void} Command
 */

/** @type {readonly string[]} */
const none = [];
/** Of a gear that lands. */
const landingKnobs = ['dampingConstant', 'touchdownVelocity', 'deceleration', 'damper.command'];

export class App {
  /** @type {Engine | null} */ engine = null;
  /** @type {Session | null} */ session = null;
  clock = new Clock(slowRateFor(null));
  store = new Store(firstState());
  /** What there is to say above the lens. @type {Note[]} */ notes = [];
  /** Why there is no engine. */ failure = '';
  isDrawerOpen = false;
  /** Whether less motion is asked for: then time goes slowly or not at all. */ isStill = false;
  /** All stories, in order; those of the engine's atlas once it is there. @type {readonly import('./story/story.js').Story[]} */
  stories = presets;
  /** What a visitor had before a story was opened, to come back to. @type {import('./story/player.js').Left | null} */
  left = null;
  /** The state as the step of the story put it. @type {State | null} */
  asTold = null;
  /** The parameter that is being explained. @type {string | null} */ explained = null;
  /** The first seconds of a fresh page; null once a visitor has done anything. @type {OpeningAct | null} */ act = null;
  /** Whether a pen is in hand. */ isDrawing = false;
  /** What it drew. */ ink = new Ink();
  /** The swing to be heard. */ sound = new Sound();
  /** Counts the changes that a hand has ended: each is a reason to speak. */ occasion = 0;
  /** Whether the outlook is to be looked at anew though no time has gone by. */ isLookDue = true;
  /** Called after each change of what elements show. */ onChange = () => {};
  /** @type {Model[] | null} */ #models = null;
  /** @type {Map<string, Quantity[]>} */ #quantities = new Map();
  /** @type {Map<string, Record<string, number>>} */ #usual = new Map();
  /** @type {LinearTheory | null} */ #theory = null;
  /** @type {SwingScent | null} */ #swings = null;
  /** The values of a gear as it touches down. @type {{ of: object | null, parameters: Record<string, number> }} */ #touchdown = { of: null, parameters: {} };
  /** Follows branches of cycles beside the page; null where nobody does. @type {import('./run/swing-scent.js').Follow | null} */ follow = null;

  /** All commands by name. @type {Readonly<Record<string, Command>>} */
  commands = {
    ...clockCommands(this), ...controlCommands(this), ...damperCommands(this), ...experimentCommands(this), ...landingCommands(this),
    ...presentCommands(this), ...storyCommands(this), ...viewCommands(this),
  };

  constructor() {
    this.store.subscribe((state, before) => {
      if (state.clock !== before.clock || state.run !== before.run) this.setRate();
      this.onChange();
    });
  }

  get state() {
    return this.store.state;
  }

  get voice() {
    return voiceOf(this.state.language);
  }

  /** Whether what would tell the future is hidden. */
  get isVeiled() {
    const { predict } = this.state;
    return predict !== null && predict.outcome === null;
  }

  /** The tables of all models; none before the engine is there. They never change, so they are asked for once. */
  get models() {
    this.#models ??= this.engine ? modelsOf(this.engine) : null;
    return this.#models ?? [];
  }

  /** The model's tables; null before the engine is there. @returns {Model | null} */
  get table() {
    return this.models.find(({ name }) => name === this.state.object) ?? null;
  }

  /** The parameters of the object as the page shows them. */
  get quantities() {
    return this.#quantitiesOf(this.state.object);
  }

  /** What can be fitted to the object. */
  get fittings() {
    const takes = (/** @type {import('./object/fittings.js').Fittings['damper']} */ damper) => this.models.some(({ name }) => name === fitted(this.state.object, { damper }));
    return { damper: (this.engine?.dampers() ?? []).map(({ name }) => name).filter(takes) };
  }

  /** Those that can be set: the speed of a gear that lands is what its landing makes it. */
  get settable() {
    return lands(this.state.object) ? this.quantities.filter(({ name }) => name !== 'velocity') : this.quantities;
  }

  /** Where the gear is unstable as one value varies; null where nothing is known of that. @param {string} parameter */
  unstable = (parameter) => this.#theory?.unstable(this.#rolling, parameter) ?? null;

  /** How widely the gear swings as one value varies; null where that is not known yet. Another function when more is known. */
  swings = this.#swingsNow();

  /** What "reset" brings back, in SI. @returns {Record<string, number>} */
  get usual() {
    return this.usualOf(this.state.object);
  }

  /** The knobs that the story is about, the most telling first; none where it leaves the choice to the dock. */
  get knobs() {
    return told(this)?.step.state.knobs ?? (lands(this.state.object) ? landingKnobs : none);
  }

  /** How much of the run the timeline shows at least, in s; undefined where nobody asks for a time. */
  get duration() {
    return told(this)?.step.state.duration ?? (lands(this.state.object) ? slowingTime(this.state.parameters) : undefined);
  }

  /** @param {string} object @returns {Record<string, number>} */
  usualOf(object) {
    const known = this.#usual.get(object);
    if (known || this.models.length === 0) return known ?? {};
    const usual = Object.fromEntries(this.#quantitiesOf(object).map(({ name, parameter }) => [name, openingParameters[name] ?? parameter.default]));
    this.#usual.set(object, usual);
    return usual;
  }

  /**
   * Carries out a command.
   * @param {string} name
   * @param {unknown} [value]
   */
  run(name, value) {
    const asked = carriedOut(name, this.isVeiled);
    if (asked === null) return;
    const command = this.commands[asked];
    if (!command) throw new Error(`no command ${asked}`);
    if (!this.session && !['language', 'theme'].includes(asked)) return;
    this.act = null;
    if (handsOff.has(asked)) this.commands.release();
    command(value);
    this.onChange();
  }

  /**
   * Takes the engine, and opens what the first of these addresses carries, else the opening.
   * @param {Engine} engine
   * @param {string[]} addresses
   * @param {{ isStill: boolean }} options `isStill`: paused, with the whole run drawn
   */
  open(engine, addresses, { isStill }) {
    this.engine = engine;
    this.isStill = isStill;
    this.stories = [...presets, ...figuresOf(engine.atlas())];
    this.#theory = new LinearTheory(engine);
    if (this.follow) {
      this.#swings = new SwingScent(this.follow, () => this.models);
      this.#swings.onChange = () => {
        this.swings = this.#swingsNow();
        this.onChange();
      };
    }
    const isFresh = !addresses.some((address) => this.openLink(address));
    if (isFresh) {
      this.store.follow({ parameters: this.usual, run: openingRun });
      this.store.follow({ links: linksThatHold(engine, openingObject, this.usual) });
    }
    this.session = new Session(engine, this.store);
    this.setRate();
    if (this.isVeiled) this.clock.pause();
    else if (!isStill) this.clock.play();
    else if (!this.state.run.time) this.session.seek(isFresh ? OpeningAct.end / this.clock.rate : settlingTime(this.session.outlook.envelope));
    if (isFresh && !isStill) this.act = new OpeningAct();
    this.onChange();
  }

  /**
   * Opens what an address carries, and notes what could not be read.
   * @param {string} text
   * @returns {boolean} whether it carried an experiment
   */
  openLink(text) {
    const { engine, session } = this;
    if (!engine || (session && text === this.link)) return false;
    // As the page opens, an address that says nothing of use is followed by what the browser keeps: both may have notes.
    const before = session ? [] : this.notes;
    const read = readLink(text, this.models, (run) => this.#accepts(run));
    if (!read) {
      const note = noteOn(strangersIn(text), this.voice);
      if (note) this.notes = [...before, note];
      return false;
    }
    // A damaged link without a start would open on a wheel at rest, and say nothing of why.
    const isBare = read.problems.length > 0 && Object.keys(read.state.run.initial).length === 0;
    const run = isBare ? openingRun : read.state.run;
    const { object, parameters, links } = read.state;
    const { story, problem } = storyIn(read.state.story, this.stories);
    if (problem) read.problems.push(problem);
    const holding = linksThatHold(engine, object, parameters);
    const change = { ...read.state, story, run, links: Object.fromEntries(Object.keys(holding).map((name) => [name, holding[name] && links[name] !== false])) };
    if (session) {
      this.commands.release();
      leave(this);
      this.store.open(change);
    } else this.store.follow(change);
    this.ink.bring(read.drawn);
    this.isDrawerOpen = told(this)?.step.state.drawer ?? false;
    this.act = null;
    if (this.isVeiled) this.clock.pause();
    const note = noteOn(read.problems, this.voice);
    if (note && isBare) note.text += ` ${this.voice.say('link.start')}`;
    this.notes = note ? [...before, note] : before;
    return true;
  }

  /** The whole state as an address; empty before there is one. */
  get link() {
    return this.engine && this.session ? writeLink(this.state, this.session.recipe, this.models, this.ink.lasting) : '';
  }

  /** The rate by hand, else the one for the motion that the run settles on; and the beat that the strobe locks to. */
  setRate() {
    const { frequency, present } = this.session?.outlook ?? {};
    const { mode, slow } = this.state.clock;
    this.clock.mode = this.isStill ? 'slow' : mode;
    this.clock.slow = slow ?? slowRateFor(frequency ?? present?.frequency ?? null);
    this.lockStrobe();
  }

  /** The strobe follows the beat of now; where there is none it has nothing to lock to. */
  lockStrobe() {
    const beat = this.session?.outlook.present.frequency;
    this.clock.period = beat ? 1 / beat : null;
  }

  /** Less motion is asked for, or no more. @param {boolean} isStill */
  beStill(isStill) {
    this.isStill = isStill;
    this.clock.mode = isStill ? 'slow' : this.state.clock.mode;
    this.onChange();
  }

  /** A hand ended what it did: look anew, and speak. */
  settled() {
    this.session?.settle();
    this.occasion++;
    this.isLookDue = true;
  }

  /** The state; of a gear that lands as it touches down. */
  get #rolling() {
    const { state } = this;
    if (!lands(state.object)) return state;
    if (this.#touchdown.of !== state.parameters) this.#touchdown = { of: state.parameters, parameters: { ...state.parameters, velocity: state.parameters.touchdownVelocity } };
    return { ...state, object: fitted(state.object, { roll: 'none' }), parameters: this.#touchdown.parameters };
  }

  #swingsNow() {
    return (/** @type {string} */ parameter) => this.#swings?.of(this.#rolling, parameter) ?? null;
  }

  /** @param {string} object */
  #quantitiesOf(object) {
    const { velocityUnit } = this.state;
    const key = `${object} ${velocityUnit}`;
    const table = this.#quantities.has(key) ? null : this.models.find(({ name }) => name === object);
    if (table) this.#quantities.set(key, table.parameters.map((parameter) => new Quantity(parameter, velocityUnit)));
    return this.#quantities.get(key) ?? [];
  }

  /** @param {import('./engine/engine.js').Run} run */
  #accepts(run) {
    try {
      if (this.engine) new this.engine.Simulator(run).free();
      return true;
    } catch {
      return false;
    }
  }
}

/** @returns {State} language and theme as kept, or as the browser has them; the experiment waits for the engine */
function firstState() {
  const kept = recall();
  const language = kept.language ?? (globalThis.navigator?.language ?? 'en').slice(0, 2);
  const theme = kept.theme;
  return {
    object: openingObject,
    parameters: {},
    run: openingRun,
    links: {},
    ghosts: [],
    clock: { mode: 'slow', slow: null },
    lens: lenses[0].name,
    views: {},
    story: null,
    predict: null,
    isBig: false,
    velocityUnit: isVelocityUnit(kept.velocityUnit) ? kept.velocityUnit : 'm/s',
    language: Object.hasOwn(languages, language) ? /** @type {State['language']} */ (language) : 'en',
    theme: theme === 'light' || theme === 'dark' ? theme : 'system',
  };
}
