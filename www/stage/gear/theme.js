/**
 * The colors and faces that the drawing takes from the page. A color is `#rgb` or `#rrggbb`,
 * because the drawing makes its own translucent shades of it.
 *
 * The drawing measures its text once for each theme object: make a new one when fonts arrive.
 *
 * @typedef {object} Theme
 * @property {'light' | 'dark'} scheme
 * @property {string} page
 * @property {string} surface
 * @property {string} raised
 * @property {string} ground
 * @property {string} rule
 * @property {string} ink
 * @property {string} ink2
 * @property {string} psi torsion angle, spring
 * @property {string} y lateral deformation, tire, slip angle, track
 * @property {string} force side force, aligning moment
 * @property {string} unstable
 * @property {string} stable also the damper
 * @property {string} freeplay the gap's zone, used translucent
 * @property {string} freeplayText
 * @property {string} ghost
 * @property {string} sans family list for words and numbers
 * @property {string} serif family list for symbols, set in italics
 */

/**
 * The same color with an opacity from 0 to 1.
 *
 * @param {string} color `#rgb` or `#rrggbb`
 * @param {number} opacity
 */
export function translucent(color, opacity) {
  const digits = color.length === 4 ? color.replace(/[0-9a-f]/gi, '$&$&') : color;
  const byte = Math.round(Math.min(1, Math.max(0, opacity)) * 255);
  return digits + byte.toString(16).padStart(2, '0');
}
