import { drawAxes, frameOf } from './axes.js';
import { drawBoundary } from './boundary.js';
import { writeCornerReading } from './corner-reading.js';
import { drawHatch } from './hatch.js';
import { linear } from './scale.js';
import { drawMapLegend } from './map-legend.js';
import { drawIsoLines, drawMapNumbers, drawRegionWords } from './map-sheet.js';
import { parameterAxis } from './parameter-axis.js';
import { textFont, widthOfLabel, writeEdged } from './text.js';
import { drawVeil } from './veil.js';
import { boxOfWorkingPoint, drawGuides, drawWorkingPoint } from './working-point.js';

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
 *   coloring: import('./map-colors.js').Coloring, limits: import('./map-colors.js').Limits, point: { x: number, y: number }, readings: readonly string[], engaged?: string, veiled?: boolean,
 * }} Shown `image`: the map's colors, a pixel a cell; `point`: the gear's values; `readings`: what is read off, in fewer and fewer words; `engaged`: what to write at
 *   the edge where freeplay is 0, if that is an edge: on it alone the spring works;
 *   `veiled`: nothing of what is stable is to be seen yet
 */

/** What opens the gap. */
export const gapParameter = 'freeplayAngle';

/** Narrower than this, in widths of small type, an axis is called by its symbol alone. */
const narrow = 34;
/** Narrower than this, too, a picture has no room in its corner for what is read off, and none beside an axis' name for its legend. */
const narrowest = 26;
/** The legend then has a row of its own, in heights of small type. */
const legendRow = 1.6;

/** Whether what is read off is to be written beside the picture. @param {Size} size @param {Theme} theme */
export function isNarrowMap({ width }, theme) {
  return width < narrowest * theme.size;
}

/**
 * Where the map goes in its picture.
 * @param {Size} size
 * @param {Theme} theme
 * @returns {Box}
 */
export function frameOfMap(size, theme) {
  const frame = frameOf(size, theme, 'above');
  return isNarrowMap(size, theme) ? { ...frame, bottom: frame.bottom - legendRow * theme.size } : frame;
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
  const gear = { x: place.x(point.x), y: place.y(point.y) };
  if (veiled) {
    drawVeil(context, frame, theme);
    drawGuides(context, frame, gear, theme);
  } else {
    context.save();
    context.beginPath();
    context.rect(frame.left, frame.top, width, height);
    context.clip();
    if (sheet) drawIsoLines(context, sheet, theme);
    drawBoundary(context, boundary, place.x, place.y, theme);
    drawGuides(context, frame, gear, theme);
    // What is to be read stands on the guides.
    if (sheet) {
      drawMapNumbers(context, sheet, theme);
      drawRegionWords(context, sheet, boxOfWorkingPoint(gear.x, gear.y, theme), theme);
    }
    if (shown.engaged) markEngaged(context, frame, shown, shown.engaged, theme);
    context.restore();
    const beside = { left: frame.left, right: frame.right - widthOfLabel(context, x.name(false), theme, 600) - theme.size, middle: frame.bottom + theme.size * 2.35 };
    const beneath = { left: frame.left, right: size.width - 0.5 * theme.size, middle: beside.middle + legendRow * theme.size };
    drawMapLegend(context, isNarrowMap(size, theme) ? beneath : beside, shown, theme, voice);
  }
  drawWorkingPoint(context, frame, gear, theme);
  writeCornerReading(context, shown.readings, frame, width - widthOfLabel(context, y.name(isNarrow), theme, 600) - theme.size, theme);
}

/**
 * The edge on which the gap is closed, and what is so there.
 * @param {CanvasRenderingContext2D} context @param {Box} frame @param {Shown} shown @param {string} words @param {Theme} theme
 */
function markEngaged(context, { left, right, top, bottom }, { x }, words, theme) {
  const isUpright = x.parameter === gapParameter;
  const end = isUpright ? { x: left, y: top } : { x: right, y: bottom };
  context.strokeStyle = theme.freeplayText;
  context.lineWidth = 6 * theme.line;
  context.beginPath();
  context.moveTo(left, bottom);
  context.lineTo(end.x, end.y);
  context.stroke();
  context.font = textFont(theme, 0.95, 600);
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  context.fillStyle = theme.freeplayText;
  writeEdged(context, words, left + 0.7 * theme.size, isUpright ? top + theme.size : bottom - theme.size, theme);
}
