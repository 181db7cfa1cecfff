/**
 * A gear that lands, as the page runs it: an object whose speed falls while it rolls. What is known of a constant speed alone (what
 * becomes of it, its energy, its forces) is asked of the gear as it is now, at the speed that it has.
 *
 * @typedef {Readonly<Record<string, number>>} Values
 */

import { fitted, fittingsOf } from '../object/fittings.js';

/** What makes a landing, as the engine names it. */
export const landingNames = /** @type {const} */ (['touchdownVelocity', 'deceleration', 'finalVelocity', 'liftFraction']);

/** Whether an object lands. @param {string} object */
export const lands = (object) => fittingsOf(object).roll === 'landing';

/** How fast it is at a time after touchdown, in m/s. @param {Values} values @param {number} time in s */
const speedAt = ({ touchdownVelocity, deceleration, finalVelocity }, time) => Math.max(finalVelocity, touchdownVelocity - deceleration * time);

/** How long it takes to slow down, in s. @param {Values} values */
export const slowingTime = ({ touchdownVelocity, deceleration, finalVelocity }) => (touchdownVelocity - finalVelocity) / deceleration;

/**
 * The gear as it is at a time, at the speed and under the weight that it has then; one that does not land is as it is.
 * @param {string} object @param {Values} values @param {number} time in s
 * @returns {{ object: string, parameters: Values }}
 */
export function gearAt(object, values, time) {
  if (!lands(object)) return { object, parameters: values };
  const velocity = speedAt(values, time);
  const verticalForce = values.verticalForce * (1 - values.liftFraction * (velocity / values.touchdownVelocity) ** 2);
  return { object: fitted(object, { roll: 'none' }), parameters: { ...values, velocity, verticalForce } };
}

/** The landing from a time on, as one of its own. @param {Values} values @param {number} time in s @returns {Record<string, number>} */
export function landingFrom(values, time) {
  const velocity = speedAt(values, time);
  return { ...values, touchdownVelocity: velocity, liftFraction: values.liftFraction * (velocity / values.touchdownVelocity) ** 2 };
}
