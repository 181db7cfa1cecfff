/**
 * What of a bifurcation diagram is drawn besides its branches: rest, special points in words, and where a simulated sweep has
 * settled.
 *
 * @typedef {import('../../pkg/shimmy.js').Bifurcation} Bifurcation
 * @typedef {import('../../pkg/shimmy.js').Sweep} Sweep
 * @typedef {import('../../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('../../words/voice.js').Key} Key
 * @typedef {import('./branches.js').Height} Height
 */

import { frictionParameter } from '../../run/linear-looks.js';
import { trusted } from '../../run/trusted.js';
import { decimalsFor } from '../../words/number.js';
import { heightsOf, turnsOf } from './branches.js';

/**
 * Rest along the foot of a diagram. Of rest the engine says what linear theory does, which leaves friction out: a wheel that it
 * holds stays at rest, whatever that says.
 * @param {Bifurcation} diagram
 * @param {Height} height
 * @param {number} friction of the gear, in N m
 * @returns {import('../../view/bifurcation.js').Line}
 */
export function restOf(diagram, height, friction) {
  const { parameter, equilibria } = diagram;
  const across = equilibria[parameter];
  const isHeld = (/** @type {number} */ i) => (parameter === frictionParameter ? across[i] : friction) > 0;
  return {
    across, up: (equilibria.state[height] ?? new Float64Array(across.length)).map(Math.abs),
    stable: equilibria.stable.map((stable, i) => (isHeld(i) ? 1 : stable)), turns: turnsOf(diagram, null),
  };
}

/**
 * A branch as it is drawn. Cycles wider than the model is trusted for are beyond it.
 * @param {Bifurcation} diagram
 * @param {number} at which of its branches
 * @param {Height} height
 * @returns {import('../../view/bifurcation.js').Line}
 */
export function lineOf(diagram, at, height) {
  const branch = diagram.cycles[at];
  return { across: branch[diagram.parameter], up: heightsOf(branch, height), stable: branch.stable, turns: turnsOf(diagram, at), isBeyond: (i) => branch.amplitude[i] > trusted };
}

/**
 * Special points with their names, in fewer words behind: which way cycles come out of a Hopf point goes first.
 * @param {Bifurcation} diagram
 * @param {{ height: Height, quantity: Quantity, isRubbed: boolean }} shown `isRubbed`: there is friction, of which those of rest do not know
 * @param {Voice} voice
 */
export function pointsOf({ parameter, points, cycles }, { height, quantity, isRubbed }, voice) {
  return points.map((point) => {
    const isOfRest = point.kind === 'hopf' || point.kind === 'divergence';
    const up = !isOfRest && point.branch !== null ? heightsOf(cycles[point.branch], height)[point.index] : height === 'frequency' ? point.frequency : 0;
    const value = quantity.write(quantity.snapped(point[parameter]), voice);
    const name = voice.say(/** @type {Key} */ (`branch.point.${point.kind}`), { value });
    const whole = isOfRest && isRubbed ? voice.say('branch.frictionless', { point: name }) : point.criticality ? voice.say(`branch.${point.criticality}`, { point: name }) : name;
    return { kind: point.kind, across: point[parameter], up, texts: [...new Set([whole, name, value])] };
  });
}

/**
 * Which way cycles come out of the Hopf points, and what tells that. Of several that differ in nothing else there is one.
 * @param {Bifurcation} diagram
 * @param {Quantity} quantity
 * @param {Voice} voice
 * @returns {{ name: string, means: string, how: string }[]} `name`: "Hopf 27.6 m/s, supercritical"; `means`: that in other words; `how`: by which test
 */
export function criticalityInWords({ parameter, points }, quantity, voice) {
  /** @type {Map<string, { at: string[], criticality: NonNullable<Bifurcation['points'][number]['criticality']>, how: string }>} */
  const alike = new Map();
  for (const point of points) {
    const { criticality, by, lyapunov } = point;
    if (point.kind !== 'hopf' || !criticality) continue;
    const how = criticality === 'degenerate' || !by ? '' : voice.say(`branch.by.${by}`, { lyapunov: voice.number(lyapunov ?? NaN, decimalsFor(lyapunov ?? NaN, 3)) });
    const before = alike.get(criticality + how)?.at ?? [];
    alike.set(criticality + how, { at: [...before, voice.say('branch.point.hopf', { value: quantity.write(quantity.snapped(point[parameter]), voice) })], criticality, how });
  }
  return Array.from(alike.values(), ({ at, criticality, how }) => ({ name: voice.say(`branch.${criticality}`, { point: at.join(', ') }), means: voice.say(`branch.${criticality}.means`), how }));
}

/** Where a simulated sweep has come to on its way up and down, and whether it has settled there. @param {Sweep} sweep */
export function stopsOf(sweep) {
  const isSettled = (/** @type {import('../../pkg/shimmy.js').SweepWay & { settled?: Uint8Array }} */ { settled }, /** @type {number} */ i) => settled?.[i] !== 0;
  return /** @type {const} */ (['up', 'down']).flatMap((way) => Array.from(sweep.value, (value, i) => ({ value, way, up: sweep[way].amplitude[i], isSettled: isSettled(sweep[way], i) }))
    .filter(({ up }, i) => sweep[way].kind[i] < sweep.kinds.length && Number.isFinite(up)));
}
