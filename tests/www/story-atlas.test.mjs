// Every figure from 5.5 to 6.24 and tables 5.1 to 6.5 open as what they are, with their titles in both languages.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { modelsOf } from '../../www/engine/models.js';
import { tableNumbers, thesisTables } from '../../www/lens/cycles/thesis-tables.js';
import { cases } from '../../www/lens/landing/cases.js';
import { lenses } from '../../www/lens/lenses.js';
import { besideOf, planesOf } from '../../www/lens/stability/beside-settings.js';
import { locusOf, planeOf } from '../../www/lens/stability/settings.js';
import { figuresOf } from '../../www/story/atlas.js';
import { figureTitle, lookOf, titleOf } from '../../www/story/title.js';
import { voiceOf } from '../../www/words/voice.js';
import { engine, openedApp, sessionOf } from './stories.mjs';
import { indexOf, search } from '../../www/story/search.js';

const entries = engine.atlas();
const figures = figuresOf(entries);
const [english, turkish] = [voiceOf('en'), voiceOf('tr')];

/** Whether a figure is a motion or a law of 5.59 … 6.24. @param {string} id */
const isOurs = (id) => {
  const [, chapter, number] = id.match(/^Figure (\d)\.(\d+)/)?.map(Number) ?? [];
  return (chapter === 5 && number >= 59) || (chapter === 6 && number <= 24);
};
/** Whether it is of cycles or of the gap, 5.87 … 6.24: then it opens in the lens Cycles. @param {string} id */
const isCycle = (id) => {
  const [, chapter, number] = id.match(/^Figure (\d)\.(\d+)/)?.map(Number) ?? [];
  return chapter === 6 ? number <= 24 : chapter === 5 && number >= 87;
};
const ours = figures.filter(({ entry }) => entry && isOurs(entry.id));

/** Linear theory: figures 5.5 … 5.58 and tables 5.1 … 5.7. @param {string} id */
const isTheory = (id) => {
  const [, kind, number] = id.match(/^(Figure|Table) 5\.(\d+)$/) ?? [];
  return kind === 'Table' ? Number(number) <= 7 : Number(number) >= 5 && Number(number) <= 58;
};
const theory = figures.filter(({ entry }) => entry && isTheory(entry.id));

/** Of cycles: tables 5.8 … 6.5. */
const tabled = figures.filter(({ entry }) => entry && tableNumbers.some((number) => entry.id === `Table ${number}`));

/** Dampers: figures 7.6 … 7.26, tables 7.2 and 7.3. @param {string} id */
const isDamped = (id) => {
  const [, kind, number] = id.match(/^(Figure|Table) 7\.(\d+)$/) ?? [];
  return kind === 'Table' ? [2, 3].includes(Number(number)) : Number(number) >= 6 && Number(number) <= 26;
};
const damped = figures.filter(({ entry }) => entry && isDamped(entry.id));

/** Landings: figures 7.27 … 7.42 and table 7.4. */
const landings = figures.filter(({ entry }) => entry && (entry.view === 'landing-roll' || entry.id === 'Table 7.4'));

test('the atlas is whole: 283 figures and tables, 153 motions and laws, 61 of linear theory and 11 tables of cycles for this page', () => {
  assert.equal(figures.length, 283);
  assert.equal(new Set(figures.map(({ name }) => name)).size, 283);
  assert.equal(ours.length, 153);
  assert.equal(theory.length, 61);
  assert.equal(tabled.length, 11);
});

test('each of them can be opened where its lens is there; nothing that needs more can', () => {
  const has = (/** @type {string} */ lens) => lenses.some(({ name, ready }) => name === lens && ready);
  for (const { name, entry, isReady } of ours) assert.equal(isReady, isCycle(entry?.id ?? '') ? has('cycles') : true, name);
  for (const { name, isReady } of theory) assert.equal(isReady, name === 'table-5.1' || has('stability'), name);
  for (const { name, isReady } of tabled) assert.equal(isReady, has('cycles'), name);
  for (const { name, isReady } of damped) assert.ok(isReady, name);
  for (const { name, isReady } of landings) assert.equal(isReady, has('landing'), name);
  for (const { entry, isReady, name } of figures) if (![...ours, ...theory, ...tabled, ...damped, ...landings].some((one) => one.name === name)) assert.ok(!isReady, `${name} ${entry?.view}`);
});

test('each figure of a damper opens with that damper, its current and its gap, and its link opens the same', () => {
  assert.equal(damped.length, 23);
  const app = openedApp();
  for (const { name, entry } of damped) {
    app.run('open', name);
    const { state } = app;
    if (entry?.view === 'damper-loops') assert.deepEqual([state.lens, state.views.damper, state.views.damperModel], ['damper', 'loops', entry.damper], name);
    else if (entry?.view === 'table') assert.deepEqual([state.lens, state.views.damperTable], ['damper', entry.id.slice(6)], name);
    else {
      const [, velocity, current] = entry?.title.match(/v = (\d+) m\/s, ([\d.]+) A/)?.map(Number) ?? [];
      const gap = Number(entry?.title.match(/freeplay ([\d.]+) deg/)?.[1] ?? 0);
      assert.equal(state.object, 'torsional.current-dependent-bouc-wen', name);
      assert.deepEqual([state.parameters.velocity, state.parameters['damper.command'], state.parameters['damper.leverArm'], state.run.initial.torsionAngle], [velocity, current, 0.1, 0.01], name);
      assert.ok(Math.abs(state.parameters.freeplayAngle - (gap * Math.PI) / 180) < 1e-12, name);
    }
    assert.equal(app.session?.failure, null, name);
    const again = openedApp(app.link);
    assert.deepEqual([again.state.object, again.state.parameters, again.state.views, again.state.lens], [state.object, state.parameters, state.views, state.lens], name);
  }
});

test('each landing opens on its damping and current under the lens Landing, and its link opens the same', () => {
  assert.equal(landings.length, 17);
  const app = openedApp();
  for (const { name, entry } of landings) {
    app.run('open', name);
    const { state } = app;
    assert.deepEqual([state.lens, state.clock.mode, state.views.landing], ['landing', 'strobe', entry?.view === 'table' ? 'table' : 'roll'], name);
    const [, damping, current] = entry?.title.match(/c = (\d+), ([\d.]+) A/)?.map(Number) ?? [0, 20, 0];
    assert.deepEqual([state.parameters.dampingConstant, state.parameters['damper.command'], state.parameters['damper.leverArm']], [damping, current, 0.1], name);
    assert.equal(state.views.landingRoll, '80,3,5,0,0.01');
    assert.equal(cases.some(({ figure, dampingConstant, current: amperes }) => figure === name && dampingConstant === damping && amperes === current), entry?.view !== 'table');
    const again = openedApp(app.link);
    assert.deepEqual([again.state.object, again.state.parameters, again.state.views], [state.object, state.parameters, state.views], name);
  }
});

test('each plane opens on the gear and the ranges of its figure, and its link opens the same', () => {
  const app = openedApp();
  const usual = modelsOf(engine)[0].parameters;
  for (const { name, entry } of theory) {
    if (entry?.view !== 'stability-map') continue;
    app.run('open', name);
    const { object, parameters, lens, views } = app.state;
    assert.equal(object, 'torsional', name);
    assert.deepEqual(parameters, { ...Object.fromEntries(usual.map((one) => [one.name, one.default])), ...entry.map?.parameters }, name);
    assert.deepEqual([lens, views.stability], ['stability', 'plane']);
    const { x, y } = planeOf(views.plane, usual);
    for (const [side, wanted] of [[x, entry.map?.x], [y, entry.map?.y]]) assert.deepEqual(side, { parameter: wanted.parameter, from: wanted.from, to: wanted.to }, name);
    // Where σ or κ are not what a, F_z and c_Fα give they stay as the thesis has them.
    assert.equal(app.state.links.relaxationLength, Math.abs(parameters.relaxationLength / 3 - parameters.halfContactLength) < 1e-12, name);
    const again = openedApp(app.link);
    assert.deepEqual([again.notes, again.state.views, again.state.parameters, again.state.story], [[], views, parameters, { name, step: 0 }], name);
  }
});

test('figure 5.5 opens on its loci, the tables on their planes, their cases and their values', () => {
  const app = openedApp();
  app.run('open', 'figure-5.5');
  assert.deepEqual([app.state.object, app.state.lens, app.state.views.stability], ['torsional-linear', 'stability', 'locus']);
  const { sweep, family } = locusOf(app.state.views.locus, engine.models()[0].parameters);
  assert.deepEqual([sweep.parameter, family?.parameter].sort(), theory[0].entry?.vary.toSorted());
  /** @type {[string, string[], number][]} */
  const tables = [
    ['5.2', ['casterLength', 'torsionalStiffness'], 3], ['5.3', ['dampingConstant', 'relaxationLength'], 7], ['5.4', ['dampingConstant', 'verticalForce'], 3],
    ['5.5', ['casterLength', 'halfContactLength', 'torsionalStiffness'], 12], ['5.6', ['dampingConstant', 'casterLength', 'relaxationLength'], 28],
  ];
  for (const [number, names, count] of tables) {
    app.run('open', `table-${number}`);
    assert.deepEqual([app.state.lens, app.state.views.stability, app.isDrawerOpen], ['stability', 'beside', false]);
    const beside = besideOf(app.state.views.beside, engine.models()[0].parameters);
    assert.deepEqual([beside?.x.parameter, beside?.y.parameter, ...(beside?.lists ?? []).map(({ parameter }) => parameter)], ['velocity', ...names], number);
    assert.equal(beside && planesOf(beside).length, count);
    const again = openedApp(app.link);
    assert.deepEqual([again.notes, again.state.views, again.state.story], [[], app.state.views, { name: `table-${number}`, step: 0 }]);
  }
  app.run('open', 'table-5.7');
  assert.deepEqual(app.state.views, { stability: 'histories' });
  app.run('open', 'table-5.1');
  assert.ok(app.isDrawerOpen);
  assert.ok(openedApp(app.link).isDrawerOpen, 'shared as a link it opens on the values, too');
  app.run('open', 'figure-5.6');
  assert.ok(!app.isDrawerOpen);
  assert.ok(!openedApp(app.link).isDrawerOpen);
});

test('each table of cycles opens on the first of its gears that swings, and its link opens the same', () => {
  const app = openedApp();
  const usual = Object.fromEntries(engine.models()[0].parameters.map((one) => [one.name, one.default]));
  for (const { name, entry } of tabled) {
    app.run('open', name);
    const { parameters, run, lens, views } = app.state;
    const number = entry?.id.split(' ')[1] ?? '';
    assert.deepEqual([lens, views], ['cycles', { cycles: 'tables', cycleTable: number }]);
    const { start, fixed, rows } = thesisTables[number];
    assert.ok(rows.some((row) => Object.entries({ ...usual, ...fixed, ...row }).every(([key, value]) => parameters[key] === value)), `${name}: a gear of the table`);
    assert.deepEqual(run, { initial: { torsionAngle: start } });
    assert.ok(['shimmies', 'rattles'].includes(sessionOf(app).outlook.verdict), name);
    const again = openedApp(app.link);
    assert.deepEqual([again.notes, again.state.views, again.state.parameters, again.state.story], [[], views, parameters, { name, step: 0 }], name);
  }
});

test('the rows of the tables are the gears of the thesis’ figures', () => {
  const gears = (/** @type {string} */ title) => new Set(entries.filter(({ id, title: one }) => /^Figure [56]/.test(id) && one.startsWith(title)).map(({ run }) => JSON.stringify(run)));
  const rowOf = (/** @type {string} */ number, /** @type {number} */ i) => ({ ...thesisTables[number].fixed, ...thesisTables[number].rows[i] });
  const isThere = (/** @type {Record<string, number>} */ values, /** @type {number} */ start, /** @type {string} */ title) => [...gears(title)].some((text) => {
    const { parameters, initial } = JSON.parse(text);
    return initial.torsionAngle === start && Object.entries({ torsionalStiffness: 100_000, freeplayAngle: 0, ...values }).every(([key, value]) => ({ torsionalStiffness: 100_000, freeplayAngle: 0, ...parameters })[key] === value);
  });
  for (const [number, title] of [['5.8', 'limit cycle'], ['5.10', 'limit cycle'], ['5.12', 'limit cycle'], ['5.13', 'limit cycle'], ['6.1', 'torsionAngle with'], ['6.2', 'torsionAngle with'], ['6.3', 'lateralDeformation with'], ['6.4', 'lateralDeformation with'], ['6.5', 'limit cycle with']])
    thesisTables[number].rows.forEach((_, i) => assert.ok(isThere(rowOf(number, i), thesisTables[number].start, title), `${number} ${JSON.stringify(rowOf(number, i))}`));
});

test('they are found by their number and by their words, in both languages', () => {
  const index = indexOf(figures, [english, turkish]);
  const found = (/** @type {string} */ query) => search(index, query).map(({ story }) => story.name);
  assert.deepEqual(found('figure 5.31'), ['figure-5.31']);
  assert.ok(found('table 5.6').includes('table-5.6') && found('tablo 5.6').includes('table-5.6'));
  assert.ok(found('stability sigma 0.02').includes('figure-5.9') || found('stability 0.02').includes('figure-5.9'));
  for (const query of ['floquet table', 'limit cycle 5.12', 'limit çevrim 5.12']) assert.ok(found(query).includes('table-5.12'), query);
  assert.ok(found('kararlılık').includes('figure-5.6'));
  for (const query of ['root locus', 'kök yer eğrisi', 'eigenvalue', 'özdeğer']) assert.ok(found(query).includes('figure-5.5'), query);
  for (const query of ['routh', 'Routh-Hurwitz', 'eigenvalue', 'hopf']) assert.ok(found(query).includes('figure-5.6') && found(query).includes('table-5.6'), query);
  assert.ok(found('eigenvalue').includes('figure-5.59') && found('özdeğer').includes('table-5.7'));
});

test('each opens with the object, values and start of its figure, seen as the figure shows it', () => {
  const app = openedApp();
  const tables = modelsOf(engine);
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
    assert.equal(lens, isLinear ? 'stability' : isCycle(entry.id) ? 'cycles' : 'phase');
    const over = number === 87 || (number >= 100 && number <= 105) ? 'dampingConstant:0:100,torsionAngle' : 'velocity:1:120,torsionAngle';
    const beside = isLinear ? { stability: 'histories', histories: entry.show?.[0] } : !isCycle(entry.id) ? {} : entry.id.startsWith('Figure 6') ? { cycles: 'freeplay' } : { cycles: 'branch', branch: over };
    const cycle = (/** @type {string} */ cycleOrbit) => ({ cycles: 'cycle', cycleOrbit });
    const shown = { 'time-history': { timeline: entry.show?.[0], ...beside }, 'phase-2d': cycle('portrait'), 'phase-3d': cycle('space') }[entry.view];
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
    assert.doesNotMatch(en + tr, /_|torsionAngle|lateralDeformation|psi|sigma|undefined|[{}]/, entry.id);
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

test('every figure of cycles and of the gap, 5.87 to 6.24, opens in the lens Cycles, and its link opens the same', () => {
  const app = openedApp();
  const cycles = ours.filter(({ entry }) => entry && isCycle(entry.id));
  assert.equal(cycles.length, 125);
  for (const { name, entry } of cycles) {
    app.run('open', name);
    assert.equal(app.state.lens, 'cycles', name);
    if (entry?.view === 'freeplay-law') assert.deepEqual(app.state.views, { cycles: 'freeplay', gapBelow: 'law' });
    const { views, parameters, story } = app.state;
    const again = openedApp(app.link);
    assert.deepEqual([again.notes, again.state.lens, again.state.views, again.state.parameters, again.state.story], [[], 'cycles', views, parameters, story], name);
  }
});
