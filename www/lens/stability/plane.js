import { LitElement, html } from 'lit';
import { tell } from '../../command.js';
import { frictionParameter, leftOut } from '../../run/linear-looks.js';
import { isSameList } from '../../store.js';
import '../../view/canvas.js';
import { drawStabilityMap, frameOfMap, gapParameter, isNarrowMap, placesOfMap } from '../../view/stability-map.js';
import { withinFrame } from '../../view/working-point.js';
import { MapPicture } from './map-picture.js';
import { becomes, becomesBriefly, becomesInSigns, lowerName, plainSymbol, valueInWords } from './say.js';

/**
 * @typedef {import('../../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../../view/axes.js').Box} Box
 * @typedef {import('../../run/scene.js').Scene} Scene
 * @typedef {import('../../style/theme.js').Theme} Theme
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('./plane-map.js').Looked} Looked
 * @typedef {import('./settings.js').Plane} Chosen
 */

/** A press that moves no further than this is a click, in px. */
const widestClick = 4;

/**
 * The plane with the gear as a point in it, which mouse, finger and arrow keys move; a click elsewhere in the plane brings
 * it there. The mouse reads where it is; where the picture is too narrow for what is read off, an event `read` has the words.
 * Commands: `point` with both values, `settle` at the end of a gesture, `toggle`.
 */
export class Plane extends LitElement {
  static properties = { voice: { attribute: false }, quantities: { attribute: false }, plane: { attribute: false }, isVeiled: { attribute: false }, label: {}, spoken: { state: true } };

  /** @type {Scene | null} */ #scene = null;
  /** @type {Theme | null} */ #theme = null;
  /** @type {Looked | null} */ #looked = null;
  /** What is drawn already, so that nothing is drawn twice. @type {unknown[]} */ #drawn = [];
  #picture = new MapPicture();
  /** The hand on the point: which pointer, how far beside its middle, and for a click where it began. @type {{ pointer: number, dx: number, dy: number, from: { x: number, y: number }, isClick: boolean } | null} */
  #grip = null;
  /** Where the mouse reads, in px. @type {{ x: number, y: number } | null} */ #hover = null;
  #gestures = 0;
  /** What was read off last and has no room in the picture. */ #told = '';

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    /** @type {Quantity[]} */ this.quantities = [];
    /** @type {Chosen | null} */ this.plane = null;
    /** Whether what would tell the future is hidden. */ this.isVeiled = false;
    /** What the picture is, for those who do not see it. */ this.label = '';
    /** What the point says of itself. */ this.spoken = '';
  }

  createRenderRoot() {
    return this;
  }

  render() {
    const { voice, plane } = this;
    const sides = this.#sides;
    if (!voice || !plane || !sides) return html``;
    const does = voice.say('stability.point.does', { across: lowerName(sides.x.quantity, voice), up: lowerName(sides.y.quantity, voice) });
    const value = this.#scene?.parameters[plane.x.parameter] ?? 0;
    return html`
      <shimmy-canvas .label=${this.label} .paint=${this.#paint}
        @pointerdown=${this.#press} @pointermove=${this.#move} @pointerup=${this.#lift} @pointercancel=${this.#lift} @pointerleave=${this.#leave}></shimmy-canvas>
      <div class="plane-point" role="slider" tabindex="0" aria-label=${voice.say('stability.point')} aria-description=${does} title=${does}
        aria-valuemin=${plane.x.from} aria-valuemax=${plane.x.to} aria-valuenow=${value} aria-valuetext=${this.spoken}
        @pointerdown=${this.#grab} @pointermove=${this.#drag} @pointerup=${this.#release} @pointercancel=${this.#release}
        @lostpointercapture=${this.#release} @keydown=${this.#key}></div>`;
  }

  /** @param {Map<string, unknown>} changed */
  updated(changed) {
    // Words that follow what was drawn are no reason to draw it again.
    if ([...changed.keys()].every((name) => ['label', 'spoken'].includes(name))) return;
    this.#drawn = [];
    this.#show();
  }

  /** @param {Scene} scene @param {Looked | null} looked @param {Theme} theme */
  draw(scene, looked, theme) {
    this.#scene = scene;
    this.#looked = looked;
    this.#theme = theme;
    this.#show();
  }

  get #canvas() {
    return /** @type {import('../../view/canvas.js').Canvas | null} */ (this.querySelector('shimmy-canvas'));
  }

  get #sides() {
    const { plane, quantities } = this;
    const side = (/** @type {import('./settings.js').Range | undefined} */ range) => {
      const quantity = quantities.find(({ name }) => name === range?.parameter);
      return range && quantity ? { ...range, quantity } : null;
    };
    const [x, y] = [side(plane?.x), side(plane?.y)];
    return x && y ? { x, y } : null;
  }

  /** The side along which the gap opens, if one does: then the plane speaks of linear theory, wherever its point is. */
  get #gapSide() {
    const sides = this.#sides;
    return sides ? [sides.x, sides.y].find(({ parameter }) => parameter === gapParameter) : undefined;
  }

  /** Frame and scales of what is on the screen. */
  get #places() {
    const { plane } = this;
    const size = this.#canvas?.size;
    if (!plane || !size || !this.#theme) return null;
    const frame = frameOfMap(size, this.#theme);
    return { frame, ...placesOfMap(frame, plane.x, plane.y) };
  }

  /** Draws where something has changed, and puts the handle over the point. */
  #show() {
    const { plane, voice } = this;
    const scene = this.#scene;
    const places = this.#places;
    if (!plane || !voice || !scene || !places) return;
    const point = this.#point;
    const wanted = [this.#looked, this.#theme, this.isVeiled, point.x, point.y, this.#hover?.x, this.#hover?.y];
    if (isSameList(wanted, this.#drawn)) return;
    this.#drawn = wanted;
    this.#canvas?.redraw();
    const handle = /** @type {HTMLElement | null} */ (this.querySelector('.plane-point'));
    const { x, y } = ringOf(point, places);
    if (handle) Object.assign(handle.style, { left: `${x.toFixed(1)}px`, top: `${y.toFixed(1)}px` });
    this.spoken = this.#readings(point, true)[0];
    this.#tell();
  }

  /** Whether there is no room in the picture for what is read off. */
  get #isNarrow() {
    const size = this.#canvas?.size;
    return Boolean(size && this.#theme && isNarrowMap(size, this.#theme));
  }

  #tell() {
    const told = this.#isNarrow ? this.#readings(this.#read)[0] : '';
    if (told === this.#told) return;
    this.#told = told;
    this.dispatchEvent(new CustomEvent('read', { detail: told }));
  }

  /** The values at the mouse, else the gear's. */
  get #read() {
    const places = this.#places;
    return this.#hover && places ? { x: places.valueX(this.#hover.x), y: places.valueY(this.#hover.y) } : this.#point;
  }

  /** The gear's values. */
  get #point() {
    const { plane } = this;
    const parameters = this.#scene?.parameters ?? {};
    return { x: parameters[plane?.x.parameter ?? ''] ?? 0, y: parameters[plane?.y.parameter ?? ''] ?? 0 };
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paint = (context, size) => {
    const { voice, plane, isVeiled } = this;
    const scene = this.#scene;
    const theme = this.#theme;
    const sides = this.#sides;
    const looked = this.#looked;
    if (!voice || !plane || !scene || !theme || !sides) return;
    const { coloring } = plane;
    const isLinearOnly = scene.linear.isGapped || this.#gapSide !== undefined;
    if (looked && !isVeiled) this.#picture.make(context, frameOfMap(size, theme), looked, { coloring, isLinearOnly, isRubbed: scene.linear.isRubbed }, theme, voice);
    drawStabilityMap(context, size, {
      ...sides, image: looked ? this.#picture.image : null, sheet: looked ? this.#picture.sheet : null, boundary: looked?.boundary ?? [],
      coloring, limits: looked?.limits ?? { growthRate: 1, frequency: [0, 1] },
      point: this.#point, readings: this.#isNarrow ? [] : this.#readings(this.#read), veiled: isVeiled,
      engaged: this.#gapSide?.from === 0 ? voice.say('stability.engaged', { symbol: plainSymbol(this.#gapSide.quantity) }) : '',
    }, theme, voice);
  };

  /** What linear theory says of a point, in fewer and fewer words: of a veiled one its values alone. @param {{ x: number, y: number }} point @param {boolean} [isSpoken] with names and units */
  #readings(point, isSpoken = false) {
    const { voice, plane } = this;
    const sides = this.#sides;
    const linear = this.#scene?.linear;
    if (!voice || !plane || !sides || !linear) return [''];
    const side = (/** @type {Quantity} */ quantity, /** @type {number} */ value) =>
      (isSpoken ? `${lowerName(quantity, voice)} ${quantity.write(value, voice)}` : valueInWords(quantity, value, voice));
    const [x, y] = [side(sides.x.quantity, sides.x.quantity.snapped(point.x)), side(sides.y.quantity, sides.y.quantity.snapped(point.y))];
    if (this.isVeiled) return [`${x}, ${y}`];
    let roots;
    try {
      roots = linear.eigenvalues({ [plane.x.parameter]: point.x, [plane.y.parameter]: point.y });
    } catch {
      roots = /** @type {import('../../view/root-paths.js').Root[]} */ ([]);
    }
    const gap = this.#gapSide;
    const isGapped = gap ? (gap.parameter === plane.x.parameter ? point.x : point.y) > 0 : linear.isGapped;
    const rubbing = [[plane.x, point.x], [plane.y, point.y]].find(([axis]) => /** @type {typeof plane.x} */ (axis).parameter === frictionParameter);
    const leavesOut = leftOut(isGapped, rubbing ? Number(rubbing[1]) > 0 : linear.isRubbed);
    const briefly = gap && !leavesOut ? [voice.say('stability.linear.engaged', { what: becomes(roots, voice) })] : becomesBriefly(roots, leavesOut, voice);
    return [...[briefly[0], becomesInSigns(roots, leavesOut, voice)].map((what) => voice.say('stability.reading', { x, y, what })), ...briefly];
  }

  /** @param {PointerEvent} event */
  #grab(event) {
    const places = this.#places;
    if (event.button !== 0 || !event.isPrimary || !places || this.#grip) return;
    const { x, y } = placeOf(event, this);
    event.preventDefault();
    const handle = /** @type {HTMLElement} */ (event.currentTarget);
    handle.setPointerCapture(event.pointerId);
    handle.focus({ preventScroll: true });
    const ring = ringOf(this.#point, places);
    this.#grip = { pointer: event.pointerId, dx: x - ring.x, dy: y - ring.y, from: { x, y }, isClick: false };
    this.#gestures++;
    this.#hover = null;
  }

  /** @param {PointerEvent} event */
  #drag(event) {
    const grip = this.#grip;
    if (grip?.pointer !== event.pointerId) return;
    const { x, y } = placeOf(event, this);
    this.#put(x - grip.dx, y - grip.dy, `point drag ${this.#gestures}`);
  }

  /** @param {PointerEvent} event */
  #release(event) {
    if (this.#grip?.pointer !== event.pointerId) return;
    this.#grip = null;
    tell(this, 'settle');
  }

  /** A press in the plane beside the point. @param {PointerEvent} event */
  #press(event) {
    if (event.button !== 0 || !event.isPrimary || this.#grip) return;
    this.#grip = { pointer: event.pointerId, dx: 0, dy: 0, from: placeOf(event, this), isClick: true };
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const at = placeOf(event, this);
    if (this.#grip?.pointer === event.pointerId && Math.hypot(at.x - this.#grip.from.x, at.y - this.#grip.from.y) > widestClick) this.#grip = null;
    if (event.pointerType !== 'mouse') return;
    const frame = this.#places?.frame;
    // A pen draws, and reads nothing.
    this.#hover = frame && isInside(at, frame) && !this.closest('[data-pen]') ? at : null;
    this.#show();
  }

  /** @param {PointerEvent} event */
  #lift(event) {
    const grip = this.#grip;
    if (!grip?.isClick || grip.pointer !== event.pointerId) return;
    this.#grip = null;
    const frame = this.#places?.frame;
    if (event.type !== 'pointerup' || !frame || !isInside(grip.from, frame)) return;
    this.#put(grip.from.x, grip.from.y, null);
    tell(this, 'settle');
  }

  #leave() {
    this.#hover = null;
    this.#show();
  }

  /** @param {number} x in px @param {number} y @param {string | null} gesture */
  #put(x, y, gesture) {
    const places = this.#places;
    if (places) this.#set(places.valueX(x), places.valueY(y), gesture);
  }

  /** The point to values within the plane, rounded as fields show them. @param {number} x in SI @param {number} y @param {string | null} gesture */
  #set(x, y, gesture) {
    const sides = this.#sides;
    if (!sides) return;
    const within = (/** @type {typeof sides.x} */ { from, to, quantity }, /** @type {number} */ value) => Math.min(Math.max(quantity.snapped(value), from), to);
    tell(this, 'point', { values: { [sides.x.parameter]: within(sides.x, x), [sides.y.parameter]: within(sides.y, y) }, gesture });
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const sides = this.#sides;
    const [across, up] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] ?? [0, 0];
    if (event.ctrlKey || event.metaKey || !sides || !(across || up || event.key === ' ')) return;
    event.preventDefault();
    event.stopPropagation();
    if (event.key === ' ') {
      tell(this, 'toggle');
      return;
    }
    const { parameter, quantity, from, to } = across ? sides.x : sides.y;
    const factor = event.shiftKey ? 10 : event.altKey ? 0.1 : 1;
    const value = this.#scene?.parameters[parameter] ?? 0;
    const next = quantity.stepped(value, (across || up) * factor);
    tell(this, 'point', { values: { [parameter]: Math.min(Math.max(next, Math.min(from, value)), Math.max(to, value)) }, gesture: `point keys ${parameter}` });
    tell(this, 'settle');
  }
}

/** Where the ring of a point stands. @param {{ x: number, y: number }} point @param {{ frame: Box, x: (value: number) => number, y: (value: number) => number }} places */
const ringOf = (point, { frame, x, y }) => withinFrame({ x: x(point.x), y: y(point.y) }, frame);

/** @param {{ x: number, y: number }} at @param {Box} frame */
const isInside = ({ x, y }, { left, right, top, bottom }) => x >= left && x <= right && y >= top && y <= bottom;

/** @param {PointerEvent} event @param {HTMLElement} element */
function placeOf(event, element) {
  const { left, top } = element.getBoundingClientRect();
  return { x: event.clientX - left, y: event.clientY - top };
}

customElements.define('shimmy-plane', Plane);
