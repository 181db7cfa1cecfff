/**
 * The engine as the page asks it: a model's name may have fittings in it (`torsional.bouc-wen.on-off`), which become records
 * of the run that is asked about.
 *
 * @typedef {import('./engine.js').Engine} Engine
 */

import { fittingsOf } from '../object/fittings.js';
import { landingNames } from '../run/landing.js';
import { nested } from './models.js';

/**
 * What is asked with a model's name as the engine takes it.
 * @template T
 * @param {T} asked
 * @param {boolean} [isRun] whether it may be a run whose speed falls
 * @returns {T}
 */
export function plain(asked, isRun = true) {
  const { model, parameters: values, ...others } = /** @type {{ model?: unknown, parameters?: Record<string, number> | null }} */ (asked ?? {});
  if (typeof model !== 'string') return asked;
  const { gear, damper, control, roll } = fittingsOf(model);
  const { landing, parameters } = parted(values ?? {});
  const records = nested(parameters);
  return /** @type {T} */ ({
    ...others, model: gear, ...records,
    ...(damper !== 'none' && { damper: { ...records.damper, model: damper } }),
    ...(control !== 'none' && { control: { ...records.control, law: control } }),
    // What takes a constant speed alone is asked of the gear at the speed it is given.
    ...(roll !== 'none' && isRun && landing),
  });
}

/** The values of a landing, which are the run's own, apart from those of the gear. @param {Record<string, number>} values */
function parted(values) {
  const parameters = { ...values };
  /** @type {Record<string, number>} */
  const landing = {};
  for (const name of landingNames) {
    if (name in values) landing[name] = values[name];
    delete parameters[name];
  }
  return { landing, parameters };
}

/** What takes a run whose speed falls. */
const rolling = ['simulate', 'landingRoll', 'start', 'runTables'];
/** What of the module takes no run, and what is made of one. */
const asItIs = ['default', 'initSync'];
const made = /** @type {const} */ (['Simulator', 'Job']);

/**
 * The module, asked in the page's names.
 * @param {Engine} engine
 * @returns {Engine}
 */
export function askedInNames(engine) {
  const entries = Object.entries(engine).filter(([name]) => !asItIs.includes(name));
  const functions = entries.filter(([name]) => /^[a-z]/.test(name));
  const asking = functions.map(([name, ask]) => [name, (/** @type {unknown[]} */ ...asked) => /** @type {Function} */ (ask)(...asked.map((one) => plain(one, rolling.includes(name))))]);
  return { ...engine, ...Object.fromEntries(asking), ...Object.fromEntries(made.map((name) => [name, madeInNames(engine[name])])) };
}

/** @template {new (...args: any[]) => any} C @param {C} Made @returns {C} */
function madeInNames(Made) {
  return class extends Made {
    /** @param {any[]} asked */
    constructor(...asked) {
      super(...asked.map((one) => plain(one)));
    }
  };
}
