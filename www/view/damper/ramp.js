/**
 * A color between two.
 * @param {string} from `#rrggbb`
 * @param {string} to
 * @param {number} share 0 … 1
 */
export function mix(from, to, share) {
  const channel = (/** @type {string} */ color, /** @type {number} */ at) => parseInt(color.slice(at, at + 2), 16);
  return `#${[1, 3, 5].map((at) => Math.round(channel(from, at) + (channel(to, at) - channel(from, at)) * share).toString(16).padStart(2, '0')).join('')}`;
}
