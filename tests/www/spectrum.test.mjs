import { test } from 'node:test';
import assert from 'node:assert/strict';
import { harmonicsOf } from '../../www/view/harmonics.js';
import { powers } from '../../www/view/scale.js';
import { drawSpectrum } from '../../www/view/spectrum.js';
import { voiceOf } from '../../www/words/voice.js';
import { numbersOf, recordingContext, written } from './plot-recorder.mjs';
import { theme } from './theme.mjs';

const degree = Math.PI / 180;
const size = { width: 604, height: 420 };
/** Narrow peaks on a floor. @param {[number, number][]} peaks frequency in Hz and amplitude in degrees @param {number} floor in degrees */
const spectrumOf = (peaks, floor = 1e-4) => {
  const frequency = Float64Array.from({ length: 801 }, (_, i) => i / 2);
  const amplitude = frequency.map((f) => peaks.reduce((sum, [at, height]) => sum + height * Math.exp(-(((f - at) / 1.5) ** 2)), floor) * degree);
  const [highest] = peaks.toSorted((one, other) => other[1] - one[1]);
  return { frequency, amplitude, peak: { frequency: highest[0], amplitude: highest[1] * degree } };
};
const rich = spectrumOf([[52, 15], [156, 0.6], [260, 0.02]]);
const limits = { frequency: 300, amplitude: 20 * degree };

/** @param {object} [more] @param {'en' | 'tr'} [language] */
function drawn(more = {}, language = 'en', canvas = size) {
  const recorder = recordingContext();
  drawSpectrum(recorder.context, canvas, { spectrum: rich, limits, ...more }, theme, voiceOf(language));
  return recorder;
}

test('the peak is ringed where it is and named with frequency and amplitude', () => {
  const { named } = drawn();
  const ring = named('arc').find(({ style }) => style.strokeStyle === theme.psi);
  const words = named('fillText').find(({ args }) => args[0] === '52.0 Hz · 15.0°');
  assert.ok(ring && words);
  const ticks = named('fillText');
  const place = (/** @type {string} */ text) => ticks.find(({ args }) => args[0] === text)?.args;
  const [zero, hundred] = [place('0')?.[1], place('100')?.[1]];
  assert.ok(Math.abs((ring.args[0] - zero) / (hundred - zero) - 0.52) < 1e-6, 'at 52 Hz');
  const [top, bottom] = [place('20°')?.[2], place('0°')?.[2]];
  assert.ok(Math.abs((bottom - ring.args[1]) / (bottom - top) - 0.75) < 1e-6, '15° of 20°');
  assert.ok(written(drawn({}, 'tr').named('fillText')).includes('52,0 Hz · 15,0°'));
});

test('on a logarithmic axis each power of ten is as far from the next', () => {
  const { named } = drawn({ isLogarithmic: true, limits: { frequency: 300, amplitude: 100 * degree } });
  const at = ['100°', '10°', '1°', '0.1°', '0.01°', '0.001°'].map((text) => named('fillText').find(({ args }) => args[0] === text)?.args[2]);
  at.slice(1).forEach((y, i) => assert.ok(Math.abs(y - at[i] - (at[1] - at[0])) < 1e-6));
  const lowest = Math.max(...named('lineTo').filter(({ style }) => style.strokeStyle === theme.psi).map(({ args }) => args[1]));
  assert.ok(lowest <= at[5] + 1e-6, 'what lies below the axis stands at its foot');
  assert.deepEqual(powers(0.02, 200), [0.1, 1, 10, 100]);
});

test('odd harmonics are marked where they stand out, and only there', () => {
  assert.deepEqual(harmonicsOf(rich).map(({ order, frequency }) => [order, frequency]), [[3, 156], [5, 260]]);
  assert.deepEqual(harmonicsOf(spectrumOf([[52, 15]])), []);
  // Half as high again as the floor around it is no peak.
  assert.deepEqual(harmonicsOf(spectrumOf([[52, 15], [156, 0.05]], 0.1)), []);
  assert.deepEqual(harmonicsOf({ ...rich, peak: null }), []);
  const marks = (/** @type {object} */ more) => drawn(more).named('fillText').filter(({ args }, i, all) => args[0] === 'f' && /^[357]$/.test(all[i - 1]?.args[0])).length;
  assert.equal(marks({ isLogarithmic: true }), 2);
  // 0.6° of 20° is seen, 0.02° is not.
  assert.equal(marks({}), 1);
});

test('without a peak nothing is named; a ghost’s spectrum is dashed and named', () => {
  const flat = { frequency: rich.frequency, amplitude: rich.amplitude.map(() => 0), peak: null };
  const none = drawn({ spectrum: flat, isLogarithmic: true });
  assert.ok(numbersOf(none.calls).every(Number.isFinite));
  assert.ok(!written(none.named('fillText')).some((text) => text.includes('Hz ·')));
  const { named } = drawn({ ghosts: [{ label: 'v = 60', spectrum: spectrumOf([[51, 17]]) }] });
  assert.ok(named('stroke').some(({ style }) => style.strokeStyle === theme.ghost && style.dash[0] === 6));
  assert.ok(written(named('fillText')).includes('ghost: v = 60'));
});

test('words stay on the canvas, at the ends of the axes too', () => {
  for (const canvas of [size, { width: 390, height: 280 }, { width: 440, height: 500 }])
    for (const frequency of [54, 300]) for (const isLogarithmic of [false, true]) {
      const { named, calls } = drawn({ limits: { frequency, amplitude: 15.1 * degree }, isLogarithmic, ghosts: [{ label: 'v = 60', spectrum: rich }] }, 'tr', canvas);
      assert.ok(numbersOf(calls).every(Number.isFinite));
      for (const { args: [text, x, y], style, at } of named('fillText')) {
        const width = text.length * 0.5 * parseFloat(style.font.match(/([\d.]+)px/)[1]);
        const start = style.textAlign === 'right' ? x - width : style.textAlign === 'center' ? x - width / 2 : x;
        for (const end of [start, start + width]) {
          const [left, top] = at(end, y);
          assert.ok(left >= -1 && left <= canvas.width + 1 && top >= 0 && top <= canvas.height, `"${text}" at ${left}, ${top}`);
        }
      }
    }
});
