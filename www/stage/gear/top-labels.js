/**
 * The labels of the top view. They stand off the wheel: those of the tire on the side to which it
 * is deformed, ψ on the other. A value near zero takes its label away with it.
 *
 * @module
 */

import { formatNumber } from '../../words/number.js';
import { putLabel } from './desk.js';
import { swingOf } from './fan.js';
import { drawnAngle, FORK_REACH, onSheet } from './pose.js';
import { protractorBox, WEDGE } from './protractor.js';
import { WHEEL_WIDTH } from './sheet.js';
import { strong, subscript, symbol } from './text.js';

/** @typedef {import('./desk.js').Desk} Desk */
/** @typedef {import('./scene.js').Scene} Scene */
/** @typedef {import('./forces.js').ForceArrows} ForceArrows */

const DEGREES = 180 / Math.PI;

/**
 * Whether what a label names is large enough to be seen. A pause can come at any size, so a label
 * is there or it is not.
 *
 * @param {number} pixels
 */
const isSeen = (pixels) => Math.abs(pixels) >= 4;

/** Decimals of an angle or a length that is drawn this much larger. @param {number} magnification */
const decimalsAt = (magnification) => (magnification < 20 ? 1 : 2);

/**
 * @param {Desk} desk
 * @param {ForceArrows} arrows
 */
export function writeTopLabels(desk, arrows) {
  const side = desk.pose.deformation < 0 ? -1 : 1;
  writeTorsionAngle(desk, -side);
  if (desk.sheet.detailed) {
    writeDeformation(desk, side);
    writeSlipAngle(desk, side);
  }
  writeSideForce(desk, arrows);
  writeAligningMoment(desk, arrows);
}

/**
 * The swing's range, where the number of a single pose would flicker.
 *
 * @param {Desk} desk
 */
export function writeSwing(desk) {
  const { sheet, scene, theme, words } = desk;
  const { low, high } = swingOf(scene);
  const [lowest, highest] = [low, high].map((psi) => degrees(psi, scene, words));
  const range = lowest === highest.replace('+', '−') ? highest.replace('+', '±') : `${lowest} … ${highest}`;
  const style = { size: sheet.large, color: theme.psi, halo: theme.ground };
  putLabel(desk, [symbol('ψ'), strong(` ${range}`)], style, (width) => {
    const x = Math.min(sheet.axis.x + WEDGE * sheet.protractor - 0.4 * width, protractorBox(sheet).x - 4 - width);
    const swept = WEDGE * sheet.protractor * Math.sin(drawnAngle(scene, low));
    return [7, 13, 19, 26, 34].map((gap) => ({ x, y: sheet.axis.y - swept + gap }));
  });
}

/** ψ with its sign, in the page's language. @param {number} psi @param {Scene} scene @param {import('./scene.js').GearWords} words */
function degrees(psi, scene, words) {
  const number = formatNumber(psi * DEGREES, decimalsAt(scene.magnification), words.language);
  const sign = /^[0.,]*$/.test(number) || number.startsWith('−') ? '' : '+';
  return `${sign}${number}°`;
}

/** @param {Desk} desk @param {number} side 1 above the line straight ahead, −1 below it */
function writeTorsionAngle(desk, side) {
  const { sheet, scene, pose, theme, words } = desk;
  const wedge = WEDGE * sheet.protractor;
  const covered = Math.max(0, side * wedge * Math.sin(pose.angle));
  const style = { size: sheet.large, color: theme.psi, halo: theme.ground };
  const value = ` ${degrees(scene.state[0] ?? 0, scene, words)}`;
  putLabel(desk, [symbol('ψ'), strong(value)], style, (width, height) => {
    const limit = protractorBox(sheet).x - 4 - width;
    const x = Math.min(sheet.axis.x + wedge - 0.4 * width, limit);
    return [7, 13, 19, 26, 34].map((gap) => ({
      x,
      y: sheet.axis.y - side * (covered + gap + height / 2) - height / 2,
    }));
  });
}

/** @param {Desk} desk @param {ForceArrows} arrows */
function writeSideForce(desk, arrows) {
  const { sheet, scene, theme, words } = desk;
  if (!isSeen(arrows.side.length)) return;
  const { sideForce, sideForceLimited } = scene.forces;
  const size = Math.abs(sideForce);
  const inKilo = scene.forceScale.force >= 1000;
  const number = formatNumber(inKilo ? size / 1000 : size, inKilo ? 1 : 0, words.language);
  const value = ` ${number} ${inKilo ? 'kN' : 'N'}`;
  const values = sideForceLimited && sheet.detailed ? [value + words.atItsLimit, value] : [value];

  const { from, to, length } = arrows.side;
  const reach = Math.max(1, (FORK_REACH * sheet.scale + 12) / length);
  const x = from.x + reach * (to.x - from.x);
  const y = from.y + reach * (to.y - from.y);
  const up = to.y < from.y ? 1 : -1;
  const style = { size: sheet.label, color: theme.force, halo: theme.ground };
  /** @param {number} width @param {number} height */
  const wishes = (width, height) => {
    const highest = sheet.band.top + 3;
    const lowest = sheet.band.bottom - 3 - height;
    const middle = Math.min(lowest, Math.max(highest, y - height / 2));
    const places = [-4, 2, 8, 14, 20].map((shift) =>
      Math.min(lowest, Math.max(highest, middle + up * shift)),
    );
    return [
      ...places.map((place) => ({ x: x - 13 * sheet.line - width, y: place })),
      ...places.map((place) => ({ x: x + 13 * sheet.line, y: place })),
    ];
  };
  // The longer line is worth having near its arrow only.
  values.some((text, i) => {
    const runs = [symbol('F'), subscript('y'), strong(text)];
    const farthest = i === values.length - 1 ? 90 : sheet.roomy ? 60 : 30;
    return putLabel(desk, runs, { ...style, farthest }, wishes);
  });
}

/** @param {Desk} desk @param {number} side */
function writeDeformation(desk, side) {
  const { ctx, sheet, scene, pose, theme, words } = desk;
  if (!isSeen(pose.deformation * sheet.scale)) return;
  const y = Math.abs(scene.state[2] ?? 0) * 1000;
  const number = formatNumber(y, decimalsAt(scene.magnification), words.language);
  const ring = onSheet(sheet, pose, pose.half, pose.deformation);
  const clear = onSheet(sheet, pose, pose.half, 0).y - side * (0.62 * WHEEL_WIDTH * sheet.scale);
  const style = { size: sheet.label, color: theme.y, halo: theme.ground, farthest: 90 };
  const box = putLabel(desk, [symbol('y'), strong(` ${number} mm`)], style, (width, height) => {
    const { top, bottom } = sheet.band;
    const edge = side > 0 ? top + 4 : bottom - 4 - height;
    const rows = [4, 10, 16, 22, 28, 34, 40].map((gap) => clear - side * (gap + height / 2) - height / 2);
    // Where room is scarce it keeps to the band's edge, and leaves α the place between.
    return (sheet.roomy ? rows : [edge, ...rows]).flatMap((row) =>
      [8, 26, -0.3 * width].map((dx) => ({ x: ring.x + dx, y: row })),
    );
  });
  if (!box) return;
  const foot = {
    x: Math.min(box.x + box.width - 4, Math.max(box.x + 4, ring.x + 8)),
    y: side > 0 ? box.y + box.height - 1 : box.y + 1,
  };
  ctx.strokeStyle = theme.y;
  ctx.lineWidth = 1.4 * sheet.line;
  ctx.beginPath();
  ctx.moveTo(foot.x, foot.y);
  ctx.lineTo(ring.x, ring.y - side * 6 * sheet.line);
  ctx.stroke();
}

/** @param {Desk} desk @param {number} side */
function writeSlipAngle(desk, side) {
  const { sheet, scene, pose, theme, words } = desk;
  if (!isSeen(pose.deformation * sheet.scale)) return;
  const alpha = Math.abs(scene.forces.slipAngle) * DEGREES;
  const number = formatNumber(alpha, decimalsAt(scene.magnification), words.language);
  const style = { size: sheet.label, color: theme.y, halo: theme.ground, farthest: 70 };
  putLabel(desk, [symbol('α'), strong(` ${number}°`)], style, (width, height) => {
    const limit = protractorBox(sheet).x - 4 - width;
    const along = onSheet(sheet, pose, pose.half + 0.6 * pose.relaxation, 0.4 * pose.deformation);
    const x = Math.min(along.x - width / 2, limit);
    return [6, 12, 18, 24, 30, 38].flatMap((gap) =>
      [0, 14, -14].map((dx) => ({
        x: Math.min(x + dx, limit),
        y: along.y - side * (gap + height / 2) - height / 2,
      })),
    );
  });
}

/** @param {Desk} desk @param {ForceArrows} arrows */
function writeAligningMoment(desk, arrows) {
  const { sheet, scene, theme, words } = desk;
  const { x, y, radius, start, end } = arrows.moment;
  if (!isSeen(radius * (end - start))) return;
  const decimals = scene.forceScale.moment < 20 ? 1 : 0;
  const number = formatNumber(Math.abs(scene.forces.aligningMoment), decimals, words.language);
  const runs = [symbol('M'), subscript('z'), strong(` ${number} N m`)];
  const style = { size: sheet.label, color: theme.force, halo: theme.ground };
  putLabel(desk, runs, style, (width, height) =>
    [0.5, 0.25, 0, 0.75, 1].flatMap((share) => {
      const angle = start + (end - start) * share;
      return [12, 20].map((gap) => ({
        x: x + (radius + gap * sheet.line) * Math.cos(angle) - width,
        y: y + radius * Math.sin(angle) - height / 2,
      }));
    }),
  );
}
