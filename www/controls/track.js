/** The slider's track with what it tells: hatched stretches, ticks at their ends, numbers and a caption beneath. */

import { html, nothing } from 'lit';
import { placeLabels } from './scent-labels.js';

/** @typedef {import('./scent.js').Scent} Scent */

/** Behind the slider. Its caption says the same, and the slider does to who cannot see it. @param {Scent | null} scent */
export function trackOf(scent) {
  return html`
    <div class="track" aria-hidden="true">
      ${scent?.hatches.map(({ from, to }) => html`<span class="hatch" style="left:${percent(from)};right:${percent(1 - to)}"></span>`) ?? nothing}
      ${scent?.marks.map(({ place }) => html`<span class="tick" style="left:${percent(place)}"></span>`) ?? nothing}
    </div>`;
}

/**
 * Under the slider.
 * @param {Scent | null} scent
 * @param {{ width: number, size: number }} track its width and the size of its text, in px
 */
export function labelsOf(scent, { width, size }) {
  const { numbers, caption } = scent && width > 0 ? placeLabels(scent, width, (text) => textWidth(text, size)) : noLabels;
  if (numbers.length === 0 && !caption) return html`<div class="scent" aria-hidden="true"></div>`;
  return html`
    <div class="scent" data-rows=${caption?.row === 1 ? 2 : 1} aria-hidden="true">
      ${numbers.map(({ x, text }) => html`<span class="scent-number" style="left:${x.toFixed(1)}px">${text}</span>`)}
      ${caption ? html`<span class="scent-caption" data-row=${caption.row} style="left:${caption.x.toFixed(1)}px">${caption.text}</span>` : nothing}
    </div>`;
}

/** @type {import('./scent-labels.js').Labels} */
const noLabels = { numbers: [], caption: null };

/** @param {number} place 0 … 1 */
function percent(place) {
  return `${(100 * place).toFixed(2)}%`;
}

/** @type {CanvasRenderingContext2D | null} */
let context = null;
/** Measured widths of a text in 1 px, for as long as no other face has been loaded. @type {Map<string, number>} */
const widths = new Map();
document.fonts.addEventListener('loadingdone', () => widths.clear());

/** How wide a text is, each digit as wide as a zero. @param {string} text @param {number} size in px */
function textWidth(text, size) {
  const steady = text.replaceAll(/\d/g, '0');
  let width = widths.get(steady);
  if (width === undefined) {
    context ??= document.createElement('canvas').getContext('2d');
    if (!context) return 0.6 * size * text.length;
    context.font = `100px ${getComputedStyle(document.body).fontFamily}`;
    width = context.measureText(steady).width / 100;
    widths.set(steady, width);
  }
  return width * size;
}
