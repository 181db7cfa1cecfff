/**
 * Where the gear stands along an axis: a dotted line.
 * @param {CanvasRenderingContext2D} context
 * @param {import('./axes.js').Box} frame
 * @param {number} x in px
 * @param {import('../style/theme.js').Theme} theme
 */
export function drawGuideAcross(context, { top, bottom }, x, theme) {
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.5 * theme.line;
  context.setLineDash([1.5 * theme.line, 4 * theme.line]);
  context.beginPath();
  context.moveTo(x, top);
  context.lineTo(x, bottom);
  context.stroke();
  context.setLineDash([]);
}
