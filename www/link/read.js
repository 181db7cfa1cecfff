/**
 * What an address carries; see write.js for its keys. Reading never fails as a whole: what could be read is opened, what
 * could not is listed. Addresses of version 1, with fewer keys, open as they did.
 *
 * @typedef {import('../store.js').State} State
 * @typedef {import('../run/live-run.js').Change} Change
 * @typedef {import('./pen.js').Drawn} Drawn
 * @typedef {import('./write.js').Table} Table
 * @typedef {{ key: string, value: string, reason: 'unknown' | 'not-a-number' | 'too-large' | 'refused' | 'newer' | 'version' | 'missing' | 'twice' | 'unclear' | 'unknown-story' | 'story-ends', instead?: number }} Problem
 * @typedef {Pick<State, 'object' | 'parameters' | 'run' | 'links' | 'ghosts' | 'clock' | 'lens' | 'views' | 'story' | 'predict' | 'isBig'> & { velocityUnit?: State['velocityUnit'] }} Linked
 *   an address that names no unit leaves the speed in the reader's own
 * @typedef {(run: { model: string, parameters: Record<string, number>, initial: Record<string, number> }) => boolean} Accepts
 *   whether the engine takes these values
 * @typedef {{ state: Linked, run: { initial: Record<string, number>, start: Record<string, number>, changes: Change[], time: number }, drawn: Drawn[], table: Table, models: Table[], accepts: Accepts }} Reading
 */

import { isVelocityUnit } from '../controls/unit.js';
import { gapBelowOf, gapParameter, isOrbit, methodsBelowOf, readBranch, readFolds } from '../lens/cycles/settings.js';
import { tableNumbers } from '../lens/cycles/thesis-tables.js';
import { isCalmAcross, isCurrents, isDamper, isMotion, isPush } from '../lens/damper/settings.js';
import { isDamperTable } from '../lens/damper/thesis-tables.js';
import { lenses } from '../lens/lenses.js';
import { readBeside } from '../lens/stability/beside-settings.js';
import { isHistories, isMode, isSorting, readLocus, readPlane } from '../lens/stability/settings.js';
import { readRoll } from '../lens/landing/settings.js';
import { hasView } from '../lens/views.js';
import { magnifications } from '../run/fit.js';
import { mostGhosts } from '../run/ghosts.js';
import { slowRates } from '../run/rate.js';
import { mostStrokes, strokeOf } from './pen.js';
import { version } from './write.js';

/** A text longer than this is no address of ours: ours has some forty changes, four ghosts and a few dozen strokes at most. */
const longestText = 60_000;
/** A run of an address goes no further than this, or a slip of the hand would keep the page busy for minutes, in s. */
const longestRun = 120;

/**
 * @param {string} text the address' fragment or query
 * @param {Table[]} models the first is the one that need not be named
 * @param {Accepts} accepts
 * @returns {{ state: Linked, drawn: Drawn[], problems: Problem[] } | null} null where the address carries no experiment
 */
export function readLink(text, models, accepts) {
  const pairs = [...new URLSearchParams(text.slice(0, longestText).replace(/^[#?]/, ''))];
  const hasVersion = pairs.some(([key]) => key === 'shimmy');
  const named = pairs.find(([key]) => key === 'model')?.[1];
  const table = models.find(({ name }) => name === named) ?? models[0];
  if (!hasVersion && !pairs.some(([key]) => isOfTable(key, table))) return null;
  const reading = {
    state: blank(table),
    run: { initial: /** @type {Record<string, number>} */ ({}), start: /** @type {Record<string, number>} */ ({}), changes: /** @type {Change[]} */ ([]), time: 0 },
    drawn: /** @type {Drawn[]} */ ([]), table, models, accepts,
  };
  /** @type {Problem[]} */
  const problems = hasVersion ? [] : [{ key: 'shimmy', value: '1', reason: 'missing' }];
  const seen = new Set();
  for (const [key, value] of pairs) {
    const isRepeated = seen.has(key) && !['do', 'ghost', 'pen'].includes(key);
    seen.add(key);
    const reason = isRepeated ? 'twice' : readPair(reading, key, value);
    if (reason) problems.push({ key, value, reason });
  }
  const { state } = reading;
  state.run = runOf(reading.run);
  for (const problem of problems)
    if (isOfTable(problem.key, table)) problem.instead = state.parameters[problem.key] ?? state.run.initial[problem.key.replace('initial.', '')] ?? 0;
  return { state, drawn: reading.drawn, problems };
}

/**
 * What an address names that is no key at all: one that meant an experiment and misspelt it should hear so.
 * @param {string} text the address' fragment
 * @returns {Problem[]}
 */
export function strangersIn(text) {
  if (!text.startsWith('#') || !text.includes('=')) return [];
  return [...new URLSearchParams(text.slice(1, longestText))].map(([key, value]) => ({ key, value, reason: 'unknown' }));
}

/** @param {Table} table @returns {Linked} */
function blank(table) {
  return {
    object: table.name,
    parameters: Object.fromEntries(table.parameters.map((parameter) => [parameter.name, parameter.default])),
    run: { initial: {} },
    links: {},
    ghosts: [],
    clock: { mode: 'slow', slow: null },
    lens: lenses[0].name,
    views: {},
    story: null,
    predict: null,
    isBig: false,
  };
}

/** A run to which nothing was done is its start alone. @param {Reading['run']} run @returns {State['run']} */
function runOf({ initial, start, changes, time }) {
  if (changes.length === 0 && time === 0) return { initial };
  const last = changes.reduce((most, change) => Math.max(most, change.time), time);
  return { initial, start, changes: changes.sort((one, other) => one.time - other.time), time: last };
}

/** @param {string} key @param {Table} table */
function isOfTable(key, table) {
  return table.parameters.some(({ name }) => name === key) || table.state.some(({ name }) => `initial.${name}` === key);
}

/** A run begins no further turned than once around, in rad: what is wider is a slip, and no axis has numbers for it. */
const widestStart = 2 * Math.PI;

/** @type {Readonly<Record<string, (reading: Reading, value: string) => Problem['reason'] | null>>} */
export const readers = {
  shimmy: (_, value) => (['1', String(version)].includes(value) ? null : Number(value) > version ? 'newer' : 'version'),
  model: ({ models }, value) => (models.some(({ name }) => name === value) ? null : 'unknown'),
  lens: ({ state }, value) => {
    if (!lenses.some(({ name, ready }) => name === value && ready)) return 'unknown';
    state.lens = value;
    return null;
  },
  slow: ({ state }, value) => {
    const number = numberOf(value);
    if (!slowRates.includes(number)) return Number.isFinite(number) ? 'refused' : 'not-a-number';
    state.clock = { ...state.clock, slow: number };
    return null;
  },
  clock: ({ state }, value) => {
    if (value !== 'slow' && value !== 'strobe' && value !== 'real') return 'unknown';
    state.clock = { ...state.clock, mode: value };
    return null;
  },
  free: ({ state, table }, value) => {
    const names = value.split(',');
    state.links = Object.fromEntries(names.map((name) => [name, false]));
    return names.every((name) => table.parameters.some((parameter) => parameter.name === name)) ? null : 'unclear';
  },
  time: ({ run }, value) => {
    const number = numberOf(value);
    if (!Number.isFinite(number)) return notFinite(number);
    if (number < 0 || number > longestRun) return 'refused';
    run.time = number;
    return null;
  },
  do: (reading, value) => {
    const change = changeOf(value, reading);
    if (!change) return 'unclear';
    reading.run.changes.push(change);
    return null;
  },
  ghost: (reading, value) => {
    if (reading.state.ghosts.length >= mostGhosts) return 'refused';
    const ghost = ghostOf(value, reading);
    if (!ghost) return 'unclear';
    reading.state.ghosts = [...reading.state.ghosts, ghost];
    return null;
  },
  'view.velocityUnit': ({ state }, value) => {
    if (!isVelocityUnit(value)) return 'unknown';
    state.velocityUnit = value;
    return null;
  },
  'view.plane': (reading, value) => {
    const plane = readPlane(value, reading.table.parameters);
    return plane ? looked(reading, 'plane', value, [plane.x, plane.y]) : 'unclear';
  },
  'view.locus': (reading, value) => {
    const locus = readLocus(value, reading.table.parameters);
    return locus ? looked(reading, 'locus', value, locus.family ? [locus.sweep, locus.family] : [locus.sweep]) : 'unclear';
  },
  'view.beside': (reading, value) => {
    const beside = readBeside(value, reading.table.parameters);
    if (!beside) return 'unclear';
    const areTaken = beside.lists.every(({ parameter, values }) => values.every((one) => accepted(reading, { [parameter]: one }, {})));
    return areTaken ? looked(reading, 'beside', value, [beside.x, beside.y]) : 'refused';
  },
  'view.branch': (reading, value) => {
    const branch = readBranch(value, reading.table.parameters);
    return branch ? looked(reading, 'branch', value, [branch.range]) : 'unclear';
  },
  'view.folds': (reading, value) => {
    const plane = readFolds(value, reading.table.parameters);
    return plane ? looked(reading, 'folds', value, [plane.x, plane.y]) : 'unclear';
  },
  story: ({ state }, value) => {
    const [name, step = '0'] = value.split(',');
    if (!/^[\w.-]+$/.test(name) || !/^\d{1,3}$/.test(step)) return 'unclear';
    state.story = { name, step: Number(step) };
    return null;
  },
  predict: ({ state }, value) => {
    if (value !== '1') return 'unclear';
    state.predict = { guess: null, outcome: null };
    return null;
  },
  pen: ({ drawn }, value) => {
    const stroke = strokeOf(value);
    if (!stroke) return 'unclear';
    if (drawn.length >= mostStrokes) return 'refused';
    drawn.push(stroke);
    return null;
  },
  big: ({ state }, value) => {
    if (value !== '1') return 'unclear';
    state.isBig = true;
    return null;
  },
};

/** What besides the lenses can be shown otherwise, and whether it can be so. @type {Readonly<Record<string, (value: string, table: Table) => boolean>>} */
const viewed = {
  timeline: (value, { state }) => state.some(({ name }) => name === value),
  magnification: (value) => magnifications.some((factor) => String(factor) === value),
  mode: isMode,
  besideSort: isSorting,
  histories: isHistories,
  casesSort: isSorting,
  cycleOrbit: isOrbit,
  gapBelow: (value) => gapBelowOf(value) === value,
  gapMap: (value, { parameters }) => value !== gapParameter && parameters.some(({ name }) => name === value),
  branchSweep: (value) => value === 'on' || value === 'off',
  cycleTable: (value) => tableNumbers.includes(value),
  cycleTableSort: isSorting,
  methodsBelow: (value) => methodsBelowOf(value) === value,
  landingRoll: (value) => readRoll(value) !== null,
  landingSort: isSorting,
  methodsSort: isSorting,
  damperModel: isDamper,
  damperMap: isCalmAcross,
  damperPush: isPush,
  damperTable: isDamperTable,
  damperTableSort: isSorting,
  damperMotion: isMotion,
  damperCurrents: isCurrents,
  damperCurrent: (value) => !value.includes(',') && isCurrents(value),
};

/**
 * What a link says of a story, held against the stories there are: one that is not known is left out, one that ends
 * earlier is at its end.
 * @param {State['story']} story
 * @param {readonly { name: string, isReady: boolean, steps: readonly unknown[] }[]} stories
 * @returns {{ story: State['story'], problem: Problem | null }}
 */
export function storyIn(story, stories) {
  if (!story) return { story, problem: null };
  const { name, step } = story;
  const known = stories.find((one) => one.name === name && one.isReady);
  if (!known) return { story: null, problem: { key: 'story', value: name, reason: 'unknown-story' } };
  const last = known.steps.length - 1;
  if (step <= last) return { story, problem: null };
  return { story: { name, step: last }, problem: { key: 'story', value: `${name},${step}`, reason: 'story-ends' } };
}

/**
 * What is seen over ranges of parameters, whose ends the engine must take.
 * @param {Reading} reading @param {string} of @param {string} value @param {{ parameter: string, from: number, to: number }[]} ranges
 * @returns {Problem['reason'] | null}
 */
function looked(reading, of, value, ranges) {
  const ends = /** @type {const} */ (['from', 'to']);
  if (!ends.every((end) => accepted(reading, Object.fromEntries(ranges.map((range) => [range.parameter, range[end]])), {}))) return 'refused';
  reading.state.views = { ...reading.state.views, [of]: value };
  return null;
}

/**
 * Takes one pair into the reading, or says why it cannot.
 * @param {Reading} reading
 * @param {string} key
 * @param {string} value
 * @returns {Problem['reason'] | null}
 */
function readPair(reading, key, value) {
  const { state, run, table } = reading;
  if (Object.hasOwn(readers, key)) return readers[key](reading, value);
  if (/^view\.[\w-]+$/.test(key)) {
    const of = key.slice(5);
    const isShown = (Object.hasOwn(viewed, of) && viewed[of]) || (lenses.some(({ name }) => name === of) ? () => hasView(of, value) : null);
    if (!isShown) return 'unknown';
    if (!/^[\w.,-]{1,60}$/.test(value) || !isShown(value, table)) return 'unclear';
    state.views = { ...state.views, [of]: value };
    return null;
  }
  const [, prefix, name] = key.match(/^(was\.|initial\.)?(.*)$/) ?? [];
  const number = numberOf(value);
  const isParameter = prefix !== 'initial.' && table.parameters.some((parameter) => parameter.name === name);
  const isState = prefix === 'initial.' && table.state.some((variable) => variable.name === name);
  if (!isParameter && !isState) return 'unknown';
  if (!Number.isFinite(number)) return notFinite(number);
  if (!accepted(reading, isParameter ? { [name]: number } : {}, isState ? { [name]: number } : {})) return 'refused';
  if (isState && name === 'torsionAngle' && Math.abs(number) > widestStart) return 'too-large';
  (isState ? run.initial : prefix ? run.start : state.parameters)[name] = number;
  return null;
}

/**
 * `0.35,dampingConstant:60,state.torsionAngle:0.2,kick:10`
 * @param {string} text @param {Reading} reading
 * @returns {Change | null}
 */
function changeOf(text, reading) {
  const [when, ...what] = text.split(',');
  const time = numberOf(when);
  const parts = partsOf(what, reading.table);
  if (!(time >= 0 && time <= longestRun) || !parts || what.length === 0) return null;
  const { values, state, kick } = parts;
  if (!accepted(reading, values, state)) return null;
  return {
    time,
    ...(Object.keys(values).length > 0 && { set: values }), ...(Object.keys(state).length > 0 && { state }), ...(kick !== undefined && { kick }),
  };
}

/**
 * `0.35,torsional,velocity:80,state.torsionAngle:0.2`
 * @param {string} text @param {Reading} reading
 * @returns {State['ghosts'][number] | null}
 */
function ghostOf(text, { models, accepts }) {
  const [when, model, ...what] = text.split(',');
  const table = models.find(({ name }) => name === model);
  const from = numberOf(when);
  const parts = table && partsOf(what, table);
  if (!table || !parts || parts.kick !== undefined || !(from >= 0)) return null;
  const parameters = { ...blank(table).parameters, ...parts.values };
  return accepts({ model, parameters, initial: parts.state }) ? { object: model, parameters, initial: parts.state, from } : null;
}

/**
 * @param {string[]} parts `name:value` each
 * @param {Table} table
 */
function partsOf(parts, table) {
  /** @type {{ values: Record<string, number>, state: Record<string, number>, kick?: number }} */
  const read = { values: {}, state: {} };
  for (const part of parts) {
    const [key, value = ''] = part.split(':');
    const number = numberOf(value);
    if (!Number.isFinite(number)) return null;
    if (key === 'kick') read.kick = number;
    else if (table.parameters.some(({ name }) => name === key)) read.values[key] = number;
    else if (table.state.some(({ name }) => `state.${name}` === key)) read.state[key.slice(6)] = number;
    else return null;
  }
  return read;
}

/** @param {Reading} reading @param {Record<string, number>} parameters @param {Record<string, number>} initial */
function accepted({ accepts, table }, parameters, initial) {
  return accepts({ model: table.name, parameters, initial });
}

/** @param {string} text */
function numberOf(text) {
  return text.trim() === '' ? NaN : Number(text);
}

/** @param {number} number */
function notFinite(number) {
  return Number.isNaN(number) ? 'not-a-number' : 'too-large';
}
