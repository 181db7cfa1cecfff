/**
 * What the lens *Cycles* shows, as the state and a link keep it: readable, in SI units.
 *
 *     view.cycles=cycle                which view
 *     view.cycleOrbit=space,56,20      how the cycle is drawn: a portrait, or in space from where
 *     view.branch=velocity:1:120,torsionAngle      what varies, and what stands upward
 *     view.branchSweep=on              whether a simulated sweep lies over it
 *     view.folds=velocity:1:120,dampingConstant:0:100      the plane of folds: to the right, upward
 *     view.gapMap=dampingConstant      what is to the right of the gap
 *     view.gapBelow=law                what is beneath the map: the branch over the gap, or the spring's law with the gap in it
 *     view.methodsBelow=table          what is beneath the three methods: the curves over the speed, or the table
 *     view.cycleTable=5.12             which table
 *     view.cycleTableSort=…,down       by which column it is sorted; view.methodsSort likewise
 */

import { firstLook } from '../../view/look.js';
import { rangeOf, readRange, writeRange } from '../stability/settings.js';
import { heights } from './branches.js';

/**
 * @typedef {import('../../run/linear-looks.js').Range} Range
 * @typedef {{ range: Range, height: import('./branches.js').Height }} Branch
 */

/** The views, the first is the usual one; what each is stands in views.js. */
export const viewNames = /** @type {const} */ (['cycle', 'branch', 'folds', 'methods', 'tables', 'freeplay', 'basins']);

/** How a cycle can be drawn; the last is what becomes of an aside from it. */
export const orbitViews = /** @type {const} */ (['portrait', 'deformation', 'space', 'multipliers']);

/**
 * @param {string} text
 * @returns {{ name: typeof orbitViews[number], yaw: number, pitch: number }} yaw and pitch in degrees, NaN where nothing is said
 */
export function orbitOf(text) {
  const [first, yaw, pitch] = text.split(',');
  return { name: orbitViews.find((one) => one === first) ?? orbitViews[0], yaw: Number(yaw ?? NaN), pitch: Number(pitch ?? NaN) };
}

/** From where the cycle is looked at in space. @param {string} text @returns {import('../../view/look.js').Look} */
export function lookOf(text) {
  const { yaw, pitch } = orbitOf(text);
  return Number.isFinite(yaw) && Number.isFinite(pitch) ? { yaw: (yaw * Math.PI) / 180, pitch: (pitch * Math.PI) / 180 } : firstLook;
}

/** @param {string} text */
export function isOrbit(text) {
  const [, name, , yaw, pitch] = text.match(/^([a-z]+)(,(-?\d{1,3}),(\d{1,2}))?$/) ?? [];
  if (!orbitViews.some((one) => one === name)) return false;
  return yaw === undefined || (name === 'space' && Math.abs(Number(yaw)) <= 180 && Number(pitch) <= 90);
}

/**
 * The diagram that a setting names; over the speed where it names none of this gear.
 * @param {string} text
 * @param {readonly { name: string, min: number, max: number }[]} parameters
 * @returns {Branch}
 */
export function branchOf(text, parameters) {
  const read = readBranch(text, parameters);
  if (read) return read;
  const { name, min, max } = parameters.find((one) => one.name === 'velocity') ?? parameters[0];
  return { range: { parameter: name, from: min, to: max }, height: heights[0] };
}

/** @param {string} text @param {readonly { name: string }[]} parameters @returns {Branch | null} null for what is no diagram of these */
export function readBranch(text, parameters) {
  const [first, second = heights[0], ...more] = text.split(',');
  const range = readRange(first, parameters);
  const height = heights.find((one) => one === second);
  return range && height && more.length === 0 ? { range, height } : null;
}

/** @param {Branch} branch */
export const writeBranch = ({ range, height }) => `${writeRange(range)},${height}`;

/**
 * The plane of folds that a setting names; the damping over the speed where it names none of this gear.
 * @param {string} text
 * @param {readonly { name: string, min: number, max: number }[]} parameters
 * @returns {{ x: Range, y: Range }}
 */
export function foldsOf(text, parameters) {
  const read = readFolds(text, parameters);
  if (read) return read;
  const side = (/** @type {string} */ wanted, /** @type {number} */ instead) => rangeOf(parameters.find(({ name }) => name === wanted) ?? parameters[instead]);
  return { x: side('velocity', 0), y: side('dampingConstant', 1) };
}

/** @param {string} text @param {readonly { name: string }[]} parameters @returns {{ x: Range, y: Range } | null} null for what is no plane of these */
export function readFolds(text, parameters) {
  const [x, y, ...more] = text.split(',').map((part) => readRange(part, parameters));
  return x && y && more.length === 0 && x.parameter !== y.parameter ? { x, y } : null;
}

/** @param {{ x: Range, y: Range }} plane */
export const writeFolds = ({ x, y }) => `${writeRange(x)},${writeRange(y)}`;

/** What can be beneath the three methods of the gear as it is. */
export const methodsBelows = /** @type {const} */ (['curves', 'table']);

/** @param {string} text @returns {typeof methodsBelows[number]} */
export const methodsBelowOf = (text) => methodsBelows.find((one) => one === text) ?? methodsBelows[0];

/** What can be beneath the map over the gap; `map`: nothing, so that it is large. */
export const gapBelows = /** @type {const} */ (['branch', 'law', 'map']);

/** @param {string} text @returns {typeof gapBelows[number]} */
export const gapBelowOf = (text) => gapBelows.find((one) => one === text) ?? gapBelows[0];

/** The gap, as the engine names it. */
export const gapParameter = 'freeplayAngle';

/**
 * The ranges of the map over the gap; null where the gear has none.
 * @param {string} text what is to the right; the speed unless said
 * @param {readonly { name: string, min: number, max: number }[]} parameters
 * @returns {{ x: Range | null, y: Range | null }}
 */
export function gapRanges(text, parameters) {
  const named = (/** @type {string} */ name) => parameters.find((one) => one.name === name);
  const range = (/** @type {ReturnType<typeof named>} */ one) => (one ? { parameter: one.name, from: one.min, to: one.max } : null);
  const across = text === gapParameter ? undefined : named(text);
  return { x: range(across ?? named('velocity')), y: range(named(gapParameter)) };
}
