/** An aircraft from above, nose to the right: a sign of where it is, many times as large as the runway's scale would have it. */

/** Its outline, half of it, as shares of its length from the nose wheel: along, aside. */
const fuselage = /** @type {const} */ ([[0.16, 0], [0.13, 0.028], [0.06, 0.047], [-0.05, 0.052], [-0.5, 0.052], [-0.66, 0.03], [-0.8, 0.008]]);
const wing = /** @type {const} */ ([[-0.2, 0.045], [-0.47, 0.44], [-0.55, 0.44], [-0.43, 0.045]]);
const tail = /** @type {const} */ ([[-0.66, 0.025], [-0.78, 0.17], [-0.84, 0.17], [-0.79, 0.01]]);
const engine = /** @type {const} */ ([[-0.2, 0.14], [-0.2, 0.18], [-0.32, 0.18], [-0.32, 0.14]]);

/**
 * @param {CanvasRenderingContext2D} context
 * @param {{ x: number, y: number, length: number }} place of its nose wheel, in px
 * @param {import('../style/theme.js').Theme} theme
 */
export function drawAircraft(context, { x, y, length }, theme) {
  context.lineJoin = 'round';
  context.lineWidth = 1.3 * theme.line;
  context.strokeStyle = theme.ink;
  context.fillStyle = theme.surface;
  const shape = (/** @type {readonly (readonly [number, number])[]} */ corners, /** @type {1 | -1} */ side) => corners.map(([along, aside]) => [x + along * length, y + side * aside * length]);
  const outlines = [
    ...([1, -1]).flatMap((side) => [shape(engine, /** @type {1 | -1} */ (side)), shape(wing, /** @type {1 | -1} */ (side)), shape(tail, /** @type {1 | -1} */ (side))]),
    [...shape(fuselage, 1), ...shape(fuselage, -1).reverse()],
  ];
  for (const outline of outlines) {
    context.beginPath();
    outline.forEach(([across, down], i) => context[i ? 'lineTo' : 'moveTo'](across, down));
    context.closePath();
    context.fill();
    context.stroke();
  }
  // The nose wheel, which this page is about.
  context.fillStyle = theme.psi;
  context.beginPath();
  context.arc(x, y, 2.6 * Math.sqrt(theme.line), 0, 2 * Math.PI);
  context.fill();
}
