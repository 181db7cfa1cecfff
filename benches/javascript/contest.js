// The rule of the contest: the loosest tolerance of the ladder at which a solver meets both errors, and its time there.
// Runs in Node and in a page alike.

/**
 * What a solver brings back: the states at the times of the case.
 * @typedef {{ states: ArrayLike<number>[], steps?: number, evaluations?: number }} Outcome
 */

/** The shortest of the runs that fit into this time is reported: other work on the machine only ever lengthens a run. */
const WATCHED = 300;

/**
 * At each time the largest difference of the three states, relative to their amplitudes on the cycle.
 * @param {import('./case.js').Case} theCase
 * @param {ArrayLike<number>[]} states
 */
export const errorsOf = (theCase, states) =>
  theCase.reference.map((truth, time) =>
    Math.max(...truth.map((value, state) => Math.abs(states[time][state] - value) / theCase.amplitude[state])));

/**
 * Milliseconds of the first run, and of the shortest.
 * @param {() => unknown} run
 * @param {number} [watched] how long it is repeated, in milliseconds
 */
export function shortest(run, watched = WATCHED) {
  const start = performance.now();
  run();
  const first = performance.now() - start;
  let least = first;
  while (performance.now() - start < watched) {
    const before = performance.now();
    run();
    least = Math.min(least, performance.now() - before);
  }
  return { first, least };
}

/**
 * Takes one solver up the ladder of tolerances and tells how it did.
 * @param {import('./case.js').Case} theCase
 * @param {string} name
 * @param {(tolerance: number) => Outcome} solve throws where it gives up
 */
export function enter(theCase, name, solve) {
  let best;
  for (const tolerance of theCase.tolerances) {
    let outcome;
    try {
      outcome = solve(tolerance);
    } catch {
      continue;
    }
    const errors = errorsOf(theCase, outcome.states);
    const met = errors.every((error, time) => error <= theCase.allowed[time]);
    if (met || !best || errors[1] < best.errors[1]) best = { tolerance, outcome, errors, met };
    if (met) break;
  }
  if (!best) return { solver: name, gaveUp: true };
  const { tolerance, outcome, errors, met } = best;
  const { least } = shortest(() => solve(tolerance));
  return {
    solver: name, tolerance, met, errors, milliseconds: least,
    steps: outcome.steps ?? null, evaluations: outcome.evaluations ?? null,
  };
}
