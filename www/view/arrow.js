/**
 * An arrow on a plot, in the style in force.
 *
 * @typedef {{ x: number, y: number }} Point in px
 * @param {CanvasRenderingContext2D} context
 * @param {Point} from
 * @param {Point} to
 * @param {import('../style/theme.js').Theme} theme
 * @param {{ headOnly?: boolean }} [options]
 */
export function drawArrow(context, from, to, theme, { headOnly = false } = {}) {
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  if (!(length > 0)) return;
  const [across, down] = [(to.x - from.x) / length, (to.y - from.y) / length];
  const head = Math.min(headOnly ? Infinity : length, 9 * Math.sqrt(theme.line));
  const neck = { x: to.x - head * across, y: to.y - head * down };
  if (!headOnly) {
    context.beginPath();
    context.moveTo(from.x, from.y);
    context.lineTo(neck.x, neck.y);
    context.stroke();
  }
  context.setLineDash([]);
  context.beginPath();
  context.moveTo(to.x, to.y);
  context.lineTo(neck.x - 0.45 * head * down, neck.y + 0.45 * head * across);
  context.lineTo(neck.x + 0.45 * head * down, neck.y - 0.45 * head * across);
  context.closePath();
  context.fill();
}
