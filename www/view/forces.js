import { keysOfGhosts } from './ghosts.js';
import { keysAbove } from './key.js';
import { drawLaw } from './law.js';
import { inPanel, panelsIn } from './panels.js';
import { quantities } from './quantities.js';

/**
 * @typedef {import('./canvas.js').Size} Size
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('./law.js').Law} Law
 * @typedef {'slipAngle' | 'sideForce' | 'aligningMoment' | 'torsionAngle' | 'restoringMoment'} LawName
 * @typedef {'torsionRate' | 'frictionMoment'} FrictionName of friction, where it is seen
 * @typedef {Record<LawName, number> & Partial<Record<FrictionName, number>>} Forces
 * @typedef {Record<LawName, ArrayLike<number>> & Partial<Record<FrictionName, ArrayLike<number>>>} Exposed forces all along the exposure of a frame, where that is too long for
 *   a single point
 * @typedef {Exposed & {
 *   kinks: { sideForceLimitAngle: number | null, aligningMomentLimitAngle: number | null, freeplayAngle: number | null },
 * }} Laws as the engine gives them: columns of the tire over slip angle, of the spring over torsion angle and of friction over
 *   torsion rate, and the angles at which they bend, null where they do not
 * @typedef {{
 *   laws: Laws, limits: Forces, now: Forces | Exposed, cycle: { slipAngle: [number, number], torsionAngle: [number, number] } | null,
 *   ghosts?: { label: string, now: Forces | Exposed }[], shown?: Shown[],
 * }} ForceLaws in SI units and radians. `limits`: the ends of the axes; `cycle`: least and largest angle of the last
 *   cycle; `shown`: which laws, all but friction's unless said
 * @typedef {'sideForce' | 'aligningMoment' | 'restoringMoment' | 'frictionMoment'} Shown
 */

/** How one to four laws may share the area: side by side, in two rows, or one over the other. */
const layouts = [[[1]], [[2], [1, 1]], [[3], [2, 1], [1, 1, 1]], [[4], [2, 2], [1, 1, 1, 1]]];

/**
 * The laws that drive and hold the swing, each with the point where the gear is now: side force and aligning moment of
 * the tire over its slip angle, restoring moment of the spring over the torsion angle, moment of dry friction over the
 * torsion rate.
 * @param {CanvasRenderingContext2D} context
 * @param {Size} size
 * @param {ForceLaws} forces
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawForces(context, size, forces, theme, voice) {
  const { cycle, ghosts = [], shown = ['sideForce', 'aligningMoment', 'restoringMoment'] } = forces;
  const keys = keysOfGhosts(ghosts, theme, voice).map((key) => ({ ...key, isPoint: true }));
  const { frame, draw: drawKeys } = keysAbove(context, { left: theme.size, right: size.width - theme.size, top: theme.size * 0.9, bottom: size.height }, keys, theme);
  const top = ghosts.length ? frame.top : 0;
  const law = (/** @type {LawName | FrictionName} */ across, /** @type {LawName | FrictionName} */ up, /** @type {Pick<Law, 'cycle' | 'limitAngle' | 'freeplay'>} */ more) => ({
    across: quantities[across],
    up: quantities[up],
    limits: { across: forces.limits[across] ?? 1, up: forces.limits[up] ?? 1 },
    curve: { across: forces.laws[across] ?? [], up: forces.laws[up] ?? [] },
    now: /** @type {Law['now']} */ ({ across: forces.now[across], up: forces.now[up] }),
    ghosts: ghosts.map(({ now }) => /** @type {Law['now']} */ ({ across: now[across], up: now[up] })),
    ...more,
  });
  const limit = (/** @type {number | null} */ at, /** @type {Omit<import('./law.js').LimitAngle, 'at'>} */ name) => (at === null ? null : { ...name, at });
  const slip = cycle?.slipAngle ?? null;
  const { kinks } = forces.laws;
  const laws = {
    sideForce: law('slipAngle', 'sideForce', { cycle: slip, limitAngle: limit(kinks.sideForceLimitAngle, { symbol: 'δ' }), freeplay: 0 }),
    aligningMoment: law('slipAngle', 'aligningMoment', { cycle: slip, limitAngle: limit(kinks.aligningMomentLimitAngle, { symbol: 'α', sub: 'g' }), freeplay: 0 }),
    restoringMoment: law('torsionAngle', 'restoringMoment', { cycle: cycle?.torsionAngle ?? null, limitAngle: null, freeplay: kinks.freeplayAngle ?? 0 }),
    frictionMoment: law('torsionRate', 'frictionMoment', { cycle: null, limitAngle: null, freeplay: 0 }),
  };
  panelsIn({ width: size.width, height: size.height - top }, layouts[shown.length - 1]).forEach((panel, i) => {
    const box = { ...panel, top: panel.top + top, bottom: panel.bottom + top };
    inPanel(context, box, (inner, innerSize) => drawLaw(inner, innerSize, laws[shown[i]], theme, voice));
  });
  drawKeys();
}
