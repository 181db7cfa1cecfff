/**
 * Where a gear shimmies as one of its values varies, by linear theory. Asked again only when a value has changed.
 *
 * @typedef {import('../engine/engine.js').Engine} Engine
 * @typedef {import('../engine/engine.js').Model} Model
 * @typedef {import('../store.js').State} State
 * @typedef {import('../controls/scent.js').Unstable} Unstable
 * @typedef {Pick<State, 'object' | 'parameters' | 'links'>} Gear
 */

/**
 * The model that is an object's linear theory. Its parameters are those that enter there: no others have a scent. With a
 * hysteresis on it a gear at rest is held, and says nothing of how it swings once that yields: it has none.
 */
const linearised = /** @type {Readonly<Record<string, string>>} */ ({ torsional: 'torsional-linear', 'torsional-linear': 'torsional-linear' });

export class LinearTheory {
  #engine;
  /** @type {Gear | null} */ #gear = null;
  /** @type {Model | undefined} */ #table;
  /** @type {Record<string, number>} */ #values = {};
  /** @type {Map<string, Unstable | null>} */ #found = new Map();

  /** @param {Engine} engine */
  constructor(engine) {
    this.#engine = engine;
  }

  /**
   * Which parts of a parameter's slider are unstable; null where linear theory does not know the parameter or the gear.
   * @param {Gear} gear
   * @param {string} parameter
   */
  unstable(gear, parameter) {
    this.#take(gear);
    let found = this.#found.get(parameter);
    if (found === undefined) this.#found.set(parameter, (found = this.#ask(gear, parameter)));
    return found;
  }

  /** @param {Gear} gear */
  #take({ object, parameters, links }) {
    const last = this.#gear;
    if (last && last.object === object && last.parameters === parameters && last.links === links) return;
    this.#gear = { object, parameters, links };
    this.#found.clear();
    if (object !== last?.object) this.#table = this.#engine.models().find(({ name }) => name === linearised[object]);
    this.#values = Object.fromEntries(this.#table?.parameters.map(({ name }) => [name, parameters[name]]) ?? []);
  }

  /** @param {Gear} gear @param {string} parameter @returns {Unstable | null} */
  #ask({ parameters, links }, parameter) {
    const range = this.#table?.parameters.find(({ name }) => name === parameter);
    if (!range || !this.#table) return null;
    const run = { model: this.#table.name, parameters: this.#values };
    const { relaxationLength, treadWidthMomentConstant } = links;
    try {
      const intervals = this.#engine.unstableIntervals(run, { parameter, from: range.min, to: range.max, linked: { relaxationLength, treadWidthMomentConstant } });
      const isAll = intervals.length === 1 && intervals[0].fromKind === 'range' && intervals[0].toKind === 'range';
      // a₀, the last of the column, is what a wheel that turns aside lacks.
      const isDivergent = isAll && (this.#engine.routhHurwitz(run).column.at(-1) ?? 1) <= 0;
      const [isGapped, isRubbed] = [(parameters.freeplayAngle ?? 0) > 0, (parameters['friction.moment'] ?? 0) > 0];
      return { intervals, isOnlyLinear: isGapped || isRubbed, isDivergent, leavesOut: isRubbed ? (isGapped ? 'both' : 'friction') : null };
    } catch {
      // Values so wild that the conditions leave the numbers: nothing is said of them.
      return null;
    }
  }
}
