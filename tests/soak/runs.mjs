// Runs to throw at the module: short and right, or with something wrong in them.

import { garbage, shown } from './garbage.mjs';

/** @typedef {import('./random.mjs').Random} Random */
/** @typedef {Record<string, any>} Run */
/** @typedef {{ name: string, parameters: { name: string, min: number, max: number, default: number }[], state: { name: string, scale: number }[] }} Model */

/** However a run is damaged, it ends after this many steps. */
const STEPS = 2000;

/**
 * A run that must succeed, or end at its step limit.
 * @param {Random} random
 * @param {Model[]} models
 * @returns {Run}
 */
export function shortRun(random, models) {
  const model = random.pick(models);
  /** @type {Run} */
  const run = { model: model.name, duration: random.between(1e-4, 0.02), maxSteps: STEPS };
  if (random.chance(0.8)) {
    run.parameters = {};
    for (const { name, min, max } of model.parameters) {
      if (random.chance(0.5)) run.parameters[name] = inRange(random, min, max);
    }
  }
  if (random.chance(0.8)) {
    run.initial = {};
    for (const { name, scale } of model.state) {
      if (random.chance(0.6)) run.initial[name] = random.between(-2, 2) * scale;
    }
  }
  if (random.chance(0.6)) run.method = random.pick(['auto', 'dormand-prince', 'dop853', 'rk4', 'rodas']);
  if (random.chance(0.5)) run.rtol = 10 ** random.between(-12, -3);
  if (random.chance(0.3)) run.atol = 10 ** random.between(-14, -5);
  if (run.method === 'rk4' && random.chance(0.5)) run.step = 10 ** random.between(-5, -4);
  if (random.chance(0.3)) run.samples = 2 + random.below(200);
  else if (random.chance(0.4)) run.times = rising(random, run.duration);
  return run;
}

/** The ends of a range are as likely as what lies between. @param {Random} random @param {number} min @param {number} max */
function inRange(random, min, max) {
  if (random.chance(0.1)) return min;
  if (random.chance(0.1)) return max;
  return random.between(min, max);
}

/** @param {Random} random @param {number} duration */
function rising(random, duration) {
  const times = Array.from({ length: 1 + random.below(6) }, () => random.between(0, duration)).sort((a, b) => a - b);
  return random.chance(0.5) ? Float64Array.from(times) : times;
}

/** Keys of a run that a stranger may set: known, of later days, misspelt, and of the language itself. */
const KEYS = [
  'model', 'parameters', 'initial', 'duration', 'method', 'rtol', 'atol', 'step', 'times', 'samples', 'maxSteps', 'damper', 'tire',
  'friction', 'control', 'disturbance', 'modle', 'Duration', '__proto__', 'toString', '', 'length',
];

/** @type {((random: Random, run: Run, models: Model[]) => string)[]} */
const DAMAGES = [
  (random, run) => {
    const { name, value } = garbage(random);
    const key = random.pick(KEYS);
    // With the limit of steps and the length of the run both gone, a run may rightly take a minute.
    if (key === 'maxSteps') run.duration = 1e-4;
    if (key === 'samples' && typeof value === 'number' && value > 1e4 && value <= 1e7) return 'nothing';
    set(run, key, value);
    return `${key} is ${name}, ${shown(value)}`;
  },
  (random, run) => {
    const { name, value } = garbage(random);
    run.parameters = withOwn(run.parameters);
    const key = random.pick(['velocity', 'casterLength', 'relaxationLength', 'momentOfInertia', 'torsionalStiffness',
      'sideForceLimitAngle', 'aligningMomentLimitAngle', 'freeplayAngle', 'velocty', '__proto__', 'damper.command']);
    set(run.parameters, key, value);
    return `parameters.${key} is ${name}, ${shown(value)}`;
  },
  (random, run) => {
    const { name, value } = garbage(random);
    run.initial = withOwn(run.initial);
    const key = random.pick(['torsionAngle', 'torsionRate', 'lateralDeformation', 'hysteresis', 'torsionangle', '0']);
    set(run.initial, key, value);
    return `initial.${key} is ${name}, ${shown(value)}`;
  },
  (random, run) => {
    run.times = random.pick([[], [0], [1e-3, 1e-4], [NaN], [-1], [1e308], [1e-3, 1e-3], ['1e-3'], [[0]], new Float64Array(0),
      Float64Array.of(0, NaN), Float32Array.of(0, 1e-3), Array(3), { 0: 0, length: 1 }]);
    if (random.chance(0.3)) run.samples = 10;
    return `times are ${shown(run.times)}`;
  },
  (random, run) => {
    run.samples = random.pick([0, 1, 1.5, -1, 1e12, 2 ** 53, Infinity, 1e7 + 1, '10', 10n]);
    return `samples are ${shown(run.samples)}`;
  },
  (random, run) => {
    // Large and small numbers where each alone is allowed.
    const names = ['velocity', 'casterLength', 'halfContactLength', 'relaxationLength', 'momentOfInertia', 'torsionalStiffness',
      'dampingConstant', 'verticalForce', 'sideForceDerivative', 'aligningMomentDerivative', 'treadWidthMomentConstant'];
    run.parameters = withOwn(run.parameters);
    for (const name of names) if (random.chance(0.4)) run.parameters[name] = 10 ** random.between(-300, 300);
    return 'parameters are of any size';
  },
  (random, run, models) => {
    run.model = random.pick(models).name;
    for (const { name } of random.pick(models).parameters) run.parameters = { ...withOwn(run.parameters), [name]: 1 };
    return 'parameters are of another model';
  },
];

/** @param {object} record @param {string} key @param {unknown} value an own key, whatever its name */
const set = (record, key, value) =>
  Object.defineProperty(record, key, { value, enumerable: true, writable: true, configurable: true });

/** A copy that can be added to; of what cannot be read, an empty one. @param {unknown} record */
function withOwn(record) {
  try {
    return record && typeof record === 'object' ? { ...record } : {};
  } catch {
    return {};
  }
}

/**
 * A run with one to three things wrong, or something that is no run at all; and what is wrong with it.
 * @param {Random} random
 * @param {Model[]} models
 */
export function hostileRun(random, models) {
  if (random.chance(0.05)) {
    const { name, value } = garbage(random);
    return { run: value, wrong: [`the run is ${name}, ${shown(value)}`] };
  }
  const run = shortRun(random, models);
  const wrong = Array.from({ length: 1 + random.below(3) }, () => random.pick(DAMAGES)(random, run, models));
  return { run, wrong };
}
