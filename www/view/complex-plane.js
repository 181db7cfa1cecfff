import { axisOf, drawAxes, frameOf } from './axes.js';
import { drawHatch, hatchOf } from './hatch.js';
import { linear, ticks } from './scale.js';
import { textFont, writeEdged } from './text.js';

/**
 * The upper half of the complex plane, which the lower mirrors: growth rate to the right, angular frequency upward, with
 * rings of equal natural frequency and rays of equal damping ratio. The unstable half is hatched.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('./canvas.js').Size} Size
 * @typedef {import('./root-paths.js').Root} Root
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{ left: number, right: number, top: number }} Limits in 1/s: the real part goes from left to right, the imaginary up from 0
 * @typedef {{ frame: Box, x: (re: number) => number, y: (im: number) => number, taken: Box[] }} Places `taken`: by numbers of rings and rays
 */

const dampingRatios = [0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7];
/** How near rays may end, in widths of small type: so that their numbers stay apart. */
const nearestRays = 4;
const circle = 2 * Math.PI;

/** What the upward axis is called. @type {import('./text.js').Run[]} */
export const imaginaryName = [{ text: 'Im ' }, { symbol: 's' }, { text: ', rad/s' }];

/**
 * Draws what is behind roots, and tells where they go.
 * @param {CanvasRenderingContext2D} context
 * @param {Size} size
 * @param {Limits} limits
 * @param {Theme} theme
 * @param {Voice} voice
 * @param {{ veiled?: boolean }} [options]
 * @returns {Places}
 */
export function drawComplexPlane(context, size, { left, right, top }, theme, voice, { veiled = false } = {}) {
  const frame = frameOf(size, theme, 'above');
  const [width, height] = [frame.right - frame.left, frame.bottom - frame.top];
  /** @type {Places} */
  const places = { frame, taken: [], x: linear([left, right], [frame.left, frame.right]), y: linear([0, top], [frame.bottom, frame.top]) };
  if (width < 20 || height < 20) return places;
  const unit = /** @type {const} */ ({ symbol: 's', word: 'roots.re', perSI: 1, color: 'psi' });
  const x = axisOf({ ...unit, unit: '' }, [left, right], [frame.left, frame.right], Math.min(8, width / (theme.size * 3.6)), voice);
  const y = axisOf({ ...unit, unit: '' }, [0, top], [frame.bottom, frame.top], Math.min(5, height / (theme.size * 1.9)), voice);
  const zero = { left: places.x(0), right: frame.right, top: frame.top, bottom: frame.bottom };
  if (!veiled) drawHatch(context, hatchOf(zero, () => true, theme), theme);
  drawAxes(context, frame,
    { ...x, name: (isShort) => [{ text: 'Re ' }, { symbol: 's' }, { text: isShort ? `, ${voice.say('stability.perSecond')}` : ` ${voice.say('roots.re')}, ${voice.say('stability.perSecond')}` }] },
    { ...y, name: () => imaginaryName }, theme, { up: 'above' });
  context.save();
  context.beginPath();
  context.rect(frame.left, frame.top, width, height);
  context.clip();
  if (!veiled) drawGrid(context, places, { left, right, top }, theme, voice);
  context.restore();
  // The axis that no root may cross.
  context.strokeStyle = theme.ink2;
  context.lineWidth = 1.5 * theme.line;
  context.beginPath();
  context.moveTo(zero.left, frame.top);
  context.lineTo(zero.left, frame.bottom);
  context.stroke();
  return places;
}

/** @param {CanvasRenderingContext2D} context @param {Places} places @param {Limits} limits @param {Theme} theme @param {Voice} voice */
function drawGrid(context, { frame, x, y, taken }, { left, right, top }, theme, voice) {
  const [originX, originY] = [x(0), y(0)];
  const [perRe, perIm] = [x(1) - originX, originY - y(1)];
  context.strokeStyle = theme.ghost;
  context.fillStyle = theme.ink2;
  context.lineWidth = 0.8 * theme.line;
  context.globalAlpha = 0.65;
  context.font = textFont(theme, 0.82);
  context.setLineDash([1.5 * theme.line, 3 * theme.line]);
  const rings = ticks(0, top / circle, Math.min(4, (frame.bottom - frame.top) / (theme.size * 2.6))).filter((frequency) => frequency > 0);
  for (const frequency of rings) {
    context.beginPath();
    context.ellipse(originX, originY, circle * frequency * perRe, circle * frequency * perIm, 0, Math.PI, circle);
    context.stroke();
  }
  // Rays end at the upper edge.
  const reach = -left / Math.hypot(left, top);
  const across = (/** @type {number} */ ratio) => x(-top * Math.tan(Math.asin(ratio)));
  /** @type {number[]} */
  const steep = [];
  for (const ratio of dampingRatios.toReversed()) {
    const isApart = steep.every((other) => across(ratio) - across(other) > nearestRays * theme.size) && originX - across(ratio) > (nearestRays / 2) * theme.size;
    if (ratio < 0.97 * reach && isApart) steep.push(ratio);
  }
  for (const ratio of steep) {
    context.beginPath();
    context.moveTo(originX, originY);
    context.lineTo(across(ratio), frame.top);
    context.stroke();
  }
  context.setLineDash([]);
  context.globalAlpha = 1;
  const write = (/** @type {string} */ text, /** @type {number} */ at, /** @type {number} */ up, /** @type {CanvasTextAlign} */ align) => {
    context.textAlign = align;
    context.textBaseline = 'middle';
    writeEdged(context, text, at, up, theme, 3);
    const width = context.measureText(text).width;
    const left = align === 'right' ? at - width : at - width / 2;
    taken.push({ left, right: left + width, top: up - 0.6 * theme.size, bottom: up + 0.6 * theme.size });
  };
  for (const frequency of rings) {
    const im = Math.sqrt(Math.max(0, (circle * frequency) ** 2 - right ** 2));
    if (y(im) > frame.top + theme.size * 0.6) write(`${voice.number(frequency, 0)} Hz`, frame.right - 4, y(im), 'right');
  }
  for (const ratio of steep) {
    const down = (0.8 * theme.size) / (frame.bottom - frame.top);
    write(`ζ ${voice.number(ratio, 2)}`, originX + (across(ratio) - originX) * (1 - down), frame.top + 0.8 * theme.size, 'center');
  }
}
