/**
 * What became of a swing, against what was guessed.
 *
 * The rule, for a swing that is `now` wide and goes to another: it *dies out* where it comes to rest; it *grows* where it
 * becomes more than a tenth wider, or leaves the model; it *holds* where it lasts otherwise, as wide as now or smaller.
 *
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {import('../store.js').Guess} Guess
 * @typedef {{ truth: Guess, becomes: 'dies-out' | 'rests' | 'holds' | 'falls' | 'grows' | 'beyond', amplitude: number }} Outcome
 *   `truth`: which guess was right; `becomes`: how it came so; `amplitude`: of the swing it goes to, in rad
 */

/** The guesses in the order of their keys 1, 2, 3. @type {readonly Guess[]} */
export const guesses = ['dies-out', 'holds', 'grows'];

/** A swing that comes within this share of what it was holds. */
const tolerance = 0.1;

/**
 * @param {Pick<Outlook, 'verdict' | 'amplitude'>} outlook
 * @param {number} now how wide it swings, in rad
 * @returns {Outcome}
 */
export function outcomeOf({ verdict, amplitude }, now) {
  if (verdict === 'dies-out' || verdict === 'rests') return { truth: 'dies-out', becomes: verdict, amplitude: 0 };
  const goal = amplitude.torsionAngle;
  if (verdict === 'grows') return { truth: 'grows', becomes: 'beyond', amplitude: goal };
  if (goal > (1 + tolerance) * now) return { truth: 'grows', becomes: 'grows', amplitude: goal };
  return { truth: 'holds', becomes: goal < (1 - tolerance) * now ? 'falls' : 'holds', amplitude: goal };
}
