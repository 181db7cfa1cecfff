/**
 * A gear's motion by linear theory beside its motion in full, from the same start; and the cases that the thesis looks at so.
 *
 * @typedef {import('../engine/engine.js').Engine} Engine
 * @typedef {import('../engine/engine.js').Columns} Columns
 * @typedef {import('./linear-looks.js').Eigenvalue} Eigenvalue
 * @typedef {{ linear: Columns, nonlinear: Columns, initial: Record<string, number> }} Histories
 * @typedef {{ parameters: Record<string, number>, figures: string[], initial: Record<string, number>, roots: Eigenvalue[] }} Case
 *   `parameters`: all of them; `figures`: those that show it
 */

/** A wheel at rest stays there: then a small twist starts it, that of the thesis' figures, in rad. */
const touch = { torsionAngle: 0.01 };
const [inFull, byTheory] = ['torsional', 'torsional-linear'];

/**
 * @param {Engine} engine
 * @param {{ model: string, parameters: Readonly<Record<string, number>>, initial: Readonly<Record<string, number>> }} run
 * @param {number} duration in s @param {number} samples
 * @returns {Histories | null} null for a gear of which linear theory has no model
 */
export function linearHistories(engine, { model, parameters, initial }, duration, samples) {
  if (model !== inFull && model !== byTheory) return null;
  const start = Object.values(initial).some((value) => value !== 0) ? { ...initial } : touch;
  const history = (/** @type {string} */ of, /** @type {Record<string, number>} */ values) =>
    engine.simulate({ model: of, parameters: knownTo(engine, of, values), initial: start, duration, samples });
  // Inside the gap no spring works.
  const stiffness = (parameters.freeplayAngle ?? 0) > 0 ? 0 : parameters.torsionalStiffness;
  return { linear: history(byTheory, { ...parameters, torsionalStiffness: stiffness }), nonlinear: history(inFull, { ...parameters }), initial: start };
}

/** @type {WeakMap<object, readonly Case[]>} */
const known = new WeakMap();

/**
 * The cases of figures 5.59 to 5.86: each speed with each damping once. They never change, so they are looked up once.
 * @param {Engine} engine
 * @returns {readonly Case[]}
 */
export function linearCases(engine) {
  const cases = known.get(engine.atlas) ?? casesOf(engine);
  known.set(engine.atlas, cases);
  return cases;
}

/** @param {Engine} engine @returns {readonly Case[]} */
function casesOf(engine) {
  /** @type {Map<string, Case>} */
  const cases = new Map();
  const usual = Object.fromEntries(engine.models().find(({ name }) => name === byTheory)?.parameters.map((one) => [one.name, one.default]) ?? []);
  for (const { id, run, view } of engine.atlas()) {
    if (view !== 'time-history' || run?.model !== byTheory) continue;
    const parameters = { ...usual, ...run.parameters };
    const key = JSON.stringify(parameters);
    const one = cases.get(key) ?? { parameters, figures: [], initial: { ...run.initial }, roots: engine.eigenvalues({ model: byTheory, parameters }) };
    one.figures.push(id.split(' ')[1]);
    cases.set(key, one);
  }
  return [...cases.values()];
}

/** Values that a model has. @param {Engine} engine @param {string} model @param {Record<string, number>} values */
function knownTo(engine, model, values) {
  const names = engine.models().find(({ name }) => name === model)?.parameters.map(({ name }) => name) ?? [];
  return Object.fromEntries(Object.entries(values).filter(([name]) => names.includes(name)));
}
