import { html } from 'lit';
import { tell } from '../../command.js';
import { runJob } from '../../engine/workers.js';
import { isSameList } from '../../store.js';
import '../../view/canvas.js';
import { valueIn } from '../../view/field.js';
import { colorsOfSwings, paintPixels } from '../../view/map-colors.js';
import { roundLimit } from '../../view/scale.js';
import { drawSwingMap, placesOfSwingMap } from '../../view/swing-map.js';
import { swingSheetOf } from '../../view/swing-sheet.js';
import { decimalsFor } from '../../words/number.js';
import { lowerName, plainSymbol } from '../stability/say.js';
import { BesideWork } from './beside-work.js';
import { PlaneHand } from './plane-hand.js';
import { SwingPlane } from './swing-plane.js';
import { hasTwoAt } from './two-motions.js';

/**
 * A plane of two values of the gear with all that is known of its swings: how widely it swings in the end, where cycles are
 * born and where two of them meet, and where two motions are possible; the gear is a point in it that a hand drags. For the
 * views that show one: they say which values. Command: `point` with both values.
 *
 * @typedef {import('../../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../../run/linear-looks.js').Range} Range
 * @typedef {import('../../run/scene.js').Scene} Scene
 * @typedef {import('../../style/theme.js').Theme} Theme
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('./swing-plane.js').Amplitudes} Amplitudes
 * @typedef {Range & { quantity: Quantity }} Side
 * @typedef {import('./panel.js').CyclePanel & { spoken: string, sides: { x: Side, y: Side } | null }} Host `spoken`: what the point says of itself
 */

const degree = Math.PI / 180;
/** Lines of equal swing, in degrees. */
const levels = [0.5, 1, 2, 3, 5, 10, 15, 20, 30];

export class SwingChart {
  #host;
  #plane = new SwingPlane((spec, options) => runJob('bifurcation', spec, options));
  /** @type {BesideWork<import('../../pkg/shimmy.js').FoldSpec, import('../../pkg/shimmy.js').FoldCurve[]>} */
  #folds = new BesideWork((spec, options) => runJob('foldCurve', spec, options));
  /** @type {{ key: string, curves: import('../../run/linear-looks.js').BoundaryCurve[] }} */ #hopf = { key: '', curves: [] };
  #image = document.createElement('canvas');
  /** What the image was made from. @type {unknown[]} */ #imageOf = [];
  /** @type {import('../../view/swing-sheet.js').SwingSheet | null} */ #sheet = null;
  /** @type {unknown[]} */ #sheetOf = [];
  /** Where the mouse reads, in px. @type {{ x: number, y: number } | null} */ #hover = null;
  #hand = new PlaneHand({
    places: () => this.#places, point: () => this.point,
    put: (x, y, gesture) => this.#put(x, y, gesture), step: (across, up, factor) => this.#step(across, up, factor),
    settle: () => tell(this.#host, 'settle'),
    hover: (at) => {
      this.#hover = at;
      this.redraw();
    },
  });

  /** @param {Host} host */
  constructor(host) {
    this.#host = host;
    this.#plane.onChange = () => this.redraw();
    this.#folds.onChange = () => this.redraw();
  }

  /** Nobody looks any more. */
  stop() {
    this.#plane.stop();
    this.#folds.stop();
  }

  get #canvas() {
    return /** @type {import('../../view/canvas.js').Canvas | null} */ (this.#host.querySelector('.swing-map shimmy-canvas'));
  }

  get #places() {
    const { sides, theme } = this.#host;
    const size = this.#canvas?.size;
    return sides && size && theme ? placesOfSwingMap(size, theme, sides.x, sides.y) : null;
  }

  /** The gear's values. */
  get point() {
    const { sides, scene } = this.#host;
    const parameters = scene?.parameters ?? {};
    return { x: parameters[sides?.x.parameter ?? ''] ?? 0, y: parameters[sides?.y.parameter ?? ''] ?? 0 };
  }

  /** Whether the gear has two motions here, as far as is known. */
  get hasTwo() {
    const { sides } = this.#host;
    const { amplitudes, isOld } = this.#plane;
    if (!sides || !amplitudes || isOld) return false;
    const { x, y } = this.point;
    return hasTwoAt(amplitudes.two, shareOf(sides.x, x), shareOf(sides.y, y));
  }

  /** Works on what is to be seen. @param {Scene} scene */
  look(scene) {
    const { sides, isVeiled } = this.#host;
    if (!sides || isVeiled) return;
    const [x, y] = [rangeOf(sides.x), rangeOf(sides.y)];
    const others = Object.entries(scene.parameters).filter(([name]) => name !== x.parameter && name !== y.parameter);
    const shape = JSON.stringify([scene.object, x, y]);
    const key = JSON.stringify([shape, others]);
    const gear = { model: scene.object, parameters: { ...scene.parameters } };
    // The curves first: they are soon there.
    this.#folds.look({ key, shape, spec: { ...gear, x, y } });
    this.#plane.look({ key, shape, gear, x, y });
    if (this.#hopf.key !== key) this.#hopf = { key, curves: this.#host.ask((linear) => linear.boundary(x, y)) ?? [] };
  }

  redraw() {
    const host = this.#host;
    const { x, y } = this.point;
    const { amplitudes, isOld, share } = this.#plane;
    host.redrawWhere('.swing-map shimmy-canvas', [
      host.settings, host.quantities, host.voice, host.isVeiled, host.theme, amplitudes, isOld, share, this.#folds.result, this.#folds.isOld, this.#hopf, this.#hover, x, y,
    ]);
    const { ring } = this.#hand;
    const handle = /** @type {HTMLElement | null} */ (host.querySelector('.plane-point'));
    if (ring && handle) Object.assign(handle.style, { left: `${ring.x.toFixed(1)}px`, top: `${ring.y.toFixed(1)}px` });
    if (host.voice) host.spoken = this.#readings(this.point, host.voice)[0];
  }

  /** @param {string} label of the picture @param {Voice} voice */
  template(label, voice) {
    const { sides, spoken } = this.#host;
    if (!sides) return '';
    const does = voice.say('stability.point.does', { across: lowerName(sides.x.quantity, voice), up: lowerName(sides.y.quantity, voice) });
    const hand = this.#hand;
    return html`
      <div class="swing-map hand-plane">
        <shimmy-canvas .label=${label} .paint=${this.#paint}
          @pointerdown=${hand.press} @pointermove=${hand.move} @pointerup=${hand.lift} @pointercancel=${hand.lift} @pointerleave=${hand.leave}></shimmy-canvas>
        <div class="plane-point" role="slider" tabindex="0" aria-label=${voice.say('stability.point')} aria-description=${does} title=${does}
          aria-valuemin=${sides.x.from} aria-valuemax=${sides.x.to} aria-valuenow=${this.point.x} aria-valuetext=${spoken}
          @pointerdown=${hand.grab} @pointermove=${hand.drag} @pointerup=${hand.release} @pointercancel=${hand.release}
          @lostpointercapture=${hand.release} @keydown=${hand.key}></div>
      </div>`;
  }

  /** What becomes of a gear at a point of the map, in fewer and fewer words. @param {{ x: number, y: number }} point @param {Voice} voice */
  #readings({ x, y }, voice) {
    const { sides, isVeiled } = this.#host;
    const { amplitudes } = this.#plane;
    if (!sides) return [''];
    const [across, up] = /** @type {const} */ ([[sides.x, x], [sides.y, y]]).map(([{ quantity }, value]) => `${plainSymbol(quantity)} ${quantity.write(quantity.snapped(value), voice)}`);
    if (isVeiled || !amplitudes) return [`${across}, ${up}`];
    const shares = /** @type {const} */ ([shareOf(sides.x, x), shareOf(sides.y, y)]);
    const degrees = valueIn(amplitudes, ...shares) / degree;
    const swing = degrees < 0.005 ? voice.say('gap.rests') : `±${voice.number(degrees, Math.min(2, decimalsFor(degrees, 3)))}°`;
    const what = degrees >= 0.005 && hasTwoAt(amplitudes.two, ...shares) ? voice.say('folds.either', { swing }) : swing;
    return [voice.say('stability.reading', { x: across, y: up, what }), what];
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paint = (context, size) => {
    const { voice, theme, scene, isVeiled, sides } = this.#host;
    if (!voice || !theme || !scene || !sides) return;
    const { amplitudes, isOld } = this.#plane;
    const places = placesOfSwingMap(size, theme, sides.x, sides.y);
    const limit = amplitudes ? limitOf(amplitudes.values) : 1;
    const folds = isVeiled || this.#folds.isOld ? [] : this.#folds.result ?? [];
    if (amplitudes && !isVeiled) this.#make(context, places, amplitudes, limit, folds, theme, voice);
    const read = this.#hover ? { x: places.valueX(this.#hover.x), y: places.valueY(this.#hover.y) } : this.point;
    drawSwingMap(context, size, {
      ...sides, image: amplitudes ? this.#image : null, isOld, sheet: this.#sheet, curves: isVeiled ? [] : [...this.#hopf.curves, ...folds], limit, point: this.point,
      readings: this.#readings(read, voice), veiled: isVeiled,
    }, theme, voice);
  };

  /**
   * Image and lines, made anew only where something has changed; lines once all is there.
   * @param {CanvasRenderingContext2D} context @param {ReturnType<typeof placesOfSwingMap>} places @param {Amplitudes} amplitudes @param {number} limit
   * @param {readonly import('../../pkg/shimmy.js').FoldCurve[]} folds @param {Theme} theme @param {Voice} voice
   */
  #make(context, { frame, x, y }, amplitudes, limit, folds, theme, voice) {
    if (!isSameList([amplitudes, theme, limit], this.#imageOf)) {
      this.#imageOf = [amplitudes, theme, limit];
      const { columns, rows } = amplitudes;
      const on = this.#image.getContext('2d');
      if (!on) return;
      Object.assign(this.#image, { width: columns, height: rows });
      const pixels = on.createImageData(columns, rows);
      paintPixels(amplitudes, colorsOfSwings(limit, theme), pixels.data);
      on.putImageData(pixels, 0, 0);
    }
    const laid = [amplitudes, this.#folds.result, this.#hopf, theme, voice, ...Object.values(frame)];
    if (isSameList(laid, this.#sheetOf)) return;
    this.#sheetOf = laid;
    this.#sheet = this.#plane.share < 1 ? null : swingSheetOf(context, frame, amplitudes, {
      levels: levels.filter((level) => level * degree < limit * 2).map((level) => ({ value: level * degree, text: `${voice.number(level, level < 1 ? 1 : 0)}°` })),
      curves: [...folds, ...this.#hopf.curves].filter(({ bounds }) => bounds).map((curve) => ({ curve, name: this.#nameOf(curve.kind, voice) })), x, y,
      hasTwo: (across, up) => hasTwoAt(amplitudes.two, across, up), two: [voice.say('folds.two'), voice.say('folds.two.short')],
    }, theme);
  }

  /** @param {'hopf' | 'divergence' | 'fold'} kind @param {Voice} voice */
  #nameOf(kind, voice) {
    const name = voice.say(`folds.${kind}`);
    return kind !== 'fold' && this.#host.scene?.linear.isRubbed ? voice.say('branch.frictionless', { point: name }) : name;
  }

  /** @param {number} x in SI @param {number} y @param {string | null} gesture */
  #put(x, y, gesture) {
    const { sides } = this.#host;
    if (!sides) return;
    const within = (/** @type {Side} */ { from, to, quantity }, /** @type {number} */ value) => Math.min(Math.max(quantity.snapped(value), from), to);
    tell(this.#host, 'point', { values: { [sides.x.parameter]: within(sides.x, x), [sides.y.parameter]: within(sides.y, y) }, gesture });
  }

  /** @param {number} across @param {number} up @param {number} factor */
  #step(across, up, factor) {
    const { sides, scene } = this.#host;
    if (!sides) return;
    const { parameter, quantity, from, to } = across ? sides.x : sides.y;
    const value = scene?.parameters[parameter] ?? 0;
    const next = quantity.stepped(value, (across || up) * factor);
    tell(this.#host, 'point', { values: { [parameter]: Math.min(Math.max(next, Math.min(from, value)), Math.max(to, value)) }, gesture: `point keys ${parameter}` });
  }
}

/** The widest swing that colors tell apart. @param {Float64Array} values */
function limitOf(values) {
  const most = values.reduce((high, value) => Math.max(high, value), 0.1 * degree);
  return Math.min(30, roundLimit(most / degree / 1.12)) * degree;
}

/** @param {Range} side @param {number} value */
const shareOf = ({ from, to }, value) => (value - from) / (to - from);

/** @param {Range} side */
const rangeOf = ({ parameter, from, to }) => ({ parameter, from, to });
