/**
 * The tokens of tokens.css as values, for drawings: read once per change of theme or layout, not per frame.
 *
 * @typedef {import('../stage/gear/theme.js').Theme & { size: number, line: number }} Theme
 *   `size`: the small text in px; `line`: a factor for stroke widths
 */

/** The tokens that hold a color, and the name a drawing knows each by. */
const colors = /** @type {const} */ ([
  ['page', '--page'], ['surface', '--surface'], ['raised', '--raised'], ['ground', '--ground'], ['rule', '--rule'],
  ['ink', '--ink'], ['ink2', '--ink2'], ['psi', '--psi'], ['y', '--y'], ['force', '--force'],
  ['unstable', '--unstable'], ['stable', '--stable'], ['freeplay', '--freeplay'], ['freeplayText', '--freeplay-text'],
  ['ghost', '--ghost'],
]);

/**
 * @param {HTMLElement} place any element on the page
 * @returns {Theme}
 */
export function readTheme(place) {
  const probe = place.ownerDocument.createElement('span');
  probe.hidden = true;
  place.append(probe);
  const style = getComputedStyle(probe);
  // A color property resolves light-dark() to the color in force; the raw custom property would not.
  const resolved = Object.fromEntries(colors.map(([name, token]) => {
    probe.style.color = `var(${token})`;
    return [name, hex(style.color)];
  }));
  probe.style.fontSize = 'var(--size-1)';
  const theme = {
    .../** @type {Record<(typeof colors)[number][0], string>} */ (resolved),
    scheme: luma(resolved.page) < 128 ? /** @type {const} */ ('dark') : /** @type {const} */ ('light'),
    sans: style.getPropertyValue('--text').trim(),
    serif: style.getPropertyValue('--symbol').trim(),
    size: parseFloat(style.fontSize),
    line: parseFloat(style.getPropertyValue('--line')),
  };
  probe.remove();
  return theme;
}

/** @param {string} color as computed, `rgb(r, g, b)` */
function hex(color) {
  const channels = (color.match(/[\d.]+/g) ?? ['0', '0', '0']).slice(0, 3);
  return `#${channels.map((channel) => Math.round(Number(channel)).toString(16).padStart(2, '0')).join('')}`;
}

/** @param {string} color `#rrggbb` */
function luma(color) {
  const [red, green, blue] = [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16));
  return 0.3 * red + 0.6 * green + 0.1 * blue;
}
