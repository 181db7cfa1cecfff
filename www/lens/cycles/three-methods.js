/**
 * One number by three methods that have nothing in common: the amplitude and frequency of a gear's limit cycle by describing
 * functions, by shooting, and by simulation.
 *
 * @typedef {import('../../run/cycle-looks.js').CycleLooks} CycleLooks
 * @typedef {import('../../run/cycle-looks.js').LimitCycle} LimitCycle
 * @typedef {{ torsionAngle: number, lateralDeformation: number, frequency: number }} Found in rad, m, Hz
 * @typedef {{ describing: Found | null, shooting: Found | null, simulation: Found | null, cycle: LimitCycle | null }} Answer
 *   null where a method finds no cycle; `cycle`: the one that shooting found
 */

import { guessOf } from '../../run/cycle-looks.js';

/** A touch of the wheel, in rad. */
const touch = 0.01;
/** A start so much wider than the cycle falls onto it. */
const wider = 1.5;

/**
 * @param {CycleLooks} cycles
 * @param {Readonly<Record<string, number>>} values that are others
 * @param {LimitCycle | null} near a cycle of a gear that is much the same
 * @returns {Answer}
 */
export function threeMethods(cycles, values, near) {
  const steps = methodByMethod(cycles, values, near);
  for (let step = steps.next(); ; step = steps.next()) if (step.done) return step.value;
}

/**
 * The same method by method, so that no frame waits for all three.
 * @param {CycleLooks} cycles
 * @param {Readonly<Record<string, number>>} values
 * @param {LimitCycle | null} near
 * @returns {Generator<void, Answer, void>}
 */
export function* methodByMethod(cycles, values, near) {
  const guess = guessOf(near);
  const warm = guess && cycles.near(guess, values);
  const found = warm?.found ? warm : cycles.fromRest(values);
  const shooting = found.found ? numberOf(found.amplitude, found.frequency) : null;
  yield;
  const predicted = cycles.predicted(values);
  yield;
  // Of several that are predicted, the one that is nearest to what is there; else the largest that would be seen.
  const nearest = shooting
    ? predicted.reduce((best, one) => (distance(one, shooting) < distance(best, shooting) ? one : best), predicted[0])
    : predicted.findLast(({ stable }) => stable);
  return {
    describing: nearest ? numberOf(nearest.amplitude, nearest.frequency) : null,
    shooting, simulation: simulated(cycles, values, shooting), cycle: found.found ? found : null,
  };
}

/**
 * By how much a method is off, as a share of what shooting finds; null where one of them finds none.
 * @param {Found | null} number @param {Found | null} of @param {keyof Found} what
 */
export function offBy(number, of, what) {
  return number && of ? number[what] / of[what] - 1 : null;
}

/** From a touch; where that dies out although there is a cycle, from beyond it. @param {CycleLooks} cycles @param {Readonly<Record<string, number>>} values @param {Found | null} shooting */
function simulated(cycles, values, shooting) {
  const from = (/** @type {number} */ torsionAngle) => {
    const { verdict, amplitude, frequency } = cycles.outlook({ torsionAngle }, values);
    return verdict === 'shimmies' || verdict === 'rattles' ? numberOf(amplitude, frequency) : null;
  };
  return from(touch) ?? (shooting && from(wider * shooting.torsionAngle));
}

/** @param {Readonly<Record<string, number>>} amplitude @param {number | null} frequency @returns {Found} */
function numberOf({ torsionAngle, lateralDeformation }, frequency) {
  return { torsionAngle, lateralDeformation, frequency: frequency ?? NaN };
}

/** @param {{ amplitude: { torsionAngle: number } }} predicted @param {Found} number */
function distance({ amplitude }, { torsionAngle }) {
  return Math.abs(amplitude.torsionAngle - torsionAngle);
}
