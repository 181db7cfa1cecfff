/**
 * The tables as the page takes them: after a model's parameters those of the elements on it, by the dotted names that reach
 * them. A value is a value, whatever of the gear it belongs to. A gear with a damper on it is another one, with a table of its own.
 *
 * @typedef {import('./engine.js').Engine} Engine
 * @typedef {import('./engine.js').Model} Model
 * @typedef {Omit<Model, 'parameters'> & { parameters: (Model['parameters'][number] & { of?: string })[] }} Listed `of`: the damper whose it is
 */

import { fitted, fittingsOf } from '../object/fittings.js';
import { landingNames } from '../run/landing.js';

/** @param {Pick<Engine, 'models' | 'dampers' | 'runTables'>} engine @returns {Listed[]} */
export function modelsOf(engine) {
  const bare = engine.models().map((model) => ({ ...model, parameters: [...model.parameters, ...model.friction] }));
  // What turns about an axis, with friction there, has room for a damper.
  const gears = bare.filter(({ friction }) => friction.length > 0);
  const damped = gears.flatMap((gear) => engine.dampers().map(({ name: damper, commanded }) => {
    const { parameters, state } = engine.runTables({ model: gear.name, damper: { model: damper } });
    const known = parameters.filter(({ name }) => commanded || name !== 'damper.command');
    const whose = known.map((parameter) => (parameter.name.startsWith('damper.') ? { ...parameter, of: damper } : parameter));
    return { ...gear, name: fitted(gear.name, { damper }), state, parameters: whose };
  }));
  // Whatever stands on wheels can land.
  const landing = [...gears, ...damped].map((gear) => {
    const { gear: model, damper } = fittingsOf(gear.name);
    const { parameters } = engine.runTables({ model, ...(damper !== 'none' && { damper: { model: damper } }), touchdownVelocity: touchdown });
    return { ...gear, name: fitted(gear.name, { roll: 'landing' }), parameters: [...gear.parameters, ...parameters.filter(({ name }) => isOfLanding(name))] };
  });
  return [...bare, ...damped, ...landing];
}

/** Any landing has the same table, in m/s. */
const touchdown = 80;

/** @param {string} name */
const isOfLanding = (name) => /** @type {readonly string[]} */ (landingNames).includes(name);

/**
 * Values by name as a run names them: an element's in its own record.
 * @param {Record<string, number>} values
 * @returns {{ parameters: Record<string, number> } & Record<string, any>}
 */
export function nested(values) {
  /** @type {{ parameters: Record<string, number> } & Record<string, any>} */
  const records = { parameters: {} };
  for (const [name, value] of Object.entries(values)) {
    const path = name.includes('.') ? name.split('.') : ['parameters', name];
    const key = /** @type {string} */ (path.pop());
    path.reduce((record, part) => (record[part] ??= {}), /** @type {Record<string, any>} */ (records))[key] = value;
  }
  return records;
}
