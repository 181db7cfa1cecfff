/**
 * Which gear lands, and how: that on the stage with its values, and its own landing where it is one.
 *
 * @typedef {import('../../run/scene.js').Scene} Scene
 * @typedef {import('./settings.js').RollValues} RollValues
 */

import { fitted, fittingsOf } from '../../object/fittings.js';
import { landingNames } from '../../run/landing.js';
import { rollNames, rollOf } from './settings.js';

/**
 * A scene, or the state of the page, where the values of a gear that lands are with the others.
 * @typedef {Pick<Scene, 'object' | 'parameters'> & { landing?: Scene['landing'] }} OnStage
 */

/** The values of the gear as they were set. @param {OnStage} stage */
const valuesOf = ({ parameters, landing }) => landing ?? parameters;

/** Whether the gear on the stage lands. @param {OnStage} stage */
export const isLive = (stage) => landingNames[0] in valuesOf(stage);

/** The gear without its landing. @param {OnStage} stage @returns {import('./ask.js').Gear} */
export function gearOf(stage) {
  const isGears = (/** @type {string} */ name) => !(/** @type {readonly string[]} */ (landingNames).includes(name));
  return { model: fitted(stage.object, { roll: 'none' }), parameters: Object.fromEntries(Object.entries(valuesOf(stage)).filter(([name]) => isGears(name))) };
}

/** A gear that lands, as an object of the page. @param {string} gear @param {string} damper `none` where there is none */
export const landingObject = (gear, damper) => fitted(gear, { damper, roll: 'landing' });

/** The damper of the thesis, for a gear that has none. */
const usualDamper = 'current-dependent-bouc-wen';

/** The gear with a damping and a damper that gets a current, all else as it is. @param {import('./ask.js').Gear} gear @param {{ dampingConstant: number, current: number }} values @returns {import('./ask.js').Gear} */
export function gearWith({ model, parameters }, { dampingConstant, current }) {
  const { damper } = fittingsOf(model);
  return { model: damper === 'none' ? fitted(model, { damper: usualDamper }) : model, parameters: { ...parameters, dampingConstant, 'damper.command': current } };
}

/** The landing that is looked at. @param {OnStage | null} stage @param {Readonly<Record<string, string>>} settings @returns {RollValues} */
export function rollNow(stage, settings) {
  const set = rollOf(settings.landingRoll ?? '');
  if (!stage || !isLive(stage)) return set;
  const values = valuesOf(stage);
  return /** @type {RollValues} */ (Object.fromEntries(rollNames.map((name) => [name, values[name] ?? set[name]])));
}
