import { limitsFor } from '../../run/fit.js';
import { drawDeformationPortrait } from '../../view/deformation-portrait.js';
import { drawOrbit } from '../../view/orbit.js';
import { drawPhasePortrait } from '../../view/phase-portrait.js';
import { stableCycle, unstableCycle } from '../../view/strokes.js';

/**
 * @typedef {import('../../run/cycle-looks.js').LimitCycle} LimitCycle
 * @typedef {import('../../run/fit.js').Swing} Swing
 * @typedef {import('../../run/scene.js').Scene} Scene
 * @typedef {import('../../view/look.js').Look} Look
 * @typedef {typeof import('./settings.js').orbitViews[number]} OrbitView
 */

/** How much room axes leave beyond what is on them. */
const room = 1.12;

/** A cycle with the motion on its way to it, on axes that hold both and stay while a slider moves. */
export class OrbitPicture {
  /** @type {{ scales: object | null, limits: Swing }} */
  #axes = { scales: null, limits: limitsFor({ angle: 0, rate: 0, deformation: 0 }) };

  /** @param {Scene} scene @param {LimitCycle | null} cycle */
  hold({ scales }, cycle) {
    const before = this.#axes.scales === scales ? this.#axes.limits : scales.limits;
    const { torsionAngle = 0, torsionRate = 0, lateralDeformation = 0 } = cycle?.amplitude ?? {};
    const isWithin = torsionAngle <= before.angle && torsionRate <= before.rate && lateralDeformation <= before.deformation;
    const least = (/** @type {number} */ limit, /** @type {number} */ wanted) => Math.max(limit / room, wanted);
    this.#axes = {
      scales,
      limits: isWithin ? before : limitsFor({ angle: least(before.angle, torsionAngle), rate: least(before.rate, torsionRate), deformation: least(before.deformation, lateralDeformation) }),
    };
  }

  /**
   * @param {CanvasRenderingContext2D} context @param {import('../../view/canvas.js').Size} size
   * @param {{ scene: Scene, cycle: LimitCycle | null, name: OrbitView, look: Look, veiled: boolean }} shown
   * @param {import('../../style/theme.js').Theme} theme @param {import('../../words/voice.js').Voice} voice
   */
  paint(context, size, { scene, cycle, name, look, veiled }, theme, voice) {
    const motion = {
      limits: this.#axes.limits, trail: scene.orbitPast, orbit: cycle?.orbit ?? {}, orbitLabel: cycle ? voice.say(cycle.stable ? 'cycle.key.stable' : 'cycle.key.unstable') : '',
      orbitStyle: cycle?.stable ? stableCycle : unstableCycle,
      state: scene.state, exposed: scene.exposed, freeplay: scene.parameters.freeplayAngle ?? 0, veiled,
    };
    if (name === 'space') drawOrbit(context, size, { ...motion, look }, theme, voice);
    else if (name === 'deformation') drawDeformationPortrait(context, size, motion, theme, voice);
    else drawPhasePortrait(context, size, motion, theme, voice);
  }
}
