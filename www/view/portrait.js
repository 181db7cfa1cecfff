import { axisAcross, axisUp, drawAxes, footOf, frameOf } from './axes.js';
import { curveOf, strokeCurve } from './curve.js';
import { drawGap, nameGap } from './gap.js';
import { drawGhosts, keysOfGhosts } from './ghosts.js';
import { placeKeys } from './key.js';
import { drawPresentWithin, drawSmear } from './points.js';
import { quantities } from './quantities.js';
import { destination, inStyle } from './strokes.js';
import { drawTrail } from './trail.js';

/**
 * What the portraits have in common: one state of the gear over its torsion angle.
 *
 * @typedef {import('./canvas.js').Size} Size
 * @typedef {import('./corner.js').Corner} Corner
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {'torsionAngle' | 'torsionRate' | 'lateralDeformation'} StateName
 * @typedef {Partial<Record<StateName, ArrayLike<number>>>} States columns in SI units and radians
 * @typedef {{ label: string, orbit?: States, trail?: States }} Ghost a pinned run: the cycle it is on, or where it went
 * @typedef {{
 *   trail: States, orbit: States, orbitLabel: string, state: ArrayLike<number>, freeplay: number,
 *   orbitStyle?: import('./strokes.js').Style, exposed?: States | null, ghosts?: Ghost[], veiled?: boolean,
 * }} Motion `state`: ψ, ψ̇, y now; `orbitStyle`: of the orbit, dotted unless said; `freeplay`: half of the gap; `exposed`: the states of a frame's exposure, where that is
 *   too long for a single one; `veiled`: where it goes is not to be seen yet
 */

/**
 * Where the motion comes from (fading trail), is (dot) and goes (dotted), with the gap and with pinned runs (dashed).
 * @param {CanvasRenderingContext2D} context
 * @param {Size} size
 * @param {Motion} motion
 * @param {{ up: StateName, present: number, limits: { angle: number, up: number }, corners: Corner[] }} plot
 *   `limits`: the ends of the axes; `corners`: where words go, first those that such curves leave free
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawPortrait(context, size, motion, { up, present, limits, corners }, theme, voice) {
  const { orbitLabel, orbitStyle = destination, freeplay, exposed = null, ghosts = [], veiled = false } = motion;
  const goal = { text: orbitLabel, style: veiled || (motion.orbit.torsionAngle?.length ?? 0) < 2 ? null : orbitStyle };
  const area = frameOf(size, theme);
  const { frame, draw: drawKeys } = placeKeys(context, area, [
    { entry: veiled ? 'veiled' : goal, color: theme.ink, wishes: corners },
    ...keysOfGhosts(ghosts, theme, voice).map((key) => ({ ...key, wishes: corners.toReversed() })),
  ], theme, footOf(context, area, quantities.torsionAngle, theme, voice));
  const x = axisAcross(quantities.torsionAngle, [-limits.angle, limits.angle], frame, theme, voice);
  const y = axisUp(quantities[up], [-limits.up, limits.up], frame, theme, voice);
  const curve = (/** @type {States} */ states) => curveOf(states.torsionAngle ?? [], states[up] ?? [], x.at, y.at);
  const trail = curve(motion.trail);
  const orbit = curve(veiled ? {} : motion.orbit);
  const pinned = ghosts.map((ghost) => ({ curve: curve(ghost.orbit ?? ghost.trail ?? {}), isClosed: ghost.orbit !== undefined }));
  const color = theme[quantities[up].color];

  drawGap(context, frame, freeplay, x.at, theme);
  drawAxes(context, frame, x, y, theme);
  const named = nameGap(context, frame, freeplay, x.at, theme, voice);

  context.save();
  context.beginPath();
  context.rect(frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top);
  context.clip();
  drawGhosts(context, pinned, theme);
  drawTrail(context, trail, color, theme);
  inStyle(context, theme, orbitStyle, () => strokeCurve(context, orbit, { isClosed: true }));
  if (exposed) drawSmear(context, curve(exposed), color, theme);
  context.restore();
  if (!exposed) drawPresentWithin(context, frame, x.at(motion.state[0]), y.at(present), color, theme);
  drawKeys(named, [trail, orbit, ...pinned.map((ghost) => ghost.curve)]);
}
