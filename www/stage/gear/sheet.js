/**
 * The sheet: where each view stands on the canvas, how many pixels a meter has, how large type and
 * lines are. Top view over side view share the x axis, so the caster lines up in both.
 *
 * @module
 */

/** @typedef {import('./scene.js').Size} Size */
/** @typedef {import('./scene.js').Scene} Scene */
/** @typedef {import('./scene.js').LayoutName} LayoutName */

/** The wheel that is drawn. The model knows neither its radius nor its width. [m] */
export const WHEEL_RADIUS = 0.25;
export const WHEEL_WIDTH = 0.17;

/** However far the wheel trails, angles are read off an arc of this radius at least. [m] */
const LEAST_PROTRACTOR = 0.2;

/**
 * What each layout chooses. Lengths ending in `M` are in meters on the ground, the others in
 * pixels.
 *
 * @typedef {object} Layout
 * @property {number} verdict height at the top that belongs to the page's verdict
 * @property {number} widthM meters that the width shows
 * @property {number} topM height of the top view, 0 where there is none
 * @property {number} sideM height of the side view above its ground, 0 where there is none
 * @property {number} axisAt place of the steering axis as a share of the width
 * @property {number} protractorM
 * @property {number} headM radius of the steering head's detail
 * @property {number} headTop
 * @property {number} headRight
 * @property {number} foot room under the side view's ground, for its dimensions
 * @property {number} small type sizes
 * @property {number} label
 * @property {number} large
 * @property {number} line factor on every line width
 * @property {boolean} detailed whether the tire's and the head's parts are labeled
 * @property {boolean} roomy whether there is room besides for the track's name
 */

/** @type {Readonly<Record<LayoutName, Layout>>} */
const LAYOUTS = {
  desktop: {
    verdict: 84, widthM: 2.533, topM: 0.57, sideM: 0.618, axisAt: 0.47, protractorM: 0.5,
    headM: 0.294, headTop: 20, headRight: 18, foot: 34, small: 13, label: 15, large: 17, line: 1,
    detailed: true, roomy: true,
  },
  projector: {
    verdict: 84, widthM: 2.533, topM: 0.72, sideM: 0.53, axisAt: 0.44, protractorM: 0.53,
    headM: 0.29, headTop: 18, headRight: 18, foot: 36, small: 17, label: 19, large: 22, line: 1.5,
    detailed: true, roomy: false,
  },
  phone: {
    verdict: 66, widthM: 1.64, topM: 0.85, sideM: 0, axisAt: 0.46, protractorM: 0.6,
    headM: 0.205, headTop: 6, headRight: 12, foot: 0, small: 13, label: 15, large: 17, line: 1.1,
    detailed: false, roomy: false,
  },
  'phone-side': {
    verdict: 66, widthM: 1.2, topM: 0, sideM: 0.618, axisAt: 0.55, protractorM: 0.6,
    headM: 0.205, headTop: 6, headRight: 12, foot: 56, small: 13, label: 15, large: 17, line: 1.1,
    detailed: false, roomy: false,
  },
  /** Seen from the last row, under a verdict that has a row of its own. */
  big: {
    verdict: 24, widthM: 1.64, topM: 0.9, sideM: 0, axisAt: 0.4, protractorM: 0.6,
    headM: 0.205, headTop: 6, headRight: 12, foot: 0, small: 17, label: 19, large: 22, line: 1.5,
    detailed: false, roomy: false,
  },
};

/**
 * @typedef {object} Sheet
 * @property {number} width
 * @property {number} height
 * @property {number} scale pixels a meter
 * @property {{x: number, y: number}} axis the steering axis in the top view
 * @property {{top: number, bottom: number}} band the ground of the top view
 * @property {boolean} hasTop whether there is a top view
 * @property {{top: number, ground: number} | null} side the side view and its ground line
 * @property {number} protractor radius [px]
 * @property {{x: number, y: number, radius: number}} head
 * @property {number} small
 * @property {number} label
 * @property {number} large
 * @property {number} line
 * @property {boolean} detailed
 * @property {boolean} roomy
 * @property {boolean} isCached whether what stays may be kept as bitmaps
 */

/**
 * The sheet for a canvas. The steering axis moves aside for a long caster, so that neither the
 * wheel nor the protractor leaves the sheet or slides under the steering head.
 *
 * @param {Size} size
 * @param {Pick<Scene, 'layout' | 'parameters'>} scene
 * @returns {Sheet}
 */
export function sheetFor(size, scene) {
  const layout = LAYOUTS[scene.layout];
  const { width, height } = size;
  const caster = scene.parameters.casterLength ?? 0;
  const room = height - layout.verdict - layout.foot;
  const scale = Math.max(40, Math.min(width / layout.widthM, room / (layout.topM + layout.sideM)));
  const sideTop = layout.sideM > 0 ? height - layout.foot - layout.sideM * scale : height;
  const radius = layout.headM * scale;
  const head = { x: width - layout.headRight - radius, y: layout.headTop + radius, radius };

  const ahead = Math.max(
    WHEEL_RADIUS - caster + 0.12,
    layout.protractorM - 0.4 * Math.max(0, caster - 0.1),
    LEAST_PROTRACTOR,
  );
  const tickRoom = 3 * layout.small;
  const rightEnd = layout.detailed ? head.x - radius : width;
  const farthest = rightEnd - tickRoom - ahead * scale;
  const nearest = (caster + WHEEL_RADIUS + 0.12) * scale;
  const axisX = Math.min(Math.max(layout.axisAt * width, nearest), farthest);

  return {
    width,
    height,
    scale,
    axis: { x: axisX, y: (layout.verdict + sideTop) / 2 },
    band: { top: layout.verdict, bottom: sideTop },
    hasTop: layout.topM > 0,
    side: layout.sideM > 0 ? { top: sideTop, ground: height - layout.foot } : null,
    protractor: ahead * scale,
    head,
    small: layout.small,
    label: layout.label,
    large: layout.large,
    line: layout.line,
    detailed: layout.detailed,
    roomy: layout.roomy,
    isCached: false,
  };
}

/**
 * How far behind the leading contact point the sheet still shows the ground [m].
 *
 * @param {Size} size
 * @param {Pick<Scene, 'layout' | 'parameters'>} scene
 */
export function trackLength(size, scene) {
  const sheet = sheetFor(size, scene);
  const { casterLength = 0, halfContactLength = 0 } = scene.parameters;
  // A wheel that trails farther than the sheet is wide leaves its track outside of it.
  return Math.max(0, sheet.axis.x / sheet.scale + halfContactLength - casterLength);
}
