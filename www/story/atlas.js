/**
 * The figures and tables of the thesis as stories of one step: the run of the figure, seen as the figure shows it. What
 * this page cannot open yet is a story, too, but not `isReady`.
 *
 * @typedef {import('./story.js').AtlasEntry} AtlasEntry
 * @typedef {import('./story.js').Story} Story
 * @typedef {import('./story.js').Setting} Setting
 */

import { lenses } from '../lens/lenses.js';
import { isReady } from '../object/objects.js';

/** What of a run the page can set; a run with more (a damper, a landing) is not its yet. */
const known = ['model', 'parameters', 'initial', 'duration'];

/** How the kinds of figures are looked at. @type {Readonly<Record<string, (entry: AtlasEntry) => Pick<Setting, 'lens' | 'views'>>>} */
const looks = {
  'time-history': ({ show }) => ({ lens: 'phase', views: { timeline: show?.[0] ?? 'torsionAngle' } }),
  'phase-2d': () => ({ lens: 'phase', views: { phase: 'portrait' } }),
  'phase-3d': () => ({ lens: 'phase', views: { phase: 'orbit' } }),
  'freeplay-law': () => ({ lens: 'forces', views: { forces: 'restoringMoment' } }),
};

/** The law of the freeplay has no run: a gear that rattles shows it. @type {NonNullable<AtlasEntry['run']>} */
const rattling = {
  model: 'torsional', parameters: { velocity: 50, dampingConstant: 100, freeplayAngle: Math.PI / 180 }, initial: { torsionAngle: 0.05 },
};

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
  const run = entry.view === 'freeplay-law' ? rattling : entry.run;
  const look = Object.hasOwn(looks, entry.view) ? looks[entry.view](entry) : null;
  if (!run || !look || !isReady(run.model) || Object.keys(run).some((key) => !known.includes(key)))
    return { name, kind: 'figure', entry, isReady: false, steps: [] };
  const { model, parameters, initial, duration } = run;
  return {
    name, kind: 'figure', entry,
    isReady: lenses.some((lens) => lens.name === look.lens && lens.ready),
    steps: [{ state: { object: model, parameters: parameters ?? {}, initial: initial ?? {}, duration: duration ?? undefined, ...look } }],
  };
}
