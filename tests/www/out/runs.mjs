// Runs of the page as its exports take them.

import { modelsOf } from '../../../www/engine/models.js';
import { runOf } from '../../../www/out/run-of.js';
import { shimmy } from '../../node/module.mjs';

/** @typedef {import('../../../www/engine/engine.js').Model} Model */

/** @param {string} name @returns {Model} */
export function tableOf(name) {
  const table = modelsOf(shimmy).find((model) => model.name === name);
  if (!table) throw new Error(`no model ${name}`);
  return table;
}

/**
 * @param {string} model
 * @param {Record<string, number>} parameters those that differ from the defaults
 * @param {number} duration
 */
export function wholeRun(model, parameters, duration) {
  return runOf({ object: model, parameters, run: { initial: { torsionAngle: 0.05 } } }, tableOf(model), duration);
}

/** What the page opens with. */
export const opening = () => wholeRun('torsional', { velocity: 80, dampingConstant: 20 }, 2);
