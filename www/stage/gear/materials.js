/**
 * What the gear is made of: rubber and metal, in daylight and at night. They carry no meaning, so
 * they are no tokens of the page.
 *
 * @typedef {object} Materials
 * @property {string} rubber
 * @property {string} rubberLit where the tread faces the sky
 * @property {string} rubberShine edges that catch the light
 * @property {string} rubberEdge outline, against the ground
 * @property {string} groove
 * @property {string} metal
 * @property {string} metalLit
 * @property {string} metalShade
 * @property {string} metalEdge
 * @property {string} chrome the light on the sliding tube
 * @property {string} shadow
 * @property {string} mark what the tire leaves on the ground
 */

/** @type {Readonly<Record<'light' | 'dark', Materials>>} */
const MATERIALS = {
  light: {
    rubber: '#262C33',
    rubberLit: '#56606B',
    rubberShine: '#7E8995',
    rubberEdge: '#1B2127',
    groove: '#20262C',
    metal: '#C3CBD3',
    metalLit: '#F1F4F6',
    metalShade: '#98A3AE',
    metalEdge: '#3B4753',
    chrome: '#FFFFFF',
    shadow: '#14202B',
    mark: '#4A5058',
  },
  dark: {
    rubber: '#06080B',
    rubberLit: '#343E49',
    rubberShine: '#65727F',
    rubberEdge: '#7C8996',
    groove: '#000000',
    metal: '#5B6875',
    metalLit: '#93A1AE',
    metalShade: '#3B4650',
    metalEdge: '#B9C4CD',
    chrome: '#C9D3DB',
    shadow: '#000000',
    mark: '#05080B',
  },
};

/**
 * @param {import('./theme.js').Theme} theme
 * @returns {Materials}
 */
export function materialsFor(theme) {
  return MATERIALS[theme.scheme];
}
