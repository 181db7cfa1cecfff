import { test } from 'node:test';
import assert from 'node:assert/strict';
import { cursorWords } from '../../www/view/cursors.js';
import { drawRunEnvelope } from '../../www/view/run-envelope.js';
import { drawTimeHistory } from '../../www/view/time-history.js';
import { voiceOf } from '../../www/words/voice.js';
import { recordingContext, written } from './plot-recorder.mjs';
import { theme } from './theme.mjs';

const degree = Math.PI / 180;
const box = { left: 60, right: 760, top: 40, bottom: 140 };
/** ±13.2° and ±40 mm at 50 Hz, ψ highest now. @param {number} from @param {number} to */
const history = (from, to, count = 240) => {
  const time = Float64Array.from({ length: count }, (_, i) => from + ((to - from) * i) / (count - 1));
  return {
    time,
    torsionAngle: time.map((t) => 13.2 * degree * Math.cos(100 * Math.PI * t)),
    torsionRate: time.map((t) => -72 * Math.sin(100 * Math.PI * t)),
    lateralDeformation: time.map((t) => 0.04 * Math.sin(100 * Math.PI * t)),
  };
};
const moment = {
  past: history(-0.08, 0), future: history(0, 0.02, 60), from: -0.08, to: 0.02, limit: 20 * degree, freeplay: 0, value: 13.2 * degree, frequency: 50,
};
const millisecond = (box.right - box.left) / 100;

/** @param {object} [more] @param {{ isSmall?: boolean, language?: 'en' | 'tr', lane?: typeof box }} [options] */
function drawn(more = {}, { isSmall = false, language = 'en', lane = box } = {}) {
  const recorder = recordingContext();
  drawTimeHistory(recorder.context, lane, { ...moment, ...more }, theme, voiceOf(language), { isSmall });
  return recorder;
}

test('any state can be shown, in its unit and color', () => {
  const { named } = drawn({ shown: 'lateralDeformation', limit: 0.05, value: 0 });
  assert.ok(named('lineTo').some(({ style }) => style.strokeStyle === theme.y && style.dash.length === 0));
  const words = written(named('fillText'));
  assert.ok(words.includes('40') && words.some((text) => text.includes('lateral deformation, mm')));
  const heights = named('lineTo').filter(({ style }) => style.strokeStyle === theme.y).map(({ args }) => args[1]);
  // ±40 mm of ±50 mm, on 100 px.
  assert.ok(Math.abs(Math.min(...heights) - 50) < 0.2 && Math.abs(Math.max(...heights) - 130) < 0.2);
  assert.ok(written(drawn({ shown: 'torsionRate', limit: 100, value: 0 }).named('fillText')).some((text) => text.includes('rad/s')));
});

test('the state now stays on its lane: beyond the axis a triangle at the end of that', () => {
  for (const value of [-50, -13.2, 13.2, 50]) {
    const { named } = drawn({ value: value * degree });
    const dots = named('arc').filter(({ style }) => style.fillStyle === theme.psi);
    assert.equal(dots.length, Math.abs(value) > 20 ? 0 : 1);
    const tip = named('moveTo').at(-1);
    if (dots.length === 0) assert.equal(tip?.args[1], value > 0 ? box.top : box.bottom);
  }
});

test('a cursor is a line and a ring on the curve, and reads time, value, peak to peak and beat', () => {
  const { named } = drawn({ cursors: [-0.02] });
  const ring = named('arc').at(-1);
  assert.ok(Math.abs(ring?.args[0] - (box.left + 60 * millisecond)) < 1e-9, 'at −20 ms');
  assert.ok(Math.abs(ring?.args[1] - (90 - 50 * (13.2 / 20))) < 0.2, 'on the curve');
  const reading = named('fillText').at(-1);
  assert.equal(reading?.args[0], '20 ms ago · 13.2° · pk–pk 26.4° · 50.0 Hz');
  assert.equal(reading?.args[1], box.right);
  const other = drawn({ cursors: [-0.047] }).named('fillText').at(-1);
  assert.deepEqual(other?.args.slice(1), reading?.args.slice(1), 'it keeps its corner');
  assert.ok(written(drawn({ cursors: [-0.02] }, { language: 'tr' }).named('fillText')).includes('20 ms önce · 13,2° · tepe–tepe 26,4° · 50,0 Hz'));
});

test('two cursors read their differences, across now too unless the future is veiled', () => {
  const read = (/** @type {object} */ more) => drawn(more).named('fillText').at(-1)?.args[0];
  assert.equal(read({ cursors: [-0.03, -0.01] }), 'Δt 20.0 ms · 1/Δt 50.0 Hz · Δψ 0.0°');
  assert.equal(read({ cursors: [-0.03, 0.01] }), 'Δt 40.0 ms · 1/Δt 25.0 Hz · Δψ 0.0°');
  assert.equal(read({ cursors: [-0.01, 0.01], veiled: true }).startsWith('10 ms ago'), true);
  assert.equal(cursorWords([0.012], moment.future, 'torsionAngle', moment.limit, voiceOf('en')).split(' · ')[0], 'in 12 ms');
  assert.equal(cursorWords([-0.01], moment.past, 'lateralDeformation', 0.05, voiceOf('en')), '10 ms ago · 0.0 mm · pk–pk 80.0 mm · 50.0 Hz');
  assert.equal(cursorWords([], moment.past, 'torsionAngle', moment.limit, voiceOf('en')), '');
});

test('name and reading share the line above without touching, and a reading fits a phone', () => {
  for (const language of /** @type {const} */ (['en', 'tr'])) {
    const lane = { ...box, right: 460 };
    const { named } = drawn({ shown: 'lateralDeformation', limit: 0.05, value: 0, cursors: [-0.012] }, { language, lane });
    const width = (/** @type {any} */ { args: [text], style }) => text.length * 0.5 * parseFloat(style.font.match(/([\d.]+)px/)[1]);
    const line = named('fillText').filter(({ args }) => args[2] < lane.top);
    const reading = line.pop();
    assert.ok(line.length > 0 && line.every((call) => call.args[1] + width(call) < (reading?.args[1] ?? 0) - width(reading)));
    const small = drawn({ cursors: [-0.012] }, { language, isSmall: true, lane: { ...box, right: 250 } }).named('fillText').at(-1);
    assert.ok((small?.args[1] ?? 0) - width(small) >= 60, 'wider than the lane');
  }
});

test('a ghost’s trace is dashed; a veiled future is not drawn', () => {
  const { named } = drawn({ ghosts: [{ label: 'c = 60', past: history(-0.08, 0) }] });
  assert.ok(named('stroke').some(({ style }) => style.strokeStyle === theme.ghost && style.dash.length === 2));
  const beyond = (/** @type {boolean} */ veiled) =>
    drawn({ veiled }).named('lineTo').filter(({ args, style }) => style.strokeStyle === theme.psi && args[0] > box.left + 80.5 * millisecond).length;
  assert.ok(beyond(false) > 50);
  assert.equal(beyond(true), 0);
  assert.ok(written(drawn({ veiled: true }).named('fillText')).includes('?'));
});

test('ghosts of a run are dashed outlines that the axis holds; a veiled future is hatched', () => {
  const envelope = (/** @type {number[]} */ time, /** @type {number} */ width) => ({ time, low: time.map(() => -width), high: time.map(() => width) });
  const run = /** @type {import('../../www/view/run-envelope.js').Run} */ ({ past: envelope([0.1, 0.2], 0.1), future: envelope([0.3, 0.5], 0.1), from: 0, to: 1, now: 0.25, bracket: [0.17, 0.27] });
  const draw = (/** @type {object} */ more) => {
    const recorder = recordingContext();
    drawRunEnvelope(recorder.context, box, { ...run, ...more }, theme);
    return recorder;
  };
  const { named } = draw({ ghosts: [envelope([0, 0.5, 1], 0.25)] });
  const outline = named('lineTo').filter(({ style }) => style.strokeStyle === theme.ghost && style.dash.length > 0).map(({ args }) => args[1]);
  assert.equal(outline.length, 4);
  // 0.25 of an axis to 0.3, on 50 px either side.
  for (const edge of [90 - 50 / 1.2, 90 + 50 / 1.2]) assert.ok(outline.some((height) => Math.abs(height - edge) < 1e-9));
  assert.equal(draw({}).named('fill').length, 2);
  const veiled = draw({ veiled: true });
  assert.equal(veiled.named('fill').length, 1);
  assert.ok(written(veiled.named('fillText')).includes('?'));
});
