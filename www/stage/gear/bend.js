/**
 * How far the drawn tire bends. A wheel that a hand twists far, or a state from a link, would bend it into a knot; so
 * beyond what a tire could do the drawing follows less and less. Up to there it is true, beyond it the sheet says so,
 * and numbers always tell the state.
 *
 * @module
 */

/** @typedef {import('./scene.js').Scene} Scene */
/** @typedef {import('./contact-line.js').ContactLine} ContactLine */

/** True up to the first, never beyond the second: deformation at the leading point [m]. */
const DEFORMATION = [0.13, 0.18];
/** The same of the line behind it [m]. */
const LINE = [DEFORMATION[1], 0.22];
/** The same of the line's slope against the wheel plane: the tangents of 27° and of 42°. */
const SLOPE = [0.5, 0.9];

/**
 * A value as it is up to `knee`, from there on bending over toward `limit`, without a corner.
 *
 * @param {number} value
 * @param {readonly number[]} bounds
 */
function held(value, [knee, limit]) {
  const size = Math.abs(value);
  if (!(size > knee)) return value;
  return Math.sign(value) * (knee + (limit - knee) * Math.tanh((size - knee) / (limit - knee)));
}

/** The drawn deformation at the leading point [m]. @param {number} deformation magnified, a number */
export const heldDeformation = (deformation) => held(deformation, DEFORMATION);

/**
 * The line from its leading point backwards, as steep and as far aside as a tire bends.
 *
 * @param {ContactLine} line
 * @returns {ContactLine}
 */
export function heldLine({ l, n }) {
  let aside = n[0];
  return {
    l,
    n: n.map((_, i) => {
      if (i > 0) aside += held(slopeAt({ l, n }, i), SLOPE) * (l[i - 1] - l[i]);
      return held(aside, LINE);
    }),
  };
}

/** How fast the line goes aside toward the back, between a point and the one ahead. @param {ContactLine} line @param {number} i */
const slopeAt = ({ l, n }, i) => (n[i] - n[i - 1]) / (l[i - 1] - l[i]);

/**
 * Whether the tire bends further than it is drawn: now, or where its track is still seen.
 *
 * @param {Scene} scene
 * @param {ContactLine} resting the contact line as it lies on the track
 */
export function bendsFurther({ magnification, track, state }, resting) {
  const isFar = (/** @type {number} */ y) => Math.abs(magnification * y) > DEFORMATION[0];
  return isFar(state[2] ?? 0)
    || Array.prototype.some.call(track.lateralDeformation, isFar)
    || resting.n.some((aside, i) => Math.abs(aside) > LINE[0] || (i > 0 && Math.abs(slopeAt(resting, i)) > SLOPE[0]));
}
