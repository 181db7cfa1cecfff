/**
 * The numbers that a sentence of a story names, asked of the engine for the step that it belongs to. A sentence takes them
 * by name (`{swing}`); only those are computed. Boundaries are rounded to the safe side.
 *
 * @typedef {import('../engine/engine.js').Engine} Engine
 * @typedef {import('../engine/engine.js').Run} Run
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('./story.js').Step} Step
 */

import { modelsOf } from '../engine/models.js';
import { rollSpec } from '../lens/landing/ask.js';
import { gearOf } from '../lens/landing/gear.js';
import { shimmyOf, thresholdOf } from '../lens/landing/roll.js';
import { rollOf } from '../lens/landing/settings.js';
import { decimalsOf } from '../words/number.js';
import { objectOf, parametersOf } from './story.js';

const degrees = 180 / Math.PI;

/**
 * @param {Engine} engine
 * @param {Step} step
 * @param {Voice} voice
 * @returns {Record<string, string>}
 */
export function factsOf(engine, { state, asks }, voice) {
  const model = objectOf(state);
  const parameters = parametersOf(state, modelsOf(engine));
  const run = { model, parameters, initial: state.initial };
  const ghost = state.ghosts?.[0] ?? {};
  const plain = (/** @type {number} */ value) => voice.number(value, decimalsOf(value, 0));
  const angle = (/** @type {number} */ radians) => `${voice.number(radians * degrees, radians * degrees < 2 ? 2 : 1)}°`;
  const swing = (/** @type {Run} */ of) => `±${angle(engine.outlook(of).amplitude.torsionAngle)}`;
  const linear = (/** @type {Record<string, number>} */ others) => engine.routhHurwitz({ model, parameters: { ...parameters, ...others } });
  const casters = () => engine.unstableIntervals({ model, parameters }, { parameter: 'casterLength', from: -0.5, to: 0.5 });
  const roll = () => rollOf(state.views?.landingRoll ?? '');
  /** @type {ReturnType<typeof shimmyOf> | null} */
  let shimmy = null;
  const landed = () => shimmy ??= shimmyOf(engine.landingRoll(rollSpec(gearOf({ object: model, parameters }), roll())), thresholdOf(parameters));
  /** @type {Record<string, number>} */
  const noGap = 'freeplayAngle' in parameters ? { freeplayAngle: 0 } : {};
  return {
    get v() { return plain(parameters.velocity); },
    get c() { return plain(parameters.dampingConstant); },
    get friction() { return plain(parameters['friction.moment']); },
    get e() { return plain(parameters.casterLength); },
    get ahead() { return plain(-parameters.casterLength); },
    get gap() { return `±${plain(Number((parameters.freeplayAngle * degrees).toPrecision(12)))}°`; },
    get slip() { return `${plain(Number((parameters.sideForceLimitAngle * degrees).toPrecision(12)))}°`; },
    get start() { return angle(state.initial.torsionAngle ?? 0); },
    get asked() { return plain(Object.values(asks ?? {})[0]); },
    get swing() { return swing(run); },
    get rest() { return angle(engine.outlook(run).amplitude.torsionAngle); },
    get beat() { return `${voice.number(engine.outlook(run).frequency ?? NaN, 1)} Hz`; },
    get ghostSwing() { return swing({ model, parameters: { ...parameters, ...ghost.parameters }, initial: { ...state.initial, ...ghost.initial } }); },
    /** The speed up to which it is calm. */
    get vBoundary() { return down(linear(noGap).criticalVelocities[0], 1, voice); },
    /** The damping above which it is calm, as linear theory without the gap has it. */
    get cBoundary() { return up(linear(noGap).criticalDamping ?? NaN, 1, voice); },
    /** The speed above which it is calm inside the gap. */
    get vGap() { return up(linear({}).criticalVelocities.at(-1) ?? NaN, 1, voice); },
    /** The lowest speed at which the gear shimmies in linear theory with the gap. */
    get vGapFrom() { return down(linear({}).criticalVelocities[0] ?? NaN, 1, voice); },
    /** How much larger than half of the gap the rattle is. */
    get perGap() { return voice.number(engine.outlook(run).amplitude.torsionAngle / parameters.freeplayAngle, 2); },
    /** The lowest speed to which a branch of cycles folds back. */
    get vFold() {
      const { points } = engine.bifurcation({ model, parameters, parameter: 'velocity', from: 1, to: 120 });
      return down(Math.min(...points.filter(({ kind }) => kind === 'fold').map((point) => point.velocity)), 1, voice);
    },
    /** The dry friction beyond which no cycle is left. */
    get frictionFold() {
      const { points } = engine.bifurcation({ model, parameters, parameter: 'friction.moment', from: 0, to: 2000 });
      return up(Math.max(...points.filter(({ kind }) => kind === 'fold').map((point) => point['friction.moment'])), 0, voice);
    },
    /** Of a landing: its speeds at touchdown, when it begins and ends to shimmy, and its widest swing. */
    get vTouchdown() { return plain(roll().touchdownVelocity); },
    get braking() { return plain(roll().deceleration); },
    get vBegins() { return voice.number(landed().begins?.velocity ?? NaN, 1); },
    get vEnds() { return voice.number(landed().ends?.velocity ?? NaN, 1); },
    get widest() { return `±${angle(landed().widest.angle)}`; },
    get current() { return plain(parameters['damper.command']); },
    get eUpper() { return up(casters()[0]?.to ?? NaN, 3, voice); },
    get eLower() { return down(casters()[0]?.from ?? NaN, 3, voice); },
  };
}

/** @param {number} value @param {number} decimals @param {Voice} voice */
function up(value, decimals, voice) {
  return voice.number(-safe(-value, decimals), decimals);
}

/** @param {number} value @param {number} decimals @param {Voice} voice */
function down(value, decimals, voice) {
  return voice.number(safe(value, decimals), decimals);
}

/**
 * The nearest number of so many decimals that is not above `value`, but for a twentieth of its last digit.
 * @param {number} value @param {number} decimals
 */
function safe(value, decimals) {
  const scale = 10 ** decimals;
  return Math.floor(value * scale + 0.05) / scale;
}
