import { drawComplexPlane, imaginaryName } from './complex-plane.js';
import { writeCornerReading } from './corner-reading.js';
import { textFont, widthOfLabel, writeEdged } from './text.js';
import { drawVeil } from './veil.js';

/**
 * The roots of the gear as crosses in the complex plane, with the way that they have come and the place where a pair has
 * crossed the axis.
 *
 * @typedef {import('./complex-plane.js').Limits} Limits
 * @typedef {import('./complex-plane.js').Places} Places
 * @typedef {import('./root-paths.js').Root} Root
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{
 *   roots: readonly Root[], trail: readonly (readonly Root[])[], crossing: { at: Root, text: string } | null,
 *   readings: readonly string[], limits: Limits, veiled?: boolean,
 * }} Shown `trail`: each root's way, the oldest first; `readings`: of the pair, in fewer and fewer words
 */

/** Half of a cross, in px. */
const arm = 5;

/**
 * @param {CanvasRenderingContext2D} context
 * @param {import('./canvas.js').Size} size
 * @param {Shown} shown
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawRoots(context, size, { roots, trail, crossing, readings, limits, veiled = false }, theme, voice) {
  const places = drawComplexPlane(context, size, limits, theme, voice, { veiled });
  const { frame, x, y } = places;
  if (veiled) {
    drawVeil(context, frame, theme);
    return;
  }
  context.save();
  context.beginPath();
  context.rect(frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top + arm);
  context.clip();
  for (const path of trail) drawPath(context, path, places, theme);
  context.restore();
  if (crossing) markCrossing(context, crossing, places, theme);
  for (const root of roots) {
    if (root.im < 0) continue;
    if (root.re < limits.left || root.re > limits.right || root.im > limits.top) markBeyond(context, root, places, theme, voice);
    else drawCross(context, x(root.re), y(root.im), root.re > 0 ? theme.unstable : theme.stable, theme);
  }
  const name = widthOfLabel(context, imaginaryName, theme, 600);
  writeCornerReading(context, readings, frame, frame.right - frame.left - name - theme.size, theme);
}

/** A cross, as poles are drawn. @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {string} color @param {Theme} theme */
export function drawCross(context, x, y, color, theme) {
  const half = arm * Math.sqrt(theme.line);
  for (const [style, width] of /** @type {const} */ ([[theme.surface, 6], [color, 2.6]])) {
    context.strokeStyle = style;
    context.lineWidth = width * theme.line;
    context.lineCap = 'round';
    context.beginPath();
    context.moveTo(x - half, y - half);
    context.lineTo(x + half, y + half);
    context.moveTo(x - half, y + half);
    context.lineTo(x + half, y - half);
    context.stroke();
  }
  context.lineCap = 'butt';
}

/** The way of a root, fading into the past. @param {CanvasRenderingContext2D} context @param {readonly Root[]} path @param {Places} places @param {Theme} theme */
function drawPath(context, path, { x, y }, theme) {
  context.lineWidth = 2 * theme.line;
  for (let i = 1; i < path.length; i++) {
    if (path[i].im < 0 && path[i - 1].im < 0) continue;
    context.strokeStyle = path[i].re > 0 ? theme.unstable : theme.stable;
    context.globalAlpha = 0.15 + (0.75 * i) / path.length;
    context.beginPath();
    context.moveTo(x(path[i - 1].re), y(path[i - 1].im));
    context.lineTo(x(path[i].re), y(path[i].im));
    context.stroke();
  }
  context.globalAlpha = 1;
}

/** @param {CanvasRenderingContext2D} context @param {NonNullable<Shown['crossing']>} crossing @param {Places} places @param {Theme} theme */
function markCrossing(context, { at, text }, { frame, x, y }, theme) {
  const [across, up] = [x(0), Math.min(Math.max(y(at.im), frame.top), frame.bottom)];
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.5 * theme.line;
  context.beginPath();
  context.arc(across, up, 8 * Math.sqrt(theme.line), 0, 2 * Math.PI);
  context.stroke();
  context.font = textFont(theme, 1, 600);
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  context.fillStyle = theme.ink;
  // The numbers of the rays stand along the upper edge.
  const below = Math.min(Math.max(up + 1.4 * theme.size, frame.top + 2.4 * theme.size), frame.bottom - 0.8 * theme.size);
  writeEdged(context, text, across - theme.size, below, theme);
}

/** A root that the picture does not reach: at the edge, with its real part. @param {CanvasRenderingContext2D} context @param {Root} root @param {Places} places @param {Theme} theme @param {Voice} voice */
function markBeyond(context, root, { frame, x, y }, theme, voice) {
  const isLeft = x(root.re) < frame.left;
  const across = Math.min(Math.max(x(root.re), frame.left), frame.right);
  const up = Math.min(Math.max(y(root.im), frame.top), frame.bottom);
  const size = 6 * Math.sqrt(theme.line);
  context.fillStyle = root.re > 0 ? theme.unstable : theme.stable;
  context.beginPath();
  const side = isLeft ? 1 : -1;
  context.moveTo(across, up);
  context.lineTo(across + side * size * 1.4, up - size * 0.8);
  context.lineTo(across + side * size * 1.4, up + size * 0.8);
  context.closePath();
  context.fill();
  context.font = textFont(theme, 0.85);
  context.textAlign = isLeft ? 'left' : 'right';
  context.textBaseline = 'middle';
  writeEdged(context, voice.number(root.re, 0), across + side * (size * 1.4 + 4), up - theme.size * 0.55, theme, 3);
}
