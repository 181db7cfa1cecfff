import { drawComplexPlane } from './complex-plane.js';
import { drawCross } from './roots.js';
import { colorsOf, written } from './map-colors.js';
import { textFont } from './text.js';
import { drawVeil } from './veil.js';

/**
 * The ways of the roots as a parameter is swept, the paler the less of it, for one or some values of another.
 *
 * @typedef {import('./complex-plane.js').Limits} Limits
 * @typedef {import('./complex-plane.js').Places} Places
 * @typedef {import('./root-paths.js').Root} Root
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{ label: string, paths: readonly (readonly Root[])[] }} Way `label`: which value of the other it is for, '' for none
 * @typedef {{
 *   ways: readonly Way[], roots: readonly Root[], limits: Limits, sweep: { symbol: string, from: string, to: string }, veiled?: boolean,
 * }} Shown `roots`: of the gear as it is; `sweep`: what the colors mean
 */

const pieces = 24;

/**
 * @param {CanvasRenderingContext2D} context
 * @param {import('./canvas.js').Size} size
 * @param {Shown} shown
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawRootLocus(context, size, { ways, roots, limits, sweep, veiled = false }, theme, voice) {
  const places = drawComplexPlane(context, size, limits, theme, voice, { veiled });
  const { frame, x, y } = places;
  if (veiled) {
    drawVeil(context, frame, theme);
    return;
  }
  const colorOf = colorsOf('frequency', { growthRate: 1, frequency: [-0.35, 1] }, theme);
  context.save();
  context.beginPath();
  context.rect(frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top + 4);
  context.clip();
  for (const { paths } of ways) for (const path of paths) drawWay(context, path, places, colorOf, theme);
  for (const { re, im } of roots) if (im >= 0) drawCross(context, x(re), y(im), re > 0 ? theme.unstable : theme.stable, theme);
  for (const way of ways) nameWay(context, way, places, theme);
  context.restore();
  drawLegend(context, frame, sweep, colorOf, theme);
}

/** @param {CanvasRenderingContext2D} context @param {readonly Root[]} path @param {Places} places @param {(share: number) => [number, number, number]} colorOf @param {Theme} theme */
function drawWay(context, path, { x, y }, colorOf, theme) {
  const last = path.length - 1;
  context.lineWidth = 2.2 * theme.line;
  context.lineCap = 'round';
  for (let piece = 0; piece < pieces; piece++) {
    const [from, to] = [Math.round((piece / pieces) * last), Math.round(((piece + 1) / pieces) * last)];
    context.strokeStyle = written(colorOf(Math.max((piece + 0.5) / pieces, 1e-3)));
    context.beginPath();
    context.moveTo(x(path[from].re), y(path[from].im));
    for (let i = from + 1; i <= to; i++) context.lineTo(x(path[i].re), y(path[i].im));
    context.stroke();
  }
  context.lineCap = 'butt';
}

/** At the end of the way that swings fastest and is in the picture. @param {CanvasRenderingContext2D} context @param {Way} way @param {Places} places @param {Theme} theme */
function nameWay(context, { label, paths }, { frame, x, y }, theme) {
  const seen = paths.map((path) => path.findLast(({ re, im }) => im > 0 && x(re) > frame.left && x(re) < frame.right && y(im) > frame.top))
    .filter((root) => root !== undefined);
  const end = seen.reduce((most, root) => (root.im > (most?.im ?? 0) ? root : most), seen[0]);
  if (!label || !end) return;
  context.font = textFont(theme, 0.9, 600);
  context.textAlign = x(end.re) > frame.right - 6 * theme.size ? 'right' : 'left';
  context.textBaseline = 'middle';
  context.lineJoin = 'round';
  context.lineWidth = 4;
  context.strokeStyle = theme.surface;
  const across = x(end.re) + (context.textAlign === 'left' ? 6 : -6);
  context.strokeText(label, across, y(end.im));
  context.fillStyle = theme.ink;
  context.fillText(label, across, y(end.im));
}

/** What the colors mean, in the fixed corner. @param {CanvasRenderingContext2D} context @param {import('./axes.js').Box} frame @param {Shown['sweep']} sweep @param {(share: number) => [number, number, number]} colorOf @param {Theme} theme */
function drawLegend(context, frame, { symbol, from, to }, colorOf, theme) {
  const { size } = theme;
  const [width, middle] = [6 * size, frame.top - 1.1 * size];
  context.font = textFont(theme, 1);
  const end = frame.right - context.measureText(to).width - 0.5 * size;
  for (let i = 0; i < pieces; i++) {
    context.fillStyle = written(colorOf(Math.max((i + 0.5) / pieces, 1e-3)));
    context.fillRect(end - width + (i / pieces) * width, middle - 0.4 * size, width / pieces + (i < pieces - 1 ? 0.5 : 0), 0.8 * size);
  }
  context.fillStyle = theme.ink2;
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  context.fillText(to, frame.right, middle);
  context.fillText(from, end - width - 0.5 * size, middle);
  const start = end - width - size - context.measureText(from).width;
  context.font = `italic 400 ${1.2 * size}px ${theme.serif}`;
  context.fillText(symbol, start, middle);
}
