// One hostile case after the other: a seed and a number bring each of them back.

import { garbage, NUMBERS, shown } from './garbage.mjs';
import { Defect, judged, judgeTrajectory, must } from './judge.mjs';
import { randomFrom, seedOf } from './random.mjs';
import { hostileRun, shortRun } from './runs.mjs';
import { play } from './session.mjs';

/** @typedef {import('./random.mjs').Random} Random */
/** @typedef {import('./runs.mjs').Model} Model */
/** @typedef {typeof import('../../www/pkg/shimmy.js')} Shimmy */

/**
 * @param {Shimmy} shimmy
 * @param {number} seed
 * @param {number} index
 */
export function playCase(shimmy, seed, index) {
  const random = randomFrom(seedOf(seed, index));
  const models = /** @type {Model[]} */ (/** @type {unknown} */ (shimmy.models()));
  const kind = random.fraction();
  if (kind < 0.1) rightRun(shimmy, random, models);
  else if (kind < 0.65) wrongRun(shimmy, random, models);
  else if (kind < 0.9) play(shimmy, random, models);
  else helpers(shimmy, random, models);
}

/** A run with nothing wrong succeeds, or says what ended it. @param {Shimmy} shimmy @param {Random} random @param {Model[]} models */
function rightRun(shimmy, random, models) {
  const run = shortRun(random, models);
  const what = `simulate(${JSON.stringify(run)})`;
  const answer = judged(what, () => shimmy.simulate(/** @type {any} */ (run)), (error) => {
    const code = /** @type {any} */ (error).code;
    if (!['step-limit', 'unsuited', 'diverged', 'step-too-small'].includes(code)) throw new Defect(`${what} was refused: ${error.message}`);
    return false;
  });
  if (answer) judgeTrajectory(what, answer);
}

/** @param {Shimmy} shimmy @param {Random} random @param {Model[]} models */
function wrongRun(shimmy, random, models) {
  const { run, wrong } = hostileRun(random, models);
  const name = random.chance(0.85) ? 'simulate' : 'outlook';
  const what = `${name}, wrong: ${wrong.join('; ')}`;
  const answer = judged(what, () => shimmy[name](/** @type {any} */ (run)));
  if (answer && name === 'simulate') judgeTrajectory(what, answer);
  if (random.chance(0.2)) stillRight(shimmy);
}

/** After whatever came before, a plain run gives what it always gave. @param {Shimmy} shimmy */
function stillRight(shimmy) {
  const { torsionAngle } = /** @type {any} */ (
    shimmy.simulate(/** @type {any} */ ({ model: 'torsional', initial: { torsionAngle: 0.01 }, times: [0.01] })));
  must(`a plain run now gives ${torsionAngle[0]}`, Math.abs(torsionAngle[0] - PLAIN) < 1e-9);
}

/** The torsion angle of the plain run, by benches/reference.py. */
const PLAIN = -0.01066946083992453;

/** @param {Shimmy} shimmy @param {Random} random @param {Model[]} models */
function helpers(shimmy, random, models) {
  const model = random.pick(models);
  /** @type {Record<string, unknown>} */
  const parameters = {};
  for (const { name, min, max } of model.parameters) if (random.chance(0.5)) parameters[name] = random.between(min, max);
  const { name, value } = garbage(random);
  const key = random.pick(['velocity', 'halfContactLength', 'sideForceDerivative', 'velocty']);
  const spoiled = random.chance(0.5) ? { ...parameters, [key]: value } : value;
  const what = `with ${key} or all of it ${name}, ${shown(value)}`;
  judged(`linkedParameters ${what}`, () => shimmy.linkedParameters(/** @type {any} */ (spoiled)));
  const state = random.chance(0.5) ? [random.pick(NUMBERS), 0, 0] : garbage(random).value;
  judged(`forces ${what}, state ${shown(state)}`, () => shimmy.forces(/** @type {any} */ (spoiled), /** @type {any} */ (state)));
  judged('models', () => shimmy.models());
  judged('methods', () => shimmy.methods());
}
