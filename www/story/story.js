/**
 * A story: what it puts on the page, step by step. All of it is data; player.js opens it and walks it.
 *
 * @typedef {import('../store.js').State} State
 * @typedef {ReturnType<import('../engine/engine.js').Engine['atlas']>[number]} AtlasEntry a figure or table as the engine lists it
 * @typedef {{
 *   object?: string,
 *   parameters: Readonly<Record<string, number>>,
 *   initial: Readonly<Record<string, number>>,
 *   ghosts?: readonly { parameters?: Readonly<Record<string, number>>, initial?: Readonly<Record<string, number>> }[],
 *   lens?: string,
 *   views?: Readonly<Record<string, string>>,
 *   clock?: State['clock'],
 *   knobs?: readonly string[],
 *   duration?: number,
 *   drawer?: boolean,
 * }} Setting SI; values that are not named are at the engine's defaults. `ghosts`: runs beside it, each with what differs
 *   from its own; `knobs`: those that the dock shows, the first two on a projector; `duration`: what the timeline shows at
 *   least, in s; `drawer`: whether all values are shown
 * @typedef {{ state: Setting, goesOn?: boolean, asks?: Readonly<Record<string, number>> }} Step
 *   `goesOn`: the run of the step before goes on where nothing was done to it; `asks`: a question, and the values that
 *   answer it when they are set
 * @typedef {{ name: string, kind: 'preset' | 'figure', steps: readonly Step[], isReady: boolean, entry?: AtlasEntry }} Story
 *   `isReady`: whether this page can open it yet; `entry`: the figure or table that it is
 */

/** The object of a step. @param {Setting} setting */
export function objectOf({ object = 'torsional' }) {
  return object;
}

/**
 * All values of a step.
 * @param {Setting} setting
 * @param {readonly import('../engine/engine.js').Model[]} models
 * @returns {Record<string, number>}
 */
export function parametersOf(setting, models) {
  const table = models.find(({ name }) => name === objectOf(setting));
  const usual = table?.parameters.map((parameter) => [parameter.name, parameter.default]) ?? [];
  return { ...Object.fromEntries(usual), ...setting.parameters };
}
