// Modes: which there are, how they are drawn as phasors, how one moves as a ghost on the gear, and the bars of its energy.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { ModeGhost } from '../../www/run/mode-ghost.js';
import { chosenMode, modeChoices, modeOnGear } from '../../www/run/modes.js';
import { armsOf, phaseOf, statesOf } from '../../www/lens/stability/mode-shape.js';
import { balanceOf, rateWriter } from '../../www/view/energy-balance.js';
import { drawPhasors } from '../../www/view/phasors.js';
import { voiceOf } from '../../www/words/voice.js';
import { rootsOf, usual } from './linear-gear.mjs';
import { recordingContext, written } from './plot-recorder.mjs';
import { theme } from './theme.mjs';

const english = voiceOf('en');
const degree = Math.PI / 180;

/** The gear's modes in closed form, from its matrix: ψ = 1, ψ̇ = λ, y = (v + (e − a)λ)/(λ + v/σ). @param {Partial<typeof usual>} [values] */
function modesOf(values = {}) {
  const { velocity: v, casterLength: e, halfContactLength: a, relaxationLength: sigma } = { ...usual, ...values };
  return rootsOf(values).map(({ re, im }) => {
    const [above, below] = [{ re: v + (e - a) * re, im: (e - a) * im }, { re: re + v / sigma, im }];
    const size = below.re ** 2 + below.im ** 2;
    const y = { re: (above.re * below.re + above.im * below.im) / size, im: (above.im * below.re - above.re * below.im) / size };
    const phasor = (/** @type {{ re: number, im: number }} */ z) => ({ ...z, amplitude: Math.hypot(z.re, z.im), lag: Math.atan2(-z.im, z.re) });
    return {
      eigenvalue: { re, im }, dampingRatio: -re / Math.hypot(re, im), naturalFrequency: Math.hypot(re, im) / (2 * Math.PI),
      timeToHalf: re < 0 ? -Math.LN2 / re : null, timeToDouble: re > 0 ? Math.LN2 / re : null, reference: 'torsionAngle',
      shape: { torsionAngle: phasor({ re: 1, im: 0 }), torsionRate: phasor({ re, im }), lateralDeformation: phasor(y) }, energyFlow: null,
    };
  });
}

const shimmying = { velocity: 80, dampingConstant: 20 };

test('a pair is one mode, and comes first; a name that is none is the first', () => {
  const choices = modeChoices(modesOf(shimmying));
  assert.deepEqual(choices.map(({ name }) => name), ['pair-1', 'real-1']);
  assert.equal(choices[0].mode.eigenvalue.im > 0, true);
  assert.equal(chosenMode(choices, 'real-1'), choices[1]);
  assert.equal(chosenMode(choices, 'pair-7'), choices[0]);
  assert.equal(chosenMode([], ''), undefined);
});

test('a mode moves on the gear only while it is looked at', () => {
  assert.equal(modeOnGear({ lens: 'stability', views: { stability: 'modes', mode: 'real-1' } }), 'real-1');
  assert.equal(modeOnGear({ lens: 'stability', views: { stability: 'modes' } }), '');
  assert.equal(modeOnGear({ lens: 'stability', views: { mode: 'real-1' } }), null);
  assert.equal(modeOnGear({ lens: 'phase', views: { stability: 'modes' } }), null);
});

/** @param {{ time: number, magnification?: number, parameters?: Partial<typeof usual> }} at */
const sceneAt = ({ time, magnification = 1, parameters = shimmying }) => /** @type {any} */ ({
  object: 'torsional', parameters: { ...usual, ...parameters }, time, roll: 4, scales: { magnification },
  track: { time: Float64Array.of(time - 0.01, time), distance: Float64Array.of(3.2, 4) },
  linear: { modes: () => modesOf(parameters) },
});

test('the ghost swings as Re(V e^{iωt}) with the time of the run, 8° wide on the sheet, and solves the linear equations at σ = 0', () => {
  const ghosts = new ModeGhost();
  const [{ eigenvalue: { im: omega }, shape }] = modesOf(shimmying);
  for (const magnification of [1, 10]) {
    const turn = [0, 1, 2, 3].map((quarter) => ghosts.look(sceneAt({ time: 0.5 + (quarter * Math.PI) / 2 / omega, magnification }), 'pair-1'));
    const angles = turn.map((ghost) => Number(ghost?.state[0]));
    const size = Math.hypot(angles[0], angles[1]);
    assert.ok(Math.abs(size * magnification - 8 * degree) < 1e-12, `${size}`);
    // Half a turn later all is the other way round.
    assert.ok(Math.abs(angles[0] + angles[2]) < 1e-12 && Math.abs(angles[1] + angles[3]) < 1e-12);
    const rolled = turn.map((ghost) => Number(ghost?.state[2]));
    assert.ok(Math.abs(Math.hypot(rolled[0], rolled[1]) - size * shape.lateralDeformation.amplitude) < 1e-12);
    // y lags: it has its maximum by lag/ω later than ψ.
    const phase = (/** @type {number[]} */ [one, other]) => Math.atan2(-other, one);
    const behind = phase(angles) - phase(rolled);
    assert.ok(Math.abs(Math.cos(behind - shape.lateralDeformation.lag) - 1) < 1e-12);
    assert.ok(shape.lateralDeformation.lag > 0);
    // ψ̇ is the rate of this very swing: what ψ gains in a thousandth of a turn.
    const [before, after] = [-1, 1].map((way) => ghosts.look(sceneAt({ time: 0.5 + (way * 1e-3) / omega, magnification }), 'pair-1'));
    const gained = (Number(after?.state[0]) - Number(before?.state[0])) / (2e-3 / omega);
    const [{ eigenvalue: { re } }] = modesOf(shimmying);
    // By its shape ψ̇ = λψ, so it leads by a little less than a quarter: by arctan(re/ω) it is off from iωψ.
    assert.ok(Math.abs(Number(turn[0]?.state[1]) - gained - re * angles[0]) < 1e-5 * omega * size, `${turn[0]?.state[1]} for ${gained}`);
    const now = turn[0];
    // The track lies where the wheel was: at each of its instants as the ghost was then.
    const then = ghosts.look(sceneAt({ time: 0.49, magnification }), 'pair-1');
    assert.ok(Math.abs(Number(now?.track.torsionAngle[0]) - Number(then?.state[0])) < 1e-12 && Math.abs(Number(now?.track.lateralDeformation[0]) - Number(then?.state[2])) < 1e-12);
    assert.equal(now?.track.torsionAngle[1], now?.state[0]);
    assert.equal(now?.track.lateralDeformation[1], now?.state[2]);
  }
});

test('paused it stands; changed values are looked at anew; what cannot be computed has no ghost', () => {
  const ghosts = new ModeGhost();
  assert.deepEqual(ghosts.look(sceneAt({ time: 0.3 }), ''), ghosts.look(sceneAt({ time: 0.3 }), ''));
  const slower = ghosts.look(sceneAt({ time: 0.3, parameters: { velocity: 30 } }), '');
  assert.equal(slower?.mode.eigenvalue.im, modesOf({ velocity: 30 })[0].eigenvalue.im);
  const broken = { ...sceneAt({ time: 0, parameters: { velocity: 31 } }), linear: { modes: () => { throw new Error('not finite'); } } };
  assert.equal(ghosts.look(broken, ''), null);
});

test('a mode without a swing stands still, its tire bent no further than can be drawn', () => {
  const ghosts = new ModeGhost();
  const [one, later] = [0.1, 0.7].map((time) => ghosts.look(sceneAt({ time }), 'real-1'));
  assert.deepEqual(one?.state, later?.state);
  assert.ok(Math.abs(Math.abs(Number(one?.state[2])) - 0.06) < 1e-12);
});

test('phasors are measured so that they can be compared: ψ is 1, ψ̇ over ω, y over σ', () => {
  const [mode] = modesOf(shimmying);
  const arms = armsOf(mode, usual, english);
  assert.deepEqual(arms.map(({ form }) => form), ['solid', 'dotted', 'ringed']);
  assert.deepEqual([arms[0].re, arms[0].im], [1, 0]);
  assert.ok(Math.abs(arms[1].im - 1) < 1e-12, 'ψ̇ leads by nearly a quarter');
  assert.ok(Math.abs(Math.hypot(arms[2].re, arms[2].im) - mode.shape.lateralDeformation.amplitude / usual.relaxationLength) < 1e-12);
  assert.equal(phaseOf(mode, 'torsionAngle', english), '');
  assert.equal(phaseOf(mode, 'torsionRate', english), 'leads 88°');
  assert.match(phaseOf(mode, 'lateralDeformation', english), /^lags \d+°$/);
  const [, rate, deformation] = statesOf(mode);
  assert.ok(Math.abs(rate.perDegree - mode.shape.torsionRate.amplitude * degree) < 1e-12);
  assert.ok(Math.abs(deformation.perDegree - mode.shape.lateralDeformation.amplitude * degree * 1000) < 1e-12, 'mm for each degree');
  const real = modesOf(shimmying)[2];
  assert.equal(phaseOf(real, 'torsionRate', english), 'opposite');
});

test('the tips lie where the phasors say, counter-clockwise up, and the spiral goes outward where the swing grows', () => {
  for (const values of [shimmying, { velocity: 60, dampingConstant: 80 }]) {
    const [mode] = modesOf(values);
    const { re, im } = mode.eigenvalue;
    const { context, named } = recordingContext();
    drawPhasors(context, { width: 360, height: 320 }, { arms: armsOf(mode, usual, english), growth: re / im, swings: true, readings: ['× 1.28 a cycle'] }, theme);
    const dial = named('arc').find(({ style }) => style.strokeStyle === theme.rule);
    assert.ok(dial);
    const [x, y, unit] = dial.args;
    const ring = named('arc').find(({ style }) => style.strokeStyle === theme.y);
    const arm = armsOf(mode, usual, english)[2];
    assert.ok(Math.abs(ring?.args[0] - x - arm.re * unit) < 1e-9 && Math.abs(y - ring?.args[1] - arm.im * unit) < 1e-9);
    assert.ok(ring?.args[1] > y, 'what lags lies below');
    const lines = named('lineTo', 'moveTo').filter(({ style }) => style.strokeStyle === (re > 0 ? theme.unstable : theme.stable) && style.lineWidth === 1.8);
    // The last two are of the piece before the words, which says what they are of.
    const [spiral, sample] = [lines.slice(0, -2), lines.slice(-2)];
    assert.ok(sample.every(({ args }, i) => args[1] === sample[0].args[1] && args[1] < 2.2 * theme.size && args[0] < 360 && (i === 0 || args[0] - sample[0].args[0] > 20)));
    const reach = (/** @type {{ args: any[] }} */ { args }) => Math.hypot(args[0] - x, args[1] - y);
    assert.ok(Math.abs(reach(spiral[0]) - unit) < 1e-9);
    assert.ok(Math.abs(reach(spiral[spiral.length - 1]) / unit - Math.exp((2 * Math.PI * re) / im)) < 1e-9);
    assert.deepEqual(spiral[0].style.dash, re > 0 ? [6, 4] : [], 'told apart by its form, too');
    assert.ok(written(named('fillText')).includes('× 1.28 a cycle'));
  }
});

test('words at the tips keep clear of the spiral and of the arms', () => {
  for (const values of [shimmying, { velocity: 80, dampingConstant: 10 }, { velocity: 60, dampingConstant: 80 }]) for (const [width, height] of [[360, 320], [320, 280]]) {
    const [mode] = modesOf(values);
    const { re, im } = mode.eigenvalue;
    const { context, named } = recordingContext();
    drawPhasors(context, { width, height }, { arms: armsOf(mode, usual, english), growth: re / im, swings: true, readings: [] }, theme);
    const drawn = named('lineTo').filter(({ style }) => style.lineWidth === 1.8).map(({ args }) => args);
    const phases = named('fillText').filter(({ args: [text] }) => /^(leads|lags) /.test(text));
    assert.equal(phases.length, 2);
    for (const { args: [text, left, baseline] } of phases) {
      const crossed = drawn.filter(([x, y]) => x > left && x < left + text.length * theme.size * 0.5 && y < baseline && y > baseline - theme.size);
      assert.deepEqual(crossed, [], `${text} at c = ${values.dampingConstant}, ${width} wide`);
    }
  }
});

test('a mode without a swing is titled without a cycle, in both languages', () => {
  for (const language of /** @type {const} */ (['en', 'tr'])) for (const trend of /** @type {const} */ (['grows', 'lasts', 'falls'])) {
    const voice = voiceOf(language);
    assert.match(voice.say(`modes.energy.${trend}.title`), /cycle|çevrim/);
    assert.doesNotMatch(voice.say(`modes.energy.${trend}.real`), /cycle|çevrim/);
  }
});

test('without a swing each state has a row of its own', () => {
  const mode = modesOf(shimmying)[2];
  const { context, named } = recordingContext();
  drawPhasors(context, { width: 420, height: 300 }, { arms: armsOf(mode, usual, english), growth: -1, swings: false, readings: [] }, theme);
  const rows = new Set(named('moveTo').filter(({ style }) => style.strokeStyle === theme.rule && style.lineWidth === 1).map(({ args }) => args[1]));
  assert.ok(rows.size >= 3);
  assert.ok(named('arc').every(({ args }) => args[2] < 10), 'no dial');
});

test('the parts of the energy flow are written as rates that sum to the growth rate', () => {
  // From the closed form at v = 80, c = 20: what the damper takes is c|λ|²/(4E), E = (I|λ|² + k)/4.
  const [{ eigenvalue: { re, im } }] = modesOf(shimmying);
  const square = re ** 2 + im ** 2;
  const share = square / (square + usual.torsionalStiffness);
  const damper = 20 * share;
  const treadWidth = (270 / 80) * share;
  const balance = balanceOf({ tire: re + damper + treadWidth, damper, treadWidth, stored: re });
  assert.equal(balance.trend, 'grows');
  const taken = balance.taken.reduce((sum, { value }) => sum + value, 0);
  assert.ok(Math.abs(balance.fed[0].value - taken - balance.rest) < 1e-9);
  assert.equal(rateWriter(balance.whole, english)(balance.rest), '13.2 s⁻¹');
});
