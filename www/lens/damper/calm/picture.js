import { isSameList } from '../../../store.js';
import { cellAt } from '../../../view/field.js';
import { colorsOfSwings, paintPixels } from '../../../view/map-colors.js';
import { boxAround, numberedLines } from '../../../view/map-sheet.js';
import { roomiest } from '../../../view/roomiest.js';
import { nameScale } from '../../../view/swing-sheet.js';
import { textFont } from '../../../view/text.js';

/**
 * The map of swings as a picture with the edge of what is calm, made anew only where something has changed.
 *
 * @typedef {import('../../../pkg/shimmy.js').Basins} Basins
 * @typedef {import('../../../style/theme.js').Theme} Theme
 * @typedef {{ columns: number, rows: number, limit: number, frame: import('../../../view/axes.js').Box, isWhole: boolean, calm: string }} Layout `calm`: what is written where it is calm
 */

/** A cell that is not known yet. */
const unknown = 255;
const degree = Math.PI / 180;
/** Swings that live are wider: where this one lies is the edge of what is calm, a line without a number. */
const edge = 0.3 * degree;
/** Lines of equal swing, in degrees. */
const levels = [1, 2, 5, 10, 12, 14, 16, 18, 20, 25];

export class CalmPicture {
  #image = document.createElement('canvas');
  /** @type {unknown[]} */ #imageOf = [];
  /** @type {import('../../../view/swing-sheet.js').SwingSheet | null} */ #sheet = null;
  /** @type {unknown[]} */ #sheetOf = [];

  /** @param {CanvasRenderingContext2D} context @param {Basins} basins @param {Layout} layout @param {Theme} theme */
  of(context, basins, { columns, rows, limit, frame, isWhole, calm }, theme) {
    if (!isSameList([basins, theme, limit], this.#imageOf)) {
      this.#imageOf = [basins, theme, limit];
      const on = this.#image.getContext('2d');
      if (!on) return null;
      Object.assign(this.#image, { width: columns, height: rows });
      const pixels = on.createImageData(columns, rows);
      paintPixels({ values: basins.amplitude, columns, rows }, colorsOfSwings(limit, theme), pixels.data);
      basins.kind.forEach((kind, cell) => {
        if (kind === unknown) pixels.data[4 * ((rows - 1 - Math.floor(cell / columns)) * columns + (cell % columns)) + 3] = 0;
      });
      on.putImageData(pixels, 0, 0);
    }
    const laid = [basins, theme, isWhole, calm, ...Object.values(frame)];
    if (!isSameList(laid, this.#sheetOf)) {
      this.#sheetOf = laid;
      this.#sheet = isWhole ? sheetOf(context, frame, { values: basins.amplitude.map((value) => Math.min(value, 1)), columns, rows }, calm, theme) : null;
    }
    return { image: this.#image, sheet: this.#sheet };
  }
}

/** @param {CanvasRenderingContext2D} context @param {import('../../../view/axes.js').Box} frame @param {import('../../../view/field.js').Field} field @param {string} calm @param {Theme} theme @returns {import('../../../view/swing-sheet.js').SwingSheet} */
function sheetOf(context, frame, field, calm, theme) {
  context.font = textFont(theme, nameScale, 600);
  const size = { width: context.measureText(calm).width + 0.5 * theme.size, height: 1.25 * theme.size };
  const { calm: place } = roomiest(frame, (across, up) => (cellAt(field, across, up) === 0 ? 'calm' : ''), { calm: size });
  const names = place ? [{ text: calm, box: boxAround(place.x, place.y, size), color: theme.ink }] : [];
  const border = numberedLines(context, frame, field, [{ value: edge, text: '' }], [], theme).lines;
  // At the edge the swing jumps from nothing: no line of equal swing runs there.
  const swinging = { ...field, values: Array.from(field.values, (value) => value || NaN) };
  const within = numberedLines(context, frame, swinging, levels.map((level) => ({ value: level * degree, text: `${level}°` })), names, theme);
  return { lines: [...border, ...within.lines], numbers: within.numbers, hatch: new Float32Array(), names };
}

/** How widely it swings in the end at a place, 0 … 1 across and up, in rad; null where that is not known yet. @param {Basins} basins @param {number} columns @param {number} rows @param {number} across @param {number} up */
export function amplitudeAt({ kind, amplitude }, columns, rows, across, up) {
  return cellAt({ values: kind, columns, rows }, across, up) === unknown ? null : cellAt({ values: amplitude, columns, rows }, across, up);
}
