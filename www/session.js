/**
 * The experiment that runs: the engine's live gear, kept in step with the store, and what is drawn of it.
 *
 * The session knows no element and no timer. The page tells it how much model time has gone by and asks for the
 * scene; controls tell it what a hand does.
 */

import { Odometer } from './stage/odometer.js';
import { PastEnvelope } from './stage/past-envelope.js';
import { limitsFor, magnificationFor, spanFor, stillFits } from './stage/fit.js';
import { roundLimit, roundStep } from './view/scale.js';

/**
 * @typedef {import('./engine/engine.js').Engine} Engine
 * @typedef {import('./engine/engine.js').Outlook} Outlook
 * @typedef {import('./engine/engine.js').Simulator} Simulator
 * @typedef {import('./controls/refusal.js').Refusal} Refusal
 * @typedef {import('./store.js').Store} Store
 * @typedef {import('./store.js').State} State
 * @typedef {ReturnType<Session['scene']>} Scene
 */

/** What a kick is: a blow about the steering axis, in N m s. */
export const kickImpulse = 10;

/**
 * Steps that one frame, and one look ahead, may take. A gear of sensible size takes a few a millisecond and some ten
 * thousand to look 6 s ahead; an absurd one is stopped, for the page must never block.
 */
const stepsOfFrame = 100_000;
const stepsAhead = 30_000;

/** Drawn beyond this, a wheel tells nothing: then alone a run under way is magnified less than at its start. */
const widestDrawn = (60 * Math.PI) / 180;
/** Scales reach no further ahead than this, far beyond what the model is trusted for. */
const widestAhead = 1;
const pastCycles = 8;
const samplesPerCycle = 64;

export class Session {
  #engine;
  #store;
  #past = new PastEnvelope();
  /** @type {Simulator} */ #simulator;
  /** @type {Record<string, number>} */ #applied = {};
  #lookedAt = 0;
  #changedAt = 0;
  #kickedAt = -Infinity;
  #isStale = false;
  #odometer = new Odometer();

  /**
   * @param {Engine} engine
   * @param {Store} store
   */
  constructor(engine, store) {
    this.#engine = engine;
    this.#store = store;
    /** Why the run cannot go on, if so. @type {unknown} */
    this.failure = null;
    this.#simulator = this.#begin();
    /** What becomes of the motion if nothing changes. @type {Outlook} */
    this.outlook = this.#tried(() => this.#lookAhead()) ?? nothingAhead;
    /** How large things are drawn: see `fit`. */
    this.scales = this.#tried(() => this.#fitted()) ?? { magnification: 1, limits: limitsFor({ angle: 0, rate: 0 }), forces: { force: 1, moment: 1 } };
    store.subscribe((state, before) => this.#follow(state, before));
  }

  get time() {
    return this.#simulator.time;
  }

  /** The frequency of the motion now, or of where it goes. */
  get frequency() {
    return this.outlook.present.frequency ?? this.outlook.frequency ?? null;
  }

  /**
   * The outlook with the swing as it was seen last: the engine tells of the coming cycle, while trail and marks show the
   * one gone by. Just after a start or a blow there is none yet.
   * @returns {Outlook}
   */
  get seen() {
    const { time, range } = this.#simulator;
    const since = time - 1 / (this.frequency ?? 50);
    const isWhole = since >= range[0] && !(since < this.#kickedAt && this.#kickedAt <= time);
    if (!isWhole) return this.outlook;
    const { torsionAngle } = this.#simulator.history(since, time, 2 * samplesPerCycle);
    const amplitude = torsionAngle.reduce((most, angle) => Math.max(most, Math.abs(angle)), 0);
    return { ...this.outlook, present: { ...this.outlook.present, amplitude } };
  }

  /** The run from its start, with the values as they are. */
  restart() {
    this.#simulator.free();
    this.#simulator = this.#begin();
    this.refresh();
    this.fit();
  }

  /**
   * Lets model time go by.
   * @param {number} seconds
   */
  advance(seconds) {
    if (!(seconds > 0) || this.failure) return;
    this.#odometer.drive(this.time, this.#applied.velocity, this.#simulator.range[0]);
    this.#move(() => this.#simulator.advance(seconds));
  }

  /**
   * Moves to a time of the run: back within what it remembers, or on.
   * @param {number} time in s
   */
  seek(time) {
    const [earliest, latest] = this.#simulator.range;
    this.failure = null;
    this.#move(() => {
      this.#simulator.seek(Math.min(Math.max(time, earliest), latest));
      if (time > latest) this.#simulator.advance(time - latest);
    });
    this.#applied = this.#simulator.parameters();
    this.#isStale = true;
    this.#store.follow({ parameters: this.#applied });
  }

  kick() {
    if (this.failure) return;
    this.#simulator.kick(kickImpulse);
    this.#kickedAt = this.#simulator.time;
    this.refresh();
    this.#refit();
  }

  /**
   * Sets a parameter in the running gear. A value that the engine refuses changes nothing.
   * @param {string} name
   * @param {number} value in SI
   * @param {string | null} gesture what is undone together
   * @returns {Refusal | null} why it was refused
   */
  set(name, value, gesture) {
    try {
      this.#apply(name, value);
    } catch (error) {
      return /** @type {Refusal} */ (error);
    }
    this.#store.update({ parameters: { ...this.#store.state.parameters, [name]: value } }, gesture);
    return null;
  }

  /** Looks ahead anew where something has changed since. */
  refresh() {
    this.#isStale = false;
    this.outlook = this.#tried(() => this.#lookAhead()) ?? this.outlook;
    if (this.#swing().angle * this.scales.magnification > widestDrawn) this.fit();
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

  /** New axes and force scale where those in force no longer serve. The magnification stays as the run began. */
  #refit() {
    const { magnification, limits } = this.scales;
    const fitted = this.#tried(() => this.#fitted()) ?? this.scales;
    this.scales = { ...fitted, magnification, limits: stillFits(limits, this.#swing()) ? limits : fitted.limits };
  }

  /**
   * Everything a drawing of this instant needs, in SI units and radians.
   * @param {{ moment: [number, number], trackLength: number, stretches: number }} wanted
   *   `moment`: the window around now, in s; `trackLength`: how much of the ground behind is still seen, in m;
   *   `stretches`: how finely the whole run is shown
   */
  scene({ moment, trackLength, stretches }) {
    const simulator = this.#simulator;
    const { time } = simulator;
    const [earliest] = simulator.range;
    const parameters = this.#applied;
    const state = simulator.state();
    const beat = 1 / (this.frequency ?? 50);
    const since = (/** @type {number} */ span) => Math.max(earliest, time - span);
    const past = simulator.history(since(-moment[0]), time, 240);
    const orbitPast = simulator.history(since(pastCycles * beat), time, pastCycles * samplesPerCycle);
    const roll = this.#odometer.distanceAt(time);
    const track = simulator.history(Math.max(earliest, this.#odometer.timeAt(roll - trackLength)), time, 120);
    const ahead = this.#envelopeAhead();
    const span = spanFor(ahead, time, simulator.range);
    const stretch = Math.max((span.to - span.from) / stretches, roundStep(beat));
    return {
      time,
      state,
      parameters,
      forces: this.#engine.forces(parameters, state),
      past,
      orbitPast,
      track: { ...track, distance: track.time.map((at) => this.#odometer.distanceAt(at)) },
      future: this.#nextMoment(parameters, state, moment[1]),
      run: { ...span, past: this.#past.upTo(simulator, span.from, stretch), future: ahead },
      extremes: extremes(past, time - beat),
      trail: [3, 2, 1].map((twelfths) => poseAt(past, time - (twelfths * beat) / 12)).filter((pose) => pose !== null),
      roll,
      outlook: this.outlook,
      scales: this.scales,
    };
  }

  #begin() {
    const { object, parameters, run } = this.#store.state;
    const simulator = new this.#engine.Simulator({ model: object, parameters, initial: run.initial, maxSteps: stepsOfFrame });
    this.#applied = simulator.parameters();
    this.#past.clear();
    this.#odometer = new Odometer();
    this.#changedAt = 0;
    this.#kickedAt = -Infinity;
    this.failure = null;
    return simulator;
  }

  /**
   * Sets a parameter in the running gear.
   * @param {string} name @param {number} value in SI
   */
  #apply(name, value) {
    this.#recover();
    this.#simulator.set(name, value);
    this.#applied = { ...this.#applied, [name]: value };
    this.#changedAt = this.#simulator.time;
    this.#isStale = true;
  }

  /** After a stop, back to where the last change found the motion: what a wild value made of it since would stay. */
  #recover() {
    if (!this.failure) return;
    this.failure = null;
    this.#isStale = true;
    const values = this.#applied;
    this.#simulator.seek(Math.max(this.#changedAt, this.#simulator.range[0]));
    for (const [name, value] of Object.entries(this.#simulator.parameters()))
      if (values[name] !== value) this.#simulator.set(name, values[name]);
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

  /** @param {() => void} step */
  #move(step) {
    this.#tried(step);
  }

  #lookAhead() {
    this.#lookedAt = this.#simulator.time;
    return this.#engine.outlook({
      model: this.#store.state.object, parameters: this.#applied, initial: this.#present(), maxSteps: stepsAhead,
    });
  }

  /** The present state by name. */
  #present() {
    const [torsionAngle, torsionRate, lateralDeformation] = this.#simulator.state();
    return { torsionAngle, torsionRate, lateralDeformation };
  }

  /** The outlook's envelope, with times from the start of the run. */
  #envelopeAhead() {
    const { time, low, high } = this.outlook.envelope;
    return { time: time.map((ahead) => ahead + this.#lookedAt), low, high };
  }

  /**
   * What the next instants bring if nothing changes.
   * @param {Record<string, number>} parameters
   * @param {Float64Array} state
   * @param {number} duration in s
   */
  #nextMoment(parameters, [torsionAngle, torsionRate, lateralDeformation], duration) {
    const initial = { torsionAngle, torsionRate, lateralDeformation };
    return this.#engine.simulate({ model: this.#store.state.object, parameters, initial, duration, samples: 60, rtol: 1e-6, maxSteps: stepsAhead });
  }

  /** The largest ψ and ψ̇ of the motion now and to come. */
  #swing() {
    const { amplitude, present, envelope } = this.outlook;
    const [angle, rate] = this.#simulator.state().map(Math.abs);
    let ahead = Math.max(present.amplitude, amplitude.torsionAngle);
    for (let i = 0; i < envelope.time.length; i++) ahead = Math.max(ahead, envelope.high[i], -envelope.low[i]);
    const widest = Math.max(angle, Math.min(ahead, widestAhead));
    return { angle: widest, rate: Math.max(rate, 2 * Math.PI * (this.frequency ?? 0) * widest) };
  }

  #fitted() {
    const swing = this.#swing();
    return { magnification: magnificationFor(swing.angle), limits: limitsFor(swing), forces: this.#forceScale() };
  }

  /** Round numbers above the largest force and moment of the motion now and to come. */
  #forceScale() {
    const parameters = this.#applied;
    const cycle = this.#nextMoment(parameters, this.#simulator.state(), 1 / (this.frequency ?? 50));
    let force = 1;
    let moment = 1;
    for (const { torsionAngle, torsionRate, lateralDeformation } of [cycle, this.outlook.orbit]) {
      const stride = Math.max(1, Math.floor(torsionAngle.length / 60));
      for (let i = 0; i < torsionAngle.length; i += stride) {
        const now = this.#engine.forces(parameters, Float64Array.of(torsionAngle[i], torsionRate[i], lateralDeformation[i]));
        force = Math.max(force, Math.abs(now.sideForce));
        moment = Math.max(moment, Math.abs(now.aligningMoment));
      }
    }
    return { force: roundLimit(force), moment: roundLimit(moment) };
  }

  /** @param {State} state @param {State} before */
  #follow(state, before) {
    if (state.object !== before.object || state.run !== before.run) {
      this.restart();
      return;
    }
    for (const [name, value] of Object.entries(state.parameters)) {
      if (this.#applied[name] === value) continue;
      this.#apply(name, value);
    }
  }
}

/** Stands for an outlook where the very first look ahead failed. @type {Outlook} */
const nothingAhead = {
  verdict: 'rests',
  settled: true,
  amplitude: { torsionAngle: 0, torsionRate: 0, lateralDeformation: 0 },
  frequency: null,
  present: { amplitude: 0, frequency: null, trend: 'steady' },
  envelope: { time: new Float64Array(), low: new Float64Array(), high: new Float64Array() },
  orbit: { time: new Float64Array(), torsionAngle: new Float64Array(), torsionRate: new Float64Array(), lateralDeformation: new Float64Array() },
};

/**
 * @typedef {{ time: Float64Array, torsionAngle: Float64Array, lateralDeformation: Float64Array }} History
 */

/**
 * Lowest and highest ψ since a time, or null where the history does not reach back so far.
 * @param {History} history
 * @param {number} since
 * @returns {[number, number] | null}
 */
function extremes({ time, torsionAngle }, since) {
  if (!(time[0] <= since)) return null;
  let low = Infinity;
  let high = -Infinity;
  for (let i = time.length - 1; i >= 0 && time[i] >= since; i--) {
    low = Math.min(low, torsionAngle[i]);
    high = Math.max(high, torsionAngle[i]);
  }
  return [low, high];
}

/**
 * @param {History} history equally spaced
 * @param {number} at
 */
function poseAt({ time, torsionAngle, lateralDeformation }, at) {
  const last = time.length - 1;
  if (!(time[0] <= at)) return null;
  const place = Math.min(last, Math.round(((at - time[0]) / (time[last] - time[0])) * last));
  return { psi: torsionAngle[place], y: lateralDeformation[place] };
}
