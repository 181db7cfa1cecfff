/**
 * What labels keep off: the wheel and all that moves with it.
 *
 * @module
 */

import { FORK_REACH, onSheet } from './pose.js';
import { atAngle, WEDGE } from './protractor.js';
import { WHEEL_WIDTH } from './sheet.js';

/** @typedef {import('./desk.js').Desk} Desk */
/** @typedef {import('./pose.js').Pose} Pose */
/** @typedef {import('./tire-shape.js').TireShape} TireShape */

/**
 * @param {Desk} desk
 * @param {TireShape} shape
 * @param {import('./forces.js').ForceArrows} arrows
 */
export function blockMovingParts(desk, shape, arrows) {
  const { sheet, pose, placer } = desk;
  blockWheel(desk, pose, shape);
  placer.blockLine(onSheet(sheet, pose, pose.radius, 0), atAngle(sheet, sheet.protractor, pose.angle), 3);
  placer.blockLine(
    onSheet(sheet, pose, pose.half, pose.deformation),
    onSheet(sheet, pose, pose.half + pose.relaxation, 0),
    3,
  );
  blockWedge(desk, 0, pose.angle);
  if (arrows.side.length > 1) placer.blockLine(arrows.side.from, arrows.side.to, 9 * sheet.line);
  const { x, y, radius, start, end } = arrows.moment;
  const pieces = 4;
  const at = (/** @type {number} */ i) => {
    const angle = start + ((end - start) * i) / pieces;
    return { x: x + radius * Math.cos(angle), y: y + radius * Math.sin(angle) };
  };
  for (let i = 0; i < pieces; i++) placer.blockLine(at(i), at(i + 1), 8 * sheet.line);
}

/**
 * All that the fan sweeps over.
 *
 * @param {Desk} desk
 * @param {readonly import('./fan.js').Blade[]} blades
 */
export function blockFan(desk, blades) {
  for (const { pose, shape } of blades) blockWheel(desk, pose, shape);
  const angles = blades.map(({ pose }) => pose.angle);
  blockWedge(desk, Math.min(...angles), Math.max(...angles));
}

/** @param {Desk} desk @param {Pose} pose @param {TireShape} shape */
function blockWheel({ sheet, placer }, pose, shape) {
  const corner = (/** @type {number} */ l, /** @type {number} */ n) => onSheet(sheet, pose, l, n);
  const half = WHEEL_WIDTH / 2 + 0.008;
  const low = Math.min(...shape.bend) - half;
  const high = Math.max(...shape.bend) + half;
  const { radius, caster } = pose;
  placer.blockPolygon([
    corner(-radius, low), corner(radius, low), corner(radius, high), corner(-radius, high),
  ]);
  const back = Math.min(0, caster) - 0.04;
  const front = Math.max(0, caster) + 0.06;
  placer.blockPolygon([
    corner(back, -FORK_REACH), corner(front, -FORK_REACH),
    corner(front, FORK_REACH), corner(back, FORK_REACH),
  ]);
}

/** @param {Desk} desk @param {number} from @param {number} to */
function blockWedge({ sheet, placer }, from, to) {
  const radius = WEDGE * sheet.protractor + 3;
  placer.blockPolygon([sheet.axis, atAngle(sheet, radius, from), atAngle(sheet, radius, to)]);
}
