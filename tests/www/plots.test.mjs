import { test } from 'node:test';
import assert from 'node:assert/strict';
import { drawPhasePortrait } from '../../www/view/phase-portrait.js';
import { drawRunEnvelope } from '../../www/view/run-envelope.js';
import { drawTimeHistory } from '../../www/view/time-history.js';
import { linear, roundLimit, roundStep, tickDecimals, ticks } from '../../www/view/scale.js';
import { voiceOf } from '../../www/words/voice.js';
import { numbersOf, recordingContext } from './plot-recorder.mjs';
import { theme } from './theme.mjs';

const degree = Math.PI / 180;
const size = { width: 600, height: 500 };
const circle = (/** @type {number} */ radius, /** @type {number} */ count) => ({
  torsionAngle: Float64Array.from({ length: count }, (_, i) => radius * Math.cos((2 * Math.PI * i) / count)),
  torsionRate: Float64Array.from({ length: count }, (_, i) => -50 * Math.sin((2 * Math.PI * i) / count)),
});
const portrait = {
  limits: { angle: 20 * degree, rate: 100 },
  trail: circle(10 * degree, 256),
  orbit: circle(15 * degree, 64),
  orbitLabel: 'the cycle it settles on',
  state: [10 * degree, 25, 0],
  freeplay: 0,
};

test('scales are straight, ticks are round and lie inside', () => {
  assert.equal(linear([-2, 2], [0, 400])(1), 300);
  assert.deepEqual(ticks(-20, 20, 10), [-20, -15, -10, -5, 0, 5, 10, 15, 20]);
  assert.deepEqual(ticks(-1.3, 1.3, 4), [-1, 0, 1]);
  assert.equal(tickDecimals([-0.5, 0, 0.5]), 1);
  assert.equal(tickDecimals([-10, 0, 10]), 0);
  assert.deepEqual([0.019, 0.021, 1, 3].map(roundStep), [0.02, 0.05, 1, 5]);
  for (let i = 0; i < 500; i++) {
    const largest = 10 ** (6 * Math.random() - 4);
    const limit = roundLimit(largest);
    assert.ok(limit >= largest * 1.1 && limit < largest * 1.5, `${limit} for ${largest}`);
  }
});

test('the present is a dot where ψ and ψ̇ say, to the right and up', () => {
  const { context, named } = recordingContext();
  drawPhasePortrait(context, size, portrait, theme, voiceOf('en'));
  const dot = named('arc').at(-1);
  assert.ok(dot);
  const grid = named('lineTo').filter(({ style }) => style.strokeStyle === theme.ghost);
  // The zero lines cross at the origin of the plot.
  const [vertical, horizontal] = grid;
  assert.ok(dot.args[0] > vertical.args[0] && dot.args[1] < horizontal.args[1]);
  const fullWidth = horizontal.args[0] - vertical.args[0];
  assert.ok(Math.abs((dot.args[0] - vertical.args[0]) / fullWidth - 0.5) < 0.01, 'half way to 20°');
});

test('beyond the plot the present is a triangle at the edge, pointing to where it is', () => {
  for (const [angle, rate] of [[31, 25], [-31, 25], [10, 140], [10, -140], [50, 300]]) {
    const { context, named } = recordingContext();
    drawPhasePortrait(context, size, { ...portrait, orbit: {}, trail: {}, state: [angle * degree, rate, 0] }, theme, voiceOf('en'));
    assert.ok(named('arc').every(({ args }) => args[2] !== 6), 'no dot');
    const [vertical, horizontal] = named('lineTo').filter(({ style }) => style.strokeStyle === theme.ghost);
    const corners = named('lineTo').filter(({ style }) => style.fillStyle === theme.psi && style.lineWidth === 2).slice(-3).map(({ args }) => args);
    const [[x, y], ...others] = corners;
    const [right, middle] = [horizontal.args[0], horizontal.args[1]];
    assert.ok(corners.every(([across]) => across > 0 && across <= right + 1), JSON.stringify(corners));
    if (Math.abs(angle) > 20) assert.ok(others.every(([across]) => (angle > 0 ? across < x : across > x)), 'along ψ');
    else assert.ok(Math.abs((x - vertical.args[0]) / (right - vertical.args[0]) - 0.5) < 0.01 && others.every(([, up]) => (rate > 0 ? up > y : up < y)), 'along ψ̇');
    assert.ok(rate > 0 ? y < middle : y > middle);
  }
});

test('the trail fades into the past and ends in full color', () => {
  const { context, named } = recordingContext();
  drawPhasePortrait(context, size, portrait, theme, voiceOf('en'));
  const strengths = named('stroke').filter(({ style }) => style.strokeStyle === theme.psi).map(({ style }) => style.globalAlpha);
  assert.equal(strengths.length, 32);
  assert.ok(strengths.every((alpha, i) => i === 0 || alpha > strengths[i - 1]));
  assert.ok(strengths[0] < 0.1);
  assert.equal(strengths.at(-1), 1);
});

test('the destination is dotted, closed, in ink, and named; without one there is none', () => {
  const destination = (/** @type {typeof portrait} */ data) => {
    const { context, named } = recordingContext();
    drawPhasePortrait(context, size, data, theme, voiceOf('en'));
    return {
      closed: named('closePath').filter(({ style }) => style.strokeStyle === theme.ink && style.dash.length > 0).length,
      names: named('fillText').map(({ args }) => args[0]),
    };
  };
  const { closed, names } = destination(portrait);
  assert.equal(closed, 1);
  assert.ok(names.includes('the cycle it settles on'));
  const none = destination({ ...portrait, orbit: circle(0, 0), orbitLabel: '' });
  assert.equal(none.closed, 0);
  assert.ok(!none.names.includes('the cycle it settles on'));
});

test('the gap is a band as wide as twice the freeplay, and absent without it', () => {
  const band = (/** @type {number} */ freeplay) => {
    const { context, named } = recordingContext();
    drawPhasePortrait(context, size, { ...portrait, freeplay }, theme, voiceOf('en'));
    const [grid] = named('lineTo').filter(({ style }) => style.strokeStyle === theme.ghost);
    return { rects: named('fillRect').filter(({ style }) => style.fillStyle === theme.freeplay), middle: grid.args[0] };
  };
  assert.equal(band(0).rects.length, 0);
  const one = band(2 * degree);
  const two = band(4 * degree);
  const [[left, , width]] = one.rects.map(({ args }) => args);
  assert.ok(Math.abs(2 * width - two.rects[0].args[2]) < 1e-9);
  assert.ok(Math.abs(left + width / 2 - one.middle) < 1, 'not about zero');
  assert.equal(one.rects[0].style.globalAlpha, 0.25);
});

test('labels stay on the canvas, in both languages and at every size', () => {
  for (const language of /** @type {const} */ (['en', 'tr']))
    for (const [width, height] of [[604, 480], [440, 430], [390, 174], [800, 380]]) {
      const { context, named, calls } = recordingContext();
      drawPhasePortrait(context, { width, height }, { ...portrait, freeplay: 0.5 * degree }, theme, voiceOf(language));
      assert.ok(numbersOf(calls).every(Number.isFinite));
      for (const { args: [text, x, y], style, at } of named('fillText')) {
        const length = text.length * 0.5 * parseFloat(style.font.match(/([\d.]+)px/)?.[1] ?? '0');
        const start = style.textAlign === 'right' ? x - length : style.textAlign === 'center' ? x - length / 2 : x;
        for (const end of [start, start + length]) {
          const [left, top] = at(end, y);
          assert.ok(left >= -1 && left <= width + 1 && top >= 0 && top <= height, `"${text}" at ${left}, ${top} of ${width} × ${height}`);
        }
      }
    }
});

const box = { left: 60, right: 760, top: 40, bottom: 140 };

test('the past is drawn up to now, the future on from there, dotted', () => {
  const { context, calls } = recordingContext();
  const history = (/** @type {number} */ from, /** @type {number} */ to) => {
    const time = Float64Array.from({ length: 50 }, (_, i) => from + ((to - from) * i) / 49);
    return { time, torsionAngle: time.map((t) => 0.1 * Math.cos(300 * t)) };
  };
  drawTimeHistory(context, box, {
    past: history(-0.08, 0), future: history(0, 0.02), from: -0.08, to: 0.02, limit: 0.2, freeplay: 0, value: 0.1, frequency: 47.7,
  }, theme, voiceOf('tr'), { isSmall: false });
  const strokes = calls.filter(({ name, style }) => name === 'lineTo' && style.strokeStyle === theme.psi);
  const [past, future] = [strokes.filter(({ style }) => style.dash.length === 0), strokes.filter(({ style }) => style.dash.length > 0)];
  const now = box.left + 0.8 * (box.right - box.left);
  assert.ok(Math.abs((past.at(-1)?.args[0] ?? 0) - now) < 1e-9);
  assert.ok(future.every(({ args: [x] }) => x > now));
  assert.ok(Math.abs((future.at(-1)?.args[0] ?? 0) - box.right) < 1e-9);
  const dot = calls.find(({ name }) => name === 'arc');
  assert.equal(dot?.args[0], now);
  assert.ok(Math.abs(dot?.args[1] - 65) < 1e-9);
  assert.ok(calls.some(({ name, args }) => name === 'fillText' && String(args[0]).includes('47,7 Hz')));
});

test('the run’s band is as wide as it swings, solid before now and faint after', () => {
  const { context, named } = recordingContext();
  const envelope = (/** @type {number[]} */ time) => ({ time, low: time.map(() => -0.1), high: time.map(() => 0.1) });
  drawRunEnvelope(context, box, {
    past: envelope([0.1, 0.2]), future: envelope([0.25, 0.5]), from: 0, to: 1, now: 0.25, bracket: [0.17, 0.27],
  }, theme);
  const [future, past] = named('fill');
  assert.ok(past.style.globalAlpha > 2 * future.style.globalAlpha);
  const heights = named('lineTo').filter(({ style }) => style.fillStyle === theme.psi && style.globalAlpha < 1).map(({ args }) => args[1]);
  for (const edge of [90 - 50 / 1.2, 90 + 50 / 1.2]) assert.ok(heights.some((height) => Math.abs(height - edge) < 1e-9), `0.1 of 0.12, at ${edge}`);
  const [[bracketLeft, , bracketWidth]] = named('strokeRect').map(({ args }) => args);
  assert.ok(Math.abs(bracketLeft - 179.5) < 1 && Math.abs(bracketWidth - 70) <= 1);
});

test('the run’s band stays in its lane, whatever the past was and the future will be, and does not jump at now', () => {
  const envelope = (/** @type {number[]} */ time, /** @type {number[]} */ width) => ({ time, low: width.map((w) => -w), high: width });
  for (const [past, future] of [[[0.3, 0.27], [0.2, 0.001]], [[0.02, 0.05], [0.3, 80]], [[0, 0], [0, 0]]]) {
    const { context, calls, named } = recordingContext();
    drawRunEnvelope(context, box, {
      past: envelope([0.1, 0.25], past), future: envelope([0.24, 0.5], future), from: 0, to: 1, now: 0.25, bracket: [0.17, 0.27],
    }, theme);
    for (const { args: [left, top, width, height] } of named('rect'))
      assert.ok(left >= box.left && left + width <= box.right && top >= box.top && top + height <= box.bottom, 'drawn beyond the lane');
    assert.equal(named('clip').length, 2);
    const edge = (/** @type {number} */ band) => {
      const starts = calls.flatMap(({ name }, i) => (name === 'moveTo' ? [i] : []));
      return calls.slice(starts[band], calls.findIndex(({ name }, i) => i > starts[band] && name === 'closePath'));
    };
    const now = box.left + 0.25 * (box.right - box.left);
    const [comes, was] = [edge(1), edge(2)].map((lines) => lines.filter(({ args }) => Math.abs(args[0] - now) < 1e-6).map(({ args }) => args[1]));
    assert.equal(Math.min(...comes), Math.min(...was), 'the bands do not meet');
    for (const { args: [, y] } of edge(2)) assert.ok(y >= box.top && y <= box.bottom, 'the past is cut');
  }
});
