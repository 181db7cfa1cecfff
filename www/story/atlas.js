/**
 * The figures and tables of the thesis as stories of one step: the run of the figure, seen as the figure shows it. What
 * this page cannot open yet is a story, too, but not `isReady`.
 *
 * @typedef {import('./story.js').AtlasEntry} AtlasEntry
 * @typedef {import('./story.js').Story} Story
 * @typedef {import('./story.js').Setting} Setting
 */

import { tableNumbers, thesisTables } from '../lens/cycles/thesis-tables.js';
import { damperTableNumbers, damperTables } from '../lens/damper/thesis-tables.js';
import { lenses } from '../lens/lenses.js';
import { readyBesides } from '../lens/stability/beside-settings.js';
import { thesisLocus, writePlane } from '../lens/stability/settings.js';
import { fitted, fittingsOf } from '../object/fittings.js';
import { isReady } from '../object/objects.js';
import { landingOf } from './landings.js';

/** What of a run the page can set; a run with more (a landing) is not its yet. */
const known = ['model', 'parameters', 'initial', 'duration'];

/**
 * How the kinds of figures are looked at; undefined where this page cannot yet.
 * @type {Readonly<Record<string, (entry: AtlasEntry) => Pick<Setting, 'lens' | 'views' | 'drawer'> | undefined>>}
 */
const looks = {
  'time-history': ({ id, show, run }) => {
    const state = show?.[0] ?? 'torsionAngle';
    const cycles = besideCycles(id);
    if (cycles) return { lens: 'cycles', views: { ...cycles, timeline: state } };
    // What linear theory says is seen beside the gear in full.
    const isLinear = run?.model === 'torsional-linear';
    return isLinear ? { lens: 'stability', views: linearViews(state) } : { lens: 'phase', views: { timeline: state } };
  },
  'phase-2d': () => ({ lens: 'cycles', views: { cycles: 'cycle', cycleOrbit: 'portrait' } }),
  'phase-3d': () => ({ lens: 'cycles', views: { cycles: 'cycle', cycleOrbit: 'space' } }),
  'freeplay-law': () => ({ lens: 'cycles', views: { cycles: 'freeplay', gapBelow: 'law' } }),
  'root-locus': () => ({ lens: 'stability', views: { stability: 'locus', locus: thesisLocus } }),
  'stability-map': ({ map }) => ({ lens: 'stability', views: { stability: 'plane', plane: writePlane({ x: map?.x, y: map?.y, coloring: 'stable' }) } }),
  'damper-loops': ({ damper }) => ({ lens: 'damper', views: { damper: 'loops', damperModel: String(damper) } }),
  table: ({ id }) => tables[id.split(' ')[1]],
};

/**
 * What stands beside the time histories of cycles and of what has none, which the timeline shows: the branch over what their
 * figures vary, the map over the gap. Undefined for others.
 * @param {string} id @returns {Record<string, string> | undefined}
 */
function besideCycles(id) {
  const [, chapter, number] = id.match(/^Figure (\d)\.(\d+)/)?.map(Number) ?? [];
  if (chapter === 6) return { cycles: 'freeplay' };
  if (chapter !== 5 || number < 87) return undefined;
  const isOverDamping = number === 87 || (number >= 100 && number <= 105);
  return { cycles: 'branch', branch: isOverDamping ? 'dampingConstant:0:100,torsionAngle' : 'velocity:1:120,torsionAngle' };
}

/** @param {string} state @returns {Record<string, string>} */
const linearViews = (state) => ({ stability: 'histories', histories: state, timeline: state });

/** How tables are looked at, by their numbers. @type {Readonly<Record<string, Pick<Setting, 'lens' | 'views' | 'drawer'>>>} */
const tables = {
  5.1: { drawer: true },
  ...Object.fromEntries(readyBesides.filter(({ table }) => table).map(({ table, text }) => [table, { lens: 'stability', views: { stability: 'beside', beside: text } }])),
  5.7: { lens: 'stability', views: { stability: 'histories' } },
  ...Object.fromEntries(tableNumbers.map((number) => [number, { lens: 'cycles', views: { cycles: 'tables', cycleTable: number } }])),
  ...Object.fromEntries(damperTableNumbers.map((number) => [number, { lens: 'damper', views: { damper: 'tables', damperTable: number } }])),
};

/** The law of the freeplay has no run: a gear that rattles shows it. @type {NonNullable<AtlasEntry['run']>} */
const rattling = {
  model: 'torsional', parameters: { velocity: 50, dampingConstant: 100, freeplayAngle: Math.PI / 180 }, initial: { torsionAngle: 0.05 },
};

/**
 * What has no run of its own has one that shows it: a law a gear that rattles; a table of cycles the first of its gears that
 * swings, one of dampers the first of its gears; a plane, another table or a damper by itself the gear of the thesis, touched.
 * @param {AtlasEntry} entry
 * @returns {AtlasEntry['run']}
 */
function runOf({ id, view, run, map }) {
  if (view === 'freeplay-law') return rattling;
  const table = thesisTables[id.split(' ')[1]];
  if (view === 'table' && table) return firstOf(table);
  const damped = damperTables[id.split(' ')[1]];
  if (view === 'table' && damped) return withDamper({ model: 'torsional', parameters: { ...damped.fixed, ...damped.rows[0] }, initial: { torsionAngle: damped.start }, damper: { model: thesisDamper } });
  return map || view === 'table' || view === 'damper-loops' ? { model: 'torsional', parameters: map?.parameters, initial: { torsionAngle: 0.01 } } : run && withDamper(run);
}

/** The damper that the thesis puts on the gear. */
const thesisDamper = 'current-dependent-bouc-wen';

/** A gear with a damper is one object of the page, and the damper's values are among its own. @param {NonNullable<AtlasEntry['run']>} run */
function withDamper({ damper, ...run }) {
  if (!damper) return run;
  const { model, leverArm, command, parameters = {} } = damper;
  const own = Object.entries(/** @type {Record<string, number>} */ (parameters ?? {})).map(([name, value]) => [`damper.parameters.${name}`, value]);
  const values = { ...run.parameters, ...(leverArm && { 'damper.leverArm': leverArm }), ...(command !== undefined && command !== null && { 'damper.command': command }), ...Object.fromEntries(own) };
  return { ...run, model: fitted(run.model, { damper: model }), parameters: values };
}

/** Without a gap the gears of chapter 6 are calm. @param {import('../lens/cycles/thesis-tables.js').ThesisTable} table @returns {NonNullable<AtlasEntry['run']>} */
function firstOf({ start, fixed, rows }) {
  const first = rows.find(({ freeplayAngle = 1 }) => freeplayAngle > 0) ?? rows[0];
  return { model: 'torsional', parameters: { ...fixed, ...first }, initial: { torsionAngle: start } };
}

/** @param {readonly AtlasEntry[]} entries @returns {Story[]} in the order of the thesis, a chapter's tables after its figures */
export function figuresOf(entries) {
  return entries.map(figureOf).sort((one, other) => (placeOf(one.name) < placeOf(other.name) ? -1 : 1));
}

/** `figure-5.88a` stands at `5 figure 088a`. @param {string} name */
function placeOf(name) {
  const [, kind, chapter, number, part] = name.match(/^(\w+)-(\w+)\.(\d+)(\w*)$/) ?? [];
  return number ? `${chapter} ${kind} ${number.padStart(3, '0')}${part}` : name;
}

/** @param {AtlasEntry} entry @returns {Story} */
function figureOf(entry) {
  const name = entry.id.toLowerCase().replace(' ', '-');
  const landing = landingOf(entry);
  if (landing) return { name, kind: 'figure', entry, isReady: lenses.some((lens) => lens.name === landing.lens && lens.ready), steps: [{ state: landing }] };
  const run = runOf(entry);
  const look = Object.hasOwn(looks, entry.view) ? looks[entry.view](entry) : undefined;
  if (!run || !look || !isReady(fittingsOf(run.model).gear) || Object.keys(run).some((key) => !known.includes(key)))
    return { name, kind: 'figure', entry, isReady: false, steps: [] };
  const { model, parameters, initial, duration } = run;
  return {
    name, kind: 'figure', entry,
    isReady: lenses.some((lens) => lens.name === (look.lens ?? lenses[0].name) && lens.ready),
    steps: [{ state: { object: model, parameters: parameters ?? {}, initial: initial ?? {}, duration: duration ?? undefined, ...look } }],
  };
}
