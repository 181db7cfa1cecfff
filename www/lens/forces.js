import { html } from 'lit';
import { drawForces } from '../view/forces.js';
import { roundLimit } from '../view/scale.js';
import { PlotLens } from './plot-lens.js';

/**
 * @typedef {import('../run/scene.js').Scene} Scene
 * @typedef {import('../view/forces.js').Shown} Shown
 * @typedef {import('../words/voice.js').Voice} Voice
 */

const degree = Math.PI / 180;
/** A slip angle beyond this tells nothing of the laws' shape, in rad. */
const widestSlip = 60 * degree;
/** How much of a law is seen beyond its last bend. */
const beyondKink = 1.5;
const all = /** @type {const} */ (['sideForce', 'aligningMoment', 'restoringMoment']);

/** The lens *Forces*: what drives and what holds the swing, each law with the point where the gear is now. */
export class ForcesLens extends PlotLens {
  /** Axes are kept as long as the scales of the session are. */
  #limits = { for: /** @type {unknown} */ (null), object: '', slipAngle: 0, torsionAngle: 0, sideForce: 0, aligningMoment: 0, restoringMoment: 0 };

  /** @param {string} name @param {Voice} voice */
  nameOfView(name, voice) {
    return voice.say(/** @type {import('../words/voice.js').Key} */ (`forces.view.${name}`));
  }

  /** @param {Voice} voice */
  label(voice) {
    return voice.say('forces.name');
  }

  /** @param {Voice} voice */
  line(voice) {
    return html`<p>${voice.say(this.#isLimited ? 'forces.limited' : 'forces.growing')}</p>`;
  }

  /** Whether the side force meets its limit within a cycle: of the cycle, as the instant changes too fast to be read. */
  get #isLimited() {
    const { scene } = this;
    const [low, high] = scene?.lastCycle()?.slipAngle ?? [0, 0];
    const limit = scene?.laws({ samples: 2 }).kinks.sideForceLimitAngle ?? Infinity;
    return Math.max(high, -low) > limit;
  }

  /** @type {PlotLens['paintScene']} */
  paintScene(context, size, scene, theme, voice) {
    const limits = this.#limitsFor(scene);
    const laws = scene.laws({ slipAngle: limits.slipAngle, torsionAngle: limits.torsionAngle, samples: 201 });
    const { view } = this;
    drawForces(context, size, {
      laws, limits,
      now: scene.exposed ? pathOf(scene.forcesAlong(scene.object, scene.parameters, scene.exposed), scene.exposed) : pointOf(scene.forces, scene.state),
      cycle: scene.lastCycle(),
      ghosts: scene.ghosts.map((ghost) => ({ label: this.labelOf(scene, ghost, voice), now: shownOf(scene, ghost) })),
      shown: view === 'all' ? [...all] : [/** @type {Shown} */ (view)],
    }, theme, voice);
  }

  /** @param {Scene} scene */
  #limitsFor(scene) {
    if (this.#limits.for === scene.scales && this.#limits.object === scene.object) return this.#limits;
    const { limits } = scene.scales;
    const { kinks } = scene.laws({ samples: 2 });
    const bend = Math.max(kinks.sideForceLimitAngle ?? 0, kinks.aligningMomentLimitAngle ?? 0);
    const swing = Math.atan(limits.deformation / scene.parameters.relaxationLength);
    const slip = roundLimit(Math.min(Math.max(beyondKink * bend, swing), widestSlip) / degree) * degree;
    const laws = scene.laws({ slipAngle: slip, torsionAngle: limits.angle, samples: 101 });
    this.#limits = {
      for: scene.scales, object: scene.object, slipAngle: slip, torsionAngle: limits.angle,
      sideForce: limitOf(laws.sideForce), aligningMoment: limitOf(laws.aligningMoment), restoringMoment: limitOf(laws.restoringMoment),
    };
    return this.#limits;
  }
}

/** @param {import('../engine/engine.js').Forces} forces @param {ArrayLike<number>} state */
function pointOf({ slipAngle, sideForce, aligningMoment, springTorque }, state) {
  return { slipAngle, sideForce, aligningMoment, torsionAngle: state[0], restoringMoment: springTorque };
}

/** @param {import('../engine/engine.js').ForceColumns} forces @param {{ torsionAngle: Float64Array }} states */
function pathOf({ slipAngle, sideForce, aligningMoment, springTorque }, { torsionAngle }) {
  return { slipAngle, sideForce, aligningMoment, torsionAngle, restoringMoment: springTorque };
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

customElements.define('shimmy-forces-lens', ForcesLens);
