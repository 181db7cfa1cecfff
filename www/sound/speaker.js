/**
 * A tone on a loudspeaker: two oscillators that beat as one, so that a new wave is faded in on the silent one while the other
 * fades out, and nothing clicks.
 *
 * @typedef {import('./wave.js').Tone} Tone
 */

import { distance, loudnessOf } from './wave.js';

/** The loudest that is sent out: there are people with headphones. */
const most = 0.4;
/** Changes of volume and beat take about this long, of the wave a little less, in s. */
const glide = 0.05;
const fade = 0.04;
/** Where nobody goes on playing (a page that stands still, a frame that never came) it falls silent by itself after this, in s. */
const breath = 0.5;
/** Waves nearer than this are one to the ear. */
const alike = 0.02;

export class Speaker {
  #context;
  #beat;
  #volume;
  /** @type {readonly { oscillator: OscillatorNode, gain: GainNode }[]} */ #voices;
  #speaking = 0;
  /** The wave that is heard, and since when. @type {{ partials: Tone['partials'], since: number } | null} */ #wave = null;

  /** @param {BaseAudioContext} context */
  constructor(context) {
    this.#context = context;
    this.#volume = new GainNode(context, { gain: 0 });
    this.#volume.connect(context.destination);
    this.#beat = new ConstantSourceNode(context, { offset: 50 });
    this.#voices = [0, 1].map(() => {
      const oscillator = new OscillatorNode(context, { frequency: 0 });
      const gain = new GainNode(context, { gain: 0 });
      this.#beat.connect(oscillator.frequency);
      oscillator.connect(gain).connect(this.#volume);
      return { oscillator, gain };
    });
    // Begun at one instant and driven by one beat, they keep step.
    const start = context.currentTime;
    this.#beat.start(start);
    for (const { oscillator } of this.#voices) oscillator.start(start);
  }

  /** @param {Tone} tone */
  play({ beat, amplitude, partials }) {
    const now = this.#context.currentTime;
    if (this.#wave === null) this.#beat.offset.setValueAtTime(beat, now);
    else to(this.#beat.offset, beat, now, glide);
    this.#speak(partials, now);
    to(this.#volume.gain, most * loudnessOf(amplitude), now, glide);
    this.#volume.gain.setTargetAtTime(0, now + breath, glide);
  }

  hush() {
    to(this.#volume.gain, 0, this.#context.currentTime, glide);
  }

  /** Fades over to another wave, once the last one is there. @param {Tone['partials']} partials @param {number} now */
  #speak(partials, now) {
    if (this.#wave && (now - this.#wave.since < 5 * fade || distance(partials, this.#wave.partials) < alike)) return;
    const [before, next] = [this.#voices[this.#speaking], this.#voices[1 - this.#speaking]];
    next.oscillator.setPeriodicWave(new PeriodicWave(this.#context, { real: partials.cos, imag: partials.sin, disableNormalization: true }));
    to(next.gain.gain, 1, now, fade);
    to(before.gain.gain, 0, now, fade);
    this.#speaking = 1 - this.#speaking;
    this.#wave = { partials, since: now };
  }
}

/** Glides from wherever it is. @param {AudioParam} parameter @param {number} value @param {number} now @param {number} time constant, in s */
function to(parameter, value, now, time) {
  parameter.cancelScheduledValues(now);
  parameter.setTargetAtTime(value, now, time);
}
