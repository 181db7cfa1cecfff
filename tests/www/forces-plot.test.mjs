import { test } from 'node:test';
import assert from 'node:assert/strict';
import { drawForces } from '../../www/view/forces.js';
import { grids, panelsIn } from '../../www/view/panels.js';
import { drawSmallMultiples } from '../../www/view/small-multiples.js';
import { voiceOf } from '../../www/words/voice.js';
import { numbersOf, recordingContext, written } from './plot-recorder.mjs';
import { theme } from './theme.mjs';

const degree = Math.PI / 180;
const size = { width: 604, height: 420 };
const across = (/** @type {number} */ limit) => Float64Array.from({ length: 201 }, (_, i) => limit * (i / 100 - 1));
const slipAngle = across(15 * degree);
const torsionAngle = across(20 * degree);
const forces = {
  laws: {
    slipAngle,
    sideForce: slipAngle.map((a) => 180_000 * Math.max(-5 * degree, Math.min(5 * degree, a))),
    aligningMoment: slipAngle.map((a) => (Math.abs(a) < 10 * degree ? -1000 * Math.sin((Math.PI * a) / (10 * degree)) : 0)),
    torsionAngle,
    restoringMoment: torsionAngle.map((a) => -100_000 * a),
    kinks: { sideForceLimitAngle: /** @type {number | null} */ (5 * degree), aligningMomentLimitAngle: /** @type {number | null} */ (10 * degree), freeplayAngle: /** @type {number | null} */ (null) },
  },
  limits: { slipAngle: 15 * degree, sideForce: 20_000, aligningMoment: 1200, torsionAngle: 20 * degree, restoringMoment: 40_000 },
  now: { slipAngle: 7.5 * degree, sideForce: 15_708, aligningMoment: -707, torsionAngle: -10 * degree, restoringMoment: 17_453 },
  cycle: { slipAngle: /** @type {[number, number]} */ ([-9 * degree, 9 * degree]), torsionAngle: /** @type {[number, number]} */ ([-15 * degree, 15 * degree]) },
};
/** The same laws with other kinks. @param {Partial<typeof forces.laws.kinks>} kinks */
const bent = (kinks) => ({ laws: { ...forces.laws, kinks: { ...forces.laws.kinks, ...kinks } } });

/** @param {object} [more] @param {'en' | 'tr'} [language] */
function drawn(more = {}, language = 'en', canvas = size) {
  const recorder = recordingContext();
  drawForces(recorder.context, canvas, { ...forces, ...more }, theme, voiceOf(language));
  return recorder;
}

test('three laws are drawn with their symbols and units, each in its color', () => {
  const { named } = drawn();
  const words = written(named('fillText'));
  for (const word of ['F', 'M', 'α', 'ψ', ' side force, kN', ' aligning moment, N m', ' restoring moment, kN m', ' slip angle', ' torsion angle']) assert.ok(words.includes(word), word);
  const curves = named('stroke').filter(({ style }) => style.lineWidth > 2 && style.lineWidth < 3 && style.globalAlpha === 1).map(({ style }) => style.strokeStyle);
  assert.deepEqual(curves, [theme.force, theme.force, theme.psi]);
});

test('the point stands on its curve and its value beside the axis, in round units', () => {
  const { named } = drawn();
  const dots = named('arc').filter(({ args }) => args[2] === 6);
  assert.equal(dots.length, 3);
  const texts = named('fillText');
  for (const [i, value, line] of /** @type {const} */ ([[0, '15.7 kN', 'force'], [1, '−707 N m', 'force'], [2, '17.5 kN m', 'psi']])) {
    const text = texts.find(({ args }) => args[0] === value);
    assert.ok(text, value);
    assert.equal(text.style.fillStyle, theme[line]);
    assert.ok(Math.abs(text.at(text.args[1], text.args[2])[1] - dots[i].at(dots[i].args[0], dots[i].args[1])[1]) < 1e-9, 'at the height of its point');
    // The dotted line from the point ends on the axis, and the number stands beyond it.
    const axis = named('lineTo').findLast(({ args, style }) => style.strokeStyle === theme[line] && style.dash.length > 0 && args[1] === dots[i].args[1]);
    assert.ok(axis && Math.sign(axis.args[0] - dots[i].args[0]) === Math.sign(text.args[1] - axis.args[0]));
  }
  // Half of the way to the end of its axis, to the right.
  const [zero] = named('lineTo').filter(({ style }) => style.strokeStyle === theme.ghost).map(({ args }) => args[0]);
  const ten = texts.find(({ args }) => args[0] === '10°')?.args[1];
  assert.ok(Math.abs((dots[0].args[0] - zero) / (ten - zero) - 0.75) < 0.01);
});

test('what is too fast for the screen is a piece of each law, without point or value; so is a ghost', () => {
  const inside = (/** @type {ArrayLike<number>} */ column) => Array.from(column).slice(60, 141);
  const exposed = {
    slipAngle: inside(slipAngle), sideForce: inside(forces.laws.sideForce), aligningMoment: inside(forces.laws.aligningMoment),
    torsionAngle: inside(torsionAngle), restoringMoment: inside(forces.laws.restoringMoment),
  };
  const { named } = drawn({ now: exposed, ghosts: [{ label: 'c = 40', now: exposed }, { label: 'c = 60', now: exposed }] });
  // The keys keep their samples: hollow points outside of the panels.
  assert.equal(named('arc').filter(({ args }) => args[2] === 6).length, 0);
  assert.ok(!written(named('fillText')).some((text) => /^−?[\d.]+ k?N( m)?$/.test(text)), 'a value of an instant');
  const smears = named('stroke').filter(({ style }) => style.globalAlpha === 0.4 && style.lineCap === 'round').map(({ style }) => style.strokeStyle);
  assert.deepEqual(smears, [theme.force, theme.force, theme.psi].flatMap((color) => [theme.ghost, theme.ghost, color]));
});

test('the last cycle’s part of the curve is laid under it, as wide as the cycle', () => {
  const { calls, named } = drawn();
  const bands = calls.flatMap(({ name, style }, i) => (name === 'stroke' && style.lineWidth === 9 ? [i] : []));
  assert.equal(bands.length, 3);
  const clip = calls.slice(0, bands[0]).findLast(({ name }) => name === 'rect');
  const texts = named('fillText');
  const [left, right] = ['−10°', '10°'].map((text) => texts.find(({ args }) => args[0] === text)?.args[1]);
  assert.ok(Math.abs(clip?.args[2] / (right - left) - 0.9) < 1e-6, '18° of 20°');
  assert.equal(drawn({ cycle: null }).named('stroke').filter(({ style }) => style.lineWidth === 9).length, 0);
});

test('limit angles are marked on both sides, where a law has them and the axis reaches', () => {
  const marks = (/** @type {object} */ more) => written(drawn(more).named('fillText')).filter((text) => ['δ', 'g'].includes(text)).length;
  assert.equal(marks({}), 4);
  assert.equal(marks(bent({ sideForceLimitAngle: null, aligningMomentLimitAngle: null })), 0);
  assert.equal(marks({ limits: { ...forces.limits, slipAngle: 8 * degree } }), 2);
});

test('inside the gap there is no spring: the band is named, and the value keeps off the flat curve', () => {
  const { named } = drawn({ ...bent({ freeplayAngle: 3 * degree }), now: { ...forces.now, torsionAngle: degree, restoringMoment: 0 } });
  const [band] = named('fillRect').filter(({ style }) => style.fillStyle === theme.freeplay);
  const name = named('fillText').find(({ args }) => args[0] === 'inside the gap: no spring');
  assert.ok(band && name && Math.abs(band.args[0] + band.args[2] / 2 - name.args[1]) < 1);
  const value = named('fillText').find(({ args }) => args[0] === '0.0 kN m');
  const dot = named('arc').findLast(({ args }) => args[2] === 6);
  assert.ok(dot && value && dot.args[1] - value.args[2] > 10);
});

test('ghosts are hollow points, named above and numbered where they are several', () => {
  const ghost = (/** @type {string} */ label, /** @type {number} */ share) => ({ label, now: { slipAngle: share * 4 * degree, sideForce: share * 12_566, aligningMoment: share * -951, torsionAngle: share * 8 * degree, restoringMoment: share * -13_963 } });
  const one = drawn({ ghosts: [ghost('c = 60', 1)] });
  assert.equal(one.named('arc').filter(({ args, style }) => args[2] === 4.5 && style.strokeStyle === theme.ghost).length, 3 + 1);
  assert.ok(written(one.named('fillText')).includes('ghost: c = 60'));
  const two = written(drawn({ ghosts: [ghost('c = 60', 1), ghost('v = 60', -0.5)] }).named('fillText'));
  assert.equal(two.filter((text) => text === '2').length, 3);
});

test('fewer laws can be shown, and words stay on the canvas at every size', () => {
  for (const language of /** @type {const} */ (['en', 'tr']))
    for (const [width, height] of [[604, 420], [390, 420], [390, 280], [440, 500], [1200, 300], [360, 700]])
      for (const shown of [undefined, ['sideForce'], ['sideForce', 'restoringMoment']]) {
        const { named, calls } = drawn({ ...bent({ freeplayAngle: degree }), shown }, language, { width, height });
        assert.ok(numbersOf(calls).every(Number.isFinite));
        assert.equal(named('arc').filter(({ args }) => args[2] === 6).length, shown?.length ?? 3);
        for (const { args: [text, x, y], style, at } of named('fillText')) {
          const length = text.length * 0.5 * parseFloat(style.font.match(/([\d.]+)px/)[1]);
          const start = style.textAlign === 'right' ? x - length : style.textAlign === 'center' ? x - length / 2 : x;
          for (const end of [start, start + length]) {
            const [left, top] = at(end, y);
            assert.ok(left >= -1 && left <= width + 1 && top >= 0 && top <= height, `"${text}" at ${left}, ${top} of ${width} × ${height}`);
          }
        }
      }
});

test('panels fill the area without overlap, in the shape that reads best', () => {
  const three = [[3], [2, 1], [1, 1, 1]];
  const shape = (/** @type {number} */ width, /** @type {number} */ height) => panelsIn({ width, height }, three).map(({ left, top, right }) => [left, top, right]);
  assert.deepEqual(shape(604, 420), [[0, 0, 302], [302, 0, 604], [0, 210, 604]]);
  assert.deepEqual(shape(1200, 300), [[0, 0, 400], [400, 0, 800], [800, 0, 1200]]);
  assert.deepEqual(shape(360, 720), [[0, 0, 360], [0, 240, 360], [0, 480, 360]]);
  for (const count of [1, 2, 3, 4, 5, 7]) {
    const panels = panelsIn({ width: 600, height: 400 }, grids(count));
    assert.ok(panels.length >= count);
    const share = panels.reduce((sum, { left, right, top, bottom }) => sum + (right - left) * (bottom - top), 0);
    assert.ok(Math.abs(share - 600 * 400) < 1e-6);
  }
});

test('small multiples draw each run in its own panel of one size, under its name', () => {
  const { context, named } = recordingContext();
  /** @type {import('../../www/view/canvas.js').Size[]} */
  const sizes = [];
  drawSmallMultiples(context, size, ['now', 'c = 40', 'c = 60'].map((label) => ({ label, draw: (inner, area) => { sizes.push(area); inner.fillRect(0, 0, 1, 1); } })), theme);
  assert.equal(sizes.length, 3);
  assert.ok(sizes.every(({ width, height }) => width === sizes[0].width && height === sizes[0].height));
  const corners = named('fillRect').map(({ at }) => at(0, 0).join());
  assert.equal(new Set(corners).size, 3);
  assert.deepEqual(written(named('fillText')), ['now', 'c = 40', 'c = 60']);
});

test('dry friction has its law over the torsion rate: against the turning, whichever way it goes, with the point on it', () => {
  const torsionRate = Float64Array.of(-80, -1e-9, 1e-9, 80);
  const rubbed = {
    laws: { ...forces.laws, torsionRate, frictionMoment: Float64Array.of(200, 200, -200, -200) }, limits: { ...forces.limits, torsionRate: 80, frictionMoment: 250 },
    now: { ...forces.now, torsionRate: 40, frictionMoment: -200 }, shown: ['sideForce', 'aligningMoment', 'restoringMoment', 'frictionMoment'],
  };
  const { named } = drawn(rubbed);
  const words = written(named('fillText'));
  for (const word of [' dry friction, N m', ' torsion rate, rad/s', '−200 N m']) assert.ok(words.includes(word), word);
  const dots = named('arc').filter(({ args }) => args[2] === 6);
  assert.equal(dots.length, 4);
  const curve = named('lineTo').filter(({ style }) => style.strokeStyle === theme.stable && style.lineWidth > 2 && style.dash.length === 0);
  assert.equal(curve.at(-1)?.args[1], dots[3].args[1], 'the point is at the height of the law');
  assert.ok(!written(drawn().named('fillText')).some((text) => /friction/.test(text)));
});
