/**
 * What linear theory says of the gear as it is: asked for when a lens looks, with some of its values put elsewhere or not.
 * A gear with freeplay is linear about its middle, inside the gap, where no spring works.
 *
 * @typedef {import('../engine/engine.js').Engine} Engine
 * @typedef {ReturnType<Engine['eigenvalues']>[number]} Eigenvalue
 * @typedef {ReturnType<Engine['stabilityMap']>} StabilityMap
 * @typedef {ReturnType<Engine['hopfCurve']>[number]} BoundaryCurve
 * @typedef {ReturnType<Engine['eigenmodes']>[number]} Mode
 * @typedef {ReturnType<Engine['routhArray']>} RouthArray
 * @typedef {ReturnType<Engine['routhHurwitz']>} RouthHurwitz
 * @typedef {'stable' | 'growthRate' | 'frequency' | 'kind'} Asked
 * @typedef {{ parameter: string, from: number, to: number }} Range of a parameter, in SI
 * @typedef {ReturnType<typeof linearLooks>} LinearLooks
 */

import { linearCases, linearHistories } from './linear-histories.js';

/** A curve is drawn to a fraction of a pixel, as a share of the plane. */
const drawn = 1e-4;

/** A swing so small that neither tire nor gap can limit it, however long it grows here, in rad: it goes as linear theory says. */
const tiny = 1e-12;

/**
 * What of a gear linear theory leaves out: the spring outside of the gap, dry friction, or both.
 *
 * @typedef {'gap' | 'friction' | 'both' | null} LeftOut
 */

/** Dry friction, as the engine names it. */
export const frictionParameter = 'friction.moment';

/** @param {boolean} isGapped @param {boolean} isRubbed @returns {LeftOut} */
export const leftOut = (isGapped, isRubbed) => (isGapped ? (isRubbed ? 'both' : 'gap') : isRubbed ? 'friction' : null);

/**
 * @param {Engine} engine
 * @param {{ model: string, parameters: Readonly<Record<string, number>> }} gear
 * @param {() => Readonly<Record<string, number>>} [start] the state that its run starts from
 */
export function linearLooks(engine, { model, parameters }, start = () => ({})) {
  return {
    /** Half of the gap: where it is not 0, a swing that has left it is not what linear theory speaks of. */
    isGapped: (parameters.freeplayAngle ?? 0) > 0,
    /** Dry friction, of which linear theory does not speak. */
    isRubbed: (parameters[frictionParameter] ?? 0) > 0,
    leavesOut: leftOut((parameters.freeplayAngle ?? 0) > 0, (parameters[frictionParameter] ?? 0) > 0),
    /**
     * By falling real part, of a pair the positive imaginary part first.
     * @param {Readonly<Record<string, number>>} [values] that are others
     * @returns {Eigenvalue[]}
     */
    eigenvalues: (values = {}) => engine.eigenvalues({ model, parameters: { ...parameters, ...values } }),
    /**
     * Row by row from the least `y`, values at the middle of cells.
     * @param {Range & { count: number }} x @param {Range & { count: number }} y @param {Asked[]} quantities
     * @param {Readonly<Record<string, number>>} [values] that are others
     * @returns {StabilityMap}
     */
    map: (x, y, quantities, values = {}) => engine.stabilityMap({ model, parameters: { ...parameters, ...values }, x, y, quantities }),
    /** Where in a plane stability ends. @param {Range} x @param {Range} y @param {Readonly<Record<string, number>>} [values] that are others @returns {BoundaryCurve[]} */
    boundary: (x, y, values = {}) => engine.hopfCurve({ model, parameters: { ...parameters, ...values }, x, y, accuracy: drawn }),
    /** What the gear does at each eigenvalue, in their order. */
    modes: () => engine.eigenmodes({ model, parameters }),
    routhArray: () => engine.routhArray({ model, parameters }),
    routhHurwitz: () => engine.routhHurwitz({ model, parameters }),
    /** Its motion from where the run started, by linear theory and in full. @param {number} duration in s @param {number} samples */
    histories: (duration, samples) => linearHistories(engine, { model, parameters, initial: start() }, duration, samples),
    /** What linear theory says of the thesis' cases. */
    cases: () => linearCases(engine),
    /**
     * A swing too small to be limited, as multiples of the angle that it starts from.
     * @param {number} duration in s @param {number} samples
     */
    smallSwing: (duration, samples) => {
      // Friction would hold it.
      const { time, torsionAngle } = engine.simulate({ model, parameters: { ...parameters, 'friction.moment': 0 }, initial: { torsionAngle: tiny }, duration, samples, rtol: 1e-6, atol: tiny * 1e-7 });
      return { time, angle: torsionAngle.map((angle) => angle / tiny) };
    },
  };
}
