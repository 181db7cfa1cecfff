/**
 * A mode as a ghost on the gear: it swings as Re(V e^{iωt}) with the time of the run, neither growing nor falling, as wide as
 * is well seen. A mode that does not swing stands turned aside.
 *
 * @typedef {import('./linear-looks.js').LinearLooks} LinearLooks
 * @typedef {import('./linear-looks.js').Mode} Mode
 * @typedef {import('./scene.js').Scene} Scene
 */

import { isSameRecord } from '../store.js';
import { chosenMode, modeChoices } from './modes.js';

/** How wide it is drawn, in rad, whatever the magnification; and how far its tire may bend, in m. */
const widest = { angle: (8 * Math.PI) / 180, deformation: 0.06 };

export class ModeGhost {
  /** @type {{ object: string, parameters: Readonly<Record<string, number>> } | null} */ #gear = null;
  /** @type {ReturnType<typeof modeChoices>} */ #choices = [];

  /**
   * The ghost as it is now; null where the values cannot be computed with.
   * @param {Pick<Scene, 'object' | 'parameters' | 'linear' | 'time' | 'track' | 'roll' | 'scales'>} scene
   * @param {string} name of the mode
   */
  look(scene, name) {
    const { object, parameters, linear, time, track, scales } = scene;
    if (this.#gear?.object !== object || !isSameRecord(this.#gear.parameters, parameters)) {
      this.#gear = { object, parameters };
      try {
        this.#choices = modeChoices(linear.modes());
      } catch {
        this.#choices = [];
      }
    }
    const mode = chosenMode(this.#choices, name)?.mode;
    if (!mode) return null;
    const size = sizeOf(mode) / scales.magnification;
    const [angleAt, rateAt, deformationAt] = ['torsionAngle', 'torsionRate', 'lateralDeformation'].map((state) => partOf(mode, state, size));
    return {
      mode, parameters,
      state: [angleAt(time), rateAt(time), deformationAt(time)],
      track: { distance: track.distance, torsionAngle: track.time.map(angleAt), lateralDeformation: track.time.map(deformationAt) },
    };
  }
}

/** How wide the reference swings. @param {Mode} mode */
function sizeOf({ shape }) {
  const within = (/** @type {string} */ state, /** @type {number} */ most) => (shape[state]?.amplitude > 0 ? most / shape[state].amplitude : Infinity);
  return Math.min(within('torsionAngle', widest.angle), within('lateralDeformation', widest.deformation));
}

/**
 * A state over time.
 * @param {Mode} mode @param {string} state @param {number} size of the reference
 * @returns {(time: number) => number}
 */
function partOf({ shape, eigenvalue }, state, size) {
  const { amplitude, lag } = shape[state] ?? { amplitude: 0, lag: 0 };
  return (time) => size * amplitude * Math.cos(eigenvalue.im * time - lag);
}
