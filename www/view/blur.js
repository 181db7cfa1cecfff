import { strokeCurve } from './curve.js';

/** Positions of the curve over the exposure of a frame, as many as the gear has poses. */
const layers = 16;
/** Of each layer. */
const opacity = 0.14;

/**
 * A curve that moves too fast for the screen: drawn where it was all along the exposure of a frame, so that no single
 * position can be read from it.
 * @param {CanvasRenderingContext2D} context in the style of the curve
 * @param {import('./curve.js').Curve} curve where it is now
 * @param {number} travel how far to the left it has moved in the frame, in px
 */
export function strokeBlurred(context, curve, travel) {
  const { globalAlpha } = context;
  context.globalAlpha = globalAlpha * opacity;
  for (let layer = 0; layer < layers; layer++) {
    const shift = (travel * layer) / layers;
    strokeCurve(context, { ...curve, x: (i) => curve.x(i) + shift });
  }
  context.globalAlpha = globalAlpha;
}
