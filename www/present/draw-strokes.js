import { dotsOf } from './stroke.js';

/**
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('./ink.js').Stroke} Stroke
 * @typedef {import('./stroke.js').Dot} Dot
 */

/** A rim in the paper's color, so that ink is read on a dark tire too, in px. */
const rim = 1.5;

/**
 * What a pen drew on a view.
 * @param {CanvasRenderingContext2D} context
 * @param {import('../view/canvas.js').Size} size of the view
 * @param {readonly Stroke[]} strokes
 * @param {Pick<Theme, 'ink' | 'surface' | 'line'>} theme
 */
export function drawStrokes(context, size, strokes, { ink, surface, line }) {
  for (const { points, strength } of strokes) {
    const dots = dotsOf(points, size, line);
    context.globalAlpha = strength;
    fill(context, dots, rim * line, surface);
    fill(context, dots, 0, ink);
  }
  context.globalAlpha = 1;
}

/**
 * All dots and what lies between them as one area, so that a stroke that fades shows no seams. Circles and pieces go
 * round the same way: where they overlap they add up.
 * @param {CanvasRenderingContext2D} context @param {Dot[]} dots @param {number} wider in px @param {string} color
 */
function fill(context, dots, wider, color) {
  context.fillStyle = color;
  context.beginPath();
  dots.forEach((dot, i) => {
    const radius = dot.radius + wider;
    context.moveTo(dot.x + radius, dot.y);
    context.arc(dot.x, dot.y, radius, 0, 2 * Math.PI);
    context.closePath();
    const last = dots[i - 1];
    if (last) addPiece(context, last, dot, wider);
  });
  context.fill();
}

/** @param {CanvasRenderingContext2D} context @param {Dot} from @param {Dot} to @param {number} wider */
function addPiece(context, from, to, wider) {
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  if (length === 0) return;
  const [x, y] = [(from.y - to.y) / length, (to.x - from.x) / length];
  const [one, other] = [from.radius + wider, to.radius + wider];
  context.moveTo(from.x + x * one, from.y + y * one);
  context.lineTo(from.x - x * one, from.y - y * one);
  context.lineTo(to.x - x * other, to.y - y * other);
  context.lineTo(to.x + x * other, to.y + y * other);
  context.closePath();
}
