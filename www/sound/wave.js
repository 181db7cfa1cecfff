/**
 * A swing as a tone: its beat, and the shape of one of its cycles as it is sent to a loudspeaker.
 *
 * What is heard is ψ̈, the jerk that a hand on the gear would feel, at the swing's true beat: of its n-th harmonic it has n²
 * times as much as ψ, so kinks of the tire and of the gap are heard. A small loudspeaker cannot play the 50 Hz of the
 * beat itself. So the wave is bent a little at its crests, as by an amplifier driven too far; the overtones of that lie at
 * 150, 250, 350 … Hz, and from them an ear makes out the beat. That is the only thing added, and the page says so.
 *
 * @typedef {{ time: ArrayLike<number>, torsionAngle: ArrayLike<number> }} History equally spaced, some tens of samples a cycle
 * @typedef {{ cos: Float32Array, sin: Float32Array }} Partials of one cycle, by harmonic; the one at 0 is none
 * @typedef {{ beat: number, amplitude: number, partials: Partials }} Tone `beat` in Hz; `amplitude` of ψ in the last cycle, in
 *   rad; `partials`: of a wave whose crest is 1
 */

/** Cycles that the shape is taken from: fewer and a growing swing would seem to have a jump in each. */
const mostCycles = 6;
const fewestCycles = 2;
/** Harmonics of ψ that are looked at, and those of the bent wave. */
const harmonics = 24;
const overtones = 40;
/** Samples of a cycle between the two. */
const samples = 256;
/** How far the amplifier is driven. */
export const drive = 4;
/** What the middle line is crossed by, as a share of the swing, before it can be crossed again: a rattle may tremble there. */
const slack = 0.25;

/**
 * The tone of a motion; null for one that does not swing, or has not swung for long enough.
 * @param {History} history
 * @returns {Tone | null}
 */
export function toneOf({ time, torsionAngle }) {
  const crossings = crossingsOf(roundZero({ time, torsionAngle }), 0);
  if (crossings.length <= fewestCycles) return null;
  const seen = crossings.slice(-1 - mostCycles);
  const [from, to] = [seen[0], seen[seen.length - 1]];
  const beat = (seen.length - 1) / (to - from);
  const swing = partialsOf({ time, torsionAngle }, from, to, beat);
  const amplitude = amplitudeSince({ time, torsionAngle }, to - 1 / beat);
  if (!(amplitude > 0) || !Number.isFinite(beat)) return null;
  return { beat, amplitude, partials: bent(accelerated(swing)) };
}

/**
 * The swing less itself half a cycle before: it is round zero wherever the swing stands, and goes through it at equal times
 * however fast that grows.
 * @param {History} history @returns {History}
 */
function roundZero({ time, torsionAngle }) {
  const crossings = crossingsOf({ time, torsionAngle }, middleOf(torsionAngle));
  if (crossings.length < 2) return { time: [], torsionAngle: [] };
  const cycle = (crossings[crossings.length - 1] - crossings[0]) / (crossings.length - 1);
  const half = Math.max(1, Math.round((0.5 * cycle * (time.length - 1)) / (time[time.length - 1] - time[0])));
  const from = (/** @type {ArrayLike<number>} */ series) => Array.from(series).slice(half);
  return { time: from(time), torsionAngle: from(torsionAngle).map((psi, i) => psi - torsionAngle[i]) };
}

/** @param {ArrayLike<number>} psi */
function middleOf(psi) {
  let [low, high] = [Infinity, -Infinity];
  for (let i = 0; i < psi.length; i++) [low, high] = [Math.min(low, psi[i]), Math.max(high, psi[i])];
  return (low + high) / 2;
}

/** When ψ goes up through a line, in s. @param {History} history @param {number} middle @returns {number[]} */
function crossingsOf({ time, torsionAngle: psi }, middle) {
  /** @type {number[]} */
  const crossings = [];
  // A swing that grows was smaller: what counts as far below follows the half cycle gone by.
  let deepest = 0;
  let highest = 0;
  for (let i = 1; i < time.length; i++) {
    const [before, now] = [psi[i - 1] - middle, psi[i] - middle];
    deepest = Math.min(deepest, now);
    highest = Math.max(highest, now);
    if (before < 0 && now >= 0 && -deepest > slack * highest) {
      crossings.push(time[i - 1] + ((time[i] - time[i - 1]) * -before) / (now - before));
      [deepest, highest] = [0, 0];
    }
  }
  return crossings;
}

/**
 * The harmonics of ψ over whole cycles, under a bell that is zero at both ends: a swing that grows has no jump there.
 * @param {History} history @param {number} from @param {number} to in s @param {number} beat in Hz
 * @returns {Partials}
 */
function partialsOf({ time, torsionAngle }, from, to, beat) {
  const [cos, sin] = [new Float32Array(harmonics + 1), new Float32Array(harmonics + 1)];
  let weights = 0;
  for (let i = 0; i < time.length; i++) {
    if (time[i] < from || time[i] > to) continue;
    const weight = 1 - Math.cos((2 * Math.PI * (time[i] - from)) / (to - from));
    weights += weight;
    for (let n = 1; n <= harmonics; n++) {
      const phase = 2 * Math.PI * n * beat * (time[i] - from);
      cos[n] += 2 * weight * torsionAngle[i] * Math.cos(phase);
      sin[n] += 2 * weight * torsionAngle[i] * Math.sin(phase);
    }
  }
  return { cos: cos.map((one) => one / weights), sin: sin.map((one) => one / weights) };
}

/** ψ̈ of ψ, turned so that its first harmonic begins at zero and rises, whatever instant it was seen from. @param {Partials} partials @returns {Partials} */
function accelerated({ cos, sin }) {
  const turn = Math.atan2(cos[1], sin[1]);
  const turned = (/** @type {number} */ n) => ({ re: sin[n] * Math.cos(n * turn) + cos[n] * Math.sin(n * turn), im: cos[n] * Math.cos(n * turn) - sin[n] * Math.sin(n * turn) });
  return { sin: sin.map((_, n) => n * n * turned(n).re), cos: cos.map((_, n) => n * n * turned(n).im) };
}

/** The wave with its crest at 1, bent. @param {Partials} partials @returns {Partials} */
function bent(partials) {
  const wave = waveOf(partials, samples);
  const crest = wave.reduce((most, value) => Math.max(most, Math.abs(value)), 0) || 1;
  const driven = wave.map((value) => Math.tanh((drive * value) / crest) / Math.tanh(drive));
  const [cos, sin] = [new Float32Array(overtones + 1), new Float32Array(overtones + 1)];
  for (let n = 1; n <= overtones; n++)
    for (let i = 0; i < samples; i++) {
      const phase = (2 * Math.PI * n * i) / samples;
      cos[n] += (2 / samples) * driven[i] * Math.cos(phase);
      sin[n] += (2 / samples) * driven[i] * Math.sin(phase);
    }
  return { cos, sin };
}

/** One cycle of a wave. @param {Partials} partials @param {number} count @returns {Float64Array} */
export function waveOf({ cos, sin }, count) {
  return Float64Array.from({ length: count }, (_, i) => {
    let value = 0;
    for (let n = 1; n < cos.length; n++) {
      const phase = (2 * Math.PI * n * i) / count;
      value += cos[n] * Math.cos(phase) + sin[n] * Math.sin(phase);
    }
    return value;
  });
}

/** @param {History} history @param {number} since in s */
function amplitudeSince({ time, torsionAngle }, since) {
  let [low, high] = [Infinity, -Infinity];
  for (let i = time.length - 1; i >= 0 && time[i] >= since; i--) [low, high] = [Math.min(low, torsionAngle[i]), Math.max(high, torsionAngle[i])];
  return (high - low) / 2;
}

/** So wide a swing is as loud as it gets, in rad; and so small it is not heard. */
const loudest = 0.4;
const faintest = 2e-5;

/** How loud a swing is, 0 … 1: a hundredth of the loudest is a tenth as loud, for the ear hears ratios. @param {number} amplitude of ψ in rad */
export const loudnessOf = (amplitude) => (amplitude < faintest ? 0 : Math.sqrt(Math.min(amplitude / loudest, 1)));

/** How far two waves differ, as a share of their crests. @param {Partials} one @param {Partials} other */
export function distance(one, other) {
  let sum = 0;
  for (let n = 1; n < one.cos.length; n++) sum += (one.cos[n] - other.cos[n]) ** 2 + (one.sin[n] - other.sin[n]) ** 2;
  return Math.sqrt(sum / 2);
}
