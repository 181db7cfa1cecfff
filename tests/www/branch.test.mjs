// Branches of cycles: how they are asked for, met by a hand, walked along, and drawn.

import assert from 'node:assert/strict';
import { mock, test } from 'node:test';
import { Quantity } from '../../www/controls/quantity.js';
import { BesideWork } from '../../www/lens/cycles/beside-work.js';
import { along, cycleAt, heightsOf, highest, nearest, nearestTo, roundValue, slopeOfSmall, turnsOf } from '../../www/lens/cycles/branches.js';
import { criticalityInWords, pointsOf, restOf, stopsOf } from '../../www/lens/cycles/diagram.js';
import { branchOf, readBranch, writeBranch } from '../../www/lens/cycles/settings.js';
import { readLink } from '../../www/link/read.js';
import { drawBifurcation } from '../../www/view/bifurcation.js';
import { drawSpecialPoints } from '../../www/view/special-points.js';
import { voiceOf } from '../../www/words/voice.js';
import { opened, table } from './opened-session.mjs';
import { recordingContext, written } from './plot-recorder.mjs';
import { engine } from './stories.mjs';
import { theme } from './theme.mjs';

const english = voiceOf('en');
const speeds = engine.bifurcation({ model: 'torsional', parameters: { dampingConstant: 20 }, parameter: 'velocity', from: 10, to: 80, probes: 0 });
const velocity = new Quantity(/** @type {typeof table.parameters[number]} */ (table.parameters.find(({ name }) => name === 'velocity')));

/** @param {number} got @param {number} expected @param {number} error */
const near = (got, expected, error) => assert.ok(Math.abs(got - expected) <= error, `${got} for ${expected}`);

test('a diagram is readable text; without one it is over the speed', () => {
  const text = 'dampingConstant:0:60,lateralDeformation';
  assert.equal(writeBranch(branchOf(text, table.parameters)), text);
  assert.equal(writeBranch(branchOf('', table.parameters)), 'velocity:1:120,torsionAngle');
  assert.equal(writeBranch(branchOf('r:0:30', [{ name: 'r', min: 0, max: 30 }])), 'r:0:30,torsionAngle');
  for (const wrong of ['velocity', 'velocity:80:10', 'speed:1:2', 'velocity:1:2,mood', 'velocity:1:2,frequency,more']) assert.equal(readBranch(wrong, table.parameters), null, wrong);
  const read = (/** @type {string} */ link) => readLink(`#shimmy=2&lens=cycles&${link}`, [table], ({ parameters }) => (parameters.velocity ?? 1) > 0)?.problems.map(({ reason }) => reason);
  assert.deepEqual(read('view.cycles=branch&view.branch=velocity:1:60,frequency&view.branchSweep=on'), []);
  assert.deepEqual(read('view.branch=velocity:-1:60'), ['refused']);
  assert.deepEqual(read('view.branch=velocity:60:1&view.branchSweep=maybe'), ['unclear', 'unclear']);
});

test('one diagram is worked on at a time, then the newest that was asked for; the old one stays and is told to be old', async () => {
  /** @type {{ key: string, done: (diagram: any) => void, fail: (reason: any) => void, signal: AbortSignal }[]} */
  const jobs = [];
  const work = /** @type {BesideWork<any, any>} */ (new BesideWork((spec, { signal }) => new Promise((done, fail) => {
    jobs.push({ key: spec.key, done, fail, signal });
    signal.addEventListener('abort', () => fail(signal.reason));
  })));
  let changes = 0;
  work.onChange = () => { changes++; };
  const look = (/** @type {string} */ key, shape = 'v') => work.look({ key, shape, spec: /** @type {any} */ ({ key }) });
  const settle = () => new Promise((done) => { setTimeout(done); });
  look('a');
  look('b');
  look('c');
  assert.deepEqual(jobs.map(({ key }) => key), ['a']);
  jobs[0].done('diagram a');
  await settle();
  assert.deepEqual([work.result, work.isOld, changes, jobs.map(({ key }) => key)], ['diagram a', true, 1, ['a', 'c']]);
  jobs[1].done('diagram c');
  await settle();
  assert.deepEqual([work.result, work.isOld], ['diagram c', false]);
  look('d');
  assert.deepEqual([work.result, work.isOld], ['diagram c', true]);
  jobs[2].fail(new Error('not finite'));
  await settle();
  assert.deepEqual([work.result, work.isFailed], [null, true]);
  look('e');
  look('f', 'c');
  await settle();
  assert.deepEqual([jobs[3].signal.aborted, jobs.at(-1)?.key, work.isFailed], [true, 'f', false], 'of other axes nothing is waited for');
  work.stop();
  await settle();
  assert.ok(jobs.at(-1)?.signal.aborted);
});

test('a hand meets the nearest cycle, and never the point at which a branch has none yet', () => {
  const places = { x: (/** @type {number} */ v) => 10 * v, y: (/** @type {number} */ a) => 300 - 1000 * a };
  const [branch] = speeds.cycles;
  const place = nearest(speeds, 'torsionAngle', places, { x: 405, y: 0 });
  assert.ok(place);
  near(branch.velocity[place.index], 40, 2);
  // theory.md: v = 40, c = 20: 18.057°.
  const cycle = engine.limitCycle({ model: 'torsional', parameters: { dampingConstant: 20, velocity: branch.velocity[place.index] } }, cycleAt(branch, place.index));
  near(cycle.amplitude.torsionAngle, branch.amplitude[place.index], 1e-7);
  near(branch.amplitude[place.index], (18.057 * Math.PI) / 180, 2e-3);
  const first = nearest(speeds, 'torsionAngle', places, { x: 276, y: 300 });
  assert.ok(first && first.index > 0 && branch.amplitude[first.index] > 0);
  assert.equal(nearest({ ...speeds, cycles: [] }, 'torsionAngle', places, { x: 0, y: 0 }), null);
  assert.equal(along(branch, 1, -1), 1, 'the Hopf point itself is no cycle');
  assert.equal(along(branch, branch.amplitude.length - 1, 5), branch.amplitude.length - 1);
  assert.equal(heightsOf(branch, 'frequency'), branch.frequency);
  near(highest(speeds, 'torsionAngle'), Math.max(...branch.amplitude), 0);
});

test('small cycles grow in proportion to the gap: 1.28 times half of it at v = 50, c = 100', () => {
  const gap = engine.bifurcation({ model: 'torsional', parameters: { velocity: 50, dampingConstant: 100 }, parameter: 'freeplayAngle', from: 0, to: 0.0524 });
  // theory.md 4: 0.011171 rad at 0.5°.
  near(slopeOfSmall(gap) ?? NaN, 0.011171 / ((0.5 * Math.PI) / 180), 2e-3);
  assert.equal(slopeOfSmall(speeds), null);
});

test('slow work is given up for something newer, waits for the gear to stand still, and shows what it has so far', async () => {
  mock.timers.enable({ apis: ['setTimeout'] });
  /** @type {{ key: string, done: (result: any) => void, part: (part: any) => void, signal: AbortSignal }[]} */
  const jobs = [];
  const work = /** @type {BesideWork<any, any>} */ (new BesideWork((spec, { signal, onPart }) => new Promise((done, fail) => {
    jobs.push({ key: spec.key, done, signal, part: (part) => onPart?.(part) });
    signal.addEventListener('abort', () => fail(signal.reason));
  }), { isSlow: true }));
  const settle = async () => { for (let i = 0; i < 20; i++) await Promise.resolve(); };
  const look = (/** @type {string} */ key) => work.look({ key, shape: 's', spec: { key } });
  look('a');
  jobs[0].part('half of a');
  assert.deepEqual([work.result, work.isOld], ['half of a', false]);
  look('b');
  look('c');
  await settle();
  assert.deepEqual([jobs[0].signal.aborted, jobs.length, work.result, work.isOld, work.isGoing], [true, 1, 'half of a', true, true]);
  mock.timers.tick(250);
  await settle();
  assert.deepEqual(jobs.map(({ key }) => key), ['a', 'c']);
  jobs[1].part('half of c');
  jobs[1].done('c');
  await settle();
  assert.deepEqual([work.result, work.isOld, work.isGoing], ['c', false, false]);
  look('d');
  mock.timers.tick(250);
  await settle();
  jobs[2].part('some of d');
  work.cancel();
  await settle();
  assert.deepEqual([jobs[2].signal.aborted, work.result, work.isGoing, jobs.length], [true, 'some of d', false, 3], 'what there is stays, and nothing begins anew');
  mock.timers.reset();
});

/** @param {Partial<import('../../www/view/bifurcation.js').Shown>} [others] */
function drawn(others = {}) {
  const recorder = recordingContext();
  const [branch] = speeds.cycles;
  const places = drawBifurcation(recorder.context, { width: 560, height: 320 }, {
    quantity: velocity, from: 10, to: 80, height: 'torsionAngle', limit: 0.4,
    rest: { across: speeds.equilibria.velocity, up: speeds.equilibria.velocity.map(() => 0), stable: speeds.equilibria.stable, turns: turnsOf(speeds, null) },
    branches: [{ across: branch.velocity, up: branch.amplitude, stable: branch.stable, turns: turnsOf(speeds, 0) }], points: [{ kind: 'hopf', across: speeds.points[0].velocity, up: 0, texts: ['Hopf 27.6 m/s, supercritical', 'Hopf 27.6 m/s'] }],
    law: null, sweep: [], now: { value: 50, motion: 0.1, cycle: { up: 0.3, stable: true } }, cursor: null, isOld: false, message: '', veiled: false, ...others,
  }, theme, english);
  assert.ok(places);
  return { ...recorder, places };
}

test('stable is solid and unstable dashed, on the branch and at rest, and changes where the engine says', () => {
  const { named, places } = drawn();
  const lines = named('moveTo').filter(({ style }) => [theme.stable, theme.unstable].includes(style.strokeStyle) && style.lineWidth > 2);
  const rest = lines.filter(({ args: [, y] }) => Math.abs(y - places.y(0)) < 1e-9);
  const dashed = rest.filter(({ style }) => style.dash.length > 0);
  // The critical speed of theory.md.
  near(dashed[0].args[0], places.x(27.6), 0.05);
  assert.ok(rest.some(({ style, args: [x] }) => style.dash.length === 0 && Math.abs(x - places.x(10)) < 1e-9));
  const swapped = drawn({ branches: [{ across: [20, 30, 40, 50], up: [0.1, 0.2, 0.3, 0.35], stable: [0, 1, 1, 1], turns: [1] }], rest: null });
  const pieces = swapped.named('moveTo').filter(({ style, args: [x] }) => style.lineWidth > 2 && x >= places.x(20) - 1e-6 && [theme.stable, theme.unstable].includes(style.strokeStyle));
  assert.ok(pieces.some(({ style, args }) => style.dash.length > 0 && Math.abs(args[0] - places.x(20)) < 1e-9));
  assert.ok(pieces.some(({ style, args }) => style.dash.length === 0 && Math.abs(args[0] - places.x(30)) < 1e-9));
});

test('the gear rides on it: a ring on its cycle, a dot at its swing; names, law and sweep are there where they are asked for', () => {
  const { named, places } = drawn();
  const rings = named('arc').map(({ args: [x, y] }) => [x, y]);
  assert.ok(rings.some(([x, y]) => Math.abs(x - places.x(50)) < 1e-9 && Math.abs(y - places.y(0.3)) < 1e-9));
  assert.ok(rings.some(([x, y]) => Math.abs(x - places.x(50)) < 1e-9 && Math.abs(y - places.y(0.1)) < 1e-9));
  assert.ok(written(named('fillText')).includes('Hopf 27.6 m/s, supercritical'));
  const more = drawn({ law: { slope: 0.005, text: 'law' }, sweep: [{ value: 40, way: 'up', up: 0.2, isSettled: true }, { value: 40, way: 'down', up: 0.2, isSettled: true }], message: 'nothing here' });
  for (const word of ['law', '▸ sweep up', '◂ sweep down', 'nothing here']) assert.ok(written(more.named('fillText')).includes(word), word);
  const away = drawn({ now: { value: 200, motion: 0.1, cycle: null } });
  assert.equal(away.named('arc').length, 0);
});

test('veiled, nothing tells of a branch: no line, no point, no swing', () => {
  const { named, places } = drawn({ veiled: true });
  assert.equal(named('arc').length, 0);
  assert.ok(!written(named('fillText')).some((text) => text.includes('Hopf')));
  assert.ok(!named('lineTo').some(({ style }) => style.strokeStyle === theme.unstable));
  assert.ok(places);
});

test('the gear is put on a cycle, which one undo takes back with its value and its state', () => {
  const { store, session } = opened();
  session.advance(0.1);
  const { velocity: before } = store.state.parameters;
  const then = session.recipe;
  const [branch] = speeds.cycles;
  const at = branch.velocity.findIndex((/** @type {number} */ v) => v > 45);
  const { state } = cycleAt(branch, at);
  session.setMotion({ velocity: branch.velocity[at] }, state);
  assert.equal(store.state.parameters.velocity, branch.velocity[at]);
  near(session.outlook.amplitude.torsionAngle, branch.amplitude[at], 1e-5);
  assert.ok(session.outlook.settled);
  session.advance(0.05);
  store.undo();
  assert.equal(store.state.parameters.velocity, before);
  near(session.time, 0.1, 1e-9);
  assert.deepEqual(session.recipe, then);
  store.redo();
  assert.equal(store.state.parameters.velocity, branch.velocity[at]);
  session.setMotion({}, Object.fromEntries(Object.entries(state).map(([name, value]) => [name, 0.5 * value])));
  assert.equal(store.state.parameters.velocity, branch.velocity[at]);
  assert.ok(session.outlook.present.amplitude < 0.7 * branch.amplitude[at]);
  store.undo();
  session.refresh();
  near(session.outlook.present.amplitude, branch.amplitude[at], 1e-4);
});

test('points are named; a wheel that friction holds is at rest whatever linear theory says, and that is said', () => {
  const shown = { height: /** @type {const} */ ('torsionAngle'), quantity: velocity, isRubbed: false };
  assert.deepEqual(pointsOf(speeds, shown, english).map(({ kind, texts, up }) => [kind, texts, up]), [['hopf', ['Hopf 27.6 m/s, supercritical', 'Hopf 27.6 m/s', '27.6 m/s'], 0]]);
  assert.equal(pointsOf(speeds, { ...shown, isRubbed: true }, english)[0].texts[0], 'Hopf 27.6 m/s, without friction');
  assert.equal(pointsOf(speeds, { ...shown, isRubbed: true }, voiceOf('tr'))[0].texts[0], 'Hopf 27,6 m/s, sürtünmesiz');
  assert.deepEqual(restOf(speeds, 'torsionAngle', 0).stable, speeds.equilibria.stable);
  assert.ok(Array.from(restOf(speeds, 'torsionAngle', 10).stable).every((one) => one === 1));
  const overFriction = engine.bifurcation({ model: 'torsional', parameters: { velocity: 80, dampingConstant: 20 }, parameter: 'friction.moment', from: 0, to: 100, probes: 1 });
  const { across, stable } = restOf(overFriction, 'torsionAngle', 0);
  assert.deepEqual([stable[0], stable[across.length - 1]], [0, 1]);
  assert.equal(nearestTo(speeds.cycles[0], 'velocity', 27.6) > 0, true, 'never where there is no cycle yet');
});

test('of a Hopf point is said which way its cycles go, and by which test', () => {
  // The smooth laws of the default gear; the branch beyond Hopf is stable, which is what supercritical says.
  const [said, ...more] = criticalityInWords(speeds, velocity, english);
  assert.equal(said.name, 'Hopf 27.6 m/s, supercritical');
  assert.match(said.how, /^\(first Lyapunov coefficient −2\d\.\d s⁻¹ rad⁻²\)$/);
  assert.equal(more.length, 0);
  assert.equal(speeds.cycles[0].stable[1], 1);
  // With a gap the law has a kink at once: the branch tells it, of both ends of the rattle alike.
  const gapped = engine.bifurcation({ model: 'torsional', parameters: { dampingConstant: 100, freeplayAngle: Math.PI / 180 }, parameter: 'velocity', from: 1, to: 120, probes: 0 });
  const both = criticalityInWords(gapped, velocity, english);
  assert.deepEqual([both.length, both[0].name], [1, 'Hopf 3.2 m/s, Hopf 73.0 m/s, supercritical']);
  assert.match(both[0].how, /by the branch’s direction/);
  const points = speeds.points.map((point) => ({ ...point, criticality: /** @type {const} */ ('subcritical') }));
  const [turkish] = criticalityInWords({ ...speeds, points }, velocity, voiceOf('tr'));
  assert.match(`${turkish.name} ${turkish.means} ${turkish.how}`, /kritik altı.*kararsız.*Lyapunov/);
  assert.deepEqual(pointsOf({ ...speeds, points }, { height: 'torsionAngle', quantity: velocity, isRubbed: false }, english)[0].texts, ['Hopf 27.6 m/s, subcritical', 'Hopf 27.6 m/s', '27.6 m/s']);
});

test('a point is named in fewer words where there is no room for all, and never on another point', () => {
  const mark = (/** @type {number} */ x, /** @type {number} */ y) => ({ kind: /** @type {const} */ ('fold'), x, y, texts: ['a name of many words, far too long', 'brief'] });
  const names = (/** @type {import('../../www/view/axes.js').Box} */ frame, /** @type {ReturnType<typeof mark>[]} */ marks, /** @type {{ x: number, y: number }[]} */ curves = []) => {
    const recorder = recordingContext();
    drawSpecialPoints(recorder.context, frame, marks, curves, [], theme);
    return recorder.named('fillText');
  };
  assert.deepEqual(written(names({ left: 0, right: 500, top: 0, bottom: 300 }, [mark(250, 150)])), ['a name of many words, far too long']);
  assert.deepEqual(written(names({ left: 0, right: 90, top: 0, bottom: 300 }, [mark(45, 150)])), ['brief']);
  const [first] = names({ left: 0, right: 500, top: 0, bottom: 300 }, [mark(100, 150), mark(130, 138)]);
  const [, y] = first.args;
  assert.ok(Math.abs(y - 138) > 0.6 * theme.size, 'the name of the first stands clear of the second');
  // A branch that rises from the mark to the right.
  const [name] = names({ left: 0, right: 900, top: 0, bottom: 300 }, [mark(450, 290)], Array.from({ length: 60 }, (_, i) => ({ x: 450 + 6 * i, y: 290 - 2 * i })));
  assert.ok(name.args[1] < 450, 'it stands where no curve runs');
});

test('beyond what the model is trusted for the plane is shaded and said, and branches are fainter', () => {
  const words = /29°/;
  assert.ok(!written(drawn().named('fillText')).some((text) => words.test(text)));
  const wide = { across: [20, 30, 40, 50], up: [0.2, 0.4, 0.6, 0.7], stable: [1, 1, 1, 1], turns: [], isBeyond: (/** @type {number} */ i) => i >= 2 };
  const { named, places } = drawn({ limit: 0.8, branches: [wide], rest: null, sweep: [], now: { value: 200, motion: null, cycle: null } });
  assert.ok(written(named('fillText')).some((text) => words.test(text)));
  const [shade] = named('fillRect');
  near(shade.args[1] + shade.args[3], places.y(0.5), 1e-9);
  const starts = named('moveTo').filter(({ style }) => style.strokeStyle === theme.stable && style.lineWidth > 2);
  const alphaAt = (/** @type {number} */ value) => starts.find(({ args: [x] }) => Math.abs(x - places.x(value)) < 1e-9)?.style.globalAlpha ?? NaN;
  assert.ok(alphaAt(30) < alphaAt(20));
  assert.ok(written(drawn({ height: 'torsionRate', limit: 100, branches: [wide] }).named('fillText')).some((text) => words.test(text)), 'where another height stands upward the key says it');
});

test('a value is set from a branch with no more digits than one reads', () => {
  assert.equal(roundValue(velocity, 41.583219876), 41.5832);
  const gap = new Quantity(/** @type {typeof table.parameters[number]} */ (table.parameters.find(({ name }) => name === 'freeplayAngle')));
  near((roundValue(gap, 0.0123456789) * 180) / Math.PI, 0.707355, 1e-12);
});

test('a simulated sweep lies on the stable branch, and goes another way back where that folds', () => {
  const sweep = engine.sweep({ model: 'torsional', parameters: { dampingConstant: 20 }, over: { parameter: 'velocity', from: 20, to: 40, count: 5 } });
  const stops = stopsOf(sweep);
  assert.equal(stops.length, 10);
  for (const way of ['up', 'down']) near(stops.find((one) => one.value === 40 && one.way === way)?.up ?? NaN, (18.057 * Math.PI) / 180, 1e-4);
  const none = stopsOf({ ...sweep, up: { ...sweep.up, kind: sweep.up.kind.map(() => 255) } });
  assert.ok(none.every(({ way }) => way === 'down'), 'what is not known yet is not drawn');
  assert.ok(stops.every(({ isSettled }) => isSettled));
  const moving = stopsOf({ ...sweep, up: { ...sweep.up, .../** @type {object} */ ({ settled: Uint8Array.from([0, 1, 1, 1, 1]) }) } });
  assert.deepEqual(moving.filter(({ isSettled }) => !isSettled).map(({ value, way }) => [value, way]), [[20, 'up']]);
  const filled = (/** @type {boolean} */ isSettled) => {
    const { named } = drawn({ sweep: [{ value: 60, way: 'up', up: 0.2, isSettled }] });
    return [named('fill').filter(({ style }) => style.fillStyle === theme.force).length, written(named('fillText')).some((text) => /not settled/.test(text))];
  };
  assert.deepEqual([filled(true), filled(false)], [[1, false], [0, true]], 'hollow where it was still on its way');
});
