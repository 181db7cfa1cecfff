/**
 * The tables as the page takes them: after a model's parameters those of the elements on it, by the dotted names that reach
 * them. A value is a value, whatever of the gear it belongs to.
 *
 * @typedef {import('./engine.js').Engine} Engine
 * @typedef {import('./engine.js').Model} Model
 */

/** @param {Pick<Engine, 'models'>} engine @returns {Model[]} */
export function modelsOf(engine) {
  return engine.models().map((model) => ({ ...model, parameters: [...model.parameters, ...model.friction] }));
}

/**
 * Values by name as a run names them: an element's in its own record.
 * @param {Record<string, number>} values
 * @returns {{ parameters: Record<string, number>, friction?: Record<string, number> }}
 */
export function nested(values) {
  /** @type {Record<string, Record<string, number>>} */
  const records = { parameters: {} };
  for (const [name, value] of Object.entries(values)) {
    const [element, key] = name.includes('.') ? name.split('.') : ['parameters', name];
    (records[element] ??= {})[key] = value;
  }
  return { ...records, parameters: records.parameters };
}
