/**
 * How a box of data is looked at: turned about its upright axis and tipped toward the viewer, without perspective.
 *
 * Coordinates of the box are −1 … 1: x to the right, y away, z up as one looks from the front (yaw 0, pitch 0).
 *
 * @typedef {{ yaw: number, pitch: number }} Look in rad; pitch 0 looks level, π/2 from straight above
 * @typedef {{ x: number, y: number }} Point in pixels
 */

/**
 * From the side and a little from above: there the cycles of a shimmy lie open, those of slow gears, too, whose y follows ψ̇ more
 * than ψ and which from the right are seen on edge.
 * @type {Look}
 */
export const firstLook = { yaw: (105 * Math.PI) / 180, pitch: (20 * Math.PI) / 180 };

/** The box is this much lower than it is wide. */
export const lowness = 0.8;

const radiansPerPixel = 0.008;
const degree = Math.PI / 180;

/**
 * Turned by a hand: the front goes where the pointer goes.
 * @param {Look} look
 * @param {number} dx pixels to the right
 * @param {number} dy pixels down
 * @returns {Look}
 */
export function turnedByDrag({ yaw, pitch }, dx, dy) {
  return heldAbove({ yaw: yaw + dx * radiansPerPixel, pitch: pitch + dy * radiansPerPixel });
}

/**
 * Turned by an arrow key, the same way as by a hand.
 * @param {Look} look
 * @param {string} key as the event names it
 * @param {boolean} [isFine] one degree instead of five
 * @returns {Look | null} null for any other key
 */
export function turnedByKey({ yaw, pitch }, key, isFine = false) {
  const step = (isFine ? 1 : 5) * degree;
  const [across, down] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[key] ?? [0, 0];
  if (across === 0 && down === 0) return null;
  return heldAbove({ yaw: yaw + across * step, pitch: pitch + down * step });
}

/** Never from below, and the yaw within one turn. @param {Look} look @returns {Look} */
function heldAbove({ yaw, pitch }) {
  const turn = 2 * Math.PI;
  return { yaw: yaw - turn * Math.round(yaw / turn), pitch: Math.min(Math.PI / 2, Math.max(0, pitch)) };
}

/**
 * @param {Look} look
 * @param {import('./axes.js').Box} area where the box may stand; it keeps its size when it is turned about its upright axis
 */
export function projectionOf({ yaw, pitch }, { left, right, top, bottom }) {
  const [cosYaw, sinYaw, cosPitch, sinPitch] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
  const height = lowness * cosPitch + Math.SQRT2 * sinPitch;
  const scale = Math.max(1, Math.min((right - left) / 2 / Math.SQRT2, (bottom - top) / 2 / height));
  const [middleX, middleY] = [(left + right) / 2, (top + bottom) / 2];
  const away = (/** @type {number} */ x, /** @type {number} */ y) => x * sinYaw + y * cosYaw;
  return {
    scale,
    /** @param {number} x @param {number} y */
    across: (x, y) => middleX + scale * (x * cosYaw - y * sinYaw),
    /** @param {number} x @param {number} y @param {number} z */
    up: (x, y, z) => middleY - scale * (z * lowness * cosPitch + away(x, y) * sinPitch),
    /** How near to the viewer, 0 … 1 over the middle of the box, where curves are. @param {number} x @param {number} y @param {number} z */
    nearness: (x, y, z) => Math.min(1, Math.max(0, 0.5 + 0.55 * (z * lowness * sinPitch - away(x, y) * cosPitch))),
    /** The sides of the box that face the viewer, as the x and the y at which they stand. */
    front: { x: sinYaw >= 0 ? -1 : 1, y: cosYaw >= 0 ? -1 : 1 },
  };
}

/** @typedef {ReturnType<typeof projectionOf>} Projection */
