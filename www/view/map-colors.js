/**
 * The colors of a stability map: growth rates from `stable` through the page's own to `unstable`, nothing exactly at the
 * boundary; frequencies in one blue; or just what is unstable, tinted.
 *
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {'growthRate' | 'stable' | 'frequency'} Coloring
 * @typedef {[red: number, green: number, blue: number, packed: number]} Color `packed`: as four bytes of a picture
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
  const { calm, shimmies, idle, beats, falls, grows } = inksOf(theme);
  if (coloring === 'stable') return (value) => (value ? calm : shimmies);
  if (coloring === 'frequency') {
    const [from, to] = limits.frequency;
    return (value) => (value > 0 ? beats((value - from) / (to - from || 1)) : idle);
  }
  const limit = limits.growthRate;
  return (value) => (value > 0 ? grows(value / limit) : falls(-value / limit));
}

/**
 * The colors of a map of swings: the page's own where it rests, the stronger the wider it swings. Small swings are told apart
 * best, so colors go by the root.
 * @param {number} limit the widest that is told apart
 * @param {Theme} theme
 * @returns {(amplitude: number) => Color}
 */
export function colorsOfSwings(limit, theme) {
  const { calm, grows } = inksOf(theme);
  return (amplitude) => (amplitude > 0 ? grows(0.08 + 0.92 * Math.sqrt(amplitude / limit)) : calm);
}

/** @typedef {(share: number) => Color} Ramp from 0 to 1 */

/** @type {WeakMap<Theme, ReturnType<typeof mixed>>} */
const known = new WeakMap();

/** The colors of a theme, mixed once: map and legend ask for them in each frame of a drag. @param {Theme} theme */
function inksOf(theme) {
  const inks = known.get(theme) ?? mixed(theme);
  known.set(theme, inks);
  return inks;
}

/** @param {Theme} theme */
function mixed(theme) {
  const [page, surface, stable, unstable, psi, raised] = [theme.page, theme.surface, theme.stable, theme.unstable, theme.psi, theme.raised].map(channels);
  return {
    calm: surface, shimmies: mix(surface, unstable, tint), idle: raised,
    beats: rampOf((share) => mix(surface, psi, 0.16 + share * 0.76)),
    falls: rampOf((share) => mix(page, stable, share * strength)),
    grows: rampOf((share) => mix(page, unstable, share * strength)),
  };
}

/**
 * A map as pixels, the highest row first as pictures have it.
 * @param {import('./field.js').Field} field
 * @param {(value: number) => Color} colorOf
 * @param {Uint8ClampedArray} pixels four a cell, to be written to
 */
export function paintPixels({ values, columns, rows }, colorOf, pixels) {
  const whole = new Uint32Array(pixels.buffer, pixels.byteOffset, columns * rows);
  for (let row = 0, at = 0; row < rows; row++) {
    const start = (rows - 1 - row) * columns;
    for (let column = 0; column < columns; column++) whole[at++] = colorOf(values[start + column])[3];
  }
}

/** A color as style sheets write it. @param {Color} color */
export function written([red, green, blue]) {
  return `#${[red, green, blue].map((channel) => Math.round(channel).toString(16).padStart(2, '0')).join('')}`;
}

/** A color for each share, made once. @param {Ramp} colorAt @returns {Ramp} */
function rampOf(colorAt) {
  const colors = Array.from({ length: steps }, (_, i) => colorAt(i / (steps - 1)));
  return (share) => colors[share <= 0 ? 0 : share >= 1 ? steps - 1 : Math.round(share * (steps - 1))];
}

/** @param {Color} one @param {Color} other @param {number} share of the other @returns {Color} */
function mix(one, other, share) {
  const [red, green, blue] = [0, 1, 2].map((i) => one[i] + share * (other[i] - one[i]));
  return colorOf(red, green, blue);
}

/** @param {string} color `#rrggbb` @returns {Color} */
function channels(color) {
  const [red, green, blue] = [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16));
  return colorOf(red, green, blue);
}

const bytes = new Uint8Array(4);
const word = new Uint32Array(bytes.buffer);

/** @param {number} red @param {number} green @param {number} blue @returns {Color} */
function colorOf(red, green, blue) {
  bytes.set([red, green, blue].map(Math.round));
  bytes[3] = 255;
  return [red, green, blue, word[0]];
}
