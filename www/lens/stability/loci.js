/**
 * The ways of the roots as one parameter is swept, for one or some values of another.
 *
 * @typedef {import('../../run/linear-looks.js').LinearLooks} LinearLooks
 * @typedef {import('../../view/root-paths.js').Root} Root
 * @typedef {import('./settings.js').Locus} Locus
 * @typedef {{ value: number | null, at: number[], paths: Root[][] }} Way `value`: of the other parameter; `at`: values of the
 *   swept one, at which each path has a root
 */

import { inOrderOf, pathsThrough } from '../../view/root-paths.js';
import { roundLimit } from '../../view/scale.js';

const single = 241;
/** Of several, all together must stay within a frame. */
const several = 45;
const leftOut = 0.02;
/** How far to the left is looked at least, measured by how far upward. */
const nearShare = 0.2;
/** Roots nearer to the axis than this are looked at equally closely, in 1/s. */
const nearAxis = 30;

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
      const ways = values.map((value) => {
        const rootsAt = (/** @type {number} */ swept) => linear.eigenvalues({ [sweep.parameter]: swept, ...(family && value !== null && { [family.parameter]: value }) });
        return { value, ...wayOf(rootsAt, sweep, family ? several : single) };
      });
      this.#found = { ways, limits: limitsOf(ways) };
    } catch {
      this.#found = null;
    }
    return this.#found;
  }
}

/**
 * A sweep, finer where the roots go fast.
 * @param {(swept: number) => readonly Root[]} rootsAt
 * @param {{ from: number, to: number }} sweep
 * @param {number} most values
 */
function wayOf(rootsAt, { from, to }, most) {
  const stops = evenly(from, to, Math.ceil(most / 3)).map((at) => ({ at, roots: rootsAt(at), leap: 0 }));
  const measure = (/** @type {number} */ i) => {
    stops[i].leap = i === 0 ? 0 : leapBetween(stops[i - 1].roots, stops[i].roots);
  };
  stops.forEach((_, i) => measure(i));
  while (stops.length < most) {
    const widest = stops.reduce((best, { leap }, i) => (leap > stops[best].leap ? i : best), 0);
    if (widest === 0) break;
    const at = (stops[widest - 1].at + stops[widest].at) / 2;
    stops.splice(widest, 0, { at, roots: rootsAt(at), leap: 0 });
    measure(widest);
    measure(widest + 1);
  }
  return { at: stops.map(({ at }) => at), paths: pathsThrough(stops.map(({ roots }) => roots)) };
}

/** How far the roots go from one stop to the next, measured by where they are. @param {readonly Root[]} before @param {readonly Root[]} after */
function leapBetween(before, after) {
  const next = inOrderOf(before, after);
  return before.reduce((most, { re, im }, i) => Math.max(most, Math.hypot(next[i].re - re, next[i].im - im) / (nearAxis + Math.abs(re))), 0);
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
  // The axis is what matters: what is far from it may lie beyond the left edge.
  const left = roundLimit(Math.max(1, Math.min(falls, Math.max(nearShare * top, 3 * grows))));
  return { left: -left, right: roundLimit(Math.max(grows, left / 4)), top: roundLimit(top || 1) };
}
