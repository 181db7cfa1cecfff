/**
 * The map of a plane and its boundary, computed anew from scratch whenever any value but the plane's own two has changed:
 * coarse at once, fine when asked to refine.
 *
 * @typedef {import('../../run/linear-looks.js').LinearLooks} LinearLooks
 * @typedef {import('../../run/linear-looks.js').BoundaryCurve} BoundaryCurve
 * @typedef {import('../../view/map-sheet.js').StabilityMap} StabilityMap
 * @typedef {import('../../view/map-colors.js').Limits} Limits
 * @typedef {import('./settings.js').Plane} Plane
 * @typedef {{ object: string, parameters: Readonly<Record<string, number>>, linear: LinearLooks, scales: object }} Gear `scales`:
 *   another object once the axes were fitted anew
 * @typedef {{ map: StabilityMap, share: number | null, boundary: BoundaryCurve[], limits: Limits, isCoarse: boolean }} Looked `share`: of
 *   the plane that is stable, in per cent
 */

import { roundLimit, roundStep } from '../../view/scale.js';

const coarse = { columns: 200, rows: 150 };
const fine = { columns: 400, rows: 300 };
/** The ends of a scale leave out this share of the cells, so that a few wild ones do not pale the others. */
const leftOut = 0.03;
const sampled = 7;

/** @type {Readonly<Record<Plane['coloring'], import('../../run/linear-looks.js').Asked[]>>} */
const quantities = { growthRate: ['stable', 'growthRate', 'kind'], stable: ['stable', 'kind'], frequency: ['stable', 'frequency', 'kind'] };

export class PlaneMap {
  /** What the map is of. */ #key = '';
  /** @type {Looked | null} */ #looked = null;
  /** @type {{ for: string, scales: object, limits: Limits } | null} */ #limits = null;
  /** @type {{ linear: LinearLooks, plane: Plane } | null} */ #last = null;

  /**
   * The map as it is for these values; null where they cannot be computed with.
   * @param {Gear} gear
   * @param {Plane} plane
   * @returns {Looked | null} the same as long as nothing has changed
   */
  look({ object, parameters, linear, scales }, plane) {
    const { x, y, coloring } = plane;
    const others = Object.entries(parameters).filter(([name]) => name !== x.parameter && name !== y.parameter);
    const key = [object, coloring, ...[x, y].flatMap(({ parameter, from, to }) => [parameter, from, to]), ...others.flat()].join();
    const isFitted = this.#limits?.scales === scales;
    if (key === this.#key && isFitted) return this.#looked;
    this.#key = key;
    this.#last = { linear, plane };
    try {
      const map = mapOf(linear, plane, coarse);
      this.#looked = { ...map, boundary: boundaryOf(linear, plane), limits: this.#limitsOf(map.map, [object, x, y, coloring], scales), isCoarse: true };
    } catch {
      // Values so wild that no number comes of them: nothing is said of the plane.
      this.#looked = null;
    }
    return this.#looked;
  }

  /** The same map on finer cells. */
  refine() {
    if (!this.#looked?.isCoarse || !this.#last) return;
    const { linear, plane } = this.#last;
    this.#looked = { ...this.#looked, ...mapOf(linear, plane, fine), isCoarse: false };
  }

  /** Scales stay while a slider moves. @param {StabilityMap} map @param {unknown[]} plane @param {object} scales */
  #limitsOf(map, plane, scales) {
    const name = JSON.stringify(plane);
    if (this.#limits?.for !== name || this.#limits.scales !== scales) this.#limits = { for: name, scales, limits: limitsOf(map) };
    return this.#limits.limits;
  }
}

/** @param {LinearLooks} linear @param {Plane} plane @param {{ columns: number, rows: number }} cells */
function mapOf(linear, { x, y, coloring }, { columns, rows }) {
  const { stable, stableArea, growthRate, frequency, kind } = linear.map({ ...x, count: columns }, { ...y, count: rows }, quantities[coloring]);
  return { map: { columns, rows, stable, growthRate: growthRate ?? null, frequency: frequency ?? null, kind: kind ?? null }, share: stableArea };
}

/** None where the plane is so wide that it would hide its boundary: the cells still tell. @param {LinearLooks} linear @param {Plane} plane */
function boundaryOf(linear, { x, y }) {
  try {
    return linear.boundary(x, y);
  } catch {
    return [];
  }
}

/** @param {StabilityMap} map @returns {Limits} */
function limitsOf({ growthRate, frequency }) {
  const rates = sorted(growthRate ?? [], Math.abs);
  const beats = sorted(frequency ?? [], (value) => value).filter((value) => value > 0);
  const [least, most] = [beats[Math.floor(leftOut * beats.length)] ?? 0, beats[Math.floor((1 - leftOut) * beats.length)] ?? 1];
  const step = roundStep(Math.max((most - least) / 6, 1e-3));
  return {
    growthRate: roundLimit((rates[Math.floor((1 - leftOut) * rates.length)] || 1) / 1.12),
    frequency: [Math.floor(least / step) * step, Math.ceil(most / step) * step],
  };
}

/** Some of the values, ascending. @param {ArrayLike<number>} values @param {(value: number) => number} of */
function sorted(values, of) {
  const some = [];
  for (let i = 0; i < values.length; i += sampled) if (Number.isFinite(values[i])) some.push(of(values[i]));
  return some.sort((one, other) => one - other);
}
