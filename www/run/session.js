/**
 * The experiment that runs: the live gear, kept in step with the store, its ghosts, and what becomes of them.
 *
 * The session knows no element and no timer. The page tells it how much model time has gone by and asks for the
 * scene; controls tell it what a hand does.
 */

import { isSameRecord } from '../store.js';
import { isBeyond, spanFor } from './fit.js';
import { Ghosts } from './ghosts.js';
import { followed, linksBrokenBy, linksBrokenByPoint, withFollowers } from './links.js';
import { landingFrom, lands } from './landing.js';
import { LiveRun, recipeOf } from './live-run.js';
import { Lookout } from './lookout.js';
import { Odometer } from './odometer.js';
import { PastEnvelope } from './past-envelope.js';
import { fitted, fittedAsBegun, isTooWide, leastScales, magnificationOf, refitted, swingOf } from './scales.js';
import { sceneOf } from './scene.js';

/**
 * @typedef {import('../engine/engine.js').Engine} Engine
 * @typedef {import('../controls/refusal.js').Refusal} Refusal
 * @typedef {import('../store.js').Store} Store
 * @typedef {import('../store.js').State} State
 * @typedef {import('./live-run.js').Change} Change
 * @typedef {import('./live-run.js').Recipe} Recipe
 * @typedef {import('./live-run.js').Place & { legs: Odometer['legs'] }} Place where the run is, how it came there,
 *   and how far it had rolled
 * @typedef {import('./scene.js').Scene} Scene
 * @typedef {import('./scene.js').Wanted} Wanted
 */

/** What a kick is: a blow about the steering axis, in N m s. */
export const kickImpulse = 10;

/** A hand is firm: between two of its pushes no more time goes by than this, in s. */
const grip = 5e-4;

export class Session {
  #engine;
  #store;
  #past = new PastEnvelope();
  #odometer = new Odometer();
  /** @type {LiveRun} */ #live;
  /** @type {Lookout} */ #lookout;
  /** When a hand took hold of the wheel, where the run was, and how the wheel is held. @type {{ place: Place, angle: number } | null} */ #held = null;

  /**
   * @param {Engine} engine
   * @param {Store} store
   */
  constructor(engine, store) {
    this.#engine = engine;
    this.#store = store;
    /** Why the run cannot go on, if so. @type {unknown} */
    this.failure = null;
    this.#live = this.#begun(recipeIn(store.state));
    this.#lookout = new Lookout(engine, isVeiled(store.state));
    this.ghosts = new Ghosts(engine);
    this.ghosts.follow(store.state.ghosts, this.time);
    this.#tried(() => this.#lookout.look(this.#live));
    /** How large things are drawn. */
    this.scales = this.#tried(() => fittedAsBegun(engine, this.#live, this.#lookout, this.#chosenMagnification)) ?? leastScales;
    store.here = () => this.#place;
    store.subscribe((state, before, place) => this.#follow(state, before, place));
  }

  get time() {
    return this.#live.time;
  }

  /** The state by name, now. */
  get stateByName() {
    return this.#live.stateByName;
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
    const { to } = spanFor(this.#lookout.ahead, time, range, least);
    return { model: object, parameters: this.isLanding ? landingFrom(parameters, from) : { ...parameters }, initial, duration: to - from };
  }

  /** What becomes of the motion if nothing changes. */
  get outlook() {
    return this.#lookout.outlook;
  }

  /** The same, with the swing as it was seen last. */
  get seen() {
    return this.#lookout.seen(this.#live);
  }

  /** The frequency of the motion now, or of where it goes. */
  get frequency() {
    return this.#lookout.frequency;
  }

  /** Energy of the coming cycle by element; null for a wheel that does not swing. */
  get energy() {
    return this.#lookout.energy;
  }

  /** Whether its speed falls as it rolls. */
  get isLanding() {
    return lands(this.#live.object);
  }

  /** Whether the outlook is older than the last change. */
  get isStale() {
    return this.#lookout.isStale;
  }

  /** The run from its start, with the values as they are; ghosts with theirs, from the same start. Undo takes it back to where it was. */
  restart() {
    const { object, parameters, run, ghosts } = this.#store.state;
    this.#store.did(this.#place);
    this.#begin({ object, parameters, initial: run.initial, changes: [], time: 0 });
    this.#store.follow({ ghosts: ghosts.map((ghost) => ({ ...ghost, initial: run.initial, from: 0 })) });
  }

  /**
   * The run anew from another start; ghosts from theirs. While a hand drags it the scales stay, as long as they serve.
   * @param {Record<string, number>} initial
   * @param {string | null} [gesture] what is undone together
   */
  startFrom(initial, gesture = null) {
    const { scales } = this;
    const { ghosts } = this.#store.state;
    this.#store.update({ run: { initial }, ...(ghosts.length > 0 && { ghosts: ghosts.map((ghost) => ({ ...ghost, from: 0 })) }) }, gesture, this.#place);
    if (gesture !== null && !isTooWide(scales, swingOf(this.#live, this.#lookout).angle, this.#chosenMagnification)) this.scales = scales;
  }

  /**
   * Lets model time go by.
   * @param {number} seconds
   */
  advance(seconds) {
    if (!(seconds > 0) || this.failure) return;
    this.#odometer.drive(this.time, this.#live.present.parameters.velocity, this.#live.range[0]);
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
    this.#lookout.isStale = true;
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
    this.#held = { place: this.#place, angle };
    this.#tried(() => this.#live.apply({ state: held(angle) }, 'hold'));
    this.#lookout.isStale = true;
  }

  /** The hand lets go: the run goes on from there, and undo takes the wheel back to before. */
  letGo() {
    if (!this.#held) return;
    const { place } = this.#held;
    this.#held = null;
    if (this.failure) return;
    const state = this.#live.stateByName;
    this.#tried(() => this.#live.apply({ state }, 'hold'));
    this.#live.settle();
    this.#store.did(place);
    this.refresh();
    this.#refit();
  }

  /** The hand lets go as if it had never been there. */
  letBe() {
    const touched = this.#held;
    this.#held = null;
    if (touched && !this.failure) this.#goTo(touched.place);
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
    const links = linksBrokenBy(name, this.#store.state.links);
    return this.#setAll(() => withFollowers(this.#engine, { [name]: value }, this.#live, links), links, gesture);
  }

  /**
   * Sets several parameters at once and nothing besides: what would follow them is parted from them, for they are given as
   * a point is.
   * @param {Record<string, number>} values in SI
   * @param {string | null} gesture what is undone together
   * @returns {Refusal | null} why one was refused; then none is set
   */
  setPoint(values, gesture) {
    return this.#setAll(() => values, linksBrokenByPoint(values, this.#store.state.links), gesture);
  }

  /**
   * Puts the run on another motion: values of the gear and a state, which undo takes back together.
   * @param {Record<string, number>} values in SI; what would follow them is parted from them
   * @param {Record<string, number>} state
   * @param {string | null} [gesture] what is undone together
   */
  setMotion(values, state, gesture = null) {
    const place = this.#place;
    try {
      this.#recover();
      this.#live.apply({ ...(Object.keys(values).length > 0 && { set: values }), state }, gesture);
    } catch {
      // Whoever asks has values and state from the engine.
      return;
    }
    this.#lookout.isStale = true;
    const { state: before } = this.#store;
    const change = { parameters: { ...this.#live.parameters }, links: linksBrokenByPoint(values, before.links) };
    if (isSameRecord(change.parameters, before.parameters) && isSameRecord(change.links, before.links)) this.#store.did(place, gesture);
    else this.#store.update(change, gesture, place);
    if (gesture === null) this.settle();
  }

  /**
   * Joins a value to the values it follows, or parts it from them.
   * @param {string} name
   */
  toggleLink(name) {
    const place = this.#place;
    const links = { ...this.#store.state.links, [name]: !this.#store.state.links[name] };
    if (links[name]) {
      const { parameters } = this.#live;
      const sources = Object.fromEntries(followed[name].map((source) => [source, parameters[source]]));
      this.#apply(withFollowers(this.#engine, sources, this.#live, { [name]: true }), null);
    }
    this.#store.update({ parameters: { ...this.#live.parameters }, links }, null, place);
    this.settle();
  }

  /** Looks ahead anew where something has changed since. */
  refresh() {
    this.#tried(() => this.#lookout.look(this.#live));
    // Under a hand the scale stays, or the wheel would jump away from it.
    if (this.#lookout.isVeiled || this.isHeld) return;
    if (isTooWide(this.scales, swingOf(this.#live, this.#lookout).angle, this.#chosenMagnification)) this.fit();
    // A run that grows leaves any axes in the end.
    else if (isBeyond(this.scales.limits, this.#live.state)) this.#refit();
  }

  /** Looks ahead though it was veiled: what comes is about to be told. */
  unveil() {
    this.#lookout.isVeiled = false;
    this.refresh();
  }

  /** Chooses magnification, axes and force scale for the motion as it is and will be. */
  fit() {
    this.scales = this.#tried(() => this.#fitted()) ?? this.scales;
  }

  /** A hand let go. */
  settle() {
    this.#store.settle();
    this.#live.settle();
    if (this.failure) return;
    if (this.isStale) this.refresh();
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
    const { scales, ghosts, isHeld } = this;
    return sceneOf({ engine: this.#engine, live: this.#live, past: this.#past, odometer: this.#odometer, lookout: this.#lookout, scales, ghosts, isHeld }, wanted);
  }

  /** Where the run is; while a hand holds the wheel, where it was before. @returns {Place} */
  get #place() {
    return this.#held?.place ?? { ...this.#live.place, legs: this.#odometer.legs };
  }

  /** @param {Recipe} recipe */
  #begun(recipe) {
    const live = new LiveRun(this.#engine, recipe);
    this.#past.clear();
    this.#odometer = new Odometer();
    this.#odometer.drive(0, live.present.parameters.velocity, 0);
    this.failure = live.failure;
    return live;
  }

  /** @param {Recipe} recipe */
  #begin(recipe) {
    const live = this.#begun(recipe);
    this.#live.free();
    this.#live = live;
    this.#held = null;
    this.refresh();
    this.scales = this.#tried(() => fittedAsBegun(this.#engine, live, this.#lookout, this.#chosenMagnification)) ?? this.scales;
  }

  /** Takes the run to a place: of its own past, or of a run that was there before it. @param {Place} place */
  #goTo(place) {
    if (!this.#live.knows(place)) {
      this.#begin(recipeOf(place));
      return;
    }
    this.failure = null;
    this.#tried(() => this.#live.goTo(place));
    this.#past.clear();
    this.#odometer = new Odometer(place.legs);
    this.ghosts.goTo(this.time);
    this.#lookout.isStale = true;
  }

  /** Does something that is no change of a value: undo takes the run back to before it. @param {Omit<Change, 'time'>} change */
  #do(change) {
    if (this.failure) return;
    const place = this.#place;
    this.#tried(() => this.#live.apply(change));
    this.#store.did(place);
    this.refresh();
    this.#refit();
  }

  /** @param {() => Record<string, number>} values @param {State['links']} links @param {string | null} gesture @returns {Refusal | null} */
  #setAll(values, links, gesture) {
    const place = this.#place;
    try {
      const wanted = values();
      const others = Object.fromEntries(Object.entries(wanted).filter(([name, value]) => value !== this.#live.parameters[name]));
      const isOther = Object.keys(others).length > 0;
      // Where no value is another, nothing is done that undo would take back and a link would carry.
      if (!isOther && !this.failure && isSameRecord(links, this.#store.state.links)) return null;
      if (isOther || this.failure) this.#apply(this.failure ? wanted : others, gesture);
    } catch (error) {
      return /** @type {Refusal} */ (error);
    }
    this.#store.update({ parameters: { ...this.#live.parameters }, links }, gesture, place);
    return null;
  }

  /**
   * Sets values in the running gear.
   * @param {Record<string, number>} set in SI @param {string | null} gesture
   */
  #apply(set, gesture) {
    this.#recover();
    this.#live.apply({ set }, gesture);
    this.#lookout.isStale = true;
  }

  /** After a stop, back to where the last change found the motion: what a wild value made of it since would stay. */
  #recover() {
    if (!this.failure) return;
    this.failure = null;
    this.#lookout.isStale = true;
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

  /** New axes where those in force no longer serve. */
  #refit() {
    if (this.#lookout.isVeiled) return;
    this.scales = this.#tried(() => refitted(this.scales, this.#engine, this.#live, this.#lookout)) ?? this.scales;
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

  #fitted() {
    return fitted(this.#engine, this.#live, this.#lookout, this.#chosenMagnification);
  }

  get #chosenMagnification() {
    return this.#store.state.views.magnification;
  }

  /** @param {State} state @param {State} before @param {Place | null} place where undo or redo goes to */
  #follow(state, before, place) {
    if (state.predict !== before.predict) this.#lookout.isVeiled = isVeiled(state);
    if (place) this.#goTo(place);
    else if (state.object !== before.object || state.run !== before.run) this.#begin(recipeIn(state));
    if (state.views.magnification !== before.views.magnification) {
      const magnification = magnificationOf(swingOf(this.#live, this.#lookout).angle, this.#chosenMagnification);
      this.scales = { ...this.scales, magnification };
    }
    if (state.ghosts !== before.ghosts) this.ghosts.follow(state.ghosts, this.time);
    const { parameters } = this.#live;
    const set = Object.fromEntries(Object.entries(state.parameters).filter(([name, value]) => parameters[name] !== value));
    if (Object.keys(set).length > 0) this.#apply(set, null);
  }
}

/**
 * The run as the state has it.
 * @param {Pick<State, 'object' | 'parameters' | 'run'>} state
 * @returns {Recipe}
 */
function recipeIn({ object, parameters, run }) {
  return { object, parameters: { ...parameters, ...run.start }, initial: run.initial, changes: run.changes ?? [], time: run.time ?? 0 };
}

/** A wheel in a hand, by name. @param {number} angle ψ in rad */
const held = (angle) => ({ torsionAngle: angle, torsionRate: 0 });

/** @param {State} state */
const isVeiled = ({ predict }) => predict !== null && predict.outcome === null;
