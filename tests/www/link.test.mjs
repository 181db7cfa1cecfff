import { test } from 'node:test';
import assert from 'node:assert/strict';
import { noteOn } from '../../www/link/note.js';
import { readLink, storyIn, strangersIn } from '../../www/link/read.js';
import { writeLink } from '../../www/link/write.js';
import { mostGhosts } from '../../www/run/ghosts.js';
import { voiceOf } from '../../www/words/voice.js';

const state = [{ name: 'torsionAngle' }, { name: 'torsionRate' }, { name: 'lateralDeformation' }];
const models = [
  { name: 'torsional', parameters: [{ name: 'velocity', default: 50 }, { name: 'dampingConstant', default: 10 }, { name: 'freeplayAngle', default: 0 }], state },
  { name: 'torsional-linear', parameters: [{ name: 'velocity', default: 50 }, { name: 'dampingConstant', default: 10 }], state },
];
/** Stands for the engine's own check: speeds above 0, angles below 10 rad. @type {import('../../www/link/read.js').Accepts} */
const accepts = ({ parameters, initial }) => (parameters.velocity ?? 1) > 0 && Math.abs(initial.torsionAngle ?? 0) < 10;

/** @type {import('../../www/link/read.js').Linked} */
const linked = {
  object: 'torsional',
  parameters: { velocity: 80, dampingConstant: 20, freeplayAngle: 0 },
  run: { initial: { torsionAngle: 0.05 } },
  links: {},
  ghosts: [],
  clock: { mode: 'slow', slow: 25 },
  lens: 'phase',
  views: {},
  story: null,
  predict: null,
  isBig: false,
};
const fresh = { parameters: linked.parameters, changes: [], time: 0 };

test('a link is readable and carries only what differs from the defaults', () => {
  assert.equal(writeLink(linked, fresh, models), '#shimmy=2&velocity=80&dampingConstant=20&initial.torsionAngle=0.05&slow=25');
});

test('what a link carries comes back, to the last bit', () => {
  const odd = { ...linked, parameters: { velocity: 1 / 3, dampingConstant: 1e-300, freeplayAngle: 0.1 + 0.2 } };
  const other = { ...linked, object: 'torsional-linear', parameters: { velocity: 20, dampingConstant: 10 } };
  /** @type {typeof linked} */
  const looked = {
    ...linked, clock: { mode: 'strobe', slow: null }, views: { phase: 'orbit', timeline: 'lateralDeformation' }, story: { name: 'cure', step: 2 },
    links: { relaxationLength: false },
    ghosts: [{ object: 'torsional', parameters: { velocity: 80, dampingConstant: 60, freeplayAngle: 0 }, initial: { torsionAngle: -0.1, lateralDeformation: 1e-3 }, from: 0.25 }],
  };
  for (const one of [linked, odd, other]) {
    const read = readLink(writeLink(one, { ...fresh, parameters: one.parameters }, models), models, accepts);
    assert.deepEqual(read, { state: one, drawn: [], problems: [] });
  }
  const withLink = models.map((table) => ({ ...table, parameters: [...table.parameters, { name: 'relaxationLength', default: 0.3 }] }));
  const read = readLink(writeLink(looked, fresh, withLink), withLink, accepts);
  assert.deepEqual(read?.problems, []);
  for (const key of /** @type {const} */ (['clock', 'views', 'story', 'links'])) assert.deepEqual(read?.state[key], looked[key]);
  assert.deepEqual(read?.state.ghosts, [{ ...looked.ghosts[0], parameters: { ...looked.ghosts[0].parameters, relaxationLength: 0.3 } }]);
});

test('the unit of the speed is carried where it is not the usual one; a link without it leaves it to its reader', () => {
  const text = writeLink({ ...linked, velocityUnit: 'km/h' }, fresh, models);
  assert.match(text, /&view\.velocityUnit=km\/h$/);
  assert.equal(readLink(text, models, accepts)?.state.velocityUnit, 'km/h');
  assert.ok(!('velocityUnit' in (readLink(writeLink({ ...linked, velocityUnit: 'm/s' }, fresh, models), models, accepts)?.state ?? {})));
  assert.deepEqual(readLink('#shimmy=2&view.velocityUnit=furlong', models, accepts)?.problems, [{ key: 'view.velocityUnit', value: 'furlong', reason: 'unknown' }]);
});

test('what was done to the run comes back with its times', () => {
  const changes = [{ time: 0.35, set: { dampingConstant: 20 } }, { time: 0.4, kick: 10 }, { time: 0.5, state: { torsionAngle: 0.2, torsionRate: 0 } }];
  const recipe = { parameters: { ...linked.parameters, dampingConstant: 5 }, changes, time: 0.75 };
  const text = writeLink(linked, recipe, models);
  assert.equal(text, '#shimmy=2&velocity=80&dampingConstant=20&initial.torsionAngle=0.05&was.dampingConstant=5'
    + '&do=0.35,dampingConstant:20&do=0.4,kick:10&do=0.5,state.torsionAngle:0.2,state.torsionRate:0&time=0.75&slow=25');
  const read = readLink(text, models, accepts);
  assert.deepEqual(read?.state.run, { initial: { torsionAngle: 0.05 }, start: { dampingConstant: 5 }, changes, time: 0.75 });
  assert.deepEqual(read?.problems, []);
});

test('a link carries that it is to be guessed first, but no guess and nothing revealed; and a verdict that is big', () => {
  const asked = { ...linked, predict: { guess: /** @type {const} */ ('holds'), outcome: null }, isBig: true };
  const text = writeLink(asked, fresh, models);
  assert.match(text, /&slow=25&predict=1&big=1$/);
  assert.deepEqual(readLink(text, models, accepts)?.state, { ...asked, predict: { guess: null, outcome: null } });
  const outcome = { truth: /** @type {const} */ ('grows'), becomes: /** @type {const} */ ('grows'), amplitude: 0.3 };
  assert.ok(!writeLink({ ...asked, predict: { guess: 'holds', outcome } }, fresh, models).includes('predict'));
  assert.deepEqual(readLink('#shimmy=2&predict=yes&big=2', models, accepts)?.problems.map(({ reason }) => reason), ['unclear', 'unclear']);
});

test('a damaged record is left out, part by part', () => {
  const read = readLink('#shimmy=2&do=x,kick:1&do=0.1&do=0.2,color:3&do=0.3,kick:&do=0.4,velocity:-1&do=0.5,kick:3&time=1e9&ghost=0.1,nose,velocity:3'
    + '&ghost=0.1,torsional,kick:3&view.phase=<b>&story=a b&clock=fast&free=color', models, accepts);
  assert.deepEqual(read?.problems.map(({ key, reason }) => `${key} ${reason}`), ['do unclear', 'do unclear', 'do unclear', 'do unclear', 'do unclear', 'time refused',
    'ghost unclear', 'ghost unclear', 'view.phase unclear', 'story unclear', 'clock unknown', 'free unclear']);
  assert.deepEqual(read?.state.run.changes, [{ time: 0.5, kick: 3 }]);
  assert.equal(read?.state.run.time, 0.5);
});

test('a record out of order is put in order; a change too late, a ghost that cannot be, and one too many are left out', () => {
  const late = readLink('#shimmy=2&do=0.3,kick:3&do=0.1,kick:1&do=121,kick:2&time=0.2', models, accepts);
  assert.deepEqual(late?.state.run.changes, [{ time: 0.1, kick: 1 }, { time: 0.3, kick: 3 }]);
  assert.equal(late?.state.run.time, 0.3, 'it goes as far as its last change');
  assert.deepEqual(late?.problems.map(({ value, reason }) => [value, reason]), [['121,kick:2', 'unclear']]);
  const good = Array.from({ length: mostGhosts }, (_, i) => `&ghost=0,torsional,velocity:${10 + i}`).join('');
  const ghosts = readLink(`#shimmy=2&ghost=-1,torsional,velocity:3&ghost=0,torsional,velocity:-3${good}&ghost=0,torsional,velocity:9`, models, accepts);
  assert.deepEqual(ghosts?.state.ghosts.map(({ parameters }) => parameters.velocity), [10, 11, 12, 13]);
  assert.deepEqual(ghosts?.problems.map(({ value, reason }) => [value, reason]),
    [['-1,torsional,velocity:3', 'unclear'], ['0,torsional,velocity:-3', 'unclear'], ['0,torsional,velocity:9', 'refused']]);
});

test('a lens that there is not is none, and a text too long for an address is read up to there', () => {
  assert.deepEqual(readLink('#shimmy=2&lens=dampers', models, accepts)?.problems, [{ key: 'lens', value: 'dampers', reason: 'unknown' }]);
  const long = readLink(`#shimmy=2&velocity=30&view.story=${'x'.repeat(60_000)}&dampingConstant=40`, models, accepts);
  assert.deepEqual([long?.state.parameters.velocity, long?.state.parameters.dampingConstant], [30, 10]);
  const setting = readLink(`#shimmy=2&view.besideSort=${'x'.repeat(60)},up`, models, accepts);
  assert.deepEqual([setting?.problems.map(({ reason }) => reason), setting?.state.views], [['unclear'], {}]);
});

test('what is shown can be shown so, or the link says that it cannot', () => {
  for (const good of ['phase=orbit', 'phase=orbit,-120,45', 'phase=spectrum-log', 'forces=aligningMoment', 'timeline=torsionRate', 'magnification=20', 'stability=locus', 'plane=velocity:0.5:100,dampingConstant:0:100,frequency', 'damper=identify', 'damperModel=bouc-wen', 'damperMotion=5,1.5', 'damperCurrents=0,0.5,1', 'damperCurrent=0.5', 'damperMap=freeplayAngle', 'damperPush=0.1', 'damperTable=7.3', 'cycles=cycle', 'cycleOrbit=space,-120,45', 'cycleOrbit=deformation'])
    assert.deepEqual(readLink(`#shimmy=2&view.${good}`, models, accepts)?.problems, [], good);
  for (const [bad, reason] of /** @type {const} */ ([
    ['phase=orbt', 'unclear'], ['phase=orbit,left,up', 'unclear'], ['phase=orbit,900,20', 'unclear'], ['phase=portrait,1,2', 'unclear'],
    ['damper=anything', 'unclear'], ['damperModel=oil', 'unclear'], ['damperMotion=5', 'unclear'], ['damperMotion=900,1', 'unclear'], ['damperCurrents=1,,2', 'unclear'], ['damperCurrent=1,2', 'unclear'], ['damperMap=mood', 'unclear'], ['damperPush=7', 'unclear'], ['damperTable=7.9', 'unclear'],
    ['forces=drag', 'unclear'], ['compare=all', 'unclear'], ['stability=v,c', 'unclear'], ['plane=velocity:0:1', 'unclear'], ['timeline=mood', 'unclear'], ['magnification=3', 'unclear'], ['magnification=1e1', 'unclear'],
    ['magnification=-5', 'unclear'], ['color=red', 'unknown'], ['toString=1', 'unknown'],
  ])) {
    const read = readLink(`#shimmy=2&view.${bad}`, models, accepts);
    assert.deepEqual(read?.problems.map((problem) => problem.reason), [reason], bad);
    assert.deepEqual(read?.state.views, {}, bad);
    const key = bad.split('=')[0];
    for (const language of /** @type {const} */ (['en', 'tr'])) assert.ok(noteOn(read?.problems ?? [], voiceOf(language))?.text.includes(`view.${key}`));
  }
});

test('a story that is not known is left out, one that ends earlier is at its end, and both are said', () => {
  const stories = [{ name: 'cure', isReady: true, steps: [1, 2, 3, 4] }, { name: 'later', isReady: false, steps: [1] }];
  assert.deepEqual(storyIn(null, stories), { story: null, problem: null });
  assert.deepEqual(storyIn({ name: 'cure', step: 3 }, stories), { story: { name: 'cure', step: 3 }, problem: null });
  for (const name of ['cures', 'later'])
    assert.deepEqual(storyIn({ name, step: 0 }, stories), { story: null, problem: { key: 'story', value: name, reason: 'unknown-story' } });
  const beyond = storyIn({ name: 'cure', step: 4 }, stories);
  assert.deepEqual(beyond, { story: { name: 'cure', step: 3 }, problem: { key: 'story', value: 'cure,4', reason: 'story-ends' } });
  assert.equal(noteOn(beyond.problem ? [beyond.problem] : [], voiceOf('en'))?.text, 'Not all of the link could be read: story cure,4 (ends before, so it is at its end).');
});

test('a link of version 1 opens as it did', () => {
  const read = readLink('#shimmy=1&velocity=80&dampingConstant=20&initial.torsionAngle=0.05&slow=25', models, accepts);
  assert.deepEqual(read, { state: linked, drawn: [], problems: [] });
});

test('an address without an experiment is none', () => {
  for (const text of ['', '#', '#top', '?utm=1']) assert.equal(readLink(text, models, accepts), null);
});

test('a bad link opens what could be read and lists what could not', () => {
  const read = readLink('#shimmy=1&velocity=-3&dampingConstant=20&freeplayAngle=wide&colour=red&initial.torsionAngle=99'
    + '&initial.torsionRate=2&slow=7&lens=nowhere&dampingConstant=30&initial.velocity=1&%E0%A4%A', models, accepts);
  assert.deepEqual(read?.state, {
    ...linked,
    parameters: { velocity: 50, dampingConstant: 20, freeplayAngle: 0 },
    run: { initial: { torsionRate: 2 } },
    clock: { mode: 'slow', slow: null },
  });
  assert.deepEqual(read?.problems.slice(0, 8).map(({ key, reason }) => [key, reason]), [
    ['velocity', 'refused'], ['freeplayAngle', 'not-a-number'], ['colour', 'unknown'], ['initial.torsionAngle', 'refused'],
    ['slow', 'refused'], ['lens', 'unknown'], ['dampingConstant', 'twice'], ['initial.velocity', 'unknown'],
  ]);
});

test('a link of a newer version says so and is read as far as it goes', () => {
  const read = readLink('#shimmy=9&velocity=70', models, accepts);
  assert.equal(read?.state.parameters.velocity, 70);
  assert.deepEqual(read?.problems, [{ key: 'shimmy', value: '9', reason: 'newer' }]);
  assert.equal(readLink('#shimmy=abc', models, accepts)?.problems[0].reason, 'version');
});

test('a link that lost its version, or is a query, is read and says what it lost', () => {
  for (const text of ['#velocity=40', '?velocity=40']) {
    const read = readLink(text, models, accepts);
    assert.equal(read?.state.parameters.velocity, 40);
    assert.deepEqual(read?.problems, [{ key: 'shimmy', value: '1', reason: 'missing' }]);
  }
});

test('what is left out says what stands instead', () => {
  const read = readLink('#shimmy=1&velocity=1e400&dampingConstant=20&dampingConstant=30&initial.torsionAngle=99', models, accepts);
  assert.deepEqual(read?.problems, [
    { key: 'velocity', value: '1e400', reason: 'too-large', instead: 50 },
    { key: 'dampingConstant', value: '30', reason: 'twice', instead: 20 },
    { key: 'initial.torsionAngle', value: '99', reason: 'refused', instead: 0 },
  ]);
});

test('a run begins no further turned than once around', () => {
  const engineTakesAll = () => true;
  for (const [angle, isTaken] of /** @type {const} */ ([['6.2', true], ['-6.2', true], ['6.3', false], ['1e9', false], ['-1e9', false]])) {
    const read = readLink(`#shimmy=2&initial.torsionAngle=${angle}`, models, engineTakesAll);
    assert.deepEqual(read?.problems.map(({ reason }) => reason), isTaken ? [] : ['too-large'], angle);
  }
});

test('names of the language itself are unknown keys, not keys', () => {
  const read = readLink('#shimmy=1&__proto__=1&constructor=2&initial.toString=3', models, accepts);
  assert.deepEqual(read?.problems.map(({ reason }) => reason), ['unknown', 'unknown', 'unknown']);
});

test('of a thousand things that could not be read a few are told, each in short', () => {
  const many = Array.from({ length: 1000 }, (_, i) => `key${i}=1`).join('&');
  const read = readLink(`#shimmy=2&velocity=${'1'.repeat(400)}&${many}`, models, accepts);
  const note = noteOn(read?.problems ?? [], voiceOf('en'));
  assert.ok(note && note.text.length < 500, `${note?.text.length} letters`);
  assert.match(note?.text ?? '', /and 996 more\.$/);
});

test('a link of nothing but misspelt keys says so; an anchor and a query do not', () => {
  assert.deepEqual(strangersIn('#velocty=30&dampingConstnt=5').map(({ key, reason }) => [key, reason]), [['velocty', 'unknown'], ['dampingConstnt', 'unknown']]);
  for (const text of ['', '#', '#top', '?utm=1']) assert.deepEqual(strangersIn(text), []);
});
