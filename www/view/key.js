import { freeCorner } from './corner.js';
import { drawHollow } from './points.js';
import { inStyle } from './strokes.js';
import { textFont, writeEdged } from './text.js';
import { drawVeil } from './veil.js';

/**
 * What the lines of a plot are: a piece of each line and its name. On a wide plot they stand in corners that the curves
 * leave free, on a narrow one beside the name of its axis or in rows above.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./corner.js').Corner} Corner
 * @typedef {import('./curve.js').Curve} Curve
 * @typedef {import('./strokes.js').Style} Style
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {{ text: string, short?: string, style: Style | null }} Entry without text it takes no room; `short` where there is too
 *   little
 * @typedef {{ entry: Entry | 'veiled', color: string, weight?: number, isPoint?: boolean }} Key
 *   `veiled`: not to be read yet; `isPoint`: stands for hollow points, not for a line
 */

/** Plots narrower than this have no free corners, in widths of small type. */
const narrow = 30;
/** Rows of keys may take this share of a narrow plot; what does not fit is left unsaid. */
const mostOfFrame = 0.32;

/**
 * The frame with rows of keys above it where it is narrow, and what draws the keys once the curves are there.
 * @param {CanvasRenderingContext2D} context
 * @param {Box} frame
 * @param {(Key & { wishes: Corner[] })[]} keys `wishes`: their corners, the best first
 * @param {Theme} theme
 * @param {Box | null} [foot] room below a narrow plot for the first of them, which costs the curves none
 * @returns {{ frame: Box, draw: (taken: Box[], curves: Curve[]) => void }} `taken`: where other words stand already
 */
export function placeKeys(context, frame, keys, theme, foot = null) {
  const said = keys.filter(({ entry }) => entry === 'veiled' || entry.text !== '');
  if (frame.right - frame.left < narrow * theme.size) return keysAround(context, frame, said, theme, foot);
  const inset = theme.size * 0.4;
  const inner = { left: frame.left + inset, right: frame.right - inset, top: frame.top + 2, bottom: frame.bottom - 4 };
  const draw = (/** @type {Box[]} */ taken, /** @type {Curve[]} */ curves) => {
    const full = [...taken];
    for (const key of said) {
      const box = freeCorner(inner, sizeOf(context, key, theme), key.wishes, full, curves);
      full.push(box);
      drawKey(context, key, box, theme);
    }
  };
  return { frame, draw };
}

/**
 * @param {CanvasRenderingContext2D} context @param {Box} frame @param {Key[]} keys @param {Theme} theme @param {Box | null} foot
 * @returns {{ frame: Box, draw: () => void }}
 */
function keysAround(context, frame, keys, theme, foot) {
  const [first, ...rest] = keys;
  const width = first ? sizeOf(context, first, theme).width : Infinity;
  if (!foot || foot.left + width > foot.right) return keysAbove(context, frame, keys, theme);
  const above = keysAbove(context, frame, rest, theme);
  const draw = () => {
    drawKey(context, first, { ...foot, right: foot.left + width }, theme);
    above.draw();
  };
  return { frame: above.frame, draw };
}

/**
 * The frame below rows of keys, and what draws them.
 * @param {CanvasRenderingContext2D} context
 * @param {Box} frame
 * @param {Key[]} keys
 * @param {Theme} theme
 * @returns {{ frame: Box, draw: () => void }}
 */
export function keysAbove(context, frame, keys, theme) {
  const room = frame.top + mostOfFrame * (frame.bottom - frame.top);
  const shown = keys.map((key) => within(context, key, frame.right - frame.left, theme));
  const sizes = shown.map((key) => sizeOf(context, key, theme));
  const boxes = rowsOf(sizes, frame, theme).filter(({ bottom }) => bottom <= room);
  const lowest = boxes.at(-1);
  return {
    frame: lowest ? { ...frame, top: lowest.bottom + theme.size * 0.5 } : frame,
    draw: () => boxes.forEach((box, i) => drawKey(context, shown[i], box, theme)),
  };
}

/** A key in fewer words where there is not room for all. @param {CanvasRenderingContext2D} context @param {Key} key @param {number} room @param {Theme} theme @returns {Key} */
function within(context, key, room, theme) {
  if (key.entry === 'veiled' || key.entry.short === undefined || sizeOf(context, key, theme).width <= room) return key;
  return { ...key, entry: { ...key.entry, text: key.entry.short } };
}

/**
 * Boxes side by side, and below where a row is full.
 * @param {{ width: number, height: number }[]} sizes
 * @param {Box} area
 * @param {Theme} theme
 * @returns {Box[]}
 */
function rowsOf(sizes, { left, right, top }, theme) {
  let [x, y] = [left, top - theme.size * 0.45];
  return sizes.map(({ width, height }) => {
    if (x > left && x + width > right) [x, y] = [left, y + height];
    const box = { left: x, right: x + width, top: y, bottom: y + height };
    x += width + theme.size * 1.2;
    return box;
  });
}

/** @param {Key} key @param {Theme} theme */
const fontOf = ({ weight = 400 }, theme) => textFont(theme, 1, weight);

/** The piece of line before a name, and the room up to the name. @param {Theme} theme */
const sampleOf = ({ size }) => ({ length: 2 * size, room: 2.6 * size });

/** @param {CanvasRenderingContext2D} context @param {Key} key @param {Theme} theme */
function sizeOf(context, key, theme) {
  const height = 1.5 * theme.size;
  if (key.entry === 'veiled') return { width: 5 * theme.size, height };
  context.font = fontOf(key, theme);
  return { width: context.measureText(key.entry.text).width + (key.entry.style ? sampleOf(theme).room : 0), height };
}

/** @param {CanvasRenderingContext2D} context @param {Key} key @param {Box} box @param {Theme} theme */
function drawKey(context, key, box, theme) {
  if (key.entry === 'veiled') {
    drawVeil(context, box, theme);
    return;
  }
  const { text, style } = key.entry;
  const middle = (box.top + box.bottom) / 2;
  const { length, room } = sampleOf(theme);
  if (key.isPoint) {
    drawHollow(context, box.left + length / 2, middle, theme);
  } else if (style) {
    inStyle(context, theme, style, () => {
      context.beginPath();
      context.moveTo(box.left, middle);
      context.lineTo(box.left + length, middle);
      context.stroke();
    });
  }
  context.font = fontOf(key, theme);
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  context.fillStyle = key.color;
  writeEdged(context, text, box.left + (style ? room : 0), middle, theme);
}
