/**
 * Which planes stand side by side, as the state and a link keep it: readable, in SI units. The plane to the right and upward,
 * then one list of values or two, each value of the first with each of the second.
 *
 *     view.beside=velocity:0.5:100,dampingConstant:0:100,relaxationLength:0.02:0.07:0.12
 *     view.beside=velocity:0.5:100,casterLength:0:0.5,halfContactLength:0.09:0.11,torsionalStiffness:100000:0
 *
 * @typedef {import('../../run/linear-looks.js').Range} Range
 * @typedef {{ parameter: string, values: number[] }} List
 * @typedef {{ x: Range, y: Range, lists: List[] }} Beside
 * @typedef {import('./settings.js').Parameter} Parameter
 */

import { readRange, writeRange } from './settings.js';

/** More planes than this are no comparison. */
export const mostPlanes = 36;

const damping = 'velocity:0.5:100,dampingConstant:0:100';
const caster = 'velocity:0.5:100,casterLength:0:0.5';
const stiffnesses = 'torsionalStiffness:100000:50000:0';
const relaxations = 'relaxationLength:0.02:0.07:0.12:0.17:0.22:0.27:0.32';
const contacts = 'halfContactLength:0.09:0.095:0.105:0.11';
const casters = 'casterLength:0.09:0.095:0.105:0.11';

/** The comparisons of the thesis, the first is the usual one; `table`: where it has their shares. */
export const readyBesides = /** @type {const} */ ([
  { table: '5.2', text: `${caster},${stiffnesses}` },
  { table: '5.3', text: `${damping},${relaxations}` },
  { table: '5.4', text: `${damping},verticalForce:5000:10000:15000` },
  { table: '5.5', text: `${caster},${contacts},${stiffnesses}` },
  { table: '5.6', text: `${damping},${casters},${relaxations}` },
  { table: '', text: `${caster},${contacts}` },
  { table: '', text: `${damping},${casters}` },
]);

/**
 * The comparison that a setting names; the usual one where it names none of this gear, null where that has no such values.
 * @param {string} text
 * @param {readonly Parameter[]} parameters
 * @returns {Beside | null}
 */
export function besideOf(text, parameters) {
  return readBeside(text, parameters) ?? readBeside(readyBesides[0].text, parameters);
}

/** @param {string} text @param {readonly { name: string }[]} parameters @returns {Beside | null} null for what is none of these */
export function readBeside(text, parameters) {
  const parts = text.split(',');
  const [x, y] = parts.slice(0, 2).map((part) => readRange(part, parameters));
  const lists = parts.slice(2).map((part) => readList(part, parameters)).filter((list) => list !== null);
  if (!x || !y || lists.length === 0 || lists.length > 2 || lists.length !== parts.length - 2) return null;
  const names = [x, y, ...lists].map(({ parameter }) => parameter);
  const isTooMuch = lists.reduce((count, { values }) => count * values.length, 1) > mostPlanes;
  return new Set(names).size < names.length || isTooMuch ? null : { x, y, lists };
}

/** @param {Beside} beside */
export function writeBeside({ x, y, lists }) {
  return [writeRange(x), writeRange(y), ...lists.map(({ parameter, values }) => [parameter, ...values].join(':'))].join();
}

/**
 * The planes one after another: of each the values that set it apart.
 * @param {Beside} beside
 * @returns {Record<string, number>[]}
 */
export function planesOf({ lists }) {
  return lists.reduce((planes, { parameter, values }) => planes.flatMap((plane) => values.map((value) => ({ ...plane, [parameter]: value }))), [/** @type {Record<string, number>} */ ({})]);
}

/** @param {string} text @param {readonly { name: string }[]} parameters @returns {List | null} */
function readList(text, parameters) {
  const [parameter, ...texts] = text.split(':');
  const values = texts.map((one) => (one === '' ? NaN : Number(one)));
  return parameters.some(({ name }) => name === parameter) && values.length > 0 && values.every(Number.isFinite) ? { parameter, values } : null;
}
