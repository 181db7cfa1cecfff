/**
 * A hand on a point in a plane: it drags the point, or a click elsewhere brings it there; arrow keys move it. Used by views whose
 * picture has a point that is two values.
 *
 * @typedef {{ x: number, y: number }} Point
 * @typedef {{ frame: import('../../view/axes.js').Box, x: (value: number) => number, y: (value: number) => number, valueX: (px: number) => number, valueY: (px: number) => number }} Places
 * @typedef {{
 *   places: () => Places | null, point: () => Point, put: (x: number, y: number, gesture: string | null) => void, step: (across: number, up: number, factor: number) => void,
 *   settle: () => void, hover: (at: Point | null) => void,
 * }} Host `put`: values for the point; `step`: by so many steps; `settle`: the hand has let go; `hover`: a mouse reads there, in px
 */

import { withinFrame } from '../../view/working-point.js';

/** A press that moves no further than this is a click, in px. */
const widestClick = 4;

export class PlaneHand {
  #host;
  /** @type {{ pointer: number, dx: number, dy: number, from: Point, isClick: boolean } | null} */ #grip = null;
  #gestures = 0;

  /** @param {Host} host */
  constructor(host) {
    this.#host = host;
  }

  /** Where the handle is to be, in px; null before there is a picture. @returns {Point | null} */
  get ring() {
    const places = this.#host.places();
    const point = this.#host.point();
    return places && withinFrame({ x: places.x(point.x), y: places.y(point.y) }, places.frame);
  }

  /** The handle is taken. @param {PointerEvent} event */
  grab = (event) => {
    const { ring } = this;
    if (event.button !== 0 || !event.isPrimary || !ring || this.#grip) return;
    const handle = /** @type {HTMLElement} */ (event.currentTarget);
    event.preventDefault();
    handle.setPointerCapture(event.pointerId);
    handle.focus({ preventScroll: true });
    const at = placeOf(event);
    this.#grip = { pointer: event.pointerId, dx: at.x - ring.x, dy: at.y - ring.y, from: at, isClick: false };
    this.#gestures++;
    this.#host.hover(null);
  };

  /** @param {PointerEvent} event */
  drag = (event) => {
    const grip = this.#grip;
    if (grip?.pointer !== event.pointerId || grip.isClick) return;
    const { x, y } = placeOf(event);
    this.#put({ x: x - grip.dx, y: y - grip.dy }, `plane drag ${this.#gestures}`);
  };

  /** @param {PointerEvent} event */
  release = (event) => {
    if (this.#grip?.pointer !== event.pointerId || this.#grip.isClick) return;
    this.#grip = null;
    this.#host.settle();
  };

  /** A press beside the handle. @param {PointerEvent} event */
  press = (event) => {
    if (event.button !== 0 || !event.isPrimary || this.#grip) return;
    this.#grip = { pointer: event.pointerId, dx: 0, dy: 0, from: placeOf(event), isClick: true };
  };

  /** @param {PointerEvent} event */
  move = (event) => {
    const at = placeOf(event);
    const grip = this.#grip;
    if (grip?.pointer === event.pointerId && grip.isClick && Math.hypot(at.x - grip.from.x, at.y - grip.from.y) > widestClick) this.#grip = null;
    if (event.pointerType !== 'mouse') return;
    const frame = this.#host.places()?.frame;
    this.#host.hover(frame && isInside(at, frame) ? at : null);
  };

  /** @param {PointerEvent} event */
  lift = (event) => {
    const grip = this.#grip;
    if (!grip?.isClick || grip.pointer !== event.pointerId) return;
    this.#grip = null;
    const frame = this.#host.places()?.frame;
    if (event.type !== 'pointerup' || !frame || !isInside(grip.from, frame)) return;
    this.#put(grip.from, null);
    this.#host.settle();
  };

  leave = () => this.#host.hover(null);

  /** @param {KeyboardEvent} event */
  key = (event) => {
    const [across, up] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] ?? [0, 0];
    if (event.ctrlKey || event.metaKey || !(across || up)) return;
    event.preventDefault();
    event.stopPropagation();
    this.#host.step(across, up, event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
    this.#host.settle();
  };

  /** @param {Point} at in px @param {string | null} gesture */
  #put({ x, y }, gesture) {
    const places = this.#host.places();
    if (!places) return;
    const within = withinFrame({ x, y }, places.frame);
    this.#host.put(places.valueX(within.x), places.valueY(within.y), gesture);
  }
}

/** In px from the corner of the plane's own element. @param {PointerEvent} event @returns {Point} */
function placeOf(event) {
  const plane = /** @type {HTMLElement} */ (event.currentTarget).closest('.hand-plane');
  const { left, top } = /** @type {HTMLElement} */ (plane).getBoundingClientRect();
  return { x: event.clientX - left, y: event.clientY - top };
}

/** @param {Point} at @param {import('../../view/axes.js').Box} frame */
const isInside = ({ x, y }, { left, right, top, bottom }) => x >= left && x <= right && y >= top && y <= bottom;
