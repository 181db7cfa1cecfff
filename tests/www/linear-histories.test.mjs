// Linear theory beside the gear in full, and the thesis' cases (table 5.7), against closed forms and known critical values.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { casesColumns, casesCsv, frequencyOf, growthOf, timeOf } from '../../www/lens/stability/cases.js';
import { sorted } from '../../www/lens/stability/figures-table.js';
import { fittingSpan, largest, wantedSpan } from '../../www/lens/stability/history-span.js';
import { linearLooks } from '../../www/run/linear-looks.js';
import { linearCases, linearHistories } from '../../www/run/linear-histories.js';
import { drawLinearNonlinear, peaksOf } from '../../www/view/linear-nonlinear.js';
import { voiceOf } from '../../www/words/voice.js';
import { rootsOf, usual } from './linear-gear.mjs';
import { recordingContext, written } from './plot-recorder.mjs';
import { engine } from './stories.mjs';
import { theme } from './theme.mjs';

const english = voiceOf('en');
const cases = linearCases(engine);

/** @param {Record<string, number>} [values] @param {Record<string, number>} [initial] */
const run = (values = {}, initial = {}, model = 'torsional') => ({ model, parameters: { ...usual, ...values }, initial });

test('the cases are those of figures 5.59 to 5.86: fourteen, each with its two figures', () => {
  assert.equal(cases.length, 14);
  assert.deepEqual(cases.flatMap(({ figures }) => figures).map((figure) => Number(figure.split('.')[1])).sort((one, other) => one - other), Array.from({ length: 28 }, (_, i) => 59 + i));
  const [first] = cases;
  assert.deepEqual([first.parameters.velocity, first.parameters.dampingConstant, first.figures, first.initial], [20, 10, ['5.59', '5.73'], { torsionAngle: 0.01 }]);
  assert.equal(linearCases(engine), cases, 'looked up once');
});

test('what becomes of each agrees with the roots of the cubic and with the known critical speeds', () => {
  // theory: the gear is stable below 20.511 (c = 10), 27.600 (20), 37.263 (30), 51.881 m/s (40), and always above c = 49.7927.
  const critical = new Map([[10, 20.511], [20, 27.6], [30, 37.263], [40, 51.881]]);
  for (const one of cases) {
    const { velocity, dampingConstant } = one.parameters;
    const [leading, ...others] = rootsOf({ velocity, dampingConstant });
    assert.ok(Math.abs(growthOf(one) - leading.re) < 1e-7 * Math.abs(leading.re) + 1e-9, `${velocity}, ${dampingConstant}`);
    assert.equal(growthOf(one) > 0, velocity > (critical.get(dampingConstant) ?? Infinity));
    const pair = [leading, ...others].find(({ im }) => im > 0);
    assert.ok(Math.abs(Number(frequencyOf(one)) - Number(pair?.im) / (2 * Math.PI)) < 1e-7);
    assert.ok(Math.abs(Math.exp(Math.abs(growthOf(one)) * timeOf(one)) - 2) < 1e-12);
  }
});

test('cases are sorted by what they do, and leave as a file in SI', () => {
  const columns = casesColumns(english, () => {});
  const rates = sorted(cases, columns, 'rate,down').map(growthOf);
  assert.deepEqual(rates, rates.toSorted((one, other) => other - one));
  const verdicts = sorted(cases, columns, 'becomes,down').map((one) => growthOf(one) > 0);
  assert.deepEqual(verdicts, verdicts.toSorted((one, other) => Number(other) - Number(one)));
  const [header, first, ...others] = casesCsv(cases).split('\r\n');
  assert.equal(header, 'velocity (m/s),dampingConstant (N m s/rad),becomes,growthRate (1/s),timeToDouble (s),timeToHalf (s),frequency (Hz),figures');
  assert.match(first, /^20,10,decays,-0\.4\d+,,1\.6\d+,50\.7\d*,5\.59 5\.73$/);
  assert.equal(others.filter((line) => line !== '').length, 13);
  assert.ok(others.some((line) => line.includes(',grows,')));
});

test('a small swing is the same by both; a large one is not', () => {
  const apart = (/** @type {number} */ angle) => {
    const histories = linearHistories(engine, run({ velocity: 80, dampingConstant: 20 }, { torsionAngle: angle }), 0.1, 200);
    assert.ok(histories);
    const { linear, nonlinear } = histories;
    assert.equal(linear.torsionAngle[0], angle);
    return Math.max(...linear.torsionAngle.map((value, i) => Math.abs(value - nonlinear.torsionAngle[i]))) / angle;
  };
  // arctan α differs from α by α³/3: by 10⁻⁸ of it at these 10⁻⁴ rad.
  assert.ok(apart(1e-4) < 1e-5, `${apart(1e-4)}`);
  assert.ok(apart(0.3) > 0.1);
});

test('the linear history goes as its roots say', () => {
  const histories = linearHistories(engine, run({ velocity: 30, dampingConstant: 40 }, { torsionAngle: 0.01 }), 0.4, 4001);
  assert.ok(histories);
  const { time, torsionAngle } = histories.linear;
  const { above } = peaksOf(time, torsionAngle);
  const [{ re, im }] = rootsOf({ velocity: 30, dampingConstant: 40 });
  const [early, late] = [above.value[4], above.value[12]];
  const span = above.time[12] - above.time[4];
  // A peak is found to half a sample of 0.1 ms; cos(ω · 50 µs) is 1 − 1.3 · 10⁻⁴.
  assert.ok(Math.abs(Math.log(late / early) / span - re) < 5e-3 * Math.abs(re), `${Math.log(late / early) / span} ${re}`);
  assert.ok(Math.abs((8 / span) * 2 * Math.PI - im) < 2e-3 * im);
});

test('a gear with freeplay has no spring in theory; a wheel at rest is touched; other objects have no linear model', () => {
  const gapped = linearHistories(engine, run({ freeplayAngle: 0.02, velocity: 50, dampingConstant: 100 }, { torsionAngle: 0.01 }), 0.1, 500);
  const slack = linearHistories(engine, run({ torsionalStiffness: 0, velocity: 50, dampingConstant: 100 }, { torsionAngle: 0.01 }), 0.1, 500);
  assert.deepEqual(gapped?.linear.torsionAngle, slack?.linear.torsionAngle);
  assert.deepEqual(linearHistories(engine, run({}, { torsionAngle: 0, torsionRate: 0 }), 0.1, 50)?.initial, { torsionAngle: 0.01 });
  assert.deepEqual(linearHistories(engine, run({}, { torsionRate: 3 }), 0.1, 50)?.initial, { torsionRate: 3 });
  const fromLinear = linearHistories(engine, run({ velocity: 80 }, { torsionAngle: 0.05 }, 'torsional-linear'), 0.1, 50);
  assert.deepEqual(fromLinear, linearHistories(engine, run({ velocity: 80 }, { torsionAngle: 0.05 }), 0.1, 50), 'seen from the linear gear the same');
  assert.equal(linearHistories(engine, run({}, {}, 'lorenz'), 0.1, 50), null);
});

test('theory is dashed and the gear in full solid; many cycles are drawn by their peaks, and nothing far beyond the axis', () => {
  for (const [duration, isDense] of /** @type {const} */ ([[0.2, false], [2, true]])) {
    const histories = linearHistories(engine, run({ velocity: 80, dampingConstant: 20 }, { torsionAngle: 0.01 }), duration, Math.round(duration * 2000));
    assert.ok(histories);
    const { context, named } = recordingContext();
    const limit = 0.3;
    drawLinearNonlinear(context, { width: 600, height: 270 }, {
      time: histories.linear.time, linear: histories.linear.torsionAngle, nonlinear: histories.nonlinear.torsionAngle, state: 'torsionAngle', duration, limit, readings: ['grows 13.2 s⁻¹'],
    }, theme, english);
    const lines = (/** @type {string} */ color, /** @type {boolean} */ isDashed) =>
      named('lineTo').filter(({ style }) => style.strokeStyle === color && style.lineWidth === 1.6 && (style.dash.length > 0) === isDashed);
    const [solid, dashed] = [lines(theme.psi, false), lines(theme.ink, true)];
    assert.ok(isDense ? solid.length < 250 : solid.length >= histories.nonlinear.time.length - 1, `${solid.length}`);
    assert.equal(named('fill').some(({ style }) => style.fillStyle === theme.psi && style.globalAlpha < 0.5), isDense, 'peaks have a tint between them');
    assert.ok(isDense ? dashed.length < 100 : dashed.length > 300, `${dashed.length}`);
    // ± the limit are some 150 px apart: nothing is drawn more than four limits away.
    assert.ok(dashed.every(({ args }) => Math.abs(args[1] - 135) < 600));
    const words = written(named('fillText'));
    for (const word of ['nonlinear', 'linear', 'grows 13.2 s⁻¹', isDense ? ', s' : ', ms']) assert.ok(words.includes(word), word);
  }
});

test('peaks are where a series turns back', () => {
  const time = Float64Array.from({ length: 400 }, (_, i) => i / 100);
  const { above, below } = peaksOf(time, time.map((t) => Math.exp(-t) * Math.sin(2 * Math.PI * t)));
  assert.equal(above.time.length, 4);
  assert.equal(below.time.length, 4);
  assert.ok(above.value.every((value, i) => value > 0 && (i === 0 || value < above.value[i - 1])) && below.value.every((value) => value < 0));
  assert.ok(Math.abs(above.time[0] - Math.atan(2 * Math.PI) / (2 * Math.PI)) < 0.01);
});

test('the span fits: theory is seen to leave, a fall to its end, and nothing longer than the figures of the thesis', () => {
  const looks = (/** @type {Record<string, number>} */ values, /** @type {Record<string, number>} */ initial) =>
    linearLooks(engine, { model: 'torsional', parameters: { ...usual, ...values } }, () => initial);
  const growing = looks({ velocity: 80, dampingConstant: 20 }, { torsionAngle: 0.05 });
  const span = wantedSpan(growing, 'torsionAngle');
  const histories = growing.histories(span, 4000);
  assert.ok(histories);
  const limit = 1.5 * largest(histories.nonlinear.torsionAngle);
  const left = histories.linear.time[histories.linear.torsionAngle.findIndex((angle) => Math.abs(angle) > limit)] / span;
  assert.ok(left > 0.5 && left < 0.8, `theory leaves after ${left} of ${span} s`);
  assert.equal(fittingSpan(span), 0.3);
  // theory: a fall of σ takes ln 20 / σ to a twentieth.
  const [{ re }] = rootsOf({ velocity: 20, dampingConstant: 60 });
  assert.ok(Math.abs(wantedSpan(looks({ velocity: 20, dampingConstant: 60 }, { torsionAngle: 0.01 }), 'torsionAngle') - Math.log(20) / -re) < 1e-6);
  assert.equal(fittingSpan(wantedSpan(looks({ velocity: 20, dampingConstant: 10 }, { torsionAngle: 0.01 }), 'torsionAngle')), 2);
  // A fall so fast that nothing would be seen is shown for five of its cycles.
  const [fast] = rootsOf({ velocity: 20, dampingConstant: 200 });
  assert.ok(Math.log(20) / -fast.re < (4 * 2 * Math.PI) / fast.im);
  assert.ok(Math.abs(wantedSpan(looks({ velocity: 20, dampingConstant: 200 }, { torsionAngle: 0.01 }), 'torsionAngle') - (5 * 2 * Math.PI) / fast.im) < 1e-6);
  assert.equal(fittingSpan(0.12, 0.3), 0.3, 'it stays while it fits');
  assert.equal(fittingSpan(0.05, 0.3), 0.1);
  assert.equal(fittingSpan(0.31, 0.3), 0.5);
});
