/**
 * Where a hand can take hold of the wheel, and how far it has turned it.
 *
 * The page asks `isOnWheel` as the pointer moves, makes a `Hold` when it presses, and asks that where
 * the wheel turns to. Angles that come out are true ones: the hand turns the drawn wheel by M times
 * as much.
 *
 * @module
 */

import { bendAt, contactLine, traceBehind } from './contact-line.js';
import { LARGEST_ANGLE, onSheet, poseNow, poseOf, within } from './pose.js';
import { sheetFor, WHEEL_WIDTH } from './sheet.js';
import { straightShape, tireShape } from './tire-shape.js';

/** @typedef {import('./scene.js').Scene} Scene */
/** @typedef {import('./scene.js').Size} Size */
/** @typedef {{x: number, y: number}} Point in CSS pixels from the canvas' corner */

/** What a finger hits surely, and how far beside the tire still counts [px]. */
const TARGET = 44;
const SLACK = 4;
/**
 * Nearer to the axis than this [px] a hand has no lever: there it turns the wheel as one at this
 * distance does.
 */
const LEVER = 24;
const DEGREE = Math.PI / 180;
/** What one press of an arrow key turns [rad], and the factor of Shift. */
const KEY_TURN = 0.5 * DEGREE;
const SHIFT = 5;

/**
 * The tire's outline on the canvas, the axis it turns about, and the box around both, no smaller
 * than a finger needs.
 *
 * @param {Size} size
 * @param {Scene} scene
 */
export function grabTarget(size, scene) {
  const sheet = sheetFor(size, scene);
  const { pose, shape } = grabbed(scene);
  const { l, bend, half } = shape;
  const edge = (/** @type {-1 | 1} */ side) =>
    Array.from(l, (station, i) => onSheet(sheet, pose, station, bend[i] + side * half[i]));
  const outline = [...edge(1), ...edge(-1).reverse()];
  const center = onSheet(sheet, pose, 0, 0);
  return { outline, center, axis: sheet.axis, box: boxAround(outline) };
}

/**
 * Whether a hand at this point has hold of the wheel: anywhere on the tire, and at least 44 px
 * along and across it.
 *
 * @param {Size} size
 * @param {Scene} scene
 * @param {Point} point
 */
export function isOnWheel(size, scene, point) {
  const sheet = sheetFor(size, scene);
  const { pose, line } = grabbed(scene);
  const dx = (point.x - sheet.axis.x) / sheet.scale;
  const dy = (sheet.axis.y - point.y) / sheet.scale;
  const l = dx * pose.cos + dy * pose.sin + pose.caster;
  const n = -dx * pose.sin + dy * pose.cos;
  const reach = (/** @type {number} */ meters) => Math.max(meters + SLACK / sheet.scale, TARGET / 2 / sheet.scale);
  const bend = bendAt(line, pose, within(l, pose.radius));
  return Math.abs(l) <= reach(pose.radius) && Math.abs(n - bend) <= reach(WHEEL_WIDTH / 2);
}

/**
 * A hand's hold on the wheel, from where it took hold: nothing jumps then, wherever that is.
 */
export class Hold {
  #pivot;
  #torsionAngle;
  #magnification;
  /** The hand's direction from the pivot, and how far it has gone round since it took hold [rad]. */
  #direction;
  #turn = 0;

  /**
   * @param {Size} size
   * @param {Scene} scene
   * @param {Point} point where the hand takes hold
   */
  constructor(size, scene, point) {
    this.#pivot = pivotFor(sheetFor(size, scene).axis, point, poseNow(scene).angle);
    this.#direction = directionOf(this.#pivot, point);
    this.#torsionAngle = scene.state[0] ?? 0;
    this.#magnification = scene.magnification;
  }

  /**
   * ψ when the hand has come to this point [rad]: what it was, and the hand's turn about the
   * steering axis divided by the magnification. It stops where the drawing does.
   *
   * @param {Point} point
   */
  turnTo(point) {
    const direction = directionOf(this.#pivot, point);
    const step = direction - this.#direction;
    this.#direction = direction;
    this.#turn += step - 2 * Math.PI * Math.round(step / (2 * Math.PI));
    const start = this.#torsionAngle;
    const limit = Math.max(LARGEST_ANGLE / this.#magnification, Math.abs(start));
    return within(start + this.#turn / this.#magnification, limit);
  }
}

/**
 * What a key turns the wheel by, in true radians, or 0 where it is not for the wheel: ← to the
 * left, counter-clockwise, → to the right.
 *
 * @param {{key: string, shiftKey: boolean}} event
 */
export function turnOfKey({ key, shiftKey }) {
  const side = key === 'ArrowLeft' ? 1 : key === 'ArrowRight' ? -1 : 0;
  return side * KEY_TURN * (shiftKey ? SHIFT : 1);
}

/** The wheel that a hand sees: of a blur, its middle. @param {Scene} scene */
function grabbed(scene) {
  if (scene.fan?.length) {
    const pose = poseOf(scene, 0, 0);
    return { pose, line: { l: [pose.half], n: [0] }, shape: straightShape(pose) };
  }
  const pose = poseNow(scene);
  const line = contactLine(traceBehind(scene, pose, 2 * pose.half), pose);
  return { pose, line, shape: tireShape(pose, line) };
}

/**
 * The axis, moved away from a hand that would stand on it; on it the hand counts as behind.
 *
 * @param {Point} axis
 * @param {Point} point
 * @param {number} angle of the wheel plane
 * @returns {Point}
 */
function pivotFor(axis, point, angle) {
  const distance = Math.hypot(point.x - axis.x, point.y - axis.y);
  if (distance >= LEVER) return axis;
  const direction = distance > 1 ? directionOf(axis, point) : Math.PI + angle;
  return { x: point.x - LEVER * Math.cos(direction), y: point.y + LEVER * Math.sin(direction) };
}

/** Counter-clockwise from straight ahead [rad]. @param {Point} from @param {Point} to */
const directionOf = (from, to) => Math.atan2(from.y - to.y, to.x - from.x);

/** @param {readonly Point[]} points */
function boxAround(points) {
  const xs = points.map(({ x }) => x);
  const ys = points.map(({ y }) => y);
  const [left, top] = [Math.min(...xs), Math.min(...ys)];
  const width = Math.max(TARGET, Math.max(...xs) - left);
  const height = Math.max(TARGET, Math.max(...ys) - top);
  const middle = { x: (left + Math.max(...xs)) / 2, y: (top + Math.max(...ys)) / 2 };
  return { x: middle.x - width / 2, y: middle.y - height / 2, width, height };
}
