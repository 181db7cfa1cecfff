/** Scenes for the gear's tests: no physics, only numbers that a motion could have. */

import { gearEn } from '../../www/words/gear.js';
import { drawGear } from '../../www/stage/gear/draw.js';
import { RecordingContext } from './recording-context.mjs';

/** @typedef {import('../../www/stage/gear/scene.js').Scene} Scene */
/** @typedef {import('../../www/stage/gear/scene.js').LayoutName} LayoutName */

export const DEGREE = Math.PI / 180;

/** Each token has a color of its own, so that a mark tells what it means. */
export const theme = {
  scheme: /** @type {const} */ ('light'),
  page: '#010101', surface: '#020202', raised: '#030303', ground: '#040404', rule: '#050505',
  ink: '#060606', ink2: '#070707', psi: '#080808', y: '#090909', force: '#0a0a0a',
  unstable: '#0b0b0b', stable: '#0c0c0c', freeplay: '#0d0d0d', freeplayText: '#0e0e0e',
  ghost: '#0f0f0f', sans: 'sans-serif', serif: 'serif',
};

/** @type {Record<LayoutName, {width: number, height: number}>} */
export const sizes = {
  desktop: { width: 836, height: 510 },
  projector: { width: 584, height: 412 },
  phone: { width: 390, height: 282 },
  'phone-side': { width: 390, height: 282 },
  big: { width: 584, height: 270 },
};

/**
 * A swing of both coordinates at 50 Hz that arrives at the wanted state now.
 *
 * @param {{psi?: number, y?: number, swing?: number, shift?: number}} motion ψ and y now; the swing
 *   of ψ before [rad], and how far y runs ahead of it [rad]
 * @param {Partial<Scene>} [changes]
 * @returns {Scene}
 */
export function sceneOf({ psi = 0, y = 0, swing = 0.2, shift = 0.6 }, changes = {}) {
  const now = 0.5;
  const roll = changes.roll ?? 40;
  const time = Float64Array.from({ length: 300 }, (_, i) => now - (0.03 * (299 - i)) / 299);
  const wave = (/** @type {number} */ t, /** @type {number} */ ahead) =>
    Math.sin(2 * Math.PI * 50 * (t - now) + ahead) - Math.sin(ahead);
  const parameters = {
    velocity: 80, casterLength: 0.1, halfContactLength: 0.1, relaxationLength: 0.3,
    torsionalStiffness: 1e5, dampingConstant: 20, freeplayAngle: 0, ...changes.parameters,
  };
  const freeplay = parameters.freeplayAngle;
  const springAngle = psi - Math.min(freeplay, Math.max(-freeplay, psi));
  return {
    state: [psi, 0, y],
    forces: {
      slipAngle: Math.atan(y / 0.3),
      sideForce: 60_000 * y,
      aligningMoment: -20_000 * y,
      sideForceLimited: Math.abs(y) > 0.026,
      springAngle,
      springTorque: 1e5 * springAngle,
    },
    track: {
      distance: time.map((t) => roll - parameters.velocity * (now - t)),
      torsionAngle: time.map((t) => psi + swing * wave(t, 0)),
      lateralDeformation: time.map((t) => y + 0.2 * swing * wave(t, shift)),
    },
    roll,
    exposure: 0.027,
    extremes: [-swing, swing],
    magnification: 1,
    forceScale: { force: 5000, moment: 1000 },
    layout: 'desktop',
    trail: [],
    ...changes,
    parameters,
  };
}

/**
 * @param {Scene} scene
 * @param {import('../../www/stage/gear/scene.js').GearWords} [words]
 */
export function record(scene, words = gearEn) {
  const context = new RecordingContext();
  drawGear(context.asContext, sizes[scene.layout], scene, theme, words);
  return context;
}
