/**
 * The line on the ground that the tire follows, and the bend it gives the tire.
 *
 * The track is where the leading contact point has been. Inside the contact the tire's points rest
 * on the ground, so there its center line lies on the track; ahead of and behind the contact the
 * deformation decays with the relaxation length, as a stretched string's does.
 *
 * @module
 */

import { heldLine } from './bend.js';
import { drawnAngle, drawnDeformation } from './pose.js';

/** @typedef {import('./scene.js').Scene} Scene */
/** @typedef {import('./pose.js').Pose} Pose */

/** Points of the track nearer than this to their neighbor are left out [m]. */
const SPACING = 0.007;

/**
 * Points on the ground, newest first, in meters from the steering axis.
 *
 * @typedef {object} Trace
 * @property {number[]} x forward
 * @property {number[]} y to the left
 */

/**
 * The track from the leading contact point back over `length` meters, in the sheet's
 * magnification: each past position of the drawn point, moved back with the ground.
 *
 * @param {Scene} scene
 * @param {Pose} pose
 * @param {number} length
 * @returns {Trace}
 */
export function traceBehind(scene, pose, length) {
  const { distance, torsionAngle, lateralDeformation } = scene.track;
  const lead = pose.half - pose.caster;
  let x = lead * pose.cos - pose.deformation * pose.sin;
  let y = lead * pose.sin + pose.deformation * pose.cos;
  const end = x - length;
  const xs = [x];
  const ys = [y];
  for (let i = distance.length - 1; i >= 0 && x > end; i--) {
    const rolled = scene.roll - distance[i];
    if (!(rolled > 0)) continue;
    const angle = drawnAngle(scene, torsionAngle[i]);
    const deformation = drawnDeformation(scene, lateralDeformation[i]);
    const px = lead * Math.cos(angle) - deformation * Math.sin(angle) - rolled;
    const py = lead * Math.sin(angle) + deformation * Math.cos(angle);
    if (Math.abs(px - x) < SPACING && Math.abs(py - y) < SPACING) continue;
    xs.push((x = px));
    ys.push((y = py));
  }
  return { x: xs, y: ys };
}

/**
 * The contact line in the wheel's frame, from the leading point backwards: l falls from a to −a.
 *
 * @typedef {object} ContactLine
 * @property {number[]} l
 * @property {number[]} n
 */

/**
 * As it is drawn: as far as a tire bends.
 *
 * @param {Trace} trace
 * @param {Pose} pose
 */
export const contactLine = (trace, pose) => heldLine(restingLine(trace, pose));

/**
 * On the track, however that bends the tire.
 *
 * @param {Trace} trace
 * @param {Pose} pose
 * @returns {ContactLine}
 */
export function restingLine(trace, pose) {
  const line = { l: [pose.half], n: [pose.deformation] };
  let lastL = pose.half;
  let lastN = pose.deformation;
  for (let i = 1; i < trace.x.length && lastL > -pose.half; i++) {
    const x = trace.x[i];
    const y = trace.y[i];
    let l = x * pose.cos + y * pose.sin + pose.caster;
    let n = -x * pose.sin + y * pose.cos;
    if (l >= lastL) continue;
    if (l < -pose.half) {
      n = lastN + ((n - lastN) * (lastL + pose.half)) / (lastL - l);
      l = -pose.half;
    }
    line.l.push((lastL = l));
    line.n.push((lastN = n));
  }
  return line;
}

/**
 * The deformation of the tire's center line at l.
 *
 * @param {ContactLine} line
 * @param {Pose} pose
 * @param {number} l
 */
export function bendAt(line, pose, l) {
  const last = line.l.length - 1;
  const front = line.l[0];
  const back = line.l[last];
  if (l >= front) {
    return line.n[0] * Math.exp((front - l) / pose.relaxation);
  }
  if (l <= back) {
    return line.n[last] * Math.exp((l - back) / pose.relaxation);
  }
  let i = 1;
  while (line.l[i] > l) i++;
  const ahead = line.l[i - 1];
  const behind = line.l[i];
  const share = (ahead - l) / (ahead - behind);
  const from = line.n[i - 1];
  return from + share * (line.n[i] - from);
}
