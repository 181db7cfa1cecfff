/**
 * The roots as values change: where they are, the way that they have come since the hand began, and where a pair crossed the
 * axis on it.
 *
 * @typedef {import('../../run/linear-looks.js').LinearLooks} LinearLooks
 * @typedef {import('../../view/root-paths.js').Root} Root
 * @typedef {{ at: Root, kind: 'hopf' | 'divergence', isStable: boolean }} Crossing `isStable`: whether it led to where a swing falls
 */

import { isSameRecord } from '../../store.js';
import { inOrderOf } from '../../view/root-paths.js';

/** A rest longer than this ends a walk: the next change begins another, in s. */
const rest = 1;
const longestTrail = 240;
/** So many beginnings of walks are remembered. */
const mostStarts = 100;
/** A crossing is found to this share of the way. */
const halvings = 40;
/** A root this near to the axis, measured by its distance from 0, is on it. */
const onAxis = 1e-6;

export class RootsWalk {
  /** @type {{ object: string, begun: object | undefined, values: Readonly<Record<string, number>> } | null} */ #gear = null;
  #changedAt = -Infinity;
  /** Where walks began: who is back there has undone what came of them. @type {Readonly<Record<string, number>>[]} */ #starts = [];
  /** @type {readonly Root[]} */ roots = [];
  /** Sets of roots, the oldest first, each in the order of the one before. @type {(readonly Root[])[]} */ trail = [];
  /** The last crossing of this walk. @type {Crossing | null} */ crossing = null;

  /**
   * Takes the values as they are now.
   * @param {{ object: string, parameters: Readonly<Record<string, number>>, linear: LinearLooks, begun?: object }} gear `begun`: another
   *   object once another run was begun: from one figure to the next no way is come
   * @param {number} now in s
   * @returns {'same' | 'changed' | 'crossed'}
   */
  follow({ object, parameters, linear, begun }, now) {
    const last = this.#gear;
    if (last && last.object === object && isSameRecord(last.values, parameters)) return 'same';
    const before = this.roots;
    this.#gear = { object, begun, values: { ...parameters } };
    try {
      this.roots = linear.eigenvalues();
    } catch {
      Object.assign(this, { roots: [], trail: [], crossing: null });
      return 'changed';
    }
    if (last?.object !== object || last.begun !== begun || before.length !== this.roots.length) {
      this.#starts = [];
      return this.#rest();
    }
    const start = this.#starts.findLastIndex((one) => isSameRecord(one, parameters));
    if (start >= 0) {
      this.#starts.length = start;
      return this.#rest();
    }
    if (now - this.#changedAt > rest) {
      this.trail = [before];
      this.crossing = null;
      this.#starts.push(last.values);
      if (this.#starts.length > mostStarts) this.#starts.shift();
    }
    this.#changedAt = now;
    this.trail.push(inOrderOf(this.trail[this.trail.length - 1], this.roots));
    if (this.trail.length > longestTrail) this.trail.shift();
    if (isStable(before) === isStable(this.roots)) return 'changed';
    this.crossing = crossingBetween(linear.eigenvalues, last.values, parameters);
    return this.crossing ? 'crossed' : 'changed';
  }

  /** No way has been come. @returns {'changed'} */
  #rest() {
    this.trail = [this.roots];
    this.crossing = null;
    this.#changedAt = -Infinity;
    return 'changed';
  }
}

/** @param {readonly Root[]} roots by falling real part */
export const isStable = (roots) => roots.length > 0 && roots[0].re < 0;

/**
 * Where on the straight way between two sets of values a root crosses the axis; null where stability changes by a leap, as
 * when a gap opens.
 * @param {(values: Record<string, number>) => readonly Root[]} eigenvalues
 * @param {Readonly<Record<string, number>>} from
 * @param {Readonly<Record<string, number>>} to
 * @returns {Crossing | null}
 */
export function crossingBetween(eigenvalues, from, to) {
  const at = (/** @type {number} */ share) => eigenvalues(Object.fromEntries(Object.entries(to).map(([name, value]) => [name, from[name] + share * (value - from[name])])));
  const wasStable = isStable(at(0));
  let [before, after] = [0, 1];
  for (let i = 0; i < halvings; i++) {
    const middle = (before + after) / 2;
    if (isStable(at(middle)) === wasStable) before = middle;
    else after = middle;
  }
  const [root] = at(after);
  if (Math.abs(root.re) > onAxis * Math.max(1, Math.hypot(root.re, root.im))) return null;
  return { at: root, kind: root.im !== 0 ? 'hopf' : 'divergence', isStable: !wasStable };
}
