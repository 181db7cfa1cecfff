/**
 * The experiment as an address: readable keys, SI values, a version. What is at its default is left out.
 *
 *     #shimmy=1&velocity=80&dampingConstant=20&initial.torsionAngle=0.05&slow=50
 *
 * Reading never fails as a whole: what could be read is opened, what could not is listed.
 *
 * @typedef {import('./store.js').State} State
 * @typedef {{ key: string, value: string, reason: 'unknown' | 'not-a-number' | 'too-large' | 'refused' | 'newer' | 'version' | 'missing' | 'twice', instead?: number }} Problem
 * @typedef {{ name: string, default: number }} Named
 * @typedef {{
 *   name: string,
 *   parameters: Named[],
 *   state: { name: string }[],
 * }} Table the model's names and defaults, as the engine lists them
 * @typedef {Pick<State, 'parameters' | 'run' | 'clock' | 'lens'>} Linked
 */

import { slowRates } from './stage/rate.js';
import { lenses } from './lens/lenses.js';

const version = 1;

/**
 * @param {Linked} state
 * @param {Table} table
 */
export function writeLink(state, table) {
  const pairs = [`shimmy=${version}`];
  for (const { name, default: usual } of table.parameters) {
    const value = state.parameters[name];
    if (value !== undefined && value !== usual) pairs.push(`${name}=${value}`);
  }
  for (const { name } of table.state) {
    const value = state.run.initial[name];
    if (value) pairs.push(`initial.${name}=${value}`);
  }
  if (state.clock.slow !== null) pairs.push(`slow=${state.clock.slow}`);
  if (state.lens !== lenses[0].name) pairs.push(`lens=${state.lens}`);
  return `#${pairs.join('&')}`;
}

/**
 * @param {string} text the address' fragment or query
 * @param {Table} table
 * @param {(parameters: Record<string, number>, initial: Record<string, number>) => boolean} accepts
 *   whether the engine takes these values
 * @returns {{ state: Linked, problems: Problem[] } | null} null where the address carries no experiment
 */
export function readLink(text, table, accepts) {
  const pairs = [...new URLSearchParams(text.replace(/^[#?]/, ''))];
  const hasVersion = pairs.some(([key]) => key === 'shimmy');
  if (!hasVersion && !pairs.some(([key]) => isOfTable(key, table))) return null;
  const parameters = Object.fromEntries(table.parameters.map((parameter) => [parameter.name, parameter.default]));
  /** @type {Linked} */
  const state = { parameters, run: { initial: {} }, clock: { slow: null }, lens: lenses[0].name };
  /** @type {Problem[]} */
  const problems = hasVersion ? [] : [{ key: 'shimmy', value: String(version), reason: 'missing' }];
  const seen = new Set();
  for (const [key, value] of pairs) {
    const reason = seen.has(key) ? 'twice' : readPair(state, key, value, table, accepts);
    seen.add(key);
    if (reason) problems.push({ key, value, reason });
  }
  for (const problem of problems)
    if (isOfTable(problem.key, table)) problem.instead = state.parameters[problem.key] ?? state.run.initial[problem.key.replace('initial.', '')] ?? 0;
  return { state, problems };
}

/** @param {string} key @param {Table} table */
function isOfTable(key, table) {
  return table.parameters.some(({ name }) => name === key) || table.state.some(({ name }) => `initial.${name}` === key);
}

/** @param {number} number */
function notFinite(number) {
  return Number.isNaN(number) ? 'not-a-number' : 'too-large';
}

/**
 * Takes one pair into `state`, or says why it cannot.
 * @param {Linked} state
 * @param {string} key
 * @param {string} value
 * @param {Table} table
 * @param {(parameters: Record<string, number>, initial: Record<string, number>) => boolean} accepts
 * @returns {Problem['reason'] | null}
 */
function readPair(state, key, value, table, accepts) {
  if (key === 'shimmy') return Number(value) === version ? null : Number(value) > version ? 'newer' : 'version';
  if (key === 'lens') {
    if (!lenses.some((lens) => lens.name === value && lens.ready)) return 'unknown';
    state.lens = value;
    return null;
  }
  const number = value.trim() === '' ? NaN : Number(value);
  if (key === 'slow') {
    if (!slowRates.includes(number)) return Number.isFinite(number) ? 'refused' : 'not-a-number';
    state.clock = { slow: number };
    return null;
  }
  if (table.parameters.some(({ name }) => name === key)) {
    if (!Number.isFinite(number)) return notFinite(number);
    if (!accepts({ [key]: number }, {})) return 'refused';
    state.parameters[key] = number;
    return null;
  }
  const variable = table.state.find(({ name }) => `initial.${name}` === key);
  if (!variable) return 'unknown';
  if (!Number.isFinite(number)) return notFinite(number);
  if (!accepts({}, { [variable.name]: number })) return 'refused';
  state.run.initial[variable.name] = number;
  return null;
}
