import { drawAxes, frameOf } from './axes.js';
import { drawBoundary } from './boundary.js';
import { writeCornerReading } from './corner-reading.js';
import { linear } from './scale.js';
import { drawMapLegend } from './map-legend.js';
import { drawHatch, drawIsoLines, drawRegionWords } from './map-sheet.js';
import { parameterAxis } from './parameter-axis.js';
import { widthOfLabel } from './text.js';
import { drawVeil } from './veil.js';
import { drawWorkingPoint } from './working-point.js';

/**
 * A plane of two parameters: where the gear is stable, how fast a swing grows or falls there, and where the gear is.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./canvas.js').Size} Size
 * @typedef {import('./map-sheet.js').MapSheet} MapSheet
 * @typedef {import('../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../run/linear-looks.js').Range} Range
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {Range & { quantity: Quantity }} Side
 * @typedef {{
 *   x: Side, y: Side, image: CanvasImageSource | null, sheet: MapSheet | null, boundary: readonly import('../run/linear-looks.js').BoundaryCurve[],
 *   coloring: import('./map-colors.js').Coloring, limits: import('./map-colors.js').Limits, point: { x: number, y: number }, readings: readonly string[], veiled?: boolean,
 * }} Shown `image`: the map's colors, a pixel a cell; `point`: the gear's values; `readings`: what is read off, in fewer and fewer words;
 *   `veiled`: nothing of what is stable is to be seen yet
 */

/** Narrower than this, in widths of small type, an axis is called by its symbol alone. */
const narrow = 34;

/**
 * Where the map goes in its picture.
 * @param {Size} size
 * @param {Theme} theme
 * @returns {Box}
 */
export function frameOfMap(size, theme) {
  return frameOf(size, theme, 'above');
}

/**
 * From values to px, and from px to values.
 * @param {Box} frame @param {Range} x @param {Range} y
 */
export function placesOfMap(frame, x, y) {
  return {
    x: linear([x.from, x.to], [frame.left, frame.right]),
    y: linear([y.from, y.to], [frame.bottom, frame.top]),
    valueX: linear([frame.left, frame.right], [x.from, x.to]),
    valueY: linear([frame.bottom, frame.top], [y.from, y.to]),
  };
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Size} size
 * @param {Shown} shown
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawStabilityMap(context, size, shown, theme, voice) {
  const { image, sheet, boundary, point, veiled = false } = shown;
  const frame = frameOfMap(size, theme);
  const [width, height] = [frame.right - frame.left, frame.bottom - frame.top];
  if (width < 20 || height < 20) return;
  const place = placesOfMap(frame, shown.x, shown.y);
  const x = parameterAxis(shown.x.quantity, [shown.x.from, shown.x.to], [frame.left, frame.right], Math.min(10, width / (theme.size * 4.2)), voice);
  const y = parameterAxis(shown.y.quantity, [shown.y.from, shown.y.to], [frame.bottom, frame.top], Math.min(6, height / (theme.size * 1.9)), voice);

  if (!veiled && image) context.drawImage(image, frame.left, frame.top, width, height);
  if (!veiled && sheet) drawHatch(context, sheet.hatch, theme);
  // The corner above the right end is for what is read off.
  const isNarrow = width < narrow * theme.size;
  drawAxes(context, frame, { ...x, name: () => x.name(widthOfLabel(context, x.name(false), theme, 600) > 0.5 * width) },
    { ...y, name: () => y.name(isNarrow) }, theme, { up: 'above' });
  if (veiled) drawVeil(context, frame, theme);
  else {
    context.save();
    context.beginPath();
    context.rect(frame.left, frame.top, width, height);
    context.clip();
    if (sheet) drawIsoLines(context, sheet, theme);
    drawBoundary(context, boundary, place.x, place.y, theme);
    if (sheet) drawRegionWords(context, sheet, theme);
    context.restore();
    const nameWidth = widthOfLabel(context, x.name(false), theme, 600);
    drawMapLegend(context, { left: frame.left, right: frame.right - nameWidth - theme.size, middle: frame.bottom + theme.size * 2.35 }, shown, theme, voice);
  }
  drawWorkingPoint(context, frame, { x: place.x(point.x), y: place.y(point.y) }, theme);
  writeCornerReading(context, shown.readings, frame, width - widthOfLabel(context, y.name(isNarrow), theme, 600) - theme.size, theme);
}
