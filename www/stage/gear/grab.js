/**
 * Where a hand can take hold of the wheel.
 *
 * @module
 */

import { contactLine, traceBehind } from './contact-line.js';
import { onSheet, poseNow } from './pose.js';
import { sheetFor } from './sheet.js';
import { tireShape } from './tire-shape.js';

/**
 * The tire's outline on the canvas and the axis it turns about [px].
 *
 * @param {import('./scene.js').Size} size
 * @param {import('./scene.js').Scene} scene
 */
export function grabTarget(size, scene) {
  const sheet = sheetFor(size, scene);
  const pose = poseNow(scene);
  const line = contactLine(traceBehind(scene, pose, 2 * pose.half), pose);
  const { l, bend, half } = tireShape(pose, line);
  const edge = (/** @type {-1 | 1} */ side) =>
    Array.from(l, (station, i) => onSheet(sheet, pose, station, bend[i] + side * half[i]));
  return {
    outline: [...edge(1), ...edge(-1).reverse()],
    center: onSheet(sheet, pose, 0, 0),
    axis: sheet.axis,
  };
}
