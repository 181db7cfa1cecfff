import { axisAcross, axisUp, drawAxes, frameOf } from './axes.js';
import { strokeCurve, curveOf } from './curve.js';
import { drawHatch } from './hatch.js';
import { drawPresent, drawSmear } from './points.js';
import { quantities } from './quantities.js';
import { destination, inStyle, unstableCycle } from './strokes.js';
import { drawTrail } from './trail.js';
import { drawVeil } from './veil.js';
import { drawWorkingPoint } from './working-point.js';

/**
 * Which motion a start ends in, over its torsion angle and torsion rate: each ending with a color of its own, what keeps on
 * swinging hatched; over it the motion of the gear and the start that a hand drags.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./canvas.js').Size} Size
 * @typedef {import('./portrait.js').States} States
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{
 *   limits: { angle: number, rate: number }, image: CanvasImageSource | null, hatch: Float32Array | null, isOld: boolean,
 *   cycle: States | null, isCycleStable: boolean, trail: States, state: ArrayLike<number>, exposed: States | null, start: { x: number, y: number } | null, veiled: boolean,
 * }} Shown `image`: a pixel a cell; `hatch`: over the starts that swing on; `start`: in rad and rad/s
 */

/** Where the plane goes in its picture. @param {Size} size @param {Theme} theme */
export const frameOfBasins = (size, theme) => frameOf(size, theme);

/** Where values stand, and what values stand where. @param {Size} size @param {Theme} theme @param {{ angle: number, rate: number }} limits */
export function placesOfBasins(size, theme, { angle, rate }) {
  const frame = frameOfBasins(size, theme);
  const [width, height] = [frame.right - frame.left, frame.bottom - frame.top];
  return {
    frame,
    x: (/** @type {number} */ value) => frame.left + ((value / angle + 1) / 2) * width, y: (/** @type {number} */ value) => frame.bottom - ((value / rate + 1) / 2) * height,
    valueX: (/** @type {number} */ px) => (((px - frame.left) / width) * 2 - 1) * angle, valueY: (/** @type {number} */ px) => (((frame.bottom - px) / height) * 2 - 1) * rate,
  };
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Size} size
 * @param {Shown} shown
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawBasins(context, size, shown, theme, voice) {
  const { limits, image, hatch, isOld, cycle, trail, state, exposed, start, veiled } = shown;
  const frame = frameOfBasins(size, theme);
  const [width, height] = [frame.right - frame.left, frame.bottom - frame.top];
  if (width < 20 || height < 20) return;
  if (!veiled && image) {
    context.globalAlpha = isOld ? 0.45 : 1;
    context.imageSmoothingEnabled = false;
    context.drawImage(image, frame.left, frame.top, width, height);
    if (!isOld && hatch) drawHatch(context, hatch, theme);
    context.globalAlpha = 1;
  }
  const x = axisAcross(quantities.torsionAngle, [-limits.angle, limits.angle], frame, theme, voice);
  const y = axisUp(quantities.torsionRate, [-limits.rate, limits.rate], frame, theme, voice);
  drawAxes(context, frame, x, y, theme);
  if (veiled) drawVeil(context, frame, theme);
  const curve = (/** @type {States} */ states) => curveOf(states.torsionAngle ?? [], states.torsionRate ?? [], x.at, y.at);
  context.save();
  context.beginPath();
  context.rect(frame.left, frame.top, width, height);
  context.clip();
  if (cycle && !veiled) inStyle(context, theme, shown.isCycleStable ? destination : unstableCycle, () => strokeCurve(context, curve(cycle), { isClosed: true }));
  drawTrail(context, curve(trail), theme.psi, theme);
  if (exposed) drawSmear(context, curve(exposed), theme.psi, theme);
  context.restore();
  if (start) drawWorkingPoint(context, frame, { x: x.at(start.x), y: y.at(start.y) }, theme);
  if (!exposed) drawPresent(context, x.at(state[0]), y.at(state[1]), theme.psi, theme);
}
