/**
 * Arrow heads and shafts.
 *
 * @module
 */

/**
 * A filled head with its tip at (x, y).
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {number} x
 * @param {number} y
 * @param {number} direction [rad], clockwise on the canvas from its x axis
 * @param {number} length [px]
 */
export function fillHead(ctx, x, y, direction, length) {
  const cos = Math.cos(direction);
  const sin = Math.sin(direction);
  const half = 0.42 * length;
  ctx.beginPath();
  ctx.moveTo(x, y);
  ctx.lineTo(x - length * cos + half * sin, y - length * sin - half * cos);
  ctx.lineTo(x - length * cos - half * sin, y - length * sin + half * cos);
  ctx.closePath();
  ctx.fill();
}

/**
 * A straight arrow on a halo.
 *
 * @param {CanvasRenderingContext2D} ctx
 * @param {{x: number, y: number}} from
 * @param {{x: number, y: number}} to
 * @param {{color: string, halo: string | null, width: number, head: number}} style
 */
export function drawArrow(ctx, from, to, style) {
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  if (length === 0) return;
  const direction = Math.atan2(to.y - from.y, to.x - from.x);
  const head = Math.min(style.head, length);
  const neckX = to.x - 0.8 * head * Math.cos(direction);
  const neckY = to.y - 0.8 * head * Math.sin(direction);
  const shaft = () => {
    ctx.beginPath();
    ctx.moveTo(from.x, from.y);
    ctx.lineTo(neckX, neckY);
    ctx.stroke();
  };
  if (style.halo) {
    ctx.strokeStyle = style.halo;
    ctx.fillStyle = style.halo;
    ctx.lineJoin = 'round';
    ctx.lineWidth = style.width + 4;
    shaft();
    ctx.lineWidth = 4;
    fillHead(ctx, to.x, to.y, direction, head);
    ctx.stroke();
  }
  ctx.strokeStyle = style.color;
  ctx.fillStyle = style.color;
  ctx.lineWidth = style.width;
  shaft();
  fillHead(ctx, to.x, to.y, direction, head);
}
