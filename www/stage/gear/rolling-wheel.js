/**
 * The wheel from the right, turning at v/R: two faces and the tread between them.
 *
 * @module
 */

import { WHEEL_WIDTH } from './sheet.js';
import { translucent } from './theme.js';
import { SIPES, sipesSeen } from './tread.js';

/** @typedef {import('./side.js').SideFrame} SideFrame */
/** @typedef {import('./pose.js').Pose} Pose */

/** Radii as shares of the wheel's. */
const BEAD = 0.6;
const RIM = 0.54;
const HOLES = 0.355;
const HOLE = 0.085;
const BOSS = 0.19;
const COUNT = 6;
/** Width of the outer face as a share of the tire's: shoulders round the rest off. */
const FACE = 0.72;

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {SideFrame} frame
 * @param {import('./scene.js').Scene} scene
 * @param {readonly Pose[]} poses one, or the layers of a blur
 * @param {number} opacity of each; details are drawn on a wheel that is not blurred
 * @param {import('./theme.js').Theme} theme
 * @param {import('./materials.js').Materials} materials
 */
export function drawRollingWheel(ctx, sheet, frame, scene, poses, opacity, theme, materials) {
  const [{ radius: meters }] = poses;
  const radius = meters * frame.scale;
  const y = frame.ground - frame.axle * frame.scale;
  const middleOf = (/** @type {Pose} */ pose) => frame.x - pose.caster * pose.cos * frame.scale;
  const depthOf = (/** @type {Pose} */ pose) => (FACE / 2) * WHEEL_WIDTH * frame.scale * pose.sin;

  ctx.save();
  ctx.beginPath();
  ctx.rect(0, frame.top, sheet.width, frame.ground - frame.top);
  ctx.clip();
  ctx.globalAlpha = opacity;
  for (const pose of poses) drawTread(ctx, sheet, frame, pose, middleOf(pose), depthOf(pose), materials);
  const onFaces = (/** @type {(pose: Pose) => void} */ draw) => {
    for (const pose of poses) {
      ctx.save();
      ctx.translate(middleOf(pose) + depthOf(pose), y);
      ctx.scale(Math.abs(pose.cos), 1);
      draw(pose);
      ctx.restore();
    }
  };
  onFaces((pose) => {
    drawSidewall(ctx, sheet, radius, materials);
    if (opacity < 1) return;
    drawGloss(ctx, radius, materials);
    drawShoulder(ctx, sheet, radius, scene, pose, materials);
  });
  onFaces((pose) => {
    drawDisc(ctx, sheet, radius, materials);
    drawHoles(ctx, sheet, radius, scene, pose, opacity, theme, materials);
  });
  ctx.restore();
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {SideFrame} frame
 * @param {Pose} pose
 * @param {number} x
 * @param {number} depth
 * @param {import('./materials.js').Materials} materials
 */
function drawTread(ctx, sheet, frame, pose, x, depth, materials) {
  const y = frame.ground - frame.axle * frame.scale;
  const narrow = Math.abs(pose.cos);
  ctx.fillStyle = materials.rubber;
  ctx.strokeStyle = materials.rubberEdge;
  ctx.lineWidth = 1.6 * sheet.line;
  traceBulge(ctx, frame, pose, x, narrow, Math.abs(depth));
  ctx.fill();
  ctx.stroke();
  traceTread(ctx, x, y, pose.radius * frame.scale, narrow, depth);
  ctx.fill();
  ctx.stroke();
}

/**
 * The hull of both faces.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {number} x
 * @param {number} y
 * @param {number} radius
 * @param {number} narrow
 * @param {number} depth
 */
function traceTread(ctx, x, y, radius, narrow, depth) {
  const half = Math.abs(depth);
  ctx.beginPath();
  ctx.ellipse(x + half, y, radius * narrow, radius, 0, -Math.PI / 2, Math.PI / 2);
  ctx.ellipse(x - half, y, radius * narrow, radius, 0, Math.PI / 2, (3 * Math.PI) / 2);
  ctx.closePath();
}

/**
 * Where the tire is pressed flat its walls swell, beside the contact.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {SideFrame} frame
 * @param {Pose} pose
 * @param {number} x
 * @param {number} narrow
 * @param {number} depth
 */
function traceBulge(ctx, frame, pose, x, narrow, depth) {
  const { ground, scale } = frame;
  const chord = Math.sqrt(pose.radius ** 2 - frame.axle ** 2);
  const rise = 0.3 * pose.radius;
  const start = Math.sqrt(pose.radius ** 2 - (frame.axle - rise) ** 2);
  const swell = chord + 0.022;
  ctx.beginPath();
  for (const side of [-1, 1]) {
    const at = (/** @type {number} */ l) => x + side * (l * narrow * scale + depth);
    ctx.moveTo(at(start - 0.006), ground - rise * scale);
    ctx.bezierCurveTo(
      at(swell + 0.3 * (start - swell)), ground - 0.45 * rise * scale,
      at(swell + 0.012), ground - 0.12 * rise * scale,
      at(swell - 0.012), ground,
    );
    ctx.lineTo(at(0), ground);
  }
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {number} radius
 * @param {import('./materials.js').Materials} materials
 */
function drawSidewall(ctx, sheet, radius, materials) {
  const wall = ctx.createRadialGradient(0, 0, BEAD * radius, 0, 0, radius);
  wall.addColorStop(0, materials.rubber);
  wall.addColorStop(0.45, materials.rubberLit);
  wall.addColorStop(0.8, materials.rubberLit);
  wall.addColorStop(1, materials.rubber);
  ctx.beginPath();
  ctx.arc(0, 0, 0.985 * radius, 0, 2 * Math.PI);
  ctx.fillStyle = wall;
  ctx.fill();
  ctx.strokeStyle = translucent(materials.groove, 0.7);
  ctx.lineWidth = sheet.line;
  for (const share of [0.9, 0.7]) {
    ctx.beginPath();
    ctx.arc(0, 0, share * radius, 0, 2 * Math.PI);
    ctx.stroke();
  }
}

/**
 * The sky on the wall's roundest part, soft at its ends.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {number} radius
 * @param {import('./materials.js').Materials} materials
 */
function drawGloss(ctx, radius, materials) {
  ctx.lineCap = 'round';
  ctx.strokeStyle = translucent(materials.rubberShine, 0.2);
  for (const [width, reach] of [[0.1, 0.17], [0.07, 0.24], [0.035, 0.31]]) {
    ctx.lineWidth = width * radius;
    ctx.beginPath();
    ctx.arc(0, 0, 0.81 * radius, (1.34 - reach) * Math.PI, (1.34 + reach) * Math.PI);
    ctx.stroke();
  }
  ctx.lineCap = 'butt';
}

/**
 * The ends of the tread's sipes, turning with the wheel.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {number} radius
 * @param {import('./scene.js').Scene} scene
 * @param {Pose} pose
 * @param {import('./materials.js').Materials} materials
 */
function drawShoulder(ctx, sheet, radius, scene, pose, materials) {
  const seen = sipesSeen(scene, pose);
  if (seen === 0) return;
  const spacing = (2 * Math.PI) / SIPES;
  const turned = (scene.roll / pose.radius) % spacing;
  ctx.strokeStyle = translucent(materials.groove, seen);
  ctx.lineWidth = 1.6 * sheet.line;
  ctx.beginPath();
  for (let i = 0; i < SIPES; i++) {
    const angle = turned + i * spacing;
    ctx.moveTo(0.925 * radius * Math.cos(angle), 0.925 * radius * Math.sin(angle));
    ctx.lineTo(0.99 * radius * Math.cos(angle), 0.99 * radius * Math.sin(angle));
  }
  ctx.stroke();
}

/**
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {number} radius
 * @param {import('./materials.js').Materials} materials
 */
function drawDisc(ctx, sheet, radius, materials) {
  const rim = RIM * radius;
  const shine = ctx.createLinearGradient(-rim, -rim, rim, rim);
  shine.addColorStop(0, materials.metalLit);
  shine.addColorStop(0.5, materials.metal);
  shine.addColorStop(1, materials.metalShade);
  ctx.beginPath();
  ctx.arc(0, 0, rim, 0, 2 * Math.PI);
  ctx.fillStyle = shine;
  ctx.fill();
  ctx.strokeStyle = materials.metalEdge;
  ctx.lineWidth = 1.6 * sheet.line;
  ctx.stroke();
  // The rim's flange: a lit lip outside, a shaded step inside.
  ctx.lineWidth = 1.2 * sheet.line;
  for (const [share, color] of /** @type {const} */ ([
    [0.95, translucent(materials.metalLit, 0.9)],
    [0.87, translucent(materials.metalShade, 0.9)],
  ])) {
    ctx.beginPath();
    ctx.arc(0, 0, share * rim, 0, 2 * Math.PI);
    ctx.strokeStyle = color;
    ctx.stroke();
  }
  const hub = ctx.createRadialGradient(-0.4 * BOSS * radius, -0.5 * BOSS * radius, 0, 0, 0, BOSS * radius);
  hub.addColorStop(0, materials.metal);
  hub.addColorStop(1, materials.metalShade);
  ctx.beginPath();
  ctx.arc(0, 0, BOSS * radius, 0, 2 * Math.PI);
  ctx.fillStyle = hub;
  ctx.fill();
  ctx.strokeStyle = materials.metalEdge;
  ctx.stroke();
}

/**
 * Holes round the hub; one bolt in ψ's blue, so that turning is seen. When a frame turns the wheel
 * so far that the holes would seem to stand or run back, they blur into a ring.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {import('./sheet.js').Sheet} sheet
 * @param {number} radius
 * @param {import('./scene.js').Scene} scene
 * @param {Pose} pose
 * @param {number} opacity
 * @param {import('./theme.js').Theme} theme
 * @param {import('./materials.js').Materials} materials
 */
function drawHoles(ctx, sheet, radius, scene, pose, opacity, theme, materials) {
  const spacing = (2 * Math.PI) / COUNT;
  const turnPerFrame = Math.abs(scene.exposure) / pose.radius;
  const blurred = Math.min(1, Math.max(0, (turnPerFrame / spacing - 0.3) / 0.15));
  if (blurred > 0) {
    ctx.beginPath();
    ctx.arc(0, 0, HOLES * radius, 0, 2 * Math.PI);
    ctx.strokeStyle = translucent(materials.rubberLit, 0.4 * blurred);
    ctx.lineWidth = 2 * HOLE * radius;
    ctx.stroke();
  }
  if (blurred === 1) return;
  const turned = scene.roll / pose.radius;
  ctx.globalAlpha = opacity * (1 - blurred);
  ctx.lineWidth = 1.2 * sheet.line;
  ctx.strokeStyle = materials.metalEdge;
  for (let i = 0; i < COUNT; i++) {
    const angle = (turned % (2 * Math.PI)) + i * spacing;
    ctx.beginPath();
    ctx.arc(
      HOLES * radius * Math.cos(angle),
      HOLES * radius * Math.sin(angle),
      HOLE * radius,
      0,
      2 * Math.PI,
    );
    ctx.fillStyle = i === 0 ? theme.psi : materials.rubberLit;
    ctx.fill();
    ctx.stroke();
  }
}
