/**
 * How much of the complex plane is shown: it holds the pairs that swing, widens when one would leave it, and narrows only
 * when the axes are fitted anew. Roots on the real axis may lie beyond.
 *
 * @typedef {import('../../view/complex-plane.js').Limits} Limits
 * @typedef {import('../../view/root-paths.js').Root} Root
 */

import { roundLimit } from '../../view/scale.js';

/** The axis must be in sight even when the pair is on it, in 1/s. */
const narrowest = 25;
/** How far the unstable half reaches, measured by the stable one. */
const unstableShare = 0.7;

export class RootsLimits {
  /** @type {Limits} */ limits = { left: -narrowest, right: unstableShare * narrowest, top: 100 };
  /** @type {unknown} */ #fitted = null;

  /**
   * @param {readonly Root[]} roots
   * @param {object} scales another object once the axes were fitted anew
   */
  hold(roots, scales) {
    const isFresh = scales !== this.#fitted;
    this.#fitted = scales;
    const pairs = roots.filter(({ im }) => im > 0);
    const wide = Math.max(narrowest, ...pairs.map(({ re }) => Math.max(-re, re / unstableShare)));
    const high = Math.max(1, ...pairs.map(({ im }) => im));
    const { left, top } = this.limits;
    if (!isFresh && wide <= -left && high <= top) return;
    const width = isFresh || wide > -left ? roundLimit(wide) : -left;
    this.limits = { left: -width, right: unstableShare * width, top: isFresh || high > top ? roundLimit(high) : top };
  }
}
