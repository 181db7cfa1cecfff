/**
 * The experiment that runs: the live gear, kept in step with the store, its ghosts, and what becomes of them.
 *
 * The session knows no element and no timer. The page tells it how much model time has gone by and asks for the
 * scene; controls tell it what a hand does.
 */

import { roundLimit } from '../view/scale.js';
import { limitsFor, magnificationFor, magnifications, spanFor, stillFits } from './fit.js';
import { Ghosts } from './ghosts.js';
import { followed, linksBrokenBy, withFollowers } from './links.js';
import { LiveRun } from './live-run.js';
import { Odometer } from './odometer.js';
import { PastEnvelope } from './past-envelope.js';
import { sceneOf } from './scene.js';

/**
 * @typedef {import('../engine/engine.js').Engine} Engine
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {import('../engine/engine.js').Energy} Energy
 * @typedef {import('../controls/refusal.js').Refusal} Refusal
 * @typedef {import('../store.js').Store} Store
 * @typedef {import('../store.js').State} State
 * @typedef {import('./live-run.js').Change} Change
 * @typedef {import('./scene.js').Scene} Scene
 * @typedef {import('./scene.js').Wanted} Wanted
 */

/** What a kick is: a blow about the steering axis, in N m s. */
export const kickImpulse = 10;

/** Steps that one look ahead may take: some ten thousand look 6 s ahead; an absurd gear is stopped, for the page must never block. */
const stepsAhead = 30_000;

/** Drawn beyond this, a wheel tells nothing: then alone a run under way is magnified less than at its start. */
const widestDrawn = (60 * Math.PI) / 180;
/** Scales reach no further ahead than this, far beyond what the model is trusted for. */
const widestAhead = 1;
const samplesPerCycle = 64;
/** A trail shows so many cycles. */
const trailCycles = 8;
/** A swing smaller than this is none, in rad. */
const least = 1e-9;
/** A hand is firm: between two of its pushes no more time goes by than this, in s. */
const grip = 5e-4;

export class Session {
  #engine;
  #store;
  #past = new PastEnvelope();
  #odometer = new Odometer();
  /** @type {LiveRun} */ #live;
  #lookedAt = 0;
  #isStale = false;
  /** Whether nobody may look ahead, so that nothing tells what comes before it is guessed: no word, axis or scale. */ #isVeiled;
  /** @type {Energy | null} */ #energy = null;
  /** When a hand took hold of the wheel, and how it stood. @type {{ time: number, before: Record<string, number>, angle: number } | null} */ #held = null;

  /**
   * @param {Engine} engine
   * @param {Store} store
   */
  constructor(engine, store) {
    this.#engine = engine;
    this.#store = store;
    this.#isVeiled = isVeiled(store.state);
    /** Why the run cannot go on, if so. @type {unknown} */
    this.failure = null;
    this.#live = this.#begun(store.state);
    this.ghosts = new Ghosts(engine);
    this.ghosts.follow(store.state.ghosts, this.time);
    /** What becomes of the motion if nothing changes. @type {Outlook} */
    this.outlook = this.#isVeiled ? nothingAhead : this.#tried(() => this.#lookAhead()) ?? nothingAhead;
    /** How large things are drawn: see `fit`. */
    this.scales = this.#tried(() => this.#fitted()) ?? { magnification: 1, limits: limitsFor({ angle: 0, rate: 0, deformation: 0 }), forces: { force: 1, moment: 1 } };
    store.subscribe((state, before, walk) => this.#follow(state, before, walk));
  }

  get time() {
    return this.#live.time;
  }

  /** How to begin the run again and come to where it is. */
  get recipe() {
    return this.#live.recipe;
  }

  /**
   * The run since something was last done to it, to where the timeline ends: what is seen, as the engine's `simulate`
   * takes it.
   * @param {number} [least] how much of the run the timeline shows at least, in s
   */
  sinceChange(least) {
    const { parameters, object, range, time } = this.#live;
    const from = Math.max(this.#live.changedAt, range[0]);
    const { time: _, ...states } = this.#live.history(from, from, 2);
    const initial = Object.fromEntries(Object.entries(states).map(([name, series]) => [name, series[0]]));
    const ahead = { ...this.outlook.envelope, time: this.outlook.envelope.time.map((at) => at + this.#lookedAt) };
    const { to } = spanFor(ahead, time, range, least);
    return { model: object, parameters: { ...parameters }, initial, duration: to - from };
  }

  /** The frequency of the motion now, or of where it goes. */
  get frequency() {
    return this.outlook.present.frequency ?? this.outlook.frequency ?? null;
  }

  /** Energy of the coming cycle by element; null for a wheel that does not swing. */
  get energy() {
    return this.#energy;
  }

  /**
   * The outlook with the swing as it was seen last: the engine tells of the coming cycle, while trail and marks show the
   * one gone by. Just after a start or a blow there is none yet.
   * @returns {Outlook}
   */
  get seen() {
    const { time, range, struckAt } = this.#live;
    const since = time - 1 / (this.frequency ?? 50);
    if (since < range[0] || since < struckAt) return this.outlook;
    const { torsionAngle } = this.#live.history(since, time, 2 * samplesPerCycle);
    const amplitude = torsionAngle.reduce((most, angle) => Math.max(most, Math.abs(angle)), 0);
    return { ...this.outlook, present: { ...this.outlook.present, amplitude } };
  }

  /** The run from its start, with the values as they are; ghosts with theirs, from the same start. */
  restart() {
    const { object, parameters, run, ghosts } = this.#store.state;
    this.#begin({ object, parameters, run: { initial: run.initial } });
    this.#store.follow({ ghosts: ghosts.map((ghost) => ({ ...ghost, initial: run.initial, from: 0 })) });
  }

  /**
   * Lets model time go by.
   * @param {number} seconds
   */
  advance(seconds) {
    if (!(seconds > 0) || this.failure) return;
    this.#odometer.drive(this.time, this.#live.parameters.velocity, this.#live.range[0]);
    this.#tried(() => (this.#held ? this.#advanceHeld(this.#held.angle, seconds) : this.#live.advance(seconds)));
    this.ghosts.goTo(this.time);
  }

  /**
   * Moves to a time of the run: back within what it remembers, or on.
   * @param {number} time in s
   */
  seek(time) {
    this.failure = null;
    this.#tried(() => this.#live.seek(time));
    this.ghosts.goTo(this.time);
    this.#isStale = true;
    this.#store.follow({ parameters: this.#live.parameters });
  }

  /** A blow about the steering axis. */
  kick() {
    this.#do({ kick: kickImpulse });
  }

  /**
   * A hand holds the wheel at an angle, and the ground rolls on under it.
   * @param {number} angle ψ in rad
   */
  hold(angle) {
    if (this.failure || !Number.isFinite(angle)) return;
    this.#held = { time: this.time, before: this.#live.stateByName, ...this.#held, angle };
    this.#tried(() => this.#live.apply({ state: held(angle) }, 'hold'));
    this.#isStale = true;
  }

  /** The hand lets go: the run goes on from there, and undo takes the wheel back to before. */
  letGo() {
    if (!this.#held) return;
    const { time, before } = this.#held;
    this.#held = null;
    if (this.failure) return;
    const state = this.#live.stateByName;
    this.#tried(() => this.#live.apply({ state }, 'hold'));
    this.#store.did({ time, before, again: { state } });
    this.refresh();
    this.#refit();
  }

  /** The hand lets go as if it had never been there. */
  letBe() {
    const touched = this.#held;
    this.#held = null;
    if (touched && !this.failure) this.#takeBack(touched.time, touched.before);
  }

  /** Whether a hand holds the wheel. */
  get isHeld() {
    return this.#held !== null;
  }

  /** The wheel straight ahead and at rest; parameters stay. */
  rest() {
    this.#do({ state: Object.fromEntries(Object.keys(this.#live.stateByName).map((name) => [name, 0])) });
  }

  /**
   * Sets a parameter in the running gear, with those linked to it. A value that the engine refuses changes nothing.
   * @param {string} name
   * @param {number} value in SI
   * @param {string | null} gesture what is undone together
   * @returns {Refusal | null} why it was refused
   */
  set(name, value, gesture) {
    const { state } = this.#store;
    const links = linksBrokenBy(name, state.links);
    try {
      this.#apply(withFollowers(this.#engine, { [name]: value }, this.#live, links), gesture);
    } catch (error) {
      return /** @type {Refusal} */ (error);
    }
    this.#store.update({ parameters: { ...this.#live.parameters }, links }, gesture);
    return null;
  }

  /**
   * Joins a value to the values it follows, or parts it from them.
   * @param {string} name
   */
  toggleLink(name) {
    const links = { ...this.#store.state.links, [name]: !this.#store.state.links[name] };
    if (links[name]) {
      const { parameters } = this.#live;
      const sources = Object.fromEntries(followed[name].map((source) => [source, parameters[source]]));
      this.#apply(withFollowers(this.#engine, sources, this.#live, { [name]: true }), null);
    }
    this.#store.update({ parameters: { ...this.#live.parameters }, links });
    this.settle();
  }

  /** Looks ahead anew where something has changed since. */
  refresh() {
    this.#isStale = this.#isVeiled;
    if (this.#isVeiled) return;
    this.outlook = this.#tried(() => this.#lookAhead()) ?? this.outlook;
    // Under a hand the scale stays, or the wheel would jump away from it.
    if (this.isHeld) return;
    const { angle } = this.#swing();
    const { magnification } = this.scales;
    if (angle * magnification > widestDrawn && this.#magnification(angle) < magnification) this.fit();
  }

  /** Looks ahead though it was veiled: what comes is about to be told. */
  unveil() {
    this.#isVeiled = false;
    this.refresh();
  }

  /** Whether the outlook is older than the last change. */
  get isStale() {
    return this.#isStale;
  }

  /** Chooses magnification, axes and force scale for the motion as it is and will be. */
  fit() {
    this.scales = this.#tried(() => this.#fitted()) ?? this.scales;
  }

  /** A hand let go. */
  settle() {
    this.#store.settle();
    if (this.failure) return;
    if (this.#isStale) this.refresh();
    this.#refit();
  }

  /** Keeps the run as it is, to go on beside the one that a hand changes. */
  pin() {
    const { parameters, stateByName } = this.#live;
    const { object, ghosts } = this.#store.state;
    this.#store.update({ ghosts: [...ghosts, { object, parameters: { ...parameters }, initial: stateByName, from: this.time }] });
  }

  /** Lets a ghost go. @param {number} index */
  unpin(index) {
    this.#store.update({ ghosts: this.#store.state.ghosts.filter((_, i) => i !== index) });
  }

  /**
   * Everything a drawing of this instant needs, in SI units and radians.
   * @param {Wanted} wanted
   * @returns {Scene}
   */
  scene(wanted) {
    const { outlook, scales, frequency, ghosts } = this;
    return sceneOf({
      engine: this.#engine, live: this.#live, past: this.#past, odometer: this.#odometer,
      outlook, scales, frequency, ghosts, energy: this.#energy, lookedAt: this.#lookedAt, stepsAhead, isHeld: this.isHeld,
    }, wanted);
  }

  /**
   * A run as the store has it.
   * @param {Pick<State, 'object' | 'parameters' | 'run'>} state
   */
  #begun({ object, parameters, run }) {
    const live = new LiveRun(this.#engine, {
      object, parameters: { ...parameters, ...run.start }, initial: run.initial, changes: run.changes ?? [], time: run.time ?? 0,
    });
    this.#past.clear();
    this.#odometer = new Odometer();
    this.#odometer.drive(0, live.parameters.velocity, 0);
    this.failure = live.failure;
    return live;
  }

  /** @param {Pick<State, 'object' | 'parameters' | 'run'>} state */
  #begin(state) {
    const live = this.#begun(state);
    this.#live.free();
    this.#live = live;
    this.#held = null;
    this.refresh();
    this.fit();
  }

  /** Does something that is no change of a value: undo takes the run back to before it. @param {Omit<Change, 'time'>} change */
  #do(change) {
    if (this.failure) return;
    const deed = { time: this.time, before: this.#live.stateByName, again: change };
    this.#tried(() => this.#live.apply(change));
    this.#store.did(deed);
    this.refresh();
    this.#refit();
  }

  /**
   * Sets values in the running gear.
   * @param {Record<string, number>} set in SI @param {string | null} gesture
   */
  #apply(set, gesture) {
    this.#recover();
    this.#live.apply({ set }, gesture);
    this.#isStale = true;
  }

  /** After a stop, back to where the last change found the motion: what a wild value made of it since would stay. */
  #recover() {
    if (!this.failure) return;
    this.failure = null;
    this.#isStale = true;
    const { parameters: values, changedAt, range } = this.#live;
    this.#live.seek(Math.max(changedAt, range[0]));
    const then = this.#live.parameters;
    const set = Object.fromEntries(Object.entries(values).filter(([name, value]) => then[name] !== value));
    if (Object.keys(set).length > 0) this.#live.apply({ set });
  }

  /**
   * Time goes by while a hand keeps the wheel where it is: the ground rolls on and drags the tire along.
   * @param {number} angle ψ in rad @param {number} seconds
   */
  #advanceHeld(angle, seconds) {
    for (let left = seconds; left > 0; left -= grip) {
      this.#live.advance(Math.min(grip, left));
      this.#live.apply({ state: held(angle) }, 'hold');
    }
  }

  /** New axes and force scale where those in force no longer serve. The magnification stays as the run began. */
  #refit() {
    if (this.#isVeiled) return;
    const { magnification, limits } = this.scales;
    const swing = this.#swing();
    // A wheel at rest has no swing to fit to, and a trail that is still seen must not be cut.
    const isStill = swing.angle < least;
    const trailed = { ...swing, angle: Math.max(swing.angle, this.#trailed()) };
    if (isStill || (stillFits(limits, trailed) && !stillFits(limits, swing))) return;
    const fitted = this.#tried(() => this.#fitted()) ?? this.scales;
    this.scales = { ...fitted, magnification, limits: stillFits(limits, swing) ? limits : fitted.limits };
  }

  /** The largest ψ of the trail, in rad. */
  #trailed() {
    const { time, range } = this.#live;
    const from = Math.max(range[0], time - trailCycles / (this.frequency ?? 50));
    if (!(time > from)) return 0;
    const { low, high } = this.#live.envelope(from, time, 1);
    return Math.max(high[0], -low[0]);
  }

  /**
   * What can be computed; where that fails the run has stopped.
   * @template Result
   * @param {() => Result} task
   */
  #tried(task) {
    try {
      return task();
    } catch (error) {
      this.failure = error;
      return null;
    }
  }

  /** The run as it goes on from now. */
  get #onward() {
    const { object: model, parameters, stateByName: initial } = this.#live;
    return { model, parameters, initial, maxSteps: stepsAhead };
  }

  #lookAhead() {
    this.#lookedAt = this.time;
    const run = this.#onward;
    const outlook = this.#engine.outlook(run);
    const frequency = outlook.present.frequency ?? outlook.frequency;
    this.#energy = frequency ? this.#energyOfCycle(run, 1 / frequency) : null;
    return outlook;
  }

  /**
   * The energy of the coming cycle. Just after a start or a blow the tire has yet to follow the wheel, which makes that
   * cycle unlike all others: then it is the one after.
   * @param {{ model: string, parameters: Readonly<Record<string, number>>, initial: Record<string, number>, maxSteps: number }} run
   * @param {number} beat in s
   */
  #energyOfCycle(run, beat) {
    const isFresh = this.time - Math.max(0, this.#live.struckAt) < beat;
    if (!isFresh) return this.#engine.energy({ ...run, duration: beat });
    const { time: _, events: __, stats: ___, ...states } = this.#engine.simulate({ ...run, duration: beat, samples: 2 });
    const initial = Object.fromEntries(Object.entries(states).map(([name, series]) => [name, series[1]]));
    return this.#engine.energy({ ...run, initial, duration: beat });
  }

  /** The largest ψ, ψ̇ and y of the motion now and to come. */
  #swing() {
    const { amplitude, present, envelope } = this.outlook;
    const [angle, rate, deformation] = this.#live.state.map(Math.abs);
    let ahead = Math.max(present.amplitude, amplitude.torsionAngle);
    for (let i = 0; i < envelope.time.length; i++) ahead = Math.max(ahead, envelope.high[i], -envelope.low[i]);
    const widest = Math.max(angle, Math.min(ahead, widestAhead));
    const share = amplitude.torsionAngle > 0 ? amplitude.lateralDeformation / amplitude.torsionAngle : 0.2;
    return {
      angle: widest,
      rate: Math.max(rate, 2 * Math.PI * (this.frequency ?? 0) * widest),
      deformation: Math.max(deformation, share * widest),
    };
  }

  /** As a hand chose, else the one that fits a swing. @param {number} angle in rad */
  #magnification(angle) {
    const chosen = Number(this.#store.state.views.magnification);
    return magnifications.includes(chosen) ? chosen : magnificationFor(angle);
  }

  #fitted() {
    const swing = this.#swing();
    return { magnification: this.#magnification(swing.angle), limits: limitsFor(swing), forces: this.#forceScale() };
  }

  /** Round numbers above the largest force and moment of the motion now and to come. */
  #forceScale() {
    const run = this.#onward;
    const cycle = this.#engine.simulate({ ...run, duration: 1 / (this.frequency ?? 50), samples: 60, rtol: 1e-6 });
    let force = 1;
    let moment = 1;
    for (const motion of [cycle, this.outlook.orbit]) {
      if (motion.time.length === 0) continue;
      const { sideForce, aligningMoment } = this.#engine.forcesAlong(run, columnsOf(motion));
      force = sideForce.reduce((most, value) => Math.max(most, Math.abs(value)), force);
      moment = aligningMoment.reduce((most, value) => Math.max(most, Math.abs(value)), moment);
    }
    return { force: roundLimit(force), moment: roundLimit(moment) };
  }

  /** @param {State} state @param {State} before @param {import('../store.js').Walk | null} walk */
  #follow(state, before, walk) {
    if (state.predict !== before.predict) this.#isVeiled = isVeiled(state);
    if (state.object !== before.object || state.run !== before.run) this.#begin(state);
    if (state.views.magnification !== before.views.magnification)
      this.scales = { ...this.scales, magnification: this.#magnification(this.#swing().angle) };
    if (state.ghosts !== before.ghosts) this.ghosts.follow(state.ghosts, this.time);
    if (walk?.deed) this.#repeatOrTakeBack(walk);
    const { parameters } = this.#live;
    const set = Object.fromEntries(Object.entries(state.parameters).filter(([name, value]) => parameters[name] !== value));
    if (Object.keys(set).length > 0) this.#apply(set, null);
  }

  /** @param {import('../store.js').Walk} walk */
  #repeatOrTakeBack({ direction, deed }) {
    if (!deed) return;
    if (direction === 'redo') this.#tried(() => this.#live.apply(deed.again));
    else if (deed.time >= this.#live.range[0] && deed.time <= this.time) this.#takeBack(deed.time, deed.before);
    this.#isStale = true;
  }

  /** @param {number} time in s @param {Record<string, number>} state of then, before a hand touched it */
  #takeBack(time, state) {
    this.#tried(() => this.#live.takeBack(time, state));
    this.ghosts.goTo(this.time);
    this.#isStale = true;
  }
}

/** The columns of a motion without what else came with it. @param {import('../engine/engine.js').Columns} columns */
const columnsOf = ({ time, torsionAngle, torsionRate, lateralDeformation }) => ({ time, torsionAngle, torsionRate, lateralDeformation });

/** A wheel in a hand, by name. @param {number} angle ψ in rad */
const held = (angle) => ({ torsionAngle: angle, torsionRate: 0 });

/** @param {State} state */
const isVeiled = ({ predict }) => predict !== null && predict.outcome === null;

/** Stands for an outlook where the very first look ahead failed, or may not be. @type {Outlook} */
const nothingAhead = {
  verdict: 'rests',
  settled: true,
  amplitude: { torsionAngle: 0, torsionRate: 0, lateralDeformation: 0 },
  frequency: null,
  present: { amplitude: 0, frequency: null, trend: 'steady' },
  envelope: { time: new Float64Array(), low: new Float64Array(), high: new Float64Array() },
  orbit: { time: new Float64Array(), torsionAngle: new Float64Array(), torsionRate: new Float64Array(), lateralDeformation: new Float64Array() },
};
