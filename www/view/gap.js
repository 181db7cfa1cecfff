import { gapEdge, inStyle } from './strokes.js';
import { textFont } from './text.js';

/**
 * The freeplay's gap on a plot whose axis to the right is ψ: a band, its edges dotted, and its name.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Box} frame
 * @param {number} freeplay half of the gap, in rad
 * @param {(angle: number) => number} x
 * @param {Theme} theme
 */
export function drawGap(context, frame, freeplay, x, theme) {
  if (!(freeplay > 0)) return;
  const left = Math.max(x(-freeplay), frame.left);
  const right = Math.min(x(freeplay), frame.right);
  fillGap(context, { ...frame, left, right }, theme);
  inStyle(context, theme, gapEdge, () => {
    context.beginPath();
    for (const edge of [left, right]) {
      context.moveTo(edge, frame.top);
      context.lineTo(edge, frame.bottom);
    }
    context.stroke();
  });
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Box} box
 * @param {Theme} theme
 */
export function fillGap(context, { left, right, top, bottom }, theme) {
  context.globalAlpha = 0.25;
  context.fillStyle = theme.freeplay;
  context.fillRect(left, top, right - left, bottom - top);
  context.globalAlpha = 1;
}

/**
 * Names the gap at the foot of the frame. Words wider than the gap stand on a halo, to be read across the grid.
 * @param {CanvasRenderingContext2D} context
 * @param {Box} frame
 * @param {number} freeplay
 * @param {(angle: number) => number} x
 * @param {Theme} theme
 * @param {Voice} voice
 * @returns {Box[]} the room that the words take; none without a gap
 */
export function nameGap(context, frame, freeplay, x, theme, voice) {
  if (!(freeplay > 0)) return [];
  const words = voice.say('phase.gap');
  context.font = textFont(theme, 0.95, 600);
  context.textBaseline = 'alphabetic';
  context.textAlign = 'center';
  const width = context.measureText(words).width;
  const middle = x(0);
  const baseline = frame.bottom - theme.size * 0.7;
  if (width + 8 > x(freeplay) - x(-freeplay)) {
    context.lineJoin = 'round';
    context.lineWidth = 4;
    context.strokeStyle = theme.surface;
    context.strokeText(words, middle, baseline);
  }
  context.fillStyle = theme.freeplayText;
  context.fillText(words, middle, baseline);
  return [{ left: middle - width / 2, right: middle + width / 2, top: baseline - theme.size, bottom: baseline + theme.size * 0.4 }];
}
