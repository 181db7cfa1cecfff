/**
 * The whole state as an address: readable keys, SI values, a version. What is at its default is left out.
 *
 *     #shimmy=2&velocity=80&dampingConstant=60&initial.torsionAngle=0.05&was.dampingConstant=20&do=0.35,dampingConstant:60&time=0.5&slow=50
 *
 * | key | what |
 * | --- | --- |
 * | `model` | the object, where it is not the first |
 * | a parameter's name | its value now |
 * | `initial.…` | the state that the run starts from |
 * | `was.…` | a value at the start, where it was another |
 * | `do` | what was done at a time: `0.35,dampingConstant:60`, `0.4,kick:10`, `0.5,state.torsionAngle:0.2`; once each |
 * | `time` | how far the run goes |
 * | `free` | values that do not follow others |
 * | `ghost` | a run kept beside: the time it was kept at, its model, values, and its state then |
 * | `clock`, `slow`, `lens`, `view.…`, `story`, `big` | how it is looked at; `view.velocityUnit` where the speed is not shown in m/s |
 * | `predict` | what comes is to be guessed first |
 * | `pen` | what a pen drew, as pen.js writes it; once a stroke |
 *
 * @typedef {import('../store.js').State} State
 * @typedef {import('../run/live-run.js').Recipe} Recipe
 * @typedef {{ name: string, parameters: { name: string, default: number }[], state: { name: string }[] }} Table
 *   a model's names and defaults, as the engine lists them
 */

import { lenses } from '../lens/lenses.js';
import { penPairs } from './pen.js';

export const version = 2;

/**
 * @param {Pick<State, 'object' | 'parameters' | 'run' | 'links' | 'ghosts' | 'clock' | 'lens' | 'views' | 'story' | 'predict' | 'isBig'> & { velocityUnit?: State['velocityUnit'] }} state
 * @param {Pick<Recipe, 'parameters' | 'changes' | 'time'>} recipe how the run came to where it is
 * @param {Table[]} models the first is the one that is not named
 * @param {readonly import('./pen.js').Drawn[]} [drawn] by a pen
 */
export function writeLink(state, recipe, models, drawn = []) {
  const table = models.find(({ name }) => name === state.object) ?? models[0];
  const pairs = [`shimmy=${version}`];
  if (table !== models[0]) pairs.push(`model=${table.name}`);
  pairs.push(...entries(valuesOf(state.parameters, table), '='), ...entries(stateOf(state.run.initial, table, 'initial.'), '='));
  pairs.push(...historyOf(state, recipe, table));
  const free = Object.keys(state.links).filter((name) => !state.links[name]);
  if (free.length > 0) pairs.push(`free=${free.join(',')}`);
  pairs.push(...state.ghosts.map((ghost) => ghostOf(ghost, models)));
  if (state.clock.mode !== 'slow') pairs.push(`clock=${state.clock.mode}`);
  if (state.clock.slow !== null) pairs.push(`slow=${state.clock.slow}`);
  if (state.lens !== lenses[0].name) pairs.push(`lens=${state.lens}`);
  pairs.push(...Object.entries(state.views).map(([of, shows]) => `view.${of}=${shows}`));
  if (state.velocityUnit && state.velocityUnit !== 'm/s') pairs.push(`view.velocityUnit=${state.velocityUnit}`);
  if (state.story) pairs.push(`story=${state.story.name}${state.story.step ? `,${state.story.step}` : ''}`);
  // What has been revealed is no riddle any more.
  if (state.predict && !state.predict.outcome) pairs.push('predict=1');
  if (state.isBig) pairs.push('big=1');
  pairs.push(...penPairs(drawn));
  return `#${pairs.join('&')}`;
}

/** @param {Pick<State, 'parameters'>} state @param {Pick<Recipe, 'parameters' | 'changes' | 'time'>} recipe @param {Table} table */
function historyOf({ parameters }, recipe, table) {
  if (!(recipe.time > 0) && recipe.changes.length === 0) return [];
  const was = table.parameters.filter(({ name }) => recipe.parameters[name] !== parameters[name]);
  const done = recipe.changes.map(({ time, set, state, kick }) => {
    const what = [...entries(Object.entries(set ?? {}), ':'), ...entries(prefixed(state ?? {}, 'state.'), ':')];
    if (kick !== undefined) what.push(`kick:${kick}`);
    return `do=${[tidy(time), ...what].join(',')}`;
  });
  return [...was.map(({ name }) => `was.${name}=${recipe.parameters[name]}`), ...done, `time=${tidy(recipe.time)}`];
}

/** @param {State['ghosts'][number]} ghost @param {Table[]} models */
function ghostOf({ object, parameters, initial, from }, models) {
  const table = models.find(({ name }) => name === object) ?? models[0];
  return `ghost=${[from, object, ...entries(valuesOf(parameters, table), ':'), ...entries(stateOf(initial, table, 'state.'), ':')].join(',')}`;
}

/** Values that are not at their defaults. @param {Record<string, number>} parameters @param {Table} table @returns {[string, number][]} */
function valuesOf(parameters, table) {
  return table.parameters.flatMap(({ name, default: usual }) => {
    const value = parameters[name];
    return value === undefined || value === usual ? [] : [/** @type {[string, number]} */ ([name, value])];
  });
}

/** State variables that are not 0. @param {Record<string, number>} state @param {Table} table @param {string} prefix @returns {[string, number][]} */
function stateOf(state, table, prefix) {
  return table.state.flatMap(({ name }) => (state[name] ? [/** @type {[string, number]} */ ([prefix + name, state[name]])] : []));
}

/** @param {Record<string, number>} record @param {string} prefix @returns {[string, number][]} */
function prefixed(record, prefix) {
  return Object.entries(record).map(([name, value]) => [prefix + name, value]);
}

/** A time without the dust of its sums. @param {number} time */
const tidy = (time) => Number(time.toPrecision(14));

/** @param {[string, number][]} pairs @param {string} sign */
function entries(pairs, sign) {
  return pairs.map(([name, value]) => name + sign + value);
}
