import { hatchOf, drawHatch } from './hatch.js';
import { colorsOf, written } from './map-colors.js';
import { textFont } from './text.js';

/**
 * What the colors of a map mean: a bar with its numbers, hatched where the map is.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./map-colors.js').Coloring} Coloring
 * @typedef {import('./map-colors.js').Limits} Limits
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 */

const pieces = 48;

/**
 * From `left`, on the line `middle`, no further than `right`.
 * @param {CanvasRenderingContext2D} context
 * @param {{ left: number, right: number, middle: number }} place
 * @param {{ coloring: Coloring, limits: Limits }} look
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawMapLegend(context, { left, right, middle }, { coloring, limits }, theme, voice) {
  const { size } = theme;
  context.font = textFont(theme, 0.95);
  context.textBaseline = 'middle';
  const box = (/** @type {number} */ from, /** @type {number} */ width) => ({ left: from, right: from + width, top: middle - 0.45 * size, bottom: middle + 0.45 * size });
  const color = colorsOf(coloring, limits, theme);
  if (coloring === 'stable') {
    const words = { 1: voice.say('stability.legend.stable'), 0: voice.say('stability.legend.unstable') };
    const wordsWidth = context.measureText(words[1]).width + context.measureText(words[0]).width;
    // Two patches with their gaps, closer together where there is little room.
    const [patch, pause] = wordsWidth + (2 * 1.8 + 2 * 0.5 + 1.2) * size <= right - left ? [1.8, 1.2] : [1.1, 0.7];
    let from = left;
    for (const isStable of /** @type {const} */ ([1, 0])) {
      const text = words[isStable];
      const swatch = box(from, patch * size);
      if (swatch.right + 0.5 * size + context.measureText(text).width > right) return;
      fill(context, swatch, written(color(isStable)));
      if (!isStable) drawHatch(context, hatchOf(swatch, () => true, theme), theme);
      outline(context, swatch, theme);
      from = swatch.right + 0.5 * size;
      write(context, text, from, middle, theme);
      from += context.measureText(text).width + pause * size;
    }
    return;
  }
  const isRate = coloring === 'growthRate';
  const [from, to] = isRate ? [-limits.growthRate, limits.growthRate] : limits.frequency;
  const decimals = to - from < 5 ? 1 : 0;
  const numbers = isRate
    ? [voice.number(from, decimals), `+${voice.number(to, decimals)} ${voice.say('stability.perSecond')}`]
    : [voice.number(from, decimals), `${voice.number(to, decimals)} Hz`];
  const [before, after] = numbers.map((text) => context.measureText(text).width);
  const width = Math.min(9 * size, right - left - before - after - size);
  if (width < 3 * size) return;
  const bar = box(left + before + 0.5 * size, width);
  write(context, numbers[0], left, middle, theme);
  for (let i = 0; i < pieces; i++) {
    const value = from + ((i + 0.5) / pieces) * (to - from);
    fill(context, { ...bar, left: bar.left + (i / pieces) * width, right: bar.left + ((i + 1) / pieces) * width + (i < pieces - 1 ? 0.5 : 0) }, written(color(value)));
  }
  if (isRate) {
    const unstable = { ...bar, left: (bar.left + bar.right) / 2 };
    drawHatch(context, hatchOf(unstable, () => true, theme), theme);
    context.strokeStyle = theme.unstable;
    context.lineWidth = 2 * theme.line;
    context.beginPath();
    context.moveTo(unstable.left, bar.top - 2);
    context.lineTo(unstable.left, bar.bottom + 2);
    context.stroke();
  }
  outline(context, bar, theme);
  write(context, numbers[1], bar.right + 0.5 * size, middle, theme);
  if (isRate) return;
  const idle = box(bar.right + after + 1.7 * size, 1.8 * size);
  const text = voice.say('stability.legend.idle');
  if (idle.right + 0.5 * size + context.measureText(text).width > right) return;
  fill(context, idle, written(color(0)));
  outline(context, idle, theme);
  write(context, text, idle.right + 0.5 * size, middle, theme);
}

/** @param {CanvasRenderingContext2D} context @param {Box} box @param {string} color */
function fill(context, { left, right, top, bottom }, color) {
  context.fillStyle = color;
  context.fillRect(left, top, right - left, bottom - top);
}

/** @param {CanvasRenderingContext2D} context @param {Box} box @param {Theme} theme */
function outline(context, { left, right, top, bottom }, theme) {
  context.strokeStyle = theme.ghost;
  context.lineWidth = 1;
  context.strokeRect(left, top, right - left, bottom - top);
}

/** @param {CanvasRenderingContext2D} context @param {string} text @param {number} x @param {number} y @param {Theme} theme */
function write(context, text, x, y, theme) {
  context.fillStyle = theme.ink2;
  context.textAlign = 'left';
  context.fillText(text, x, y);
}
