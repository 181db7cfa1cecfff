/**
 * What is drawn of a run at an instant: columns and numbers, in SI units and radians, for the gear, the timeline and
 * every lens.
 *
 * @typedef {import('../engine/engine.js').Engine} Engine
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {import('../engine/engine.js').Energy} Energy
 * @typedef {import('./live-run.js').LiveRun} LiveRun
 * @typedef {ReturnType<typeof sceneOf>} Scene
 * @typedef {{ moment: [number, number], trackLength: number, stretches: number, exposure: number, duration?: number }} Wanted
 *   `moment`: the window around now, in s; `trackLength`: how much of the ground behind is still seen, in m;
 *   `stretches`: how finely the whole run is shown; `exposure`: the model time of one frame where that is too fast for
 *   a single pose, 0 where it is not, in s; `duration`: how much of the run is shown at least, in s
 */

import { roundStep } from '../view/scale.js';
import { cycleLooks } from './cycle-looks.js';
import { damperLooks } from './damper-looks.js';
import { spanFor } from './fit.js';
import { lands } from './landing.js';
import { linearLooks } from './linear-looks.js';
import { onward, stepsAhead } from './lookout.js';

/** Cycles that the trail shows, and that of a ghost. */
const pastCycles = 8;
const ghostCycles = 2;
/** A past of more cycles than this is shown with as many samples as there are pixels, and no cycle can be told in it. */
const mostCycles = 16;
const pastSamples = 240;
const samplesPerCycle = 64;
/** A spectrum looks back so many cycles, and needs a few. */
const spectrumCycles = 32;
const fewestCycles = 3;
/** Poses of a fan, spread over the exposure of a frame. */
const poses = 16;

/**
 * @param {{
 *   engine: Engine, live: LiveRun, past: import('./past-envelope.js').PastEnvelope, odometer: import('./odometer.js').Odometer,
 *   lookout: import('./lookout.js').Lookout, scales: import('./scales.js').Scales, ghosts: import('./ghosts.js').Ghosts, isHeld: boolean,
 * }} session
 * @param {Wanted} wanted
 */
export function sceneOf({ engine, live, past: pastEnvelope, odometer, lookout, scales, ghosts, isHeld }, wanted) {
  const { moment, trackLength, stretches, exposure, duration } = wanted;
  const { time, state } = live;
  const { object, parameters } = live.present;
  const { outlook, energy, frequency, ahead } = lookout;
  const [earliest] = live.range;
  const beat = 1 / (frequency ?? 50);
  const since = (/** @type {number} */ span) => Math.max(earliest, time - span);
  const { past, orbitPast } = pastsOf(live, -moment[0], pastCycles * beat, beat);
  const roll = odometer.distanceAt(time);
  const trackFrom = Math.max(earliest, odometer.timeAt(roll - trackLength));
  const tracked = (/** @type {LiveRun} */ run, /** @type {number} */ shift) => {
    // A distance turned back into a time may come out a rounding later than now.
    const from = Math.min(run.time, Math.max(run.range[0], trackFrom - shift));
    const track = run.history(from, run.time, 120);
    return { ...track, distance: track.time.map((at) => odometer.distanceAt(at + shift)) };
  };
  const span = spanFor(ahead, time, live.range, duration);
  const stretch = Math.max((span.to - span.from) / stretches, roundStep(beat));
  const model = { model: object, parameters };
  return {
    object, time, state, parameters,
    start: live.initial,
    /** Of a gear that lands its values as they were set; `parameters` are those of the gear as it is now. @type {Readonly<Record<string, number>> | null} */
    landing: lands(live.object) ? live.parameters : null,
    // Another object once another run was begun.
    begun: /** @type {object} */ (live),
    forces: engine.forces(model, state),
    past, orbitPast,
    track: tracked(live, 0),
    future: isHeld ? endOf(past, time) : engine.simulate({ ...onward(live), duration: moment[1], samples: 60, rtol: 1e-6 }),
    run: { ...span, past: pastEnvelope.upTo(live, span.from, stretch), future: ahead },
    extremes: extremes(past, time - beat),
    trail: [3, 2, 1].map((twelfths) => poseAt(past, time - (twelfths * beat) / 12)).filter((pose) => pose !== null),
    exposed: exposure > 0 ? endOf(orbitPast, since(exposure)) : null,
    fan: exposure > 0 ? fanOf(live.history(since(exposure), time, poses)) : null,
    ghosts: ghosts.all.map(({ live: run, outlook: goal, energy: exchanged, kept }) => {
      const pasts = pastsOf(run, -moment[0], ghostCycles * beat, beat);
      return {
        kept, state: run.state, parameters: run.present.parameters, outlook: goal, energy: exchanged,
        past: shifted(pasts.past, kept.from), orbitPast: pasts.orbitPast, track: tracked(run, kept.from),
        exposed: exposure > 0 ? endOf(pasts.orbitPast, run.time - exposure) : null,
      };
    }),
    roll, outlook, scales, energy, frequency, exposure,
    ...looksFurther(engine, live, beat),
  };
}

/**
 * The past that the timeline shows and the one that the trail does. Where they are alike in length they are two ends of
 * one: the engine computes what was anew, each time.
 * @param {LiveRun} run @param {number} shown in s @param {number} trailing in s @param {number} beat in s
 */
function pastsOf(run, shown, trailing, beat) {
  const { time, range } = run;
  const since = (/** @type {number} */ span) => Math.max(range[0], time - span);
  const longest = Math.max(shown, trailing);
  if (longest > mostCycles * beat) {
    return { past: run.history(since(shown), time, pastSamples), orbitPast: run.history(since(trailing), time, Math.ceil(trailing / beat) * samplesPerCycle) };
  }
  const from = since(longest);
  const all = run.history(from, time, Math.max(2, Math.ceil(((time - from) / beat) * samplesPerCycle)));
  return { past: endOf(all, since(shown)), orbitPast: endOf(all, since(trailing)) };
}

/** What of a history is at a time or later, and one sample before it. @param {import('../engine/engine.js').Columns} columns @param {number} from in s */
function endOf(columns, from) {
  const { time, torsionAngle, torsionRate, lateralDeformation } = columns;
  let at = 0;
  while (at + 2 < time.length && time[at + 1] <= from) at++;
  const end = (/** @type {Float64Array} */ series) => series.subarray(at);
  return { time: end(time), torsionAngle: end(torsionAngle), torsionRate: end(torsionRate), lateralDeformation: end(lateralDeformation) };
}

/**
 * What only some lenses look at: computed when one asks, within the frame of the scene.
 * @param {Engine} engine @param {LiveRun} live @param {number} beat in s
 */
function looksFurther(engine, live, beat) {
  const { time } = live;
  const { object, parameters } = live.present;
  const model = { model: object, parameters };
  const [earliest] = live.range;
  const cycles = Math.min(spectrumCycles, Math.floor((time - earliest) / beat));
  return {
    /** The force laws as curves. @param {import('../engine/engine.js').Curves} curves */
    laws: (curves) => engine.forceLaws(model, curves),
    /** Least and largest slip and torsion angle of the last cycle; null where there is none yet. */
    lastCycle: () => {
      if (time - beat < earliest) return null;
      const cycle = live.history(time - beat, time, samplesPerCycle);
      const { slipAngle } = engine.forcesAlong(model, cycle);
      return { slipAngle: rangeOf(slipAngle), torsionAngle: rangeOf(cycle.torsionAngle) };
    },
    /** How far back the spectrum looks, in s; 0 just after the start. */
    spectrumSpan: cycles < fewestCycles ? 0 : cycles * beat,
    /** Amplitudes of ψ by frequency, over the last cycles; null just after the start. */
    spectrum: () => {
      if (cycles < fewestCycles) return null;
      const samples = cycles * samplesPerCycle;
      const { torsionAngle } = live.history(time - cycles * beat, time, samples + 1);
      return engine.spectrum({ values: torsionAngle, interval: beat / samplesPerCycle });
    },
    /** The forces along a part of a run or of a ghost. @param {string} of @param {Readonly<Record<string, number>>} values @param {import('../engine/engine.js').Columns} states */
    forcesAlong: (of, values, states) => engine.forcesAlong({ model: of, parameters: values }, states),
    /** What linear theory says of the gear as it is. */
    linear: linearLooks(engine, model, () => live.recipe.initial),
    /** What is known of its motions that repeat. */
    cycles: cycleLooks(engine, model, () => live.stateByName),
    /** What is known of dampers by themselves. */
    dampers: damperLooks(engine),
    /** What goes in and out in a cycle of the motion that a run or a ghost goes to; null where it goes to none. @param {string} of @param {Readonly<Record<string, number>>} values @param {Outlook} goal */
    energySettled: (of, values, { orbit, frequency }) => {
      if (!frequency || orbit.time.length === 0) return null;
      const initial = { torsionAngle: orbit.torsionAngle[0], torsionRate: orbit.torsionRate[0], lateralDeformation: orbit.lateralDeformation[0] };
      return engine.energy({ model: of, parameters: values, initial, duration: 1 / frequency, maxSteps: stepsAhead });
    },
    /** The forces of a ghost at its state. @param {{ kept: { object: string }, parameters: Readonly<Record<string, number>>, state: Float64Array }} ghost */
    forcesOf: (ghost) => engine.forces({ model: ghost.kept.object, parameters: ghost.parameters }, ghost.state),
  };
}

/** @param {Float64Array} values @returns {[number, number]} */
function rangeOf(values) {
  return [values.reduce((least, value) => Math.min(least, value), Infinity), values.reduce((most, value) => Math.max(most, value), -Infinity)];
}

/** @template {{ time: Float64Array }} Columns @param {Columns} columns @param {number} later in s @returns {Columns} */
function shifted(columns, later) {
  return { ...columns, time: columns.time.map((at) => at + later) };
}

/** @param {{ torsionAngle: Float64Array, lateralDeformation: Float64Array }} history */
function fanOf({ torsionAngle, lateralDeformation }) {
  return Array.from(torsionAngle, (psi, i) => ({ psi, y: lateralDeformation[i] }));
}

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
