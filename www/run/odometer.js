/**
 * @typedef {{ time: number, distance: number, velocity: number }} Leg from an instant on, at one speed
 */

/**
 * How far the wheel has rolled, at every instant of the run: the speed of the past stays the speed of the past, whatever
 * it is set to since. Kept in legs of one speed each.
 */
export class Odometer {
  /** @type {readonly Leg[]} */ #legs;

  /** @param {readonly Leg[]} [legs] what was driven before */
  constructor(legs = [{ time: 0, distance: 0, velocity: 0 }]) {
    this.#legs = legs;
  }

  /** What has been driven. */
  get legs() {
    return this.#legs;
  }

  /**
   * The run goes on from `time` at this speed; what was driven after it is forgotten.
   * @param {number} time in s
   * @param {number} velocity in m/s
   * @param {number} earliest what the run remembers begins here, in s
   */
  drive(time, velocity, earliest) {
    const distance = this.distanceAt(time);
    const now = this.#legAt(time);
    const from = Math.max(0, this.#legs.findIndex((_, i) => i + 1 >= this.#legs.length || this.#legs[i + 1].time > earliest));
    const driven = this.#legs.slice(from, this.#legs.indexOf(now) + 1);
    this.#legs = now.velocity === velocity ? driven : [...driven, { time, distance, velocity }];
  }

  /** @param {number} time in s, @returns {number} in m */
  distanceAt(time) {
    const leg = this.#legAt(time);
    return leg.distance + leg.velocity * (time - leg.time);
  }

  /**
   * When the wheel was where it has been since `distance`; the wheel never rolls back.
   * @param {number} distance in m
   * @returns {number} in s, −Infinity before anything was driven
   */
  timeAt(distance) {
    const leg = this.#legs.findLast((one) => one.distance <= distance && one.velocity > 0);
    return leg ? leg.time + (distance - leg.distance) / leg.velocity : -Infinity;
  }

  /** @param {number} time @returns {Leg} */
  #legAt(time) {
    return this.#legs.findLast((leg) => leg.time <= time) ?? this.#legs[0];
  }
}
