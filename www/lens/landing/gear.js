/**
 * Which gear lands, and how: that on the stage with its values, and its own landing where it is one.
 *
 * @typedef {import('../../run/scene.js').Scene} Scene
 * @typedef {import('./settings.js').RollValues} RollValues
 */

import { fitted, fittingsOf } from '../../object/fittings.js';
import { rollNames, rollOf } from './settings.js';

/** How the values of a landing are named among a gear's that lands. */
const place = 'landing.';

/** @param {import('./settings.js').RollName} name */
export const placeOf = (name) => place + name;

/** Whether the gear on the stage lands. @param {Pick<Scene, 'parameters'>} scene */
export const isLive = ({ parameters }) => placeOf(rollNames[0]) in parameters;

/** The gear without its landing. @param {Pick<Scene, 'object' | 'parameters'>} scene @returns {import('./ask.js').Gear} */
export function gearOf({ object, parameters }) {
  return { model: fitted(object, { roll: 'none' }), parameters: Object.fromEntries(Object.entries(parameters).filter(([name]) => !name.startsWith(place))) };
}

/** A gear that lands, as an object of the page. @param {string} gear @param {string} damper `none` where there is none */
export const landingObject = (gear, damper) => fitted(gear, { damper });

/** The damper of the thesis, for a gear that has none. */
const usualDamper = 'current-dependent-bouc-wen';

/** The gear with a damping and a damper that gets a current, all else as it is. @param {import('./ask.js').Gear} gear @param {{ dampingConstant: number, current: number }} values @returns {import('./ask.js').Gear} */
export function gearWith({ model, parameters }, { dampingConstant, current }) {
  const { damper } = fittingsOf(model);
  return { model: damper === 'none' ? fitted(model, { damper: usualDamper }) : model, parameters: { ...parameters, dampingConstant, 'damper.command': current } };
}

/** The landing that is looked at. @param {Pick<Scene, 'parameters'> | null} scene @param {Readonly<Record<string, string>>} settings @returns {RollValues} */
export function rollNow(scene, settings) {
  const set = rollOf(settings.landingRoll ?? '');
  if (!scene || !isLive(scene)) return set;
  return /** @type {RollValues} */ (Object.fromEntries(rollNames.map((name) => [name, scene.parameters[placeOf(name)] ?? set[name]])));
}
