/**
 * What is fitted to a gear, and how it rolls. The page names the gear with its fittings as one object, `torsional.bouc-wen.on-off`:
 * what is on the stage is one thing, whose values, states, links, ghosts and undo are those of any other. The engine takes
 * them apart (www/engine/fitted.js).
 *
 * @typedef {{ gear: string, damper: string, control: string, roll: string }} Fittings each `none` where there is none
 */

const none = 'none';
const parts = /** @type {const} */ (['gear', 'damper', 'control', 'roll']);

/** @param {string} object @returns {Fittings} */
export function fittingsOf(object) {
  const [gear, damper = none, control = none, roll = none] = object.split('.');
  return { gear, damper, control, roll };
}

/**
 * The object with other fittings. What commands a damper goes with it.
 * @param {string} object
 * @param {Partial<Fittings>} fittings
 */
export function fitted(object, fittings) {
  const all = { ...fittingsOf(object), ...fittings };
  if (all.damper === none) all.control = none;
  const names = parts.map((part) => all[part]);
  while (names.at(-1) === none) names.pop();
  return names.join('.');
}
