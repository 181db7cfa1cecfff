import { gear, pictureOf } from './pen-views.js';
import './pen-layer.js';

/** @typedef {import('./pen-layer.js').PenLayer} PenLayer */

/**
 * Lays sheets over the views as far as they are needed, and shows on them what was drawn.
 * @param {HTMLElement} host the element in which stage and lens are
 * @param {Pick<import('../app.js').App, 'ink' | 'isDrawing' | 'state'>} app
 * @param {import('../style/theme.js').Theme} theme
 */
export function showInk(host, { ink, isDrawing, state }, theme) {
  if (!isDrawing && ink.strokes.length === 0 && !host.querySelector('shimmy-pen-layer')) return;
  const wheel = host.querySelector('.gear > shimmy-canvas');
  if (wheel) layerOf(wheel).show(gear, ink.strokes, theme);
  host.querySelectorAll('#lens-panel shimmy-canvas').forEach((picture, i) => layerOf(picture).show(pictureOf(state, i), ink.strokes, theme));
}

/** What was drawn over a picture, to be drawn over it elsewhere; null where there is no sheet. @param {Element} picture */
export function inkOver(picture) {
  return /** @type {PenLayer | null} */ (picture.querySelector(':scope > shimmy-pen-layer'))?.paint ?? null;
}

/** @param {Element} picture @returns {PenLayer} */
function layerOf(picture) {
  const there = /** @type {PenLayer | null} */ (picture.querySelector(':scope > shimmy-pen-layer'));
  if (there) return there;
  const layer = /** @type {PenLayer} */ (document.createElement('shimmy-pen-layer'));
  picture.append(layer);
  return layer;
}
