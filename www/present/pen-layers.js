import { gear, pictureOf } from './pen-views.js';
import './pen-layer.js';

/** @typedef {import('./pen-layer.js').PenLayer} PenLayer */

/**
 * Lays sheets over the views as far as they are needed, shows on them what was drawn, and has the page know which views
 * are on the screen.
 * @param {HTMLElement} host the element in which stage and lens are
 * @param {Pick<import('../app.js').App, 'ink' | 'isDrawing' | 'state'>} app
 * @param {import('../style/theme.js').Theme} theme
 */
export function showInk(host, { ink, isDrawing, state }, theme) {
  if (!isDrawing && ink.strokes.length === 0 && ink.shown.length === 0) return;
  const lens = /** @type {(HTMLElement & { view?: string }) | null} */ (host.querySelector('#lens-panel'));
  const wheel = host.querySelector('shimmy-gear > shimmy-canvas');
  const pictures = [...(lens?.querySelectorAll('shimmy-canvas') ?? [])];
  /** @type {[string, Element][]} */
  const shown = pictures.map((picture, i) => [pictureOf(state.lens, lens?.view ?? '', i), picture]);
  if (wheel) shown.push([gear, wheel]);
  for (const [view, picture] of shown) layerOf(picture).show(view, ink.strokes, theme);
  ink.shown = shown.map(([view]) => view);
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
