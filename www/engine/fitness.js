/**
 * What an identification asks of workers: the errors of a generation, which all of them share, and at its end what the records
 * fix.
 *
 * @typedef {import('../pkg/shimmy.js').IdentificationSpec} IdentificationSpec
 * @typedef {import('../pkg/shimmy.js').Identifiability} Identifiability
 */

import { pool } from './workers.js';

/**
 * The errors of a population, by all workers together.
 * @param {IdentificationSpec} spec
 * @param {Float64Array} population values of one individual after the other
 * @param {number} individuals
 * @param {{ signal?: AbortSignal, among?: import('./pool.js').Pool }} [options]
 * @returns {Promise<Float64Array>}
 */
export async function errorsOf(spec, population, individuals, { signal, among = pool() } = {}) {
  const each = population.length / individuals;
  const share = Math.ceil(individuals / among.size);
  const parts = [];
  for (let from = 0; from < individuals; from += share) {
    const part = population.slice(from * each, Math.min(individuals, from + share) * each);
    parts.push(among.run('fitness', { spec, population: part }, { signal }));
  }
  const errors = await Promise.all(parts);
  const all = new Float64Array(individuals);
  errors.forEach((part, i) => all.set(part, i * share));
  return all;
}

/**
 * What the records fix of values that several seeds have found.
 * @param {IdentificationSpec} spec
 * @param {Float64Array} population
 * @param {{ signal?: AbortSignal, among?: import('./pool.js').Pool }} [options]
 * @returns {Promise<Identifiability>}
 */
export const identifiabilityOf = (spec, population, { signal, among = pool() } = {}) => among.run('identifiability', { spec, population }, { signal });
