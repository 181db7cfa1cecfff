/**
 * The engine as the page asks it: a model's name may have fittings in it (`torsional.bouc-wen.on-off`), which become records
 * of the run that is asked about.
 *
 * @typedef {import('./engine.js').Engine} Engine
 */

import { fittingsOf } from '../object/fittings.js';
import { nested } from './models.js';

/**
 * What is asked with a model's name as the engine takes it.
 * @template T
 * @param {T} asked
 * @returns {T}
 */
export function plain(asked) {
  const { model, parameters, ...others } = /** @type {{ model?: unknown, parameters?: Record<string, number> | null }} */ (asked ?? {});
  if (typeof model !== 'string') return asked;
  const { gear, damper, control, roll } = fittingsOf(model);
  const records = nested(parameters ?? {});
  return /** @type {T} */ ({
    ...others, model: gear, ...records,
    ...(damper !== 'none' && { damper: { ...records.damper, model: damper } }),
    ...(control !== 'none' && { control: { ...records.control, law: control } }),
    ...(roll !== 'none' && { landing: { ...records.landing } }),
  });
}

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
  const asking = functions.map(([name, ask]) => [name, (/** @type {unknown[]} */ ...asked) => /** @type {Function} */ (ask)(...asked.map(plain))]);
  return { ...engine, ...Object.fromEntries(asking), ...Object.fromEntries(made.map((name) => [name, madeInNames(engine[name])])) };
}

/** @template {new (...args: any[]) => any} C @param {C} Made @returns {C} */
function madeInNames(Made) {
  return class extends Made {
    /** @param {any[]} asked */
    constructor(...asked) {
      super(...asked.map(plain));
    }
  };
}
