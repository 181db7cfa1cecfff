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

/** The names of the values that follow. @param {Links} links */
export function linkedNames(links) {
  return Object.keys(followed).filter((name) => links[name]);
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
