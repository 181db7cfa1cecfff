import { colorsOf, paintPixels } from '../../view/map-colors.js';

/**
 * A map's colors as a picture, a pixel a cell.
 * @param {import('../../view/map-sheet.js').StabilityMap} map
 * @param {{ coloring: import('../../view/map-colors.js').Coloring, limits: import('../../view/map-colors.js').Limits }} look
 * @param {import('../../style/theme.js').Theme} theme
 * @param {HTMLCanvasElement} canvas to be drawn on
 */
export function paintMapImage({ columns, rows, stable, growthRate, frequency }, { coloring, limits }, theme, canvas) {
  const context = canvas.getContext('2d');
  if (!context) return;
  if (canvas.width !== columns || canvas.height !== rows) Object.assign(canvas, { width: columns, height: rows });
  const values = (coloring === 'growthRate' ? growthRate : coloring === 'frequency' ? frequency : null) ?? stable;
  const pixels = context.createImageData(columns, rows);
  paintPixels({ values, columns, rows }, colorsOf(coloring, limits, theme), pixels.data);
  context.putImageData(pixels, 0, 0);
}
