import { axisOf } from './axes.js';
import { addCurve, curveOf } from './curve.js';
import { keysOfGhosts } from './ghosts.js';
import { placeKeys } from './key.js';
import { projectionOf } from './look.js';
import { drawEdges, drawFaces } from './orbit-box.js';
import { drawPresent, drawSmear } from './points.js';
import { quantities } from './quantities.js';
import { destination, gapEdge, ghost as ghostStyle, inStyle } from './strokes.js';
import { strengthAt } from './trail.js';

/**
 * @typedef {import('./canvas.js').Size} Size
 * @typedef {import('./curve.js').Curve} Curve
 * @typedef {import('./look.js').Look} Look
 * @typedef {import('./look.js').Projection} Projection
 * @typedef {import('./portrait.js').Motion} Motion
 * @typedef {import('./portrait.js').States} States
 * @typedef {import('./strokes.js').Style} Style
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{ angle: number, rate: number, deformation: number }} Limits the ends of the axes, in rad, rad/s, m
 * @typedef {{ shown: Curve, shadow: Curve, nearness: (i: number) => number, isClosed: boolean }} Path a curve in the box,
 *   and what lies straight below it on the floor
 */

/** Pieces of the trail, each of one strength. */
const pieces = 64;

/**
 * The motion in its whole state space: ψ to the right, ψ̇ away, y up. The trail is the fainter, the older and the
 * farther it is; it casts a shadow on the floor, which is the phase portrait.
 * @param {CanvasRenderingContext2D} context
 * @param {Size} size
 * @param {Motion & { limits: Limits, look: Look }} motion
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawOrbit(context, size, motion, theme, voice) {
  const { limits, look, orbitLabel, orbitStyle = destination, freeplay, exposed = null, ghosts = [], veiled = false } = motion;
  const canvas = { left: theme.size * 0.8, right: size.width - theme.size * 0.8, top: theme.size * 0.8, bottom: size.height - theme.size * 0.6 };
  const goal = { text: orbitLabel, style: veiled || (motion.orbit.torsionAngle?.length ?? 0) < 2 ? null : orbitStyle };
  const gap = { text: freeplay > 0 ? voice.say('phase.gap') : '', style: gapEdge };
  const { frame, draw: drawKeys } = placeKeys(context, canvas, [
    { entry: veiled ? 'veiled' : goal, color: theme.ink, wishes: ['top-left', 'top-right'] },
    ...keysOfGhosts(ghosts, theme, voice).map((key) => ({ ...key, wishes: /** @type {import('./corner.js').Corner[]} */ (['bottom-left', 'bottom-right', 'top-right', 'top-left']) })),
    { entry: gap, color: theme.freeplayText, weight: 600, wishes: ['top-right', 'bottom-right', 'bottom-left'] },
  ], theme);
  const projection = projectionOf(look, {
    left: frame.left + theme.size * 4.2, right: frame.right - theme.size * 2.4, top: frame.top + theme.size * 0.6, bottom: frame.bottom - theme.size * 2.6,
  });
  const most = Math.min(6, (2 * projection.scale) / (theme.size * 2.6));
  const axis = (/** @type {'torsionAngle' | 'torsionRate' | 'lateralDeformation'} */ name, /** @type {number} */ limit) =>
    axisOf(quantities[name], [-limit, limit], [-1, 1], most, voice);
  const axes = { x: axis('torsionAngle', limits.angle), y: axis('torsionRate', limits.rate), z: axis('lateralDeformation', limits.deformation) };
  const path = (/** @type {States} */ states, isClosed = false) => pathOf(states, limits, projection, isClosed);
  const trail = path(motion.trail);
  const orbit = path(veiled ? {} : motion.orbit, true);
  const pinned = ghosts.map((ghost) => path(ghost.orbit ?? ghost.trail ?? {}, ghost.orbit !== undefined));
  /** @type {[number, number, number]} */
  const now = [motion.state[0] / limits.angle, motion.state[1] / limits.rate, motion.state[2] / limits.deformation];

  drawFaces(context, projection, axes, theme);
  drawGapOnFloor(context, freeplay / limits.angle, projection, theme);
  drawShadow(context, trail, theme);
  const words = drawEdges(context, projection, axes, canvas, theme);
  pinned.forEach((one, i) => drawInDepth(context, one, ghostStyle(i), theme));
  if (!exposed) drawDrop(context, now, projection, theme);
  drawTrailInDepth(context, trail, theme);
  drawInDepth(context, orbit, orbitStyle, theme);
  if (exposed) drawSmear(context, path(exposed).shown, theme.psi, theme);
  else drawPresent(context, projection.across(now[0], now[1]), projection.up(...now), theme.psi, theme);
  drawKeys(words, [trail, orbit, ...pinned].map(({ shown }) => shown));
}

/** @param {States} states @param {Limits} limits @param {Projection} projection @param {boolean} isClosed @returns {Path} */
function pathOf({ torsionAngle = [], torsionRate = [], lateralDeformation = [] }, limits, projection, isClosed) {
  const count = torsionAngle.length;
  const [across, up, floor, near] = Array.from({ length: 4 }, () => new Float64Array(count));
  for (let i = 0; i < count; i++) {
    const [x, y, z] = [torsionAngle[i] / limits.angle, torsionRate[i] / limits.rate, lateralDeformation[i] / limits.deformation];
    across[i] = projection.across(x, y);
    up[i] = projection.up(x, y, z);
    floor[i] = projection.up(x, y, -1);
    near[i] = projection.nearness(x, y, z);
  }
  const same = (/** @type {number} */ value) => value;
  return { shown: curveOf(across, up, same, same), shadow: curveOf(across, floor, same, same), nearness: (i) => near[i], isClosed };
}

/**
 * @param {CanvasRenderingContext2D} context @param {number} half of the gap, as a share of the axis
 * @param {Projection} projection @param {Theme} theme
 */
function drawGapOnFloor(context, half, projection, theme) {
  if (!(half > 0)) return;
  const edge = Math.min(half, 1);
  const corners = [[-edge, -1], [-edge, 1], [edge, 1], [edge, -1]].map(([x, y]) => [projection.across(x, y), projection.up(x, y, -1)]);
  context.beginPath();
  corners.forEach(([x, y], i) => context[i ? 'lineTo' : 'moveTo'](x, y));
  context.closePath();
  context.globalAlpha = 0.25;
  context.fillStyle = theme.freeplay;
  context.fill();
  context.globalAlpha = 1;
  inStyle(context, theme, gapEdge, () => {
    context.beginPath();
    for (const [from, to] of [[0, 1], [2, 3]]) {
      context.moveTo(corners[from][0], corners[from][1]);
      context.lineTo(corners[to][0], corners[to][1]);
    }
    context.stroke();
  });
}

/** @param {CanvasRenderingContext2D} context @param {Path} trail @param {Theme} theme */
function drawShadow(context, { shadow }, theme) {
  context.strokeStyle = theme.ink2;
  context.lineWidth = 1.6 * theme.line;
  const parts = 8;
  const last = shadow.count - 1;
  for (let part = 0; part < parts; part++) {
    context.globalAlpha = 0.28 * strengthAt((part + 1) / parts);
    context.beginPath();
    addCurve(context, shadow, Math.floor((last * part) / parts), Math.floor((last * (part + 1)) / parts));
    context.stroke();
  }
  context.globalAlpha = 1;
}

/** @param {CanvasRenderingContext2D} context @param {Path} trail @param {Theme} theme */
function drawTrailInDepth(context, { shown, nearness }, theme) {
  const last = shown.count - 1;
  context.strokeStyle = theme.psi;
  context.lineJoin = 'round';
  context.lineCap = 'butt';
  for (let piece = 0; piece < pieces; piece++) {
    const from = Math.floor((last * piece) / pieces);
    const to = Math.floor((last * (piece + 1)) / pieces);
    if (to <= from) continue;
    const near = nearness((from + to) >> 1);
    context.globalAlpha = strengthAt((piece + 1) / pieces) * (0.45 + 0.55 * near);
    context.lineWidth = (1.2 + 1.9 * near) * theme.line;
    context.beginPath();
    addCurve(context, shown, from, to);
    context.stroke();
  }
  context.globalAlpha = 1;
}

/**
 * A dashed curve, its far half fainter. Each half is drawn in runs as long as can be, for dashes begin anew with a run.
 * @param {CanvasRenderingContext2D} context @param {Path} path @param {Style} style @param {Theme} theme
 */
function drawInDepth(context, { shown, nearness, isClosed }, style, theme) {
  const last = isClosed ? shown.count : shown.count - 1;
  if (last < 1) return;
  inStyle(context, theme, style, () => {
    for (const near of [false, true]) {
      context.globalAlpha = near ? 1 : 0.5;
      context.beginPath();
      let isOpen = false;
      for (let i = 0; i < last; i++) {
        const isHere = nearness(i) >= 0.5 === near;
        const next = (i + 1) % shown.count;
        if (isHere && !isOpen) context.moveTo(shown.x(i), shown.y(i));
        if (isHere) context.lineTo(shown.x(next), shown.y(next));
        isOpen = isHere;
      }
      context.stroke();
    }
  });
  context.globalAlpha = 1;
}

/**
 * From where the motion is now straight down to the floor.
 * @param {CanvasRenderingContext2D} context @param {[number, number, number]} now @param {Projection} projection @param {Theme} theme
 */
function drawDrop(context, [x, y, z], projection, theme) {
  const [across, top, foot] = [projection.across(x, y), projection.up(x, y, z), projection.up(x, y, -1)];
  context.strokeStyle = theme.ink2;
  context.lineWidth = 1.2 * theme.line;
  context.setLineDash([2, 3]);
  context.beginPath();
  context.moveTo(across, top);
  context.lineTo(across, foot);
  context.stroke();
  context.setLineDash([]);
  context.fillStyle = theme.ink2;
  context.beginPath();
  context.arc(across, foot, 3 * Math.sqrt(theme.line), 0, 2 * Math.PI);
  context.fill();
}
