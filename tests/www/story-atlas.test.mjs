// Every figure from 5.59 to 6.24 opens as what it is, and has its title in both languages.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { lenses } from '../../www/lens/lenses.js';
import { figuresOf } from '../../www/story/atlas.js';
import { figureTitle, lookOf, titleOf } from '../../www/story/title.js';
import { voiceOf } from '../../www/words/voice.js';
import { engine, openedApp, sessionOf } from './stories.mjs';

const entries = engine.atlas();
const figures = figuresOf(entries);
const [english, turkish] = [voiceOf('en'), voiceOf('tr')];

/** Whether a figure is one of 5.59 … 6.24. @param {string} id */
const isOurs = (id) => {
  const [, chapter, number] = id.match(/^Figure (\d)\.(\d+)/)?.map(Number) ?? [];
  return (chapter === 5 && number >= 59) || (chapter === 6 && number <= 24);
};
const ours = figures.filter(({ entry }) => entry && isOurs(entry.id));

test('the atlas is whole: 283 figures and tables, 153 of them for this page', () => {
  assert.equal(figures.length, 283);
  assert.equal(new Set(figures.map(({ name }) => name)).size, 283);
  assert.equal(ours.length, 153);
});

test('each of the 153 can be opened where its lens is there; nothing that needs more can', () => {
  const hasForces = lenses.some(({ name, ready }) => name === 'forces' && ready);
  for (const { name, entry, isReady } of ours) assert.equal(isReady, entry?.view === 'freeplay-law' ? hasForces : true, name);
  for (const { entry, isReady, name } of figures) if (!ours.some((one) => one.name === name)) assert.ok(!isReady, `${name} ${entry?.view}`);
});

test('each opens with the object, values and start of its figure, seen as the figure shows it', () => {
  const app = openedApp();
  const tables = engine.models();
  for (const { name, entry, isReady } of ours) {
    if (!isReady || !entry?.run) continue;
    app.run('open', name);
    const { object, parameters, run, lens, views, story, links } = app.state;
    const number = Number(entry.id.match(/\.(\d+)/)?.[1]);
    const isLinear = entry.id.startsWith('Figure 5') && number <= 86;
    assert.equal(object, isLinear ? 'torsional-linear' : 'torsional', name);
    const usual = tables.find((table) => table.name === object)?.parameters ?? [];
    assert.deepEqual(parameters, { ...Object.fromEntries(usual.map((one) => [one.name, one.default])), ...entry.run.parameters }, name);
    assert.deepEqual(run, { initial: entry.run.initial }, name);
    assert.deepEqual(story, { name, step: 0 });
    assert.equal(lens, 'phase');
    const shown = { 'time-history': { timeline: entry.show?.[0] }, 'phase-2d': { phase: 'portrait' }, 'phase-3d': { phase: 'orbit' } }[entry.view];
    assert.deepEqual(views, shown, name);
    assert.deepEqual(links, { relaxationLength: true, treadWidthMomentConstant: true }, name);
    const { from, to } = sessionOf(app).scene({ moment: [-0.08, 0.02], trackLength: 1.2, stretches: 60, exposure: 0, duration: app.duration }).run;
    assert.ok(to - from >= (entry.run.duration ?? NaN), `${name}: ${to} s`);
    assert.equal(sessionOf(app).failure, null, name);
  }
});

test('a figure whose values keep no relation opens with the link off', () => {
  const app = openedApp();
  const [figure] = figuresOf([{ id: 'Figure 5.59', title: 'torsion angle', view: 'time-history', run: { model: 'torsional', parameters: { relaxationLength: 0.12 }, initial: { torsionAngle: 0.01 } }, show: ['torsionAngle'] }]);
  app.stories = [figure];
  app.run('open', 'figure-5.59');
  assert.deepEqual(app.state.links, { relaxationLength: false, treadWidthMomentConstant: true });
});

test('all titles are said in both languages, with every number of the atlas', () => {
  const numbersIn = (/** @type {string} */ text) => text.replaceAll(/(?<=\d) (?=\d{3})|\u202f/g, '').replaceAll(/(?<=\d),(?=\d)/g, '.').match(/\d+(\.\d+)?/g)?.map(Number).sort() ?? [];
  const left = /\b(with|the|linear|nonlinear|freeplay|torsionAngle|lateralDeformation|limit cycle|stability|effect|of)\b/i;
  for (const story of figures) {
    const { entry } = story;
    assert.ok(entry);
    const [en, tr] = [figureTitle(entry, english), figureTitle(entry, turkish)];
    assert.notEqual(en, tr, entry.id);
    // Two tables are called "the same"; they name what of. Table 5.x say in words what the atlas says in figures.
    if (!entry.id.startsWith('Table')) {
      assert.deepEqual(numbersIn(en), numbersIn(entry.title), entry.id);
      assert.deepEqual(numbersIn(tr), numbersIn(entry.title), entry.id);
    }
    assert.doesNotMatch(tr.replaceAll('Limit çevrim', ''), left, tr);
    assert.doesNotMatch(en + tr, /torsionAngle|lateralDeformation|psi|sigma|undefined|[{}]/, entry.id);
  }
});

test('titles read as a person would write them', () => {
  const told = (/** @type {string} */ name) => {
    const story = figures.find((one) => one.name === name);
    assert.ok(story?.entry);
    return [english, turkish].map((voice) => `${titleOf(story, voice)}: ${figureTitle(/** @type {NonNullable<typeof story.entry>} */ (story.entry), voice)}; ${lookOf(/** @type {NonNullable<typeof story.entry>} */ (story.entry), voice)}`.replaceAll('\u00a0', ' '));
  };
  assert.deepEqual(told('figure-5.88a'), [
    'Figure 5.88a: Limit cycle, v = 30 m/s, c = 10 N m s/rad, ψ(0) = 0.01; orbit in space',
    'Şekil 5.88a: Limit çevrim, v = 30 m/s, c = 10 N m s/rad, ψ(0) = 0,01; uzayda yörünge',
  ]);
  assert.deepEqual(told('figure-6.18'), [
    'Figure 6.18: Lateral tire deformation with freeplay 0.5°, v = 50 m/s, c = 100, ψ(0) = 0.1; y over time',
    'Şekil 6.18: Lastiğin yanal şekil değişimi, 0,5° boşlukla, v = 50 m/s, c = 100, ψ(0) = 0,1; zamana karşı y',
  ]);
  assert.deepEqual(told('table-6.4'), [
    'Table 6.4: Effect of freeplay on the lateral deformation, ψ(0) = 0.1; ',
    'Tablo 6.4: Boşluğun yanal şekil değişimine etkisi, ψ(0) = 0,1; ',
  ]);
});

test('a title that is not known stays as the atlas has it', () => {
  const entry = { id: 'Figure 9.9', title: 'a new thing, v = 3 m/s', view: 'other' };
  assert.equal(figureTitle(entry, turkish), entry.title);
});
