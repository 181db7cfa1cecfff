import { hatchOf } from './hatch.js';
import { cellAt, valueIn } from './field.js';
import { isoLinesOf } from './iso-lines.js';
import { overlap } from './corner.js';
import { roomiest } from './roomiest.js';
import { tickDecimals, ticks } from './scale.js';
import { textFont } from './text.js';

/**
 * What of a stability map depends on nothing but the map and its frame: hatch, lines of equal value with their numbers, a
 * word in each region. Made once and drawn often.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./map-colors.js').Coloring} Coloring
 * @typedef {import('./map-colors.js').Limits} Limits
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {'stable' | 'hopf' | 'divergence'} Region
 * @typedef {{
 *   columns: number, rows: number, stable: Uint8Array, growthRate: Float64Array | null, frequency: Float64Array | null, kind: Uint8Array | null,
 * }} StabilityMap row by row from the lowest; `kind`: of the leading root, as the engine numbers them
 * @typedef {{ text: string, box: Box, color: string, elsewhere?: Box }} Word `text`: its lines; `elsewhere`: where it goes while
 *   something else stands in its box
 * @typedef {{
 *   hatch: Float32Array, lines: { x: number[], y: number[] }[], numbers: Word[], words: Word[],
 * }} MapSheet in px
 */

/** The number of a leading root that does not swing. */
const divergent = 0;
const wordScale = 1.3;
/** Where along a line its number may stand, the best first. */
const numberPlaces = [0.5, 0.35, 0.65, 0.2, 0.8, 0.08, 0.92];

/**
 * @param {CanvasRenderingContext2D} context that knows how wide words are
 * @param {Box} frame
 * @param {StabilityMap} map
 * @param {{ coloring: Coloring, limits: Limits, words: Readonly<Record<Region, string>> }} look
 * @param {Theme} theme
 * @param {Voice} voice
 * @returns {MapSheet}
 */
export function sheetOf(context, frame, map, { coloring, limits, words }, theme, voice) {
  const { columns, rows, growthRate } = map;
  const field = (/** @type {ArrayLike<number>} */ values) => ({ values, columns, rows });
  const stable = field(map.stable);
  const rates = growthRate && field(growthRate);
  const isUnstable = rates
    ? (/** @type {number} */ across, /** @type {number} */ up) => valueIn(rates, across, up) > 0
    : (/** @type {number} */ across, /** @type {number} */ up) => !cellAt(stable, across, up);
  const regionAt = (/** @type {number} */ across, /** @type {number} */ up) => {
    if (cellAt(stable, across, up)) return 'stable';
    const cell = Math.min(Math.floor(up * rows), rows - 1) * columns + Math.min(Math.floor(across * columns), columns - 1);
    return map.kind?.[cell] === divergent ? 'divergence' : 'hopf';
  };

  context.font = textFont(theme, wordScale, 700);
  const placed = placeWords(context, frame, regionAt, words, theme);

  // Where nothing swings there is no frequency, not one of 0 with all others between.
  const values = coloring === 'growthRate' ? growthRate : coloring === 'frequency' ? map.frequency?.map((one) => one || NaN) ?? null : null;
  const levels = values ? levelsOf(coloring, limits) : [];
  const decimals = tickDecimals(levels);
  const write = (/** @type {number} */ level) => (level > 0 && coloring === 'growthRate' ? '+' : '') + voice.number(level, decimals);
  const { lines, numbers } = values ? numberedLines(context, frame, thinned(field(values)), levels.map((value) => ({ value, text: write(value) })), placed, theme) : { lines: [], numbers: [] };
  return { hatch: hatchOf(frame, isUnstable, theme), lines, numbers, words: placed };
}

/**
 * Lines of equal value, and on each where there is room its number.
 * @param {CanvasRenderingContext2D} context that knows how wide words are
 * @param {Box} frame
 * @param {import('./field.js').Field} field
 * @param {readonly { value: number, text: string }[]} levels ascending
 * @param {readonly Word[]} placed where words stand already
 * @param {Theme} theme
 * @returns {Pick<MapSheet, 'lines' | 'numbers'>}
 */
export function numberedLines(context, frame, field, levels, placed, theme) {
  /** @type {Pick<MapSheet, 'lines' | 'numbers'>} */
  const sheet = { lines: [], numbers: [] };
  context.font = textFont(theme, 0.85);
  isoLinesOf(field, levels.map(({ value }) => value)).forEach((places, i) => {
    const lines = places.map(({ across, up }) => ({
      x: across.map((share) => frame.left + share * (frame.right - frame.left)),
      y: up.map((share) => frame.bottom - share * (frame.bottom - frame.top)),
    }));
    sheet.lines.push(...lines);
    const { text } = levels[i];
    const size = { width: context.measureText(text).width + 6, height: theme.size * 1.2 };
    const longest = lines.reduce((most, line) => (line.x.length > most.x.length ? line : most), { x: /** @type {number[]} */ ([]), y: /** @type {number[]} */ ([]) });
    const box = numberPlaces.map((share) => boxOn(longest, share, size)).find((one) => one && isWithinFrame(one, frame)
      && ![...placed, ...sheet.numbers].some((other) => overlap(one, other.box)));
    if (box) sheet.numbers.push({ text, box, color: theme.ink2 });
  });
  return sheet;
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Pick<MapSheet, 'lines'>} sheet
 * @param {Theme} theme
 */
export function drawIsoLines(context, { lines }, theme) {
  context.strokeStyle = theme.ink2;
  context.lineWidth = 0.9 * theme.line;
  context.globalAlpha = 0.75;
  context.beginPath();
  for (const { x, y } of lines) for (let i = 0; i < x.length; i++) context[i === 0 ? 'moveTo' : 'lineTo'](x[i], y[i]);
  context.stroke();
  context.globalAlpha = 1;
}

/** The numbers of those lines. @param {CanvasRenderingContext2D} context @param {Pick<MapSheet, 'numbers'>} sheet @param {Theme} theme */
export function drawMapNumbers(context, { numbers }, theme) {
  writeWords(context, numbers, textFont(theme, 0.85), theme);
}

/** Words of the regions, none under what stands in `taken`. @param {CanvasRenderingContext2D} context @param {MapSheet} sheet @param {Box} taken @param {Theme} theme */
export function drawRegionWords(context, { words }, taken, theme) {
  const free = words.map((word) => (word.elsewhere && overlap(word.box, taken) ? { ...word, box: word.elsewhere } : word));
  writeWords(context, free, textFont(theme, wordScale, 700), theme);
}

/**
 * A word in each region that has room for it, on as few lines as it can.
 * @param {CanvasRenderingContext2D} context with the font set
 * @param {Box} frame
 * @param {(across: number, up: number) => string} regionAt
 * @param {Readonly<Record<Region, string>>} words
 * @param {Theme} theme
 * @returns {Word[]}
 */
function placeWords(context, frame, regionAt, words, theme) {
  const sizeOf = (/** @type {string} */ text) => {
    const lines = text.split('\n');
    return { width: Math.max(...lines.map((line) => context.measureText(line).width)) + theme.size, height: theme.size * wordScale * (0.3 + 1.2 * lines.length) };
  };
  return /** @type {Region[]} */ (Object.keys(words)).flatMap((region) => {
    for (const text of brokenIn(words[region])) {
      const size = sizeOf(text);
      const place = (/** @type {typeof regionAt} */ where) => roomiest(frame, where, { [region]: size })[region];
      const first = place(regionAt);
      if (!first) continue;
      const box = boxAround(first.x, first.y, size);
      const second = place((across, up) => (holds(box, frame, across, up) ? '' : regionAt(across, up)));
      return [{ text, box, color: region === 'stable' ? theme.stable : theme.unstable, ...(second && { elsewhere: boxAround(second.x, second.y, size) }) }];
    }
    return [];
  });
}

/** A phrase on more and more lines: it is broken after a colon, then after a comma. @param {string} phrase */
function brokenIn(phrase) {
  const two = phrase.replaceAll(': ', ':\n');
  return [...new Set([phrase, two, two.replaceAll(', ', ',\n')])];
}

/** @param {Box} box @param {Box} frame @param {number} across @param {number} up shares of the frame */
function holds(box, frame, across, up) {
  const [x, y] = [frame.left + across * (frame.right - frame.left), frame.bottom - up * (frame.bottom - frame.top)];
  return x >= box.left && x <= box.right && y >= box.top && y <= box.bottom;
}

/** @param {CanvasRenderingContext2D} context @param {readonly Word[]} words @param {string} font @param {Theme} theme */
export function writeWords(context, words, font, theme) {
  context.font = font;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.lineJoin = 'round';
  context.lineWidth = 4;
  context.strokeStyle = theme.surface;
  const lines = words.flatMap(({ text, box, color }) => {
    const written = text.split('\n');
    const step = (box.bottom - box.top) / (written.length + 0.25);
    return written.map((line, i) => ({ line, color, x: (box.left + box.right) / 2, y: (box.top + box.bottom) / 2 + (i - (written.length - 1) / 2) * step }));
  });
  for (const { line, x, y } of lines) context.strokeText(line, x, y);
  for (const { line, color, x, y } of lines) {
    context.fillStyle = color;
    context.fillText(line, x, y);
  }
}

/** Round values of which lines are drawn; the boundary itself is drawn from another source. @param {Coloring} coloring @param {Limits} limits */
function levelsOf(coloring, { growthRate, frequency }) {
  if (coloring === 'growthRate') return ticks(-growthRate, growthRate, 9).filter((level) => level !== 0);
  return ticks(frequency[0], frequency[1], 7);
}

/** Every other value of a fine field: lines need no more. @param {import('./field.js').Field} field @returns {import('./field.js').Field} */
function thinned(field) {
  if (field.columns < 300) return field;
  const [columns, rows] = [Math.floor(field.columns / 2), Math.floor(field.rows / 2)];
  const values = new Float64Array(columns * rows);
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const at = 2 * row * field.columns + 2 * column;
      // The middle of four is where the middle of the larger cell is.
      values[row * columns + column] = (field.values[at] + field.values[at + 1] + field.values[at + field.columns] + field.values[at + field.columns + 1]) / 4;
    }
  }
  return { values, columns, rows };
}

/** @param {{ x: number[], y: number[] }} line @param {number} share @param {{ width: number, height: number }} size @returns {Box | null} */
function boxOn({ x, y }, share, size) {
  if (x.length < 2) return null;
  const at = Math.round(share * (x.length - 1));
  return boxAround(x[at], y[at], size);
}

/** @param {number} x @param {number} y @param {{ width: number, height: number }} size @returns {Box} */
export function boxAround(x, y, { width, height }) {
  return { left: x - width / 2, right: x + width / 2, top: y - height / 2, bottom: y + height / 2 };
}

/** @param {Box} box @param {Box} frame */
export function isWithinFrame(box, frame) {
  return box.left >= frame.left && box.right <= frame.right && box.top >= frame.top && box.bottom <= frame.bottom;
}
