/**
 * How large things are drawn: chosen when a run begins and where a change makes them useless, held in between, so that a
 * picture never jumps while a hand is on it.
 *
 * @typedef {import('../engine/engine.js').Engine} Engine
 * @typedef {import('./fit.js').Swing} Swing
 * @typedef {import('./live-run.js').LiveRun} LiveRun
 * @typedef {import('./lookout.js').Lookout} Lookout
 * @typedef {{ magnification: number, limits: Swing, forces: { force: number, moment: number } }} Scales of the wheel, of the
 *   axes (in rad, rad/s, m), and of the largest force and moment (in N, N m)
 */

import { roundLimit } from '../view/scale.js';
import { limitsFor, magnificationFor, magnifications, stillFits } from './fit.js';
import { onward, stepsAhead } from './lookout.js';

/** Drawn beyond this, a wheel tells nothing: then alone a run under way is magnified less than at its start. */
const widestDrawn = (60 * Math.PI) / 180;
/** Scales reach no further ahead than this, far beyond what the model is trusted for. */
const widestAhead = 1;
/** A trail shows so many cycles. */
const trailCycles = 8;
/** A swing smaller than this is none, in rad. */
const least = 1e-9;

/** Of a wheel at rest. @type {Scales} */
export const leastScales = { magnification: 1, limits: limitsFor({ angle: 0, rate: 0, deformation: 0 }), forces: { force: 1, moment: 1 } };

/**
 * Magnification, axes and force scale for the motion as it is and will be.
 * @param {Engine} engine @param {LiveRun} live @param {Lookout} lookout @param {string | undefined} chosen the magnification by hand
 * @returns {Scales}
 */
export function fitted(engine, live, lookout, chosen) {
  const swing = swingOf(live, lookout);
  return { magnification: magnificationOf(swing.angle, chosen), limits: limitsFor(swing), forces: forceScale(engine, live, lookout) };
}

/**
 * The same for a run that may be begun again in its midst, as from an address: the wheel is drawn as large as it was when the
 * run began, or the same swing would look another one after a reload.
 * @param {Engine} engine @param {LiveRun} live @param {Lookout} lookout @param {string | undefined} chosen the magnification by hand
 * @returns {Scales}
 */
export function fittedAsBegun(engine, live, lookout, chosen) {
  const now = fitted(engine, live, lookout, chosen);
  if (live.time === 0) return now;
  const { low, high } = live.envelope(live.range[0], live.time, 1);
  const seen = Math.max(high[0], -low[0], swingOf(live, lookout).angle);
  const begun = { ...now, magnification: magnificationOf(lookout.isVeiled ? seen : startSwing(engine, live) ?? seen, chosen) };
  return isTooWide(begun, seen, chosen) ? { ...begun, magnification: magnificationOf(seen, chosen) } : begun;
}

/** The largest ψ that was ahead when a run began; null where the engine can not look ahead from there. @param {Engine} engine @param {LiveRun} live */
function startSwing(engine, { object: model, recipe: { parameters, initial } }) {
  try {
    return Math.max(Math.abs(initial.torsionAngle ?? 0), widestAheadOf(engine.outlook({ model, parameters, initial, maxSteps: stepsAhead })));
  } catch {
    return null;
  }
}

/**
 * New axes and force scale where those in force no longer serve. The magnification stays as the run began.
 * @param {Scales} scales @param {Engine} engine @param {LiveRun} live @param {Lookout} lookout
 * @returns {Scales}
 */
export function refitted(scales, engine, live, lookout) {
  const { magnification, limits } = scales;
  const swing = swingOf(live, lookout);
  // A wheel at rest has no swing to fit to, and a trail that is still seen must not be cut.
  const isStill = swing.angle < least;
  const serves = stillFits(limits, swing);
  const trailed = { ...swing, angle: Math.max(swing.angle, trailOf(live, lookout)) };
  if (isStill || (stillFits(limits, trailed) && !serves)) return scales;
  const anew = fitted(engine, live, lookout, undefined);
  return { ...anew, magnification, limits: serves ? limits : anew.limits };
}

/** Whether a wheel would be drawn so wide that it tells nothing, and could be drawn narrower. @param {Scales} scales @param {number} angle in rad @param {string | undefined} chosen */
export function isTooWide({ magnification }, angle, chosen) {
  return angle * magnification > widestDrawn && magnificationOf(angle, chosen) < magnification;
}

/** As a hand chose, else the one that fits a swing. @param {number} angle in rad @param {string | undefined} chosen */
export function magnificationOf(angle, chosen) {
  const factor = Number(chosen);
  return magnifications.includes(factor) ? factor : magnificationFor(angle);
}

/**
 * The largest ψ, ψ̇ and y of the motion now and to come.
 * @param {LiveRun} live @param {Lookout} lookout
 * @returns {Swing}
 */
export function swingOf(live, { outlook, frequency }) {
  const { amplitude } = outlook;
  const [angle, rate, deformation] = live.state.map(Math.abs);
  const widest = Math.max(angle, widestAheadOf(outlook));
  const share = amplitude.torsionAngle > 0 ? amplitude.lateralDeformation / amplitude.torsionAngle : 0.2;
  return {
    angle: widest,
    rate: Math.max(rate, 2 * Math.PI * (frequency ?? 0) * widest, most(outlook.orbit.torsionRate)),
    deformation: Math.max(deformation, share * widest, most(outlook.orbit.lateralDeformation)),
  };
}

/** @param {Float64Array} series */
function most(series) {
  return series.reduce((largest, value) => Math.max(largest, Math.abs(value)), 0);
}

/** The largest ψ to come, in rad. @param {import('../engine/engine.js').Outlook} outlook */
function widestAheadOf({ amplitude, present, envelope }) {
  let ahead = Math.max(present.amplitude, amplitude.torsionAngle);
  for (let i = 0; i < envelope.time.length; i++) ahead = Math.max(ahead, envelope.high[i], -envelope.low[i]);
  return Math.min(ahead, widestAhead);
}

/** The largest ψ of the trail, in rad. @param {LiveRun} live @param {Lookout} lookout */
function trailOf(live, { frequency }) {
  const { time, range } = live;
  const from = Math.max(range[0], time - trailCycles / (frequency ?? 50));
  if (!(time > from)) return 0;
  const { low, high } = live.envelope(from, time, 1);
  return Math.max(high[0], -low[0]);
}

/**
 * Round numbers above the largest force and moment of the motion now and to come.
 * @param {Engine} engine @param {LiveRun} live @param {Lookout} lookout
 */
function forceScale(engine, live, { outlook, frequency }) {
  const run = onward(live);
  const cycle = engine.simulate({ ...run, duration: 1 / (frequency ?? 50), samples: 60, rtol: 1e-6 });
  let force = 1;
  let moment = 1;
  for (const motion of [cycle, outlook.orbit]) {
    if (motion.time.length === 0) continue;
    const { sideForce, aligningMoment } = engine.forcesAlong(run, motion);
    force = sideForce.reduce((most, value) => Math.max(most, Math.abs(value)), force);
    moment = aligningMoment.reduce((most, value) => Math.max(most, Math.abs(value)), moment);
  }
  return { force: roundLimit(force), moment: roundLimit(moment) };
}
