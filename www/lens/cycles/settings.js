/**
 * What the lens *Cycles* shows, as the state and a link keep it: readable, in SI units.
 *
 *     view.cycles=cycle                which view
 *     view.cycleOrbit=space,56,20      how the cycle is drawn: a portrait, or in space from where
 *     view.cycleTable=5.12             which table
 *     view.cycleTableSort=…,down       by which column it is sorted; view.methodsSort likewise
 */

/** The views, the first is the usual one; what each is stands in views.js. */
export const viewNames = /** @type {const} */ (['cycle', 'methods', 'tables']);

/** How a cycle can be drawn. */
export const orbitViews = /** @type {const} */ (['portrait', 'deformation', 'space']);

/**
 * @param {string} text
 * @returns {{ name: typeof orbitViews[number], yaw: number, pitch: number }} yaw and pitch in degrees, NaN where nothing is said
 */
export function orbitOf(text) {
  const [first, yaw, pitch] = text.split(',');
  return { name: orbitViews.find((one) => one === first) ?? orbitViews[0], yaw: Number(yaw ?? NaN), pitch: Number(pitch ?? NaN) };
}

/** @param {string} text */
export function isOrbit(text) {
  const [, name, , yaw, pitch] = text.match(/^([a-z]+)(,(-?\d{1,3}),(\d{1,2}))?$/) ?? [];
  if (!orbitViews.some((one) => one === name)) return false;
  return yaw === undefined || (name === 'space' && Math.abs(Number(yaw)) <= 180 && Number(pitch) <= 90);
}
