/**
 * The tire from above: rubber bent along the contact line, on a rim that stays in the wheel plane.
 * So y is seen as a shift between rim and tire.
 *
 * @module
 */

import { bendAt } from './contact-line.js';
import { materialsFor } from './materials.js';
import { inWheelFrame } from './pose.js';
import { WHEEL_WIDTH } from './sheet.js';
import { translucent } from './theme.js';

/** @typedef {import('./sheet.js').Sheet} Sheet */
/** @typedef {import('./pose.js').Pose} Pose */
/** @typedef {import('./contact-line.js').ContactLine} ContactLine */
/** @typedef {import('./theme.js').Theme} Theme */

const STATIONS = 30;
/** Exponent of the superellipse that rounds the tire's shoulders. */
const ROUNDNESS = 5;
const GROOVES = [-0.33, -0.12, 0.12, 0.33];
/** Sipes on the circumference; they show the wheel rolling. */
const SIPES = 20;

/** The tire's half width at a share of its radius, 1 in the middle and 0 at the ends. @param {number} share */
const profile = (share) => (1 - Math.abs(share) ** ROUNDNESS) ** (1 / ROUNDNESS);

/** The stations as shares of the radius, from −1 to 1, dense at the ends, and the widths there. */
const shares = Float64Array.from({ length: STATIONS + 1 }, (_, i) =>
  Math.sin((Math.PI / 2) * ((2 * i) / STATIONS - 1)),
);
const halfWidths = shares.map((share) => (WHEEL_WIDTH / 2) * profile(share));

/**
 * The tire's outline in the wheel's frame: stations from the back to the front, with the
 * bent center line and the half width at each.
 *
 * @typedef {object} TireShape
 * @property {Float64Array} l
 * @property {Float64Array} bend
 * @property {Float64Array} half
 */

/**
 * @param {Pose} pose
 * @param {ContactLine} line
 * @returns {TireShape}
 */
export function tireShape(pose, line) {
  const l = shares.map((share) => pose.radius * share);
  return { l, bend: l.map((station) => bendAt(line, pose, station)), half: halfWidths };
}

/**
 * Adds a line along the tire to the path: `share` of the way from the center line to the left edge.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {TireShape} shape
 * @param {number} share −1 … 1
 * @param {number} from first station
 * @param {number} to last station, before or after the first
 */
function along(ctx, sheet, pose, shape, share, from, to) {
  const step = from < to ? 1 : -1;
  for (let i = from; i !== to + step; i += step) {
    const n = shape.bend[i] + share * shape.half[i];
    ctx.lineTo(sheet.scale * (shape.l[i] - pose.caster), -sheet.scale * n);
  }
}

/**
 * The closed outline, as the current path in the wheel's frame.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {TireShape} shape
 */
export function traceTire(ctx, sheet, pose, shape) {
  ctx.beginPath();
  along(ctx, sheet, pose, shape, 1, 0, STATIONS);
  along(ctx, sheet, pose, shape, -1, STATIONS, 0);
  ctx.closePath();
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {import('./scene.js').Scene} scene
 * @param {Pose} pose
 * @param {ContactLine} line
 * @param {TireShape} shape
 * @param {Theme} theme
 */
export function drawTire(ctx, sheet, scene, pose, line, shape, theme) {
  const materials = materialsFor(theme);
  drawShadow(ctx, sheet, pose, shape, materials.shadow);
  inWheelFrame(ctx, sheet, pose, () => {
    const reach = pose.radius * sheet.scale;
    const center = -pose.caster * sheet.scale;
    const round = ctx.createLinearGradient(center - reach, 0, center + reach, 0);
    round.addColorStop(0, materials.rubber);
    round.addColorStop(0.3, materials.rubberLit);
    round.addColorStop(0.62, materials.rubberLit);
    round.addColorStop(1, materials.rubber);
    traceTire(ctx, sheet, pose, shape);
    ctx.fillStyle = round;
    ctx.fill();
    drawTread(ctx, sheet, scene, pose, line, shape, materials);
    traceTire(ctx, sheet, pose, shape);
    ctx.strokeStyle = materials.rubberEdge;
    ctx.lineWidth = 1.4 * sheet.line;
    ctx.stroke();
    drawPatch(ctx, sheet, pose, line, theme);
    drawRim(ctx, sheet, pose, materials);
  });
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {TireShape} shape
 * @param {string} color
 */
function drawShadow(ctx, sheet, pose, shape, color) {
  ctx.fillStyle = translucent(color, 0.1);
  for (let layer = 1; layer <= 2; layer++) {
    ctx.save();
    ctx.translate(2 * layer, 4 * layer);
    inWheelFrame(ctx, sheet, pose, () => {
      traceTire(ctx, sheet, pose, shape);
      ctx.fill();
    });
    ctx.restore();
  }
}

/**
 * Grooves that follow the bend, and sipes that roll forward over the top; the sipes fade before
 * the frame rate could make them stand or turn back.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {import('./scene.js').Scene} scene
 * @param {Pose} pose
 * @param {ContactLine} line
 * @param {TireShape} shape
 * @param {import('./materials.js').Materials} materials
 */
function drawTread(ctx, sheet, scene, pose, line, shape, materials) {
  ctx.lineJoin = 'round';
  for (const [width, color, shift] of /** @type {const} */ ([
    [2.4, materials.groove, 0],
    [0.7, translucent(materials.metalLit, 0.22), 1.6],
  ])) {
    ctx.save();
    ctx.translate(0, shift);
    ctx.strokeStyle = color;
    ctx.lineWidth = width * sheet.line;
    ctx.beginPath();
    for (const share of GROOVES) {
      const start = shape.l[2];
      const n = shape.bend[2] + share * WHEEL_WIDTH;
      ctx.moveTo(sheet.scale * (start - pose.caster), -sheet.scale * n);
      for (let i = 3; i <= STATIONS - 2; i++) {
        ctx.lineTo(
          sheet.scale * (shape.l[i] - pose.caster),
          -sheet.scale * (shape.bend[i] + share * WHEEL_WIDTH),
        );
      }
    }
    ctx.stroke();
    ctx.restore();
  }

  const spacing = (2 * Math.PI) / SIPES;
  const visible = 1 - (Math.abs(scene.exposure) / pose.radius / spacing - 0.32) / 0.14;
  if (visible <= 0) return;
  ctx.strokeStyle = translucent(materials.groove, Math.min(1, visible));
  ctx.lineWidth = 1.5 * sheet.line;
  ctx.beginPath();
  const turned = (scene.roll / pose.radius) % spacing;
  for (let angle = turned - 1.35; angle < 1.35; angle += spacing) {
    const l = pose.radius * Math.sin(angle);
    const bend = bendAt(line, pose, l);
    const edge = 0.5 * WHEEL_WIDTH * profile(Math.sin(angle)) - 0.003;
    for (const side of [-1, 1]) {
      const root = Math.min(edge, 0.36 * WHEEL_WIDTH);
      ctx.moveTo(sheet.scale * (l - pose.caster), -sheet.scale * (bend + side * root));
      ctx.lineTo(sheet.scale * (l - pose.caster), -sheet.scale * (bend + side * edge));
    }
  }
  ctx.stroke();
}

/**
 * The contact, seen through the tire.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {ContactLine} line
 * @param {Theme} theme
 */
function drawPatch(ctx, sheet, pose, line, theme) {
  const half = 0.4 * WHEEL_WIDTH * sheet.scale;
  const x = (/** @type {number} */ l) => sheet.scale * (l - pose.caster);
  const corners = 12;
  ctx.beginPath();
  for (let i = 0; i <= corners; i++) {
    const l = pose.half * (1 - (2 * i) / corners);
    ctx.lineTo(x(l), -sheet.scale * bendAt(line, pose, l) - half);
  }
  for (let i = corners; i >= 0; i--) {
    const l = pose.half * (1 - (2 * i) / corners);
    ctx.lineTo(x(l), -sheet.scale * bendAt(line, pose, l) + half);
  }
  ctx.closePath();
  ctx.fillStyle = translucent(theme.y, theme.scheme === 'dark' ? 0.36 : 0.62);
  ctx.fill();
  ctx.strokeStyle = theme.y;
  ctx.lineWidth = 1.2 * sheet.line;
  ctx.stroke();
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {Pose} pose
 * @param {import('./materials.js').Materials} materials
 */
function drawRim(ctx, sheet, pose, materials) {
  const length = 0.54 * pose.radius * sheet.scale;
  const half = 0.36 * WHEEL_WIDTH * sheet.scale;
  ctx.beginPath();
  ctx.roundRect(-pose.caster * sheet.scale - length, -half, 2 * length, 2 * half, 0.4 * half);
  ctx.strokeStyle = translucent(materials.metalLit, 0.6);
  ctx.lineWidth = 1.4 * sheet.line;
  ctx.stroke();
}

/**
 * Earlier poses as faint outlines.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {Sheet} sheet
 * @param {readonly {pose: Pose, shape: TireShape}[]} earlier
 * @param {Theme} theme
 */
export function drawTrail(ctx, sheet, earlier, theme) {
  ctx.fillStyle = translucent(materialsFor(theme).mark, 0.05);
  ctx.strokeStyle = translucent(theme.ink, 0.1);
  ctx.lineWidth = sheet.line;
  for (const { pose, shape } of earlier) {
    inWheelFrame(ctx, sheet, pose, () => {
      traceTire(ctx, sheet, pose, shape);
      ctx.fill();
      ctx.stroke();
    });
  }
}
