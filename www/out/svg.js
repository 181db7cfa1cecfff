import { SvgContext } from './svg-context.js';

/**
 * A picture as an SVG document.
 * @param {import('./plate.js').Picture} picture
 * @param {string} title what it shows, for those who do not see it
 * @param {import('./plate.js').Ruler} ruler
 */
export function svgOf({ size, paint }, title, ruler) {
  const context = new SvgContext(size, ruler);
  paint(context.asContext, size);
  return context.document(title);
}
