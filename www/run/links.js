/**
 * Values that follow others: σ = 3a and κ = 0.15 a² c_Fα F_z, as among the gear's usual data. The engine computes them;
 * here is who follows whom.
 *
 * @typedef {Readonly<Record<string, boolean>>} Links whether each follows
 * @typedef {import('../engine/engine.js').Engine} Engine
 */

/** @type {Readonly<Record<string, readonly string[]>>} */
export const followed = {
  relaxationLength: ['halfContactLength'],
  treadWidthMomentConstant: ['halfContactLength', 'sideForceDerivative', 'verticalForce'],
};

/**
 * Values with those that follow them.
 * @param {Engine} engine
 * @param {Record<string, number>} set
 * @param {{ object: string, parameters: Readonly<Record<string, number>> }} gear with all values in force
 * @param {Links} links
 * @returns {Record<string, number>}
 */
export function withFollowers(engine, set, { object: model, parameters }, links) {
  const names = Object.keys(followed).filter((name) => links[name] && followed[name].some((source) => source in set));
  if (names.length === 0) return set;
  /** @type {Record<string, number>} */
  const values = { ...engine.linkedParameters({ model, parameters: { ...parameters, ...set } }) };
  // Rounded as a person would write it: 3 × 0.1 is 0.3.
  return { ...set, ...Object.fromEntries(names.map((name) => [name, Number(values[name].toPrecision(15))])) };
}

/**
 * A value set by hand follows no more.
 * @param {string} name @param {Links} links
 * @returns {Links}
 */
export function linksBrokenBy(name, links) {
  return links[name] ? { ...links, [name]: false } : links;
}

/**
 * Values that are set as they are: neither they nor what would follow them follow any more.
 * @param {Readonly<Record<string, number>>} values @param {Links} links
 * @returns {Links}
 */
export function linksBrokenByPoint(values, links) {
  const parted = Object.keys(followed).filter((name) => links[name] && (name in values || followed[name].some((source) => source in values)));
  return parted.length > 0 ? { ...links, ...Object.fromEntries(parted.map((name) => [name, false])) } : links;
}

/**
 * Which links these values keep: where values come from elsewhere, a relation that does not hold is not forced on them.
 * @param {Engine} engine
 * @param {string} model
 * @param {Readonly<Record<string, number>>} parameters
 * @returns {Links}
 */
export function linksThatHold(engine, model, parameters) {
  const values = engine.linkedParameters({ model, parameters });
  return Object.fromEntries(Object.keys(followed).map((name) => {
    const value = values[/** @type {keyof typeof values} */ (name)];
    return [name, Math.abs(parameters[name] - value) <= 1e-9 * Math.abs(value)];
  }));
}
