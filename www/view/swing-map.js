import { drawAxes, frameOf } from './axes.js';
import { writeCornerReading } from './corner-reading.js';
import { colorsOfSwings, written } from './map-colors.js';
import { drawBoundary } from './boundary.js';
import { drawHatch } from './hatch.js';
import { drawIsoLines, drawMapNumbers, writeWords } from './map-sheet.js';
import { parameterAxis } from './parameter-axis.js';
import { linear } from './scale.js';
import { nameScale } from './swing-sheet.js';
import { textFont, widthOfLabel } from './text.js';
import { drawVeil } from './veil.js';
import { drawGuides, drawWorkingPoint } from './working-point.js';

/**
 * A plane of two values of the gear, colored by how widely it swings there in the end, with the curves at which cycles are
 * born (Hopf) and at which two of them meet (folds), what lies between hatched where two motions are possible, and with the
 * gear as a point in it.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./canvas.js').Size} Size
 * @typedef {import('../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../run/linear-looks.js').Range} Range
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{
 *   x: Range & { quantity: Quantity }, y: Range & { quantity: Quantity }, image: CanvasImageSource | null, isOld: boolean,
 *   sheet: import('./swing-sheet.js').SwingSheet | null, curves: readonly (import('./boundary.js').BoundaryCurve | import('./boundary.js').FoldCurve)[], limit: number, point: { x: number, y: number }, readings: readonly string[], veiled: boolean,
 * }} Shown `image`: the colors, a pixel a cell; `limit`: the widest swing that colors tell apart, in rad; `readings`: in fewer and fewer words
 */

/** Narrower than this, in widths of small type, an axis is called by its symbol alone. */
const narrow = 34;
const pieces = 40;

/** Where values stand, and what values stand where. @param {Size} size @param {Theme} theme @param {Range} x @param {Range} y */
export function placesOfSwingMap(size, theme, x, y) {
  const frame = frameOf(size, theme, 'above');
  return {
    frame,
    x: linear([x.from, x.to], [frame.left, frame.right]), y: linear([y.from, y.to], [frame.bottom, frame.top]),
    valueX: linear([frame.left, frame.right], [x.from, x.to]), valueY: linear([frame.bottom, frame.top], [y.from, y.to]),
  };
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Size} size
 * @param {Shown} shown
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawSwingMap(context, size, { x: across, y: up, image, isOld, sheet, curves, limit, point, readings, veiled }, theme, voice) {
  const { frame, x: placeX, y: placeY } = placesOfSwingMap(size, theme, across, up);
  const [width, height] = [frame.right - frame.left, frame.bottom - frame.top];
  if (width < 20 || height < 20) return;
  const x = parameterAxis(across.quantity, [across.from, across.to], [frame.left, frame.right], Math.min(10, width / (theme.size * 4.2)), voice);
  const y = parameterAxis(up.quantity, [up.from, up.to], [frame.bottom, frame.top], Math.min(6, height / (theme.size * 1.9)), voice);
  if (!veiled && image) {
    context.globalAlpha = isOld ? 0.45 : 1;
    context.imageSmoothingEnabled = true;
    context.drawImage(image, frame.left, frame.top, width, height);
    context.globalAlpha = 1;
  }
  const isNarrow = width < narrow * theme.size;
  drawAxes(context, frame, { ...x, name: () => x.name(widthOfLabel(context, x.name(false), theme, 600) > 0.5 * width) }, { ...y, name: () => y.name(isNarrow) }, theme, { up: 'above' });
  const gear = { x: placeX(point.x), y: placeY(point.y) };
  if (veiled) drawVeil(context, frame, theme);
  else {
    if (sheet && !isOld) {
      drawHatch(context, sheet.hatch, theme, theme.ink);
      drawIsoLines(context, sheet, theme);
    }
    context.globalAlpha = 1;
    drawBoundary(context, curves, placeX, placeY, theme);
    if (sheet && !isOld) {
      drawMapNumbers(context, sheet, theme);
      writeWords(context, sheet.names, textFont(theme, nameScale, 600), theme);
    }
  }
  drawGuides(context, frame, gear, theme);
  drawWorkingPoint(context, frame, gear, theme);
  if (!veiled) drawLegend(context, { left: frame.left, right: frame.right - widthOfLabel(context, x.name(false), theme, 600) - theme.size, middle: frame.bottom + theme.size * 2.35 }, limit, theme, voice);
  writeCornerReading(context, readings, frame, width - widthOfLabel(context, y.name(isNarrow), theme, 600) - theme.size, theme);
}

/** What the colors mean. @param {CanvasRenderingContext2D} context @param {{ left: number, right: number, middle: number }} place @param {number} limit @param {Theme} theme @param {Voice} voice */
function drawLegend(context, { left, right, middle }, limit, theme, voice) {
  const { size } = theme;
  const colorOf = colorsOfSwings(limit, theme);
  const [top, tall] = [middle - 0.45 * size, 0.9 * size];
  context.font = textFont(theme, 0.95);
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  const [least, most] = [`${voice.number(0, 0)}°`, `±${voice.number((limit * 180) / Math.PI, 0)}°`];
  const [before, after] = [least, most].map((text) => context.measureText(text).width);
  const width = Math.min(9 * size, right - left - before - after - size);
  if (width < 3 * size) return;
  const start = left + before + 0.5 * size;
  for (let i = 0; i < pieces; i++) {
    context.fillStyle = written(colorOf((((i + 0.5) / pieces) ** 2) * limit));
    context.fillRect(start + (i / pieces) * width, top, width / pieces + (i < pieces - 1 ? 0.5 : 0), tall);
  }
  context.strokeStyle = theme.ghost;
  context.lineWidth = 1;
  context.strokeRect(start, top, width, tall);
  context.fillStyle = theme.ink2;
  context.fillText(least, left, middle);
  context.fillText(most, start + width + 0.5 * size, middle);
}
