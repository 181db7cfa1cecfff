/**
 * The ways of the roots as one parameter is swept, for one or some values of another.
 *
 * @typedef {import('../../run/linear-looks.js').LinearLooks} LinearLooks
 * @typedef {import('../../view/root-paths.js').Root} Root
 * @typedef {import('./settings.js').Locus} Locus
 * @typedef {{ value: number | null, at: number[], paths: Root[][] }} Way `value`: of the other parameter; `at`: values of the
 *   swept one, at which each path has a root
 */

import { pathsThrough } from '../../view/root-paths.js';
import { roundLimit } from '../../view/scale.js';

const single = 241;
/** Of several, all together must stay within a frame. */
const several = 61;
const leftOut = 0.02;

export class Loci {
  #key = '';
  /** @type {{ ways: Way[], limits: import('../../view/complex-plane.js').Limits } | null} */ #found = null;

  /**
   * @param {{ object: string, parameters: Readonly<Record<string, number>>, linear: LinearLooks }} gear
   * @param {Locus} locus
   * @returns {{ ways: Way[], limits: import('../../view/complex-plane.js').Limits } | null} the same as long as nothing has changed; null where the values cannot be computed with
   */
  look({ object, parameters, linear }, { sweep, family }) {
    const others = Object.entries(parameters).filter(([name]) => name !== sweep.parameter && name !== family?.parameter);
    const key = JSON.stringify([object, sweep, family, others]);
    if (key === this.#key) return this.#found;
    this.#key = key;
    try {
      const values = family ? evenly(family.from, family.to, family.count) : [null];
      const at = evenly(sweep.from, sweep.to, family ? several : single);
      const ways = values.map((value) => ({
        value, at,
        paths: pathsThrough(at.map((swept) => linear.eigenvalues({ [sweep.parameter]: swept, ...(family && value !== null && { [family.parameter]: value }) }))),
      }));
      this.#found = { ways, limits: limitsOf(ways) };
    } catch {
      this.#found = null;
    }
    return this.#found;
  }
}

/** @param {number} from @param {number} to @param {number} count */
function evenly(from, to, count) {
  return Array.from({ length: count }, (_, i) => from + (i / (count - 1)) * (to - from));
}

/** Limits that hold what swings; roots on the real axis may run out of the picture. @param {Way[]} ways */
function limitsOf(ways) {
  const swinging = ways.flatMap(({ paths }) => paths.flat()).filter(({ im }) => im > 0);
  const most = (/** @type {number[]} */ values) => values.sort((one, other) => one - other)[Math.floor((1 - leftOut) * (values.length - 1))] ?? 0;
  const falls = most(swinging.map(({ re }) => Math.max(0, -re)));
  const grows = most(swinging.map(({ re }) => Math.max(0, re)));
  const top = most(swinging.map(({ im }) => im));
  return { left: -roundLimit(Math.max(falls, grows / 2, 1)), right: roundLimit(Math.max(grows, falls / 4, 1)), top: roundLimit(top || 1) };
}
