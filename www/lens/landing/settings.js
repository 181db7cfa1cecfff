/**
 * What the lens *Landing* shows, as the state and a link keep it: readable, in SI units.
 *
 *     view.landing=roll                which view
 *     view.landingRoll=80,3,5,0,0.01   touchdown speed, deceleration, final speed, share of the weight that lift takes then, and ψ
 *     view.landingSort=…,down          by which column table 7.4 is sorted
 */

/** The views, the first is the usual one; what each is stands in views.js. */
export const viewNames = /** @type {const} */ (['roll', 'beside', 'table']);

/**
 * What makes a landing of a run, named as the engine names it; the last is how far the wheel is turned as it touches down. Its sliders' ends are the page's: a landing is no model of the engine's
 * tables. Defaults: chosen, theory of the landing roll.
 *
 * @typedef {typeof rollNames[number]} RollName
 * @typedef {Readonly<Record<RollName, number>>} RollValues
 */
export const rollNames = /** @type {const} */ (['touchdownVelocity', 'deceleration', 'finalVelocity', 'liftFraction', 'torsionAngle']);

/** @type {Readonly<Record<RollName, import('../../pkg/shimmy.js').Parameter>>} */
export const rollParameters = {
  touchdownVelocity: parameter('touchdownVelocity', 'v_0', 'm/s', 80, 10, 120),
  deceleration: parameter('deceleration', 'b', 'm/s²', 3, 0.5, 10),
  finalVelocity: parameter('finalVelocity', 'v_e', 'm/s', 5, 1, 60),
  liftFraction: parameter('liftFraction', 'λ', '1', 0, 0, 0.95),
  torsionAngle: parameter('torsionAngle', 'ψ(0)', 'rad', 0.01, 0, 0.2),
};

/** @type {RollValues} */
export const usualRoll = /** @type {RollValues} */ (Object.fromEntries(rollNames.map((name) => [name, rollParameters[name].default])));

/** @param {string} text @returns {RollValues | null} null for what is no landing */
export function readRoll(text) {
  const values = text.split(',').map(Number);
  if (values.length !== rollNames.length || !values.every(Number.isFinite)) return null;
  const roll = /** @type {RollValues} */ (Object.fromEntries(rollNames.map((name, i) => [name, values[i]])));
  return refusedIn(roll) === null ? roll : null;
}

/** The landing that a setting names; the usual one where it names none. @param {string} text */
export const rollOf = (text) => readRoll(text) ?? usualRoll;

/** @param {RollValues} roll */
export const writeRoll = (roll) => rollNames.map((name) => Number(roll[name].toPrecision(6))).join(',');

/**
 * What cannot be of a landing: a roll that ends before it begins, or is longer than anyone waits for.
 * @param {RollValues} roll
 * @returns {'positive' | 'order' | 'share' | 'turn' | 'long' | null}
 */
export function refusedIn({ touchdownVelocity, deceleration, finalVelocity, liftFraction, torsionAngle }) {
  if (!(touchdownVelocity > 0 && deceleration > 0 && finalVelocity > 0)) return 'positive';
  if (!(finalVelocity < touchdownVelocity)) return 'order';
  if (!(liftFraction >= 0 && liftFraction < 1)) return 'share';
  if (!(Math.abs(torsionAngle) <= widestStart)) return 'turn';
  return (touchdownVelocity - finalVelocity) / deceleration > longest ? 'long' : null;
}

/** No landing takes longer, in s; and none begins further turned, in rad. */
export const longest = 120;
const widestStart = 1;

/** How long it takes, in s. @param {Pick<RollValues, 'touchdownVelocity' | 'deceleration' | 'finalVelocity'>} roll */
export const durationOf = ({ touchdownVelocity, deceleration, finalVelocity }) => (touchdownVelocity - finalVelocity) / deceleration;

/**
 * @param {RollName} name @param {string} symbol @param {string} unit @param {number} usual @param {number} min @param {number} max
 * @returns {import('../../pkg/shimmy.js').Parameter}
 */
function parameter(name, symbol, unit, usual, min, max) {
  return { name, symbol, unit, default: usual, min, max, scale: 'linear', doc: '' };
}
