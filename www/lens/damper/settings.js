/**
 * What the lens *Damper* shows, as the state and a link keep it: readable, in the units in which people think of a bench.
 *
 *     view.damper=loops                            which view
 *     view.damperModel=modified-bouc-wen           whose loops
 *     view.damperMotion=10,2                       amplitude of the piston in mm, frequency in Hz
 *     view.damperCurrents=0,0.5,1,1.5              at which commands
 *     view.damperCurrent=1                         which of them is chosen
 *     view.damperMap=velocity                      what is to the right of the map of what calms
 *     view.damperPush=0.01                         from which push, in rad
 *     view.damperTable=7.2                         which table; view.damperTableSort by which column
 */

/** The views, the first is the usual one; what each is stands in views.js. */
export const viewNames = /** @type {const} */ (['loops', 'models', 'energy', 'identify', 'calm', 'tables']);

/** The dampers, as the engine names them. The second is the best known of them, and is shown first. */
export const damperNames = /** @type {const} */ (['bouc-wen', 'modified-bouc-wen', 'modified-bouc-wen-cubic', 'current-dependent-bouc-wen']);
const usualDamper = damperNames[1];

/** @param {string} text */
export const damperOf = (text) => damperNames.find((name) => name === text) ?? usualDamper;
/** @param {string} text */
export const isDamper = (text) => damperNames.some((name) => name === text);

/** @typedef {{ amplitude: number, frequency: number }} Motion in m and Hz */

/** Ends of the sliders, in mm and Hz; beyond them no bench goes. */
export const amplitudes = { min: 0.1, max: 50, usual: 10 };
export const frequencies = { min: 0.1, max: 60, usual: 2 };

/** @param {string} text @returns {Motion} */
export function motionOf(text) {
  const [amplitude, frequency] = isMotion(text) ? text.split(',').map(Number) : [amplitudes.usual, frequencies.usual];
  return { amplitude: amplitude / 1000, frequency };
}

/** @param {Motion} motion */
export const writeMotion = ({ amplitude, frequency }) => `${Number((1000 * amplitude).toPrecision(6))},${Number(frequency.toPrecision(6))}`;

/** @param {string} text */
export function isMotion(text) {
  const parts = text.split(',');
  const [amplitude, frequency] = parts.map(Number);
  const isIn = (/** @type {number} */ value, /** @type {{ min: number, max: number }} */ { min, max }) => value >= min && value <= max;
  return parts.length === 2 && isIn(amplitude, amplitudes) && isIn(frequency, frequencies);
}

/** As many loops can be told apart. */
export const mostCurrents = 6;

/** The commands of a list, those that a damper takes. @param {string} text @param {{ min: number, max: number }} command */
export function currentsOf(text, { min, max }) {
  const listed = isCurrents(text) ? text.split(',').map(Number).filter((one) => one >= min && one <= max) : [];
  return listed.length > 0 ? listed : usualCurrents({ min, max });
}

/** Four over what the damper takes, rounded so that they read well. @param {{ min: number, max: number }} command */
function usualCurrents({ min, max }) {
  const most = Math.min(max, 1.5);
  return [0, 1 / 3, 2 / 3, 1].map((share) => Number(Math.max(min, share * most).toPrecision(3)));
}

/** @param {string} text */
export function isCurrents(text) {
  const parts = text.split(',');
  return parts.length <= mostCurrents && parts.every((part) => /^\d+(\.\d+)?$/.test(part) && Number(part) <= 10);
}

/** Which of some commands is chosen: the one named, else the last but one. @param {string} text @param {readonly number[]} currents */
export function chosenOf(text, currents) {
  const named = currents.indexOf(Number(text));
  return text !== '' && named >= 0 ? named : Math.max(0, currents.length - 2);
}

/** What can be to the right of the map of what calms; the command is upward. */
const across = ['velocity', 'freeplayAngle'];

/** @param {string} text */
export const calmAcross = (text) => (across.includes(text) ? text : across[0]);
/** @param {string} text */
export const isCalmAcross = (text) => across.includes(text);

/** From which push a motion begins, in rad. @param {string} text */
export const pushOf = (text) => (isPush(text) ? Number(text) : 0.01);
/** @param {string} text */
export const isPush = (text) => /^[\d.e-]+$/.test(text) && Number(text) > 0 && Number(text) <= 1;
