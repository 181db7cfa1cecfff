/**
 * What of a map of swings depends on nothing but the map and its frame: lines of equal swing with their numbers, the curves at
 * which cycles are born or two of them meet, each with its name, and where two motions are possible, hatched and named. Made
 * once and drawn often.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./field.js').Field} Field
 * @typedef {import('./map-sheet.js').Word} Word
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../pkg/shimmy.js').FoldCurve} FoldCurve
 * @typedef {import('../run/linear-looks.js').BoundaryCurve} BoundaryCurve
 * @typedef {{ lines: { x: number[], y: number[] }[], numbers: Word[], hatch: Float32Array, names: Word[] }} SwingSheet in px
 * @typedef {{ curve: FoldCurve | BoundaryCurve, name: string }} Named
 */

import { hatchOf } from './hatch.js';
import { boxAround, isWithinFrame, numberedLines } from './map-sheet.js';
import { overlap } from './corner.js';
import { roomiest } from './roomiest.js';
import { textFont } from './text.js';

/** Where along a curve its name may stand, the best first. */
const places = [0.5, 0.6, 0.4, 0.7, 0.3, 0.8, 0.2, 0.9, 0.1];
export const nameScale = 0.95;

/**
 * @param {CanvasRenderingContext2D} context that knows how wide words are
 * @param {Box} frame
 * @param {Field} amplitudes
 * @param {{
 *   levels: readonly { value: number, text: string }[], curves: readonly Named[], x: (value: number) => number, y: (value: number) => number,
 *   hasTwo: (across: number, up: number) => boolean, two: readonly string[],
 * }} shown `levels`: which swings have a line; `two`: what is said where there are two motions, in fewer and fewer words
 * @param {Theme} theme
 * @returns {SwingSheet}
 */
export function swingSheetOf(context, frame, amplitudes, { levels, curves, x, y, hasTwo, two }, theme) {
  context.font = textFont(theme, nameScale, 600);
  const sizeOf = (/** @type {string} */ text) => ({ width: context.measureText(text).width + 0.5 * theme.size, height: 1.25 * theme.size });
  /** @type {Word[]} */
  const names = [];
  for (const text of two) {
    const size = sizeOf(text);
    const { two: place } = roomiest(frame, (across, up) => (hasTwo(across, up) ? 'two' : ''), { two: size });
    if (!place) continue;
    names.push({ text, box: boxAround(place.x, place.y, size), color: theme.ink });
    break;
  }
  for (const { curve, name } of curves) {
    const size = sizeOf(name);
    const inside = Array.from(curve.x, (value, i) => ({ x: x(value), y: y(curve.y[i]) })).filter((point) => point.x >= frame.left && point.x <= frame.right && point.y >= frame.top && point.y <= frame.bottom);
    const box = places.map((share) => inside[Math.round(share * (inside.length - 1))]).filter((point) => point !== undefined).map((point) => beside(point, size, frame))
      .find((one) => isWithinFrame(one, frame) && !names.some((other) => overlap(one, other.box)));
    if (box) names.push({ text: name, box, color: curve.kind === 'fold' ? theme.ink : theme.unstable });
  }
  // At a fold the swing jumps from nothing: no line of equal swing runs there.
  const swinging = { ...amplitudes, values: Array.from(amplitudes.values, (value) => value || NaN) };
  return { ...numberedLines(context, frame, swinging, levels, names, theme), hatch: leaning(hatchOf(frame, (across, up) => hasTwo(1 - across, up), theme), frame), names };
}

/** The other way than lines of what is unstable lean. @param {Float32Array} ends @param {Box} frame */
const leaning = (ends, { left, right }) => ends.map((value, i) => (i % 2 === 0 ? left + right - value : value));

/** On a curve, but off its end. @param {{ x: number, y: number }} point @param {{ width: number, height: number }} size @param {Box} frame @returns {Box} */
function beside({ x, y }, size, frame) {
  const within = (/** @type {number} */ value, /** @type {number} */ half, /** @type {number} */ from, /** @type {number} */ to) => Math.min(Math.max(value, from + half + 2), to - half - 2);
  return boxAround(within(x, size.width / 2, frame.left, frame.right), within(y, size.height / 2, frame.top, frame.bottom), size);
}
