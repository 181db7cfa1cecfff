import { runJob } from '../../engine/workers.js';
import { drawBifurcation } from '../../view/bifurcation.js';
import { roundLimit } from '../../view/scale.js';
import { BesideWork } from './beside-work.js';
import { highest, slopeOfSmall } from './branches.js';
import { lineOf, pointsOf, restOf } from './diagram.js';

/**
 * The branches over one side of a plane, through its point: beneath the plane, to be looked at.
 *
 * @typedef {import('../../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../../run/linear-looks.js').Range} Range
 * @typedef {import('../../run/scene.js').Scene} Scene
 */

const degree = Math.PI / 180;

export class BranchCut {
  /** @type {BesideWork<import('../../pkg/shimmy.js').BifurcationSpec, import('../../pkg/shimmy.js').Bifurcation>} */
  #work = new BesideWork((spec, options) => runJob('bifurcation', spec, options));

  /** @param {() => void} onChange is called when there is something new */
  constructor(onChange) {
    this.#work.onChange = onChange;
  }

  /** What it is drawn from. */
  get drawn() {
    const { result, isOld, isFailed } = this.#work;
    return [result, isOld, isFailed];
  }

  /** @param {Scene} scene @param {Range} side */
  look({ object, parameters }, { parameter, from, to }) {
    const others = Object.entries(parameters).filter(([name]) => name !== parameter);
    const range = { parameter, from, to };
    this.#work.look({ key: JSON.stringify([object, range, others]), shape: JSON.stringify([object, range]), spec: { model: object, parameters: { ...parameters }, ...range } });
  }

  /** Nobody looks any more. */
  stop() {
    this.#work.stop();
  }

  /**
   * @param {CanvasRenderingContext2D} context @param {import('../../view/canvas.js').Size} size
   * @param {{ scene: Scene, side: Range & { quantity: Quantity }, cycle: import('../../run/cycle-looks.js').LimitCycle | null, hasPoints?: boolean }} shown `hasPoints`: special points are named
   * @param {import('../../style/theme.js').Theme} theme @param {import('../../words/voice.js').Voice} voice
   */
  paint(context, size, { scene, side, cycle, hasPoints = false }, theme, voice) {
    const { result, isOld, isFailed } = this.#work;
    // Of another side there is nothing yet.
    const diagram = result?.parameter === side.parameter ? result : null;
    const { quantity, from, to } = side;
    const slope = diagram && slopeOfSmall(diagram);
    const most = diagram ? highest(diagram, 'torsionAngle') : 0;
    drawBifurcation(context, size, {
      quantity, from, to, height: 'torsionAngle', limit: roundLimit(Math.max(most / degree, 0.1)) * degree,
      rest: diagram && restOf(diagram, 'torsionAngle', scene.parameters['friction.moment'] ?? 0),
      branches: diagram?.cycles.map((_, i) => lineOf(diagram, i, 'torsionAngle')) ?? [],
      points: diagram && hasPoints ? pointsOf(diagram, { height: 'torsionAngle', quantity, isRubbed: scene.linear.isRubbed }, voice) : [],
      law: slope === null ? null : { slope, text: voice.say('branch.law', { slope: voice.number(slope, 2) }) }, sweep: [],
      now: { value: scene.parameters[side.parameter], motion: scene.outlook.present.amplitude, cycle: cycle && { up: cycle.amplitude.torsionAngle, stable: cycle.stable ?? true } },
      cursor: null, isOld: isOld && diagram !== null, veiled: false,
      message: isFailed ? voice.say('stability.none') : diagram === null ? voice.say('branch.computing') : diagram.cycles.length === 0 && !isOld ? voice.say('branch.none') : '',
    }, theme, voice);
  }
}
