import { test } from 'node:test';
import assert from 'node:assert/strict';
import { Sound } from '../../www/sound/sound.js';
import { drive, loudnessOf, toneOf, waveOf } from '../../www/sound/wave.js';
import { opened, wanted } from './opened-session.mjs';

/** Eight cycles of a swing, as a scene has them. @param {(phase: number, time: number) => number} psi @param {number} beat in Hz */
function swing(psi, beat, { cycles = 8, from = 3.21 } = {}) {
  const count = Math.ceil(cycles * 64);
  const time = Float64Array.from({ length: count + 1 }, (_, i) => from + (i * cycles) / beat / count);
  return { time, torsionAngle: time.map((at) => psi(2 * Math.PI * beat * at, at)) };
}

/** @param {ReturnType<typeof toneOf>} tone */
const given = (tone) => /** @type {NonNullable<typeof tone>} */ (tone);

/** How strong a harmonic is. @param {{ cos: Float32Array, sin: Float32Array }} partials @param {number} n */
const strength = ({ cos, sin }, n) => Math.hypot(cos[n], sin[n]);

/** The n-th harmonic of one cycle of samples. @param {(phase: number) => number} wave @param {number} n */
function fourier(wave, n, count = 4096) {
  let [re, im] = [0, 0];
  for (let i = 0; i < count; i++) {
    const phase = (2 * Math.PI * i) / count;
    re += (2 / count) * wave(phase) * Math.cos(n * phase);
    im += (2 / count) * wave(phase) * Math.sin(n * phase);
  }
  return Math.hypot(re, im);
}

test('the beat of the tone is that of the swing, whether it holds, grows, falls or stands off the middle', () => {
  for (const [beat, psi] of /** @type {[number, (phase: number, time: number) => number][]} */ ([
    [51.867, (phase) => 0.2 * Math.sin(phase)],
    [26.9, (phase) => 0.02 * Math.sin(phase) + 0.004 * Math.sin(3 * phase + 1)],
    [51.867, (phase, time) => 0.01 * Math.exp(15 * (time - 3.2)) * Math.sin(phase)],
    [48, (phase, time) => 0.1 * Math.exp(-9 * (time - 3.2)) * Math.sin(phase)],
    [52, (phase) => 0.05 + 0.2 * Math.sin(phase)],
  ])) {
    const tone = given(toneOf(swing(psi, beat)));
    assert.ok(Math.abs(tone.beat / beat - 1) < 2e-3, `${tone.beat} is not ${beat}`);
  }
});

test('a swing without overtones gets those of a wave bent at its crests, and no others', () => {
  const { partials, amplitude } = given(toneOf(swing((phase) => 0.2 * Math.sin(phase), 51.867)));
  assert.ok(Math.abs(amplitude / 0.2 - 1) < 2e-3);
  const bent = (/** @type {number} */ phase) => Math.tanh(drive * Math.sin(phase)) / Math.tanh(drive);
  for (const n of [1, 2, 3, 4, 5, 7, 9]) assert.ok(Math.abs(strength(partials, n) - fourier(bent, n)) < 2e-3, `harmonic ${n}`);
});

test('harmonics of the swing are heard as those of its acceleration: n² of what ψ has', () => {
  const { partials } = given(toneOf(swing((phase) => 0.02 * Math.sin(phase) + 0.002 * Math.sin(3 * phase), 51.867)));
  const crest = 1 + 0.9; // sin φ + 0.9 sin 3φ has its crest where the two oppose each other
  const wave = (/** @type {number} */ phase) => Math.sin(phase) + 0.9 * Math.sin(3 * phase);
  const highest = Math.max(...Array.from({ length: 4096 }, (_, i) => wave((2 * Math.PI * i) / 4096)));
  assert.ok(highest < crest);
  const bent = (/** @type {number} */ phase) => Math.tanh((drive * wave(phase)) / highest) / Math.tanh(drive);
  for (const n of [1, 2, 3, 5, 7]) assert.ok(Math.abs(strength(partials, n) - fourier(bent, n)) < 5e-3, `harmonic ${n}`);
});

test('a small loudspeaker, which plays nothing below 120 Hz, still gets a good part of the power of any swing', () => {
  const { partials } = given(toneOf(swing((phase) => 0.2 * Math.sin(phase), 51.867)));
  const power = (/** @type {number} */ from) => Array.from(partials.cos.keys()).filter((n) => n >= from).reduce((sum, n) => sum + strength(partials, n) ** 2, 0);
  assert.ok(power(3) / power(1) > 0.07, String(power(3) / power(1)));
});

test('the same motion seen at another instant is the same wave, so that fading over is not heard', () => {
  const psi = (/** @type {number} */ phase) => 0.1 * Math.sin(phase) + 0.003 * Math.sin(3 * phase + 0.4);
  const [one, other] = [3.21, 3.2137].map((from) => waveOf(given(toneOf(swing(psi, 51.867, { from }))).partials, 64));
  assert.ok(one.every((value, i) => Math.abs(value - other[i]) < 0.02), 'they differ');
  assert.ok(Math.max(...one.map(Math.abs)) <= 1.01);
});

test('a swing that grows has no jump from cycle to cycle: its tone is that of one that holds', () => {
  const tones = [0, 15].map((rate) => given(toneOf(swing((phase, time) => 0.01 * Math.exp(rate * (time - 3.2)) * Math.sin(phase), 51.867))));
  for (let n = 2; n < 10; n += 2) assert.ok(strength(tones[1].partials, n) < 0.01, `harmonic ${n}`);
});

test('what does not swing, or has not yet, makes no tone', () => {
  assert.equal(toneOf(swing(() => 0, 50)), null);
  assert.equal(toneOf(swing((_, time) => 0.1 * Math.exp(-time), 50)), null);
  assert.equal(toneOf(swing((phase) => 0.1 * Math.sin(phase), 50, { cycles: 1.4 })), null);
  assert.equal(toneOf({ time: [], torsionAngle: [] }), null);
});

test('it is the louder the wider it swings, up to the loudest', () => {
  const levels = [0, 1e-5, 1e-3, 0.01, 0.1, 0.3, 0.4, 2].map(loudnessOf);
  assert.deepEqual(levels, [...levels].sort((one, other) => one - other));
  assert.deepEqual([levels[0], levels[1], levels.at(-1)], [0, 0, 1]);
});

test('the gear of the opening is heard at the beat of its limit cycle', () => {
  const { session } = opened();
  session.seek(2);
  const { orbitPast } = session.scene(wanted);
  // reference.json, limit cycle of the gear at 80 m/s with c = 20.
  assert.ok(Math.abs(given(toneOf(orbitPast)).beat - 51.867) < 0.02);
});

/** An AudioContext that only remembers. */
function silentContext() {
  /** @type {string[]} */
  const calls = [];
  const context = { currentTime: 0, destination: {}, resume: () => { calls.push('resume'); return Promise.resolve(); }, suspend: () => calls.push('suspend') };
  return { calls, context: /** @type {AudioContext} */ (/** @type {unknown} */ (context)) };
}

test('nothing is made before a hand asks for it, and a browser without sound is told of', () => {
  const sound = new Sound(() => { throw new Error('no audio here'); });
  sound.hear(swing((phase) => Math.sin(phase), 50), 0);
  assert.equal(sound.failure, '');
  sound.toggle();
  assert.deepEqual([sound.isOn, sound.failure], [false, 'no audio here']);
});

test('it is off until a hand asks for it, silent where there is nothing to hear, and follows no faster than it is heard', (t) => {
  t.mock.timers.enable({ apis: ['setTimeout'] });
  const { context, calls } = silentContext();
  /** @type {{ now: number, value: number }[]} */
  const volumes = [];
  const param = (/** @type {boolean} */ isVolume) => ({
    cancelScheduledValues: () => {}, setValueAtTime: () => {},
    setTargetAtTime: (/** @type {number} */ value, /** @type {number} */ now) => { if (isVolume) volumes.push({ now, value }); },
  });
  let gains = 0;
  const node = (/** @type {object} */ more) => ({ connect: (/** @type {unknown} */ next) => next, start: () => {}, setPeriodicWave: () => {}, ...more });
  const globals = /** @type {Record<string, unknown>} */ (/** @type {unknown} */ (globalThis));
  const kept = ['GainNode', 'ConstantSourceNode', 'OscillatorNode', 'PeriodicWave'].map((name) => [name, globals[name]]);
  t.after(() => kept.forEach(([name, value]) => { globals[/** @type {string} */ (name)] = value; }));
  Object.assign(globals, {
    GainNode: function () { return node({ gain: param(gains++ === 0) }); },
    ConstantSourceNode: function () { return node({ offset: param(false) }); },
    OscillatorNode: function () { return node({ frequency: {} }); },
    PeriodicWave: function () { return {}; },
  });
  const sound = new Sound(() => context);
  const motion = swing((phase) => 0.1 * Math.sin(phase), 50);
  sound.hear(motion, 0);
  assert.equal(volumes.length, 0);
  sound.toggle();
  sound.hear(motion, 100);
  sound.hear(motion, 110);
  assert.equal(volumes.length, 2, 'a volume, and the silence that comes if no frame does');
  assert.ok(volumes[0].value > 0.1 && volumes[1].value === 0 && volumes[1].now > volumes[0].now);
  sound.hear(null, 120);
  assert.equal(volumes.at(-1)?.value, 0);
  sound.toggle();
  t.mock.timers.tick(1000);
  assert.deepEqual(calls, ['resume', 'suspend']);
});
