/**
 * Lines at 45°: what is unstable is told by them, whatever colors an eye sees.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {import('../style/theme.js').Theme} Theme
 */

/** From line to line, in px. */
const spacing = 8;
/** How finely the lines are looked along, in px, and how often an end is halved. */
const stride = 3;
const halvings = 5;

/**
 * The pieces of the lines that lie inside.
 * @param {Box} box
 * @param {(across: number, up: number) => boolean} isInside of places from 0 to 1 to the right and upward in the box
 * @param {Theme} theme
 * @returns {Float32Array} x and y of each piece's lower and upper end, in px
 */
export function hatchOf(box, isInside, { line }) {
  const { left, right, top, bottom } = box;
  const [width, height] = [right - left, bottom - top];
  /** @type {number[]} */
  const ends = [];
  const step = spacing * line;
  // Lines stand still when the box is moved by whole steps, and start from its corner.
  for (let start = -height; start < width; start += step) {
    // Along the line: `along` px to the right and as many up from (start, bottom).
    const inside = (/** @type {number} */ along) => isInside((start + along) / width, along / height);
    const [first, last] = [Math.max(0, -start), Math.min(height, width - start)];
    let wasInside = inside(first);
    let begun = first;
    for (let from = first; from < last; from += stride) {
      const to = Math.min(from + stride, last);
      const isNow = inside(to);
      if (isNow !== wasInside) {
        const edge = edgeBetween(inside, from, to, wasInside);
        if (isNow) begun = edge;
        else ends.push(left + start + begun, bottom - begun, left + start + edge, bottom - edge);
      }
      wasInside = isNow;
    }
    if (wasInside && last > begun) ends.push(left + start + begun, bottom - begun, left + start + last, bottom - last);
  }
  return Float32Array.from(ends);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Float32Array} ends as `hatchOf` gives them
 * @param {Theme} theme
 * @param {string} [color]
 */
export function drawHatch(context, ends, theme, color = theme.unstable) {
  context.strokeStyle = color;
  context.lineWidth = theme.line;
  const { globalAlpha } = context;
  context.globalAlpha = globalAlpha * (theme.scheme === 'dark' ? 0.5 : 0.55);
  context.beginPath();
  for (let i = 0; i < ends.length; i += 4) {
    context.moveTo(ends[i], ends[i + 1]);
    context.lineTo(ends[i + 2], ends[i + 3]);
  }
  context.stroke();
  context.globalAlpha = globalAlpha;
}

/** @param {(along: number) => boolean} inside @param {number} from @param {number} to @param {boolean} isFromInside */
function edgeBetween(inside, from, to, isFromInside) {
  for (let i = 0; i < halvings; i++) {
    const middle = (from + to) / 2;
    if (inside(middle) === isFromInside) from = middle;
    else to = middle;
  }
  return (from + to) / 2;
}
