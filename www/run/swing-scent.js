/**
 * How widely a gear will swing as one of its values varies: the branches of its cycles over a slider, followed beside the page
 * once the gear has stood still for a moment. What is known of before stays until then, and is told to be old.
 *
 * @typedef {import('../engine/engine.js').Model} Model
 * @typedef {import('../pkg/shimmy.js').Bifurcation} Bifurcation
 * @typedef {import('../pkg/shimmy.js').BifurcationSpec} BifurcationSpec
 * @typedef {import('../store.js').State} State
 * @typedef {Pick<State, 'object' | 'parameters' | 'links'>} Gear
 * @typedef {(spec: BifurcationSpec) => Promise<Bifurcation>} Follow
 * @typedef {{ diagram: Bifurcation, isOld: boolean }} Swings
 */

/** So long the gear stands still before anything is followed anew, in ms. */
const patience = 250;
/** A curve of a slider's height need not be fine. */
const coarse = { step: 0.1, tolerance: 1e-3, points: 100, probes: 2 };
/** What has no such limit in its law of force has no cycle. */
const limit = 'sideForceLimitAngle';

export class SwingScent {
  /** Is called when something is known that was not. */ onChange = () => {};
  #follow;
  #tables;
  /** @type {Map<string, { key: string, diagram: Bifurcation | null }>} */ #known = new Map();
  /** What is to be followed, the newest of each slider. @type {Map<string, { key: string, spec: BifurcationSpec }>} */ #wanted = new Map();
  #timer = /** @type {ReturnType<typeof setTimeout> | null} */ (null);
  #isGoing = false;

  /** @param {Follow} follow @param {() => readonly Model[]} tables */
  constructor(follow, tables) {
    this.#follow = follow;
    this.#tables = tables;
  }

  /**
   * What is known of a slider; asks for what is not.
   * @param {Gear} gear
   * @param {string} parameter
   * @returns {Swings | null}
   */
  of(gear, parameter) {
    const table = this.#tables().find(({ name }) => name === gear.object);
    const range = table?.parameters.find(({ name }) => name === parameter);
    if (!table || !range || !table.parameters.some(({ name }) => name === limit)) return null;
    const key = keyOf(gear, parameter);
    const known = this.#known.get(parameter);
    if (known?.key !== key && this.#wanted.get(parameter)?.key !== key) {
      const { relaxationLength, treadWidthMomentConstant } = gear.links;
      this.#wanted.set(parameter, {
        key, spec: { model: gear.object, parameters: { ...gear.parameters }, parameter, from: range.min, to: range.max, linked: { relaxationLength, treadWidthMomentConstant }, ...coarse },
      });
      this.#wait();
    }
    return known?.diagram ? { diagram: known.diagram, isOld: known.key !== key } : null;
  }

  #wait() {
    if (this.#timer !== null) clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      this.#timer = null;
      this.#next();
    }, patience);
  }

  async #next() {
    const [first] = this.#wanted;
    // A hand that moves on comes first.
    if (!first || this.#isGoing || this.#timer !== null) return;
    const [parameter, { key, spec }] = first;
    this.#wanted.delete(parameter);
    this.#isGoing = true;
    const diagram = await this.#follow(spec).catch(() => null);
    this.#isGoing = false;
    this.#known.set(parameter, { key, diagram });
    this.onChange();
    this.#next();
  }
}

/** All that the branches of a slider depend on: not on the value that it sets. @param {Gear} gear @param {string} parameter */
function keyOf({ object, parameters, links }, parameter) {
  return JSON.stringify([object, Object.entries(parameters).filter(([name]) => name !== parameter), links]);
}
