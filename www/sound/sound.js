/**
 * The swing to be heard: off until a hand asks for it, as browsers have it, and never begun by a link. What is heard is the
 * motion that is seen, at its true beat however slowly it is shown; a run that stands still is silent.
 */

import { Speaker } from './speaker.js';
import { toneOf } from './wave.js';

/** So often the tone follows the motion, in ms. */
const pause = 40;
/** Once it is off, and faded, the loudspeaker rests after this, in ms. */
const rest = 500;

export class Sound {
  isOn = false;
  /** Whether it has been heard on this visit. */ wasOn = false;
  /** Why there is none to be had; empty where nothing is in the way. */ failure = '';
  #make;
  /** @type {AudioContext | null} */ #context = null;
  /** @type {Speaker | null} */ #speaker = null;
  #isHeard = false;
  #heardAt = -Infinity;

  /** @param {() => AudioContext} [make] is called as a hand presses: a browser grants sound to none else */
  constructor(make = () => new AudioContext()) {
    this.#make = make;
  }

  toggle() {
    if (this.isOn) {
      this.isOn = false;
      this.#hush();
      setTimeout(() => !this.isOn && this.#context?.suspend(), rest);
      return;
    }
    try {
      this.#context ??= this.#make();
      this.#speaker ??= new Speaker(this.#context);
      this.#context.resume().catch(() => {});
      this.isOn = true;
      this.wasOn = true;
      this.failure = '';
    } catch (error) {
      this.failure = error instanceof Error ? error.message : String(error);
    }
  }

  /**
   * The motion of a frame; null where nothing is to be heard.
   * @param {import('./wave.js').History | null} history the last cycles
   * @param {number} now in ms
   */
  hear(history, now) {
    if (!this.isOn || !this.#speaker) return;
    if (history && this.#isHeard && now - this.#heardAt < pause) return;
    this.#heardAt = now;
    const tone = history && toneOf(history);
    if (tone) {
      this.#speaker.play(tone);
      this.#isHeard = true;
    } else this.#hush();
  }

  #hush() {
    if (this.#isHeard) this.#speaker?.hush();
    this.#isHeard = false;
  }
}
