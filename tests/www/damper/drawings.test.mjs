// Drawings of a damper: the model's elements move as it moves, loops lie where their data say, populations stand on their axes.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { drawLoops } from '../../../www/view/damper/loops.js';
import { drawPopulation, placeOn } from '../../../www/view/damper/population.js';
import { drawSchematic } from '../../../www/view/damper/schematic.js';
import { voiceOf } from '../../../www/words/voice.js';
import { numbersOf, recordingContext, written } from '../plot-recorder.mjs';
import { theme } from '../theme.mjs';

const size = { width: 600, height: 400 };
const words = { element: 'Bouc–Wen', dashpot: 'dashpot', spring: 'spring', seriesDashpot: 'dashpot', outerSpring: 'gas spring' };
const still = { x: 0, w: 0, z: 0, force: 0, command: 0 };

/** @param {Partial<typeof still>} pose @param {boolean} [isSeries] */
function schematic(pose, isSeries = true) {
  const { context, calls, named } = recordingContext();
  drawSchematic(context, size, { isSeries, pose: { ...still, ...pose }, words }, theme);
  assert.ok(numbersOf(calls).every(Number.isFinite));
  const pistons = named('fillRect').filter(({ style }) => style.fillStyle === theme.stable).map(({ args: [x, , width] }) => x + width / 2);
  const tips = named('bezierCurveTo').map(({ args: [foot, , , , tip] }) => tip - foot);
  const filled = named('fill').filter(({ style }) => style.fillStyle === theme.force && style.globalAlpha === 1).length;
  return { pistons, tips, filled, texts: written(named('fillText')).join(' ') };
}

test('pistons move with x and w, bristles lean with z', () => {
  const [rest, out, inner] = [schematic({}), schematic({ x: 1 }), schematic({ w: 1 })];
  assert.equal(rest.pistons.length, 2);
  assert.ok(out.pistons[0] > rest.pistons[0] && out.pistons[1] === rest.pistons[1], 'x moves the inner piston alone');
  assert.ok(inner.pistons[1] > rest.pistons[1], 'w moves the outer one');
  assert.deepEqual(rest.tips.map(Math.abs), Array(5).fill(0));
  assert.ok(schematic({ z: 1 }).tips.every((tip) => tip > 5) && schematic({ z: -1 }).tips.every((tip) => tip < -5));
  assert.deepEqual(schematic({ z: 3 }).tips, schematic({ z: 1 }).tips, 'it slips at z_max');
});

test('the simple form has one dashpot, the modified one two, with w and a second spring', () => {
  const simple = schematic({}, false);
  assert.equal(simple.pistons.length, 1);
  assert.doesNotMatch(simple.texts, /w|gas/);
  const modified = schematic({}).texts;
  for (const word of ['w', 'x', 'F', 'gas spring', 'Bouc–Wen']) assert.ok(modified.includes(word), word);
});

test('the coil fills in proportion to the current', () => {
  const [none, third, all] = [0, 1 / 3, 1].map((command) => schematic({ command }).filled);
  assert.equal(all - none, 18, 'nine windings above, nine below');
  assert.equal(third - none, 6);
});

const angles = Array.from({ length: 64 }, (_, i) => (2 * Math.PI * i) / 64);
const loop = (/** @type {number} */ most, /** @type {string} */ label, isChosen = false) =>
  ({ label, isChosen, displacement: angles.map((a) => 0.01 * Math.sin(a)), velocity: angles.map((a) => 0.1 * Math.cos(a)), force: angles.map((a) => most * Math.cos(a)) });
const limits = { displacement: 0.012, velocity: 0.12, force: 1500 };

test('a loop lies where its data say, the chosen one in the accent, all named', () => {
  const { context, calls, named } = recordingContext();
  drawLoops(context, { width: 900, height: 300 }, { loops: [loop(500, '0 A'), loop(1000, '1 A', true)], limits, now: { displacement: 0, velocity: 0.1, force: 1000 } }, theme, voiceOf('en'));
  assert.ok(numbersOf(calls).every(Number.isFinite));
  const texts = written(named('fillText'));
  assert.equal(texts.filter((text) => text === '0 A').length, 2, 'in both plots');
  assert.ok(texts.some((text) => /piston velocity, m\/s/.test(text)) && texts.some((text) => /damper force, N/.test(text)));
  const strokes = calls.filter(({ name, style }) => name === 'stroke' && style.strokeStyle === theme.psi && Math.abs(style.lineWidth - 2.8) < 1e-9);
  assert.equal(strokes.length, 2);
  // Upright: 1000 N of the chosen loop lies between the marks of 500 and 1500, twice as far from zero as 500 N.
  const mark = (/** @type {string} */ text) => { const call = named('fillText').find(({ args }) => args[0] === text); assert.ok(call, text); return call.at(call.args[1], call.args[2])[1]; };
  const dot = named('arc').at(-1);
  assert.ok(dot);
  const [, y] = dot.at(dot.args[0], dot.args[1]);
  const perNewton = (mark('−1000') - mark('1000')) / 2000;
  assert.ok(Math.abs(y - (mark('1000'))) < 1.5, `${y}, ${mark('1000')}, ${perNewton}`);
});

test('large forces are told in kilonewtons, and under the veil nothing is drawn of the loops', () => {
  const { context, named } = recordingContext();
  drawLoops(context, { width: 900, height: 300 }, { loops: [loop(9e4, '2 A')], limits: { ...limits, force: 1e5 }, veiled: true }, theme, voiceOf('tr'));
  const texts = written(named('fillText'));
  assert.ok(texts.some((text) => /sönümleyici kuvveti, kN/.test(text)));
  assert.ok(!texts.includes('2 A'));
});

test('a parameter over decades stands by its logarithm', () => {
  const axis = { name: [{ symbol: 'c' }], min: 100, max: 1e6, write: String };
  assert.ok(Math.abs(placeOn({ ...axis, isLog: true }, 1e4) - 0.5) < 1e-12);
  assert.equal(placeOn({ ...axis, min: -2, max: 2, isLog: false }, 1), 0.75);
  assert.equal(placeOn({ ...axis, isLog: true }, 1e9), 1);
});

test('the population: every individual a line, the best in the accent with its values, loose ones told apart', () => {
  const axes = ['c', 'k', 'α'].map((symbol, i) => ({ name: [{ symbol }], min: 1, max: 1000, isLog: true, write: (/** @type {number} */ value) => `${value}!`, isLoose: i === 2 }));
  const individuals = [[1, 10, 100], [1000, 100, 10], [31, 31, 31]];
  for (const [at, isLying] of /** @type {const} */ ([[{ width: 600, height: 300 }, false], [{ width: 150, height: 300 }, true]])) {
    const { context, calls, named } = recordingContext();
    drawPopulation(context, at, { axes, individuals, best: individuals[1], ranks: [0.5, 0, 1] }, theme);
    assert.ok(numbersOf(calls).every(Number.isFinite));
    assert.equal(named('stroke').filter(({ style }) => style.strokeStyle === theme.ghost && style.dash.length === 0 && style.lineWidth === 1).length, 3);
    assert.equal(named('stroke').filter(({ style }) => style.strokeStyle === theme.psi).length, 1);
    assert.ok(named('stroke').some(({ style }) => style.strokeStyle === theme.unstable));
    for (const value of ['1000!', '100!', '10!']) assert.ok(written(named('fillText')).includes(value), `${value} ${isLying}`);
  }
});
