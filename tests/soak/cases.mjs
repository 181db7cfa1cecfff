// One hostile case after the other: a seed and a number bring each of them back.

import { garbage, NUMBERS, shown } from './garbage.mjs';
import { Defect, judged, judgeTrajectory, must } from './judge.mjs';
import { randomFrom, seedOf } from './random.mjs';
import { hostileRun, shortRun } from './runs.mjs';
import { play } from './session.mjs';

/** @typedef {import('../../www/pkg/shimmy.js').UnfinishedMap} UnfinishedMap */
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
  const name = random.chance(0.7) ? 'simulate' : random.pick(/** @type {const} */ ([
    'outlook', 'energy', 'routhHurwitz', 'linkedParameters', 'forceLaws', 'equilibrium', 'jacobian', 'eigenvalues',
    'characteristicPolynomial', 'routhArray', 'eigenmodes',
  ]));
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

/**
 * What is asked beside a run: of a good one or a bad one, in good words or bad ones.
 * @param {Shimmy} shimmy @param {Random} random @param {Model[]} models
 */
function helpers(shimmy, random, models) {
  const run = /** @type {any} */ (random.chance(0.7) ? shortRun(random, models) : hostileRun(random, models).run);
  const question = /** @type {any} */ (random.pick(QUESTIONS)(random, random.pick(models)));
  const name = /** @type {'forces'} */ (question.name);
  const asked = random.chance(0.5) ? question.asked : spoiled(random, question.asked);
  const what = `${name}(${shown(run)}, ${shown(asked)})`;
  if (ALONE.includes(/** @type {string} */ (name))) judged(what, () => shimmy[/** @type {'spectrum'} */ (/** @type {string} */ (name))](asked));
  else if (name === /** @type {string} */ ('Job')) judged(what, () => worked(shimmy, 'parameter' in question.asked ? 'bifurcation' : 'stabilityMap', asked, random));
  else if (name === /** @type {string} */ ('identification')) judged(what, () => searched(shimmy, asked));
  else judged(what, () => shimmy[name](run, asked));
  judged('models', () => shimmy.models());
  judged('methods', () => shimmy.methods());
  if (random.chance(0.02)) must('the atlas has changed', shimmy.atlas().length === 283);
}

/** Functions that take no run. */
const ALONE = ['spectrum', 'stabilityMap', 'hopfCurve', 'bifurcation', 'foldCurve', 'basins', 'sweep', 'damperResponse', 'damperRecord'];

/** A job, made in slices, with what it had half-way. @param {Shimmy} shimmy @param {'bifurcation' | 'stabilityMap'} kind @param {any} asked @param {Random} random */
function worked(shimmy, kind, asked, random) {
  const job = new shimmy.Job(kind, asked);
  try {
    job.advance(0);
    const early = /** @type {any} */ (job.result());
    if (random.chance(0.2)) judged('advance', () => job.advance(/** @type {any} */ (garbage(random).value)));
    while (!job.advance(1).done);
    const late = /** @type {any} */ (job.result());
    if (kind === 'bifurcation') must('rest has shrunk', early.equilibria.stable.length <= late.equilibria.stable.length);
    else must('a map has shrunk', early.stable.length <= late.stable.length);
    return late;
  } finally {
    job.free();
  }
}

const DAMPERS = ['bouc-wen', 'modified-bouc-wen', 'modified-bouc-wen-cubic', 'current-dependent-bouc-wen'];

/** A damper on a moving piston. @param {Random} random */
function piston(random) {
  const size = () => (random.chance(0.9) ? 10 ** random.between(-4, 1) : random.pick(NUMBERS));
  const parameters = random.chance(0.3) ? { [random.pick(['gamma', 'beta', 'exponent', 'amplitude'])]: random.chance(0.5) ? 1 + random.below(5) : random.pick(NUMBERS) } : null;
  const damper = { model: random.pick(DAMPERS), command: random.chance(0.5) ? random.between(0.1, 2) : null, parameters };
  const excitation = { amplitude: size(), frequency: size(), shape: random.pick(['sine', 'triangle', null]), endAmplitude: random.chance(0.5) ? size() : null };
  return { damper, excitation, cycles: random.between(0.1, 3), samples: 8 + random.below(30) };
}

/** A search to its end, what it has half-way, and what it knows then. @param {Shimmy} shimmy @param {any} asked */
function searched(shimmy, asked) {
  const search = new shimmy.Identification(asked);
  try {
    search.tell(shimmy.fitness(asked, search.ask()));
    search.result();
    while (!search.done) search.step();
    return search.result();
  } finally {
    search.free();
  }
}

/** A small plane of two parameters. @param {Random} random @param {Model} model @param {boolean} counted */
function plane(random, model, counted) {
  const axis = () => {
    const { name, min, max } = random.pick(model.parameters);
    const range = { parameter: name, from: random.chance(0.9) ? min : random.pick(NUMBERS), to: random.chance(0.9) ? max : random.pick(NUMBERS) };
    return counted ? { ...range, count: 1 + random.below(40) } : range;
  };
  const spec = { model: model.name, x: axis(), y: axis(), linked: { relaxationLength: random.chance(0.5) } };
  if (!counted) return spec;
  const quantities = ['stable', 'growthRate', 'frequency', 'kind'].filter(() => random.chance(0.5));
  return { ...spec, quantities, tile: random.chance(0.2) ? { column: random.below(10), rows: 1 + random.below(10) } : null };
}

/** A short diagram over a parameter. @param {Random} random @param {Model} model */
function diagram(random, model) {
  const { name, min, max } = random.pick(model.parameters);
  const parameters = Object.fromEntries(model.parameters.filter(() => random.chance(0.3)).map(({ name, min, max }) => [name, random.between(min, max)]));
  const state = Object.fromEntries(model.state.map(({ name, scale }) => [name, random.between(-3, 3) * scale]));
  const cycle = random.chance(0.3) ? { period: random.between(0.005, 0.2), state, value: random.between(min, max) } : null;
  const to = random.chance(0.9) ? max : random.pick(NUMBERS);
  return { model: model.name, parameters, parameter: name, from: min, to, cycle, points: 2 + random.below(20), probes: random.below(2) };
}

/** Parameters of a gear, most of them its defaults. @param {Random} random @param {Model} model */
const someParameters = (random, model) => Object.fromEntries(model.parameters.filter(() => random.chance(0.3)).map(({ name, min, max }) => [name, random.between(min, max)]));

/** A range of a parameter or a state, of a few cells. @param {Random} random @param {Model} model @param {boolean} states */
function fewCells(random, model, states) {
  const { name, min, max } = states ? { min: -1, max: 1, ...random.pick(model.state) } : random.pick(model.parameters);
  return { [states ? 'state' : 'parameter']: name, from: random.chance(0.9) ? min : random.pick(NUMBERS), to: random.chance(0.9) ? max : random.pick(NUMBERS), count: 1 + random.below(4) };
}

/** Basins of a few cells, soon over. @param {Random} random @param {Model} model */
const basins = (random, model) => ({
  model: model.name,
  parameters: someParameters(random, model),
  x: fewCells(random, model, random.chance(0.5)),
  y: fewCells(random, model, random.chance(0.5)),
  refine: random.chance(0.5),
  duration: random.between(0.001, 0.3),
});

/** A sweep over a few values, soon over. @param {Random} random @param {Model} model */
const sweep = (random, model) => ({
  model: model.name,
  parameters: someParameters(random, model),
  over: random.chance(0.5) ? fewCells(random, model, false) : { x: fewCells(random, model, false), y: fewCells(random, model, false) },
  measure: random.chance(0.5) ? random.pick(model.state).name : null,
  duration: random.between(0.001, 0.3),
});

/** @type {((random: Random, model: Model) => { name: string, asked: unknown })[]} */
const QUESTIONS = [
  (random) => {
    const asked = piston(random);
    return random.chance(0.5) ? { name: 'damperResponse', asked } : { name: 'damperRecord', asked: { ...asked, noise: random.between(0, 0.2), seed: random.below(9) } };
  },
  (random) => {
    const values = (/** @type {number} */ size) => Float64Array.from({ length: 40 }, () => random.between(-size, size));
    const record = { displacement: values(0.05), velocity: random.chance(0.5) ? values(1) : null, force: values(2000), interval: random.between(1e-4, 0.1) };
    const bounds = random.chance(0.3) ? { gamma: [1e5, 1e6], beta: [random.between(-1e5, 1e6), 2e6] } : null;
    const records = random.chance(0.9) ? [record, { ...record, command: random.between(0.1, 2) }] : random.pick([[], [[]], [record, 1], record]);
    return { name: 'identification', asked: { model: random.pick(DAMPERS), records, bounds, population: 8, generations: 4, seed: random.below(9) } };
  },
  (random, { state }) => ({ name: 'forces', asked: state.map(({ scale }) => (random.chance(0.8) ? random.between(-3, 3) * scale : random.pick(NUMBERS))) }),
  (random, { state }) => ({
    name: 'forcesAlong',
    asked: Object.fromEntries(state.map(({ name, scale }) => [name, Float64Array.from({ length: 9 }, () => random.between(-3, 3) * scale)])),
  }),
  (random, { parameters }) => {
    const { name, min, max } = random.pick(parameters);
    const linked = { relaxationLength: random.chance(0.5), treadWidthMomentConstant: random.chance(0.5) };
    return { name: random.pick(['unstableIntervals', 'crossings']), asked: { parameter: name, from: min, to: random.chance(0.9) ? max : random.pick(NUMBERS), linked } };
  },
  (random) => ({ name: 'forceLaws', asked: { slipAngle: random.between(0.01, 1.6), torsionAngle: random.between(0.01, 1), samples: 2 + random.below(50) } }),
  (random, model) => ({ name: 'stabilityMap', asked: plane(random, model, true) }),
  (random, model) => ({ name: 'Job', asked: plane(random, model, true) }),
  (random, model) => ({ name: 'hopfCurve', asked: plane(random, model, false) }),
  (random, model) => ({ name: random.pick(['bifurcation', 'bifurcation', 'Job']), asked: diagram(random, model) }),
  (random, model) => {
    // Folds of a plane take two diagrams at least, and those of any gear seconds where motions are stiff: one in a few.
    const { linked, ...spec } = /** @type {any} */ (plane(random, model, false));
    return random.chance(0.1) ? { name: 'foldCurve', asked: { ...spec, linked, seeds: 1 } } : { name: 'bifurcation', asked: diagram(random, model) };
  },
  (random, model) => (random.chance(0.5) ? { name: 'basins', asked: basins(random, model) } : { name: 'sweep', asked: sweep(random, model) }),
  (random, { state }) => ({
    name: 'poincare',
    asked: { state: random.pick(state).name, level: random.chance(0.5) ? 0 : random.between(-0.1, 0.1), rising: random.chance(0.5), after: random.chance(0.5) ? 0 : random.pick(NUMBERS) },
  }),
  (random) => ({
    name: 'spectrum',
    asked: { values: Float64Array.from({ length: random.below(300) }, () => random.between(-1, 1)), interval: 10 ** random.between(-6, 2) },
  }),
];

/** The same with something else in one place, or something else altogether. @param {Random} random @param {unknown} asked */
function spoiled(random, asked) {
  const { value } = garbage(random);
  if (random.chance(0.3)) return value;
  const copy = /** @type {Record<string, unknown>} */ (Array.isArray(asked) ? [...asked] : { .../** @type {object} */ (asked) });
  const key = random.chance(0.9) ? random.pick(Object.keys(copy)) : 'more';
  Object.defineProperty(copy, key, { value, enumerable: true, configurable: true, writable: true });
  return copy;
}
