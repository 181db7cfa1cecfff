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

import { heightsOf, turnsOf } from './branches.js';

/** Dry friction, as the engine names it. */
const frictionParameter = 'friction.moment';

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
 * Special points with their names.
 * @param {Bifurcation} diagram
 * @param {{ height: Height, quantity: Quantity, isRubbed: boolean }} shown `isRubbed`: there is friction, of which those of rest do not know
 * @param {Voice} voice
 */
export function pointsOf({ parameter, points, cycles }, { height, quantity, isRubbed }, voice) {
  return points.map((point) => {
    const isOfRest = point.kind === 'hopf' || point.kind === 'divergence';
    const up = !isOfRest && point.branch !== null ? heightsOf(cycles[point.branch], height)[point.index] : height === 'frequency' ? point.frequency : 0;
    const kind = point.kind === 'hopf' && point.criticality === 'subcritical' ? 'hopf.subcritical' : point.kind;
    const name = voice.say(/** @type {Key} */ (`branch.point.${kind}`), { value: quantity.write(quantity.snapped(point[parameter]), voice) });
    return { kind: point.kind, across: point[parameter], up, text: isOfRest && isRubbed ? voice.say('branch.frictionless', { point: name }) : name };
  });
}

/** Where a simulated sweep has settled, on its way up and down. @param {Sweep} sweep */
export function stopsOf(sweep) {
  return /** @type {const} */ (['up', 'down']).flatMap((way) => Array.from(sweep.value, (value, i) => ({ value, way, up: sweep[way].amplitude[i] }))
    .filter(({ up }, i) => sweep[way].kind[i] < sweep.kinds.length && Number.isFinite(up)));
}
