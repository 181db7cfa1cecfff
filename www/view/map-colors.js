/**
 * The colors of a stability map: growth rates from `stable` through the page's own to `unstable`, nothing exactly at the
 * boundary; frequencies in one blue; or just what is unstable, tinted.
 *
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {'growthRate' | 'stable' | 'frequency'} Coloring
 * @typedef {[number, number, number]} Color
 * @typedef {{ growthRate: number, frequency: [number, number] }} Limits the ends of the scales: ± in 1/s, from and to in Hz
 */

/** How far a map's strongest color goes toward the token, so that grid and words stay to be read on it. */
const strength = 0.62;
const tint = 0.14;
const steps = 256;

/**
 * What color each value has.
 * @param {Coloring} coloring
 * @param {Limits} limits
 * @param {Theme} theme
 * @returns {(value: number) => Color} of a growth rate, of whether it is stable (1 or 0), or of a frequency (0: no beat)
 */
export function colorsOf(coloring, limits, theme) {
  const [page, surface, stable, unstable, psi, raised] = [theme.page, theme.surface, theme.stable, theme.unstable, theme.psi, theme.raised].map(channels);
  if (coloring === 'stable') {
    const shimmies = mix(surface, unstable, tint);
    return (value) => (value ? surface : shimmies);
  }
  if (coloring === 'frequency') {
    const [from, to] = limits.frequency;
    const ramp = rampOf((share) => mix(surface, psi, 0.08 + share * 0.8));
    return (value) => (value > 0 ? ramp((value - from) / (to - from || 1)) : raised);
  }
  const limit = limits.growthRate;
  const falls = rampOf((share) => mix(page, stable, share * strength));
  const grows = rampOf((share) => mix(page, unstable, share * strength));
  return (value) => (value > 0 ? grows(value / limit) : falls(-value / limit));
}

/**
 * A map as pixels, the highest row first as pictures have it.
 * @param {import('./field.js').Field} field
 * @param {(value: number) => Color} colorOf
 * @param {Uint8ClampedArray} pixels four a cell, to be written to
 */
export function paintPixels({ values, columns, rows }, colorOf, pixels) {
  for (let row = 0, at = 0; row < rows; row++) {
    const start = (rows - 1 - row) * columns;
    for (let column = 0; column < columns; column++, at += 4) {
      const [red, green, blue] = colorOf(values[start + column]);
      pixels[at] = red;
      pixels[at + 1] = green;
      pixels[at + 2] = blue;
      pixels[at + 3] = 255;
    }
  }
}

/** A color as style sheets write it. @param {Color} color */
export function written([red, green, blue]) {
  return `#${[red, green, blue].map((channel) => Math.round(channel).toString(16).padStart(2, '0')).join('')}`;
}

/** A color for each share from 0 to 1, made once. @param {(share: number) => Color} colorAt @returns {(share: number) => Color} */
function rampOf(colorAt) {
  const colors = Array.from({ length: steps }, (_, i) => colorAt(i / (steps - 1)));
  return (share) => colors[share <= 0 ? 0 : share >= 1 ? steps - 1 : Math.round(share * (steps - 1))];
}

/** @param {Color} one @param {Color} other @param {number} share of the other @returns {Color} */
function mix(one, other, share) {
  return /** @type {Color} */ (one.map((channel, i) => channel + share * (other[i] - channel)));
}

/** @param {string} color `#rrggbb` @returns {Color} */
function channels(color) {
  return /** @type {Color} */ ([1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16)));
}
