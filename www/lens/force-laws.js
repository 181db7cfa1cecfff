import { frictionParameter } from '../run/linear-looks.js';
import { drawForces } from '../view/forces.js';
import { roundLimit } from '../view/scale.js';

/**
 * @typedef {import('../run/scene.js').Scene} Scene
 * @typedef {import('../view/forces.js').Shown} Shown
 */

const degree = Math.PI / 180;
/** A slip angle beyond this tells nothing of the laws' shape, in rad. */
const widestSlip = 60 * degree;
/** How much of a law is seen beyond its last bend. */
const beyondKink = 1.5;
/** As slow as nothing: on either side of it dry friction has turned about, in rad/s. */
const slow = 1e-9;

/** Whether anything rubs in the gear. @param {{ parameters: Readonly<Record<string, number>> }} gear */
export const isRubbed = ({ parameters }) => (parameters[frictionParameter] ?? 0) > 0;

/** The laws of the tire, of the spring and of the friction, with the gear as a point on each: for the lens *Forces*, and wherever a law is seen. */
export class ForceLaws {
  /** Axes are kept as long as the scales of the session are. */
  #limits = {
    for: /** @type {unknown} */ (null), object: '', rubs: false, slipAngle: 0, torsionAngle: 0, torsionRate: 0, sideForce: 0, aligningMoment: 0, restoringMoment: 0, frictionMoment: 0,
  };

  /**
   * @param {CanvasRenderingContext2D} context @param {import('../view/canvas.js').Size} size
   * @param {{ scene: Scene, shown: Shown[], labelOf?: (ghost: Scene['ghosts'][number]) => string }} wanted `labelOf`: what a ghost is called, where ghosts are to be seen
   * @param {import('../style/theme.js').Theme} theme @param {import('../words/voice.js').Voice} voice
   */
  paint(context, size, { scene, shown, labelOf }, theme, voice) {
    const limits = this.#limitsFor(scene);
    const laws = scene.laws({ slipAngle: limits.slipAngle, torsionAngle: limits.torsionAngle, samples: 201 });
    drawForces(context, size, {
      laws: { ...laws, ...frictionOver(limits.torsionRate, scene) }, limits,
      now: scene.exposed ? pathOf(scene.forcesAlong(scene.object, scene.parameters, scene.exposed), scene.exposed) : pointOf(scene.forces, scene.state),
      cycle: scene.lastCycle(),
      ghosts: labelOf ? scene.ghosts.map((ghost) => ({ label: labelOf(ghost), now: shownOf(scene, ghost) })) : [],
      shown,
    }, theme, voice);
  }

  /** @param {Scene} scene */
  #limitsFor(scene) {
    const rubs = isRubbed(scene);
    if (this.#limits.for === scene.scales && this.#limits.object === scene.object && this.#limits.rubs === rubs) return this.#limits;
    const { limits } = scene.scales;
    const { kinks } = scene.laws({ samples: 2 });
    const bend = Math.max(kinks.sideForceLimitAngle ?? 0, kinks.aligningMomentLimitAngle ?? 0);
    const swing = Math.atan(limits.deformation / scene.parameters.relaxationLength);
    const slip = roundLimit(Math.min(Math.max(beyondKink * bend, swing), widestSlip) / degree) * degree;
    const laws = scene.laws({ slipAngle: slip, torsionAngle: limits.angle, samples: 101 });
    this.#limits = {
      for: scene.scales, object: scene.object, rubs, slipAngle: slip, torsionAngle: limits.angle, torsionRate: limits.rate,
      sideForce: limitOf(laws.sideForce), aligningMoment: limitOf(laws.aligningMoment), restoringMoment: limitOf(laws.restoringMoment),
      frictionMoment: limitOf(frictionOver(limits.rate, scene).frictionMoment),
    };
    return this.#limits;
  }
}

/** The friction's torque over the torsion rate, straight ahead: it jumps where the wheel turns about. @param {number} limit in rad/s @param {Scene} scene */
function frictionOver(limit, scene) {
  const torsionRate = Float64Array.of(-limit, -slow, slow, limit);
  const rest = new Float64Array(torsionRate.length);
  const { frictionTorque: frictionMoment } = scene.forcesAlong(scene.object, scene.parameters, { time: rest, torsionAngle: rest, torsionRate, lateralDeformation: rest });
  return { torsionRate, frictionMoment };
}

/** @param {import('../engine/engine.js').Forces} forces @param {ArrayLike<number>} state */
function pointOf({ slipAngle, sideForce, aligningMoment, springTorque, frictionTorque }, state) {
  return { slipAngle, sideForce, aligningMoment, torsionAngle: state[0], restoringMoment: springTorque, torsionRate: state[1], frictionMoment: frictionTorque };
}

/** @param {import('../engine/engine.js').ForceColumns} forces @param {{ torsionAngle: Float64Array, torsionRate: Float64Array }} states */
function pathOf({ slipAngle, sideForce, aligningMoment, springTorque, frictionTorque }, { torsionAngle, torsionRate }) {
  return { slipAngle, sideForce, aligningMoment, torsionAngle, restoringMoment: springTorque, torsionRate, frictionMoment: frictionTorque };
}

/** @param {Scene} scene @param {Scene['ghosts'][number]} ghost */
function shownOf(scene, { kept, parameters, state, exposed }) {
  return exposed ? pathOf(scene.forcesAlong(kept.object, parameters, exposed), exposed)
    : pointOf(scene.forcesOf({ kept, parameters, state }), state);
}

/** A round number above all values. @param {Float64Array} values */
function limitOf(values) {
  return roundLimit(values.reduce((most, value) => Math.max(most, Math.abs(value)), 0) || 1);
}
