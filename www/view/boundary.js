/**
 * Where stability ends in a plane: a solid line where a swing begins to grow (Hopf), a dashed one with dots where the wheel
 * begins to turn aside (divergence), a dashed one in ink where two cycles meet and vanish (fold). Where another root or
 * multiplier crosses beyond that, nothing changes between stable and not: a thin line.
 *
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../run/linear-looks.js').BoundaryCurve} BoundaryCurve
 * @typedef {import('../pkg/shimmy.js').FoldCurve} FoldCurve
 */

import { curveOf, strokeCurve } from './curve.js';

/** @type {Readonly<Record<BoundaryCurve['kind'] | FoldCurve['kind'], number[]>>} */
const dashes = { hopf: [], divergence: [9, 4, 2, 4], fold: [8, 5] };

/**
 * @param {CanvasRenderingContext2D} context
 * @param {readonly (BoundaryCurve | FoldCurve)[]} curves
 * @param {(value: number) => number} x
 * @param {(value: number) => number} y
 * @param {Theme} theme
 */
export function drawBoundary(context, curves, x, y, theme) {
  context.lineJoin = 'round';
  for (const { kind, closed, bounds, ...points } of curves) {
    const curve = curveOf(points.x, points.y, x, y);
    context.setLineDash([]);
    // On a pale edge, so that it stands off the strongest color.
    context.strokeStyle = theme.surface;
    context.lineWidth = (bounds ? 4.5 : 2) * theme.line;
    context.globalAlpha = 0.7;
    strokeCurve(context, curve, { isClosed: closed });
    context.globalAlpha = 1;
    context.setLineDash(dashes[kind].map((length) => length * theme.line));
    context.strokeStyle = kind === 'fold' ? theme.ink : theme.unstable;
    context.lineWidth = (bounds ? 2.5 : 1) * theme.line;
    strokeCurve(context, curve, { isClosed: closed });
  }
  context.setLineDash([]);
}
