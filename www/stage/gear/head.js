/**
 * The steering head, from above, in a round detail: what ψ turns and what holds it.
 *
 * The tube turns with the wheel. Its tooth sits in a slot of the collar; the spiral spring ties the
 * collar to the fixed housing. Inside the gap the tube turns alone; beyond it the tooth takes the
 * collar along, by s(ψ), and the spring winds. A damper works on a lever of the tube all the time.
 *
 * The gap is always drawn ±17°, so that tooth and stop touch on the sheet exactly when |ψ| reaches
 * ψ_fp; the collar's turn is drawn with the magnification of the wheel.
 *
 * @module
 */

import { drawDamper } from './damper.js';
import { materialsFor } from './materials.js';
import { within } from './pose.js';
import { translucent } from './theme.js';

/** @typedef {import('./sheet.js').Sheet} Sheet */
/** @typedef {import('./scene.js').Scene} Scene */
/** @typedef {import('./theme.js').Theme} Theme */

const DEGREE = Math.PI / 180;
/** Half of the gap, as drawn. */
export const DRAWN_GAP = 17 * DEGREE;
/** Half of the tooth's angle. */
const TOOTH = 10 * DEGREE;
/** Where slot and tooth are: behind the axis on the sheet, below in the picture. */
const SLOT = -90 * DEGREE;
const LARGEST_TURN = 75 * DEGREE;

/** Radii as shares of the detail's. */
const HOUSING = 0.885;
const SPRING_OUTER = 0.83;
const SPRING_INNER = 0.57;
const COLLAR = 0.52;
const BORE = 0.325;
const TUBE = 0.27;
const TIP = 0.49;
const TURNS = 3;

/**
 * @typedef {object} HeadPose
 * @property {number} collar drawn turn of the collar, counter-clockwise [rad]
 * @property {number} tube drawn turn of the tube
 * @property {number} gap drawn half gap, 0 without freeplay
 * @property {-1 | 0 | 1} touching the stop that the tooth presses on: 1 the one it meets turning
 *   counter-clockwise, 0 none
 */

/**
 * @param {Scene} scene
 * @returns {HeadPose}
 */
export function headPose(scene) {
  const psi = scene.state[0] ?? 0;
  const freeplay = scene.parameters.freeplayAngle ?? 0;
  const collar = within(scene.magnification * scene.forces.springAngle, LARGEST_TURN);
  if (!(freeplay > 0)) return { collar, tube: collar, gap: 0, touching: 0 };
  const place = within(psi / freeplay, 1);
  const touching = Math.abs(place) === 1 ? /** @type {-1 | 1} */ (place) : 0;
  return { collar, tube: collar + DRAWN_GAP * place, gap: DRAWN_GAP, touching };
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Scene} scene
 * @param {Theme} theme
 */
export function drawHead(ctx, sheet, scene, theme) {
  const { x, y, radius } = sheet.head;
  const pose = headPose(scene);
  const wound = scene.forces.springAngle !== 0;
  const stiff = (scene.parameters.torsionalStiffness ?? 1) > 0;
  ctx.save();
  ctx.translate(x, y);
  drawHousing(ctx, sheet, radius, theme);
  ctx.globalAlpha = stiff ? 1 : 0.3;
  drawSpring(ctx, sheet, radius, pose.collar, wound, theme);
  ctx.globalAlpha = 1;
  drawCollar(ctx, sheet, radius, pose, theme);
  drawTube(ctx, sheet, radius, pose, theme);
  drawDamper(ctx, sheet, radius, pose.tube, scene.parameters.dampingConstant ?? 0, theme);
  drawCross(ctx, sheet, radius, theme);
  ctx.restore();
}

/** Where the leader meets the detail: low on its near side, out of the pointer's way. */
const LEADER_END = 250 * DEGREE;

/**
 * A thin dotted line from the steering axis to the detail.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Theme} theme
 */
export function drawLeader(ctx, sheet, theme) {
  const { axis, head } = sheet;
  ctx.strokeStyle = theme.ghost;
  ctx.lineWidth = sheet.line;
  ctx.setLineDash([2, 4]);
  ctx.beginPath();
  ctx.moveTo(axis.x, axis.y);
  ctx.lineTo(head.x + head.radius * Math.cos(LEADER_END), head.y - head.radius * Math.sin(LEADER_END));
  ctx.stroke();
  ctx.setLineDash([]);
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {number} radius
 * @param {Theme} theme
 */
function drawHousing(ctx, sheet, radius, theme) {
  const inner = HOUSING * radius;
  const well = ctx.createRadialGradient(0, 0, 0.5 * inner, 0, 0, inner);
  well.addColorStop(0, theme.surface);
  well.addColorStop(0.75, theme.surface);
  well.addColorStop(1, theme.raised);
  ctx.beginPath();
  ctx.arc(0, 0, radius, 0, 2 * Math.PI);
  ctx.fillStyle = theme.surface;
  ctx.fill();
  ctx.beginPath();
  ctx.arc(0, 0, inner, 0, 2 * Math.PI);
  ctx.fillStyle = well;
  ctx.fill();

  const strokes = Math.round(radius * 0.82);
  const lean = 0.07;
  ctx.strokeStyle = translucent(theme.ink2, 0.85);
  ctx.lineWidth = sheet.line;
  ctx.beginPath();
  for (let i = 0; i < strokes; i++) {
    const angle = (2 * Math.PI * i) / strokes;
    ctx.moveTo(inner * Math.cos(angle), inner * Math.sin(angle));
    ctx.lineTo(radius * Math.cos(angle + lean), radius * Math.sin(angle + lean));
  }
  ctx.stroke();

  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = 2 * sheet.line;
  ctx.beginPath();
  ctx.arc(0, 0, radius, 0, 2 * Math.PI);
  ctx.stroke();
  ctx.lineWidth = 1.2 * sheet.line;
  ctx.beginPath();
  ctx.arc(0, 0, inner, 0, 2 * Math.PI);
  ctx.stroke();
}

/**
 * A spiral from the housing, at the left, to the collar; heavier while it works.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {number} radius
 * @param {number} collar
 * @param {boolean} wound
 * @param {Theme} theme
 */
function drawSpring(ctx, sheet, radius, collar, wound, theme) {
  const sweep = TURNS * 2 * Math.PI + collar;
  const steps = 168;
  const outer = SPRING_OUTER * radius;
  const inner = SPRING_INNER * radius;
  const width = Math.min((wound ? 3.2 : 2.2) * sheet.line, 0.042 * radius);
  ctx.lineJoin = 'round';
  ctx.lineCap = 'round';
  ctx.beginPath();
  ctx.moveTo(-HOUSING * radius, 0);
  for (let i = 0; i <= steps; i++) {
    const share = i / steps;
    const angle = Math.PI + share * sweep;
    const r = outer + share * (inner - outer);
    ctx.lineTo(r * Math.cos(angle), -r * Math.sin(angle));
  }
  ctx.lineTo(-COLLAR * radius * Math.cos(collar), COLLAR * radius * Math.sin(collar));
  ctx.strokeStyle = theme.psi;
  ctx.lineWidth = width;
  ctx.stroke();
  // The light along the steel strip.
  ctx.strokeStyle = translucent(theme.surface, 0.5);
  ctx.lineWidth = 0.3 * width;
  ctx.stroke();
  ctx.lineCap = 'butt';
}

/**
 * A ring open at its slot. In the slot the gap is tinted and its stops are marked; the stop that
 * the tooth presses on glows.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {number} radius
 * @param {HeadPose} pose
 * @param {Theme} theme
 */
function drawCollar(ctx, sheet, radius, pose, theme) {
  const materials = materialsFor(theme);
  const outer = COLLAR * radius;
  const bore = BORE * radius;
  const middle = -(SLOT + pose.collar);
  const half = TOOTH + pose.gap;

  if (pose.gap > 0) {
    ctx.beginPath();
    ctx.arc(0, 0, outer, middle - half, middle + half);
    ctx.arc(0, 0, bore, middle + half, middle - half, true);
    ctx.closePath();
    ctx.fillStyle = translucent(theme.freeplay, 0.32);
    ctx.fill();
  }

  const shine = ctx.createLinearGradient(-outer, -outer, outer, outer);
  shine.addColorStop(0, materials.metalLit);
  shine.addColorStop(0.55, materials.metal);
  shine.addColorStop(1, materials.metalShade);
  ctx.beginPath();
  ctx.arc(0, 0, outer, middle + half, middle - half + 2 * Math.PI);
  ctx.arc(0, 0, bore, middle - half + 2 * Math.PI, middle + half, true);
  ctx.closePath();
  ctx.fillStyle = shine;
  ctx.fill();
  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = 1.4 * sheet.line;
  ctx.lineJoin = 'round';
  ctx.stroke();

  if (pose.gap === 0) return;
  for (const side of /** @type {const} */ ([-1, 1])) {
    const angle = middle - side * half;
    const touched = pose.touching === side;
    if (touched) drawGlow(ctx, 0.42 * radius, angle, 0.3 * radius, theme);
    ctx.strokeStyle = touched ? theme.freeplayText : theme.freeplay;
    ctx.lineWidth = (touched ? 4.5 : 3.2) * sheet.line;
    ctx.beginPath();
    ctx.moveTo(bore * Math.cos(angle), bore * Math.sin(angle));
    ctx.lineTo(outer * Math.cos(angle), outer * Math.sin(angle));
    ctx.stroke();
  }
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {number} distance
 * @param {number} angle
 * @param {number} size
 * @param {Theme} theme
 */
function drawGlow(ctx, distance, angle, size, theme) {
  const x = distance * Math.cos(angle);
  const y = distance * Math.sin(angle);
  const glow = ctx.createRadialGradient(x, y, 0, x, y, size);
  glow.addColorStop(0, translucent(theme.freeplay, 0.95));
  glow.addColorStop(0.45, translucent(theme.freeplay, 0.5));
  glow.addColorStop(1, translucent(theme.freeplay, 0));
  ctx.fillStyle = glow;
  ctx.beginPath();
  ctx.arc(x, y, size, 0, 2 * Math.PI);
  ctx.fill();
}

/**
 * The tube with its tooth, one outline.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {number} radius
 * @param {HeadPose} pose
 * @param {Theme} theme
 */
function drawTube(ctx, sheet, radius, pose, theme) {
  const middle = -(SLOT + pose.tube);
  // The tooth's flanks run along radii, as the stops do, so that they meet face to face.
  const root = TOOTH;
  ctx.beginPath();
  ctx.arc(0, 0, TUBE * radius, middle + root, middle - root + 2 * Math.PI);
  ctx.lineTo(TIP * radius * Math.cos(middle - TOOTH), TIP * radius * Math.sin(middle - TOOTH));
  ctx.arc(0, 0, TIP * radius, middle - TOOTH, middle + TOOTH);
  ctx.closePath();
  const shine = ctx.createRadialGradient(-0.1 * radius, -0.12 * radius, 0, 0, 0, TIP * radius);
  shine.addColorStop(0, theme.surface);
  shine.addColorStop(0.5, theme.surface);
  shine.addColorStop(1, translucent(theme.psi, 0.25));
  ctx.fillStyle = theme.surface;
  ctx.fill();
  ctx.fillStyle = shine;
  ctx.fill();
  ctx.strokeStyle = theme.psi;
  ctx.lineWidth = 2.4 * sheet.line;
  ctx.lineJoin = 'round';
  ctx.stroke();
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {number} radius
 * @param {Theme} theme
 */
function drawCross(ctx, sheet, radius, theme) {
  const arm = 0.065 * radius;
  ctx.strokeStyle = theme.ink;
  ctx.lineWidth = 1.6 * sheet.line;
  ctx.beginPath();
  ctx.moveTo(-arm, 0);
  ctx.lineTo(arm, 0);
  ctx.moveTo(0, -arm);
  ctx.lineTo(0, arm);
  ctx.stroke();
}
