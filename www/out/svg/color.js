/**
 * A canvas color as SVG programs outside of browsers read it: the color and its opacity apart.
 * @param {string} color `#rgb`, `#rrggbb`, `#rrggbbaa`, `rgb(…)`, `rgba(…)` or a name
 * @returns {{ color: string, opacity: number }}
 */
export function svgColor(color) {
  if (/^#[\da-f]{8}$/i.test(color)) return { color: color.slice(0, 7), opacity: parseInt(color.slice(7), 16) / 255 };
  const channels = /^rgba?\(([^)]+)\)$/i.exec(color)?.[1].split(/[\s,/]+/).filter(Boolean);
  if (!channels) return { color, opacity: 1 };
  const [red, green, blue, alpha = '1'] = channels;
  const opacity = alpha.endsWith('%') ? parseFloat(alpha) / 100 : Number(alpha);
  return { color: `rgb(${red}, ${green}, ${blue})`, opacity };
}
