import { linear } from './scale.js';
import { textFont, writeEdged } from './text.js';

/**
 * A landing roll small, beside others: how wide it swung over time, on axes that all of them share.
 *
 * @typedef {import('./canvas.js').Size} Size
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {{
 *   band: { time: ArrayLike<number>, low: ArrayLike<number>, high: ArrayLike<number> } | null, end: number, limit: number, threshold: number,
 *   note: string, isShimmy: boolean, isNow: boolean, isOld: boolean,
 * }} Shown `end` of time, in s; `limit` of ψ, in rad; `note`: what is read of it
 */

/** @param {CanvasRenderingContext2D} context @param {Size} size @param {Shown} shown @param {Theme} theme */
export function drawRollMultiple(context, { width, height }, { band, end, limit, threshold, note, isShimmy, isNow, isOld }, theme) {
  const box = { left: 2, right: width - 2, top: 2, bottom: height - 2 };
  const x = linear([0, end], [box.left, box.right]);
  const y = linear([-limit, limit], [box.bottom, box.top]);
  context.fillStyle = isNow ? theme.raised : theme.surface;
  context.fillRect(0, 0, width, height);
  context.strokeStyle = isNow ? theme.psi : theme.rule;
  context.lineWidth = isNow ? 2 * theme.line : 1;
  context.strokeRect(0.5, 0.5, width - 1, height - 1);
  context.strokeStyle = theme.rule;
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(box.left, y(0));
  context.lineTo(box.right, y(0));
  context.stroke();
  context.strokeStyle = theme.unstable;
  context.globalAlpha = 0.6;
  context.setLineDash([2, 4]);
  context.beginPath();
  for (const level of [threshold, -threshold]) {
    context.moveTo(box.left, y(level));
    context.lineTo(box.right, y(level));
  }
  context.stroke();
  context.setLineDash([]);
  context.globalAlpha = isOld ? 0.4 : 0.85;
  if (band && band.time.length > 1) {
    context.fillStyle = isShimmy ? theme.unstable : theme.psi;
    context.save();
    context.beginPath();
    context.rect(1, 1, width - 2, height - 2);
    context.clip();
    context.beginPath();
    for (let i = 0; i < band.time.length; i++) context[i ? 'lineTo' : 'moveTo'](x(band.time[i]), Math.min(y(band.high[i]), y(0) - 0.6));
    for (let i = band.time.length - 1; i >= 0; i--) context.lineTo(x(band.time[i]), Math.max(y(band.low[i]), y(0) + 0.6));
    context.closePath();
    context.fill();
    context.restore();
  }
  context.globalAlpha = 1;
  if (!note) return;
  context.font = textFont(theme, 0.85, 600);
  context.fillStyle = theme.ink;
  context.textAlign = 'right';
  context.textBaseline = 'alphabetic';
  writeEdged(context, note, width - theme.size * 0.5, height - theme.size * 0.5, theme);
}
