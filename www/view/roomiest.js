/**
 * Room for a word in each region of a plane.
 *
 * @typedef {import('./axes.js').Box} Box
 * @typedef {{ width: number, height: number }} Size
 */

/** How finely room is looked for, in parts of a word's height. */
const fineness = 3;

/**
 * Where each region has the most room for its word; regions without room for theirs have no place.
 * @param {Box} box
 * @param {(across: number, up: number) => string} regionAt of places from 0 to 1 to the right and upward
 * @param {Readonly<Record<string, Size>>} words how large the word of each region is
 * @returns {Record<string, { x: number, y: number }>} the middle of each word, in px
 */
export function roomiest({ left, right, top, bottom }, regionAt, words) {
  /** @type {Record<string, { x: number, y: number }>} */
  const places = {};
  for (const [region, { width, height }] of Object.entries(words)) {
    // Cells as wide to their height as the word, so that a square of them is room for it.
    const [cellWidth, cellHeight] = [width / fineness, height / fineness];
    const columns = Math.floor((right - left) / cellWidth);
    const rows = Math.floor((bottom - top) / cellHeight);
    let before = new Uint16Array(columns + 1);
    let best = fineness - 1;
    for (let row = 0; row < rows; row++) {
      const sides = new Uint16Array(columns + 1);
      for (let column = 0; column < columns; column++) {
        if (regionAt((column + 0.5) / columns, (row + 0.5) / rows) !== region) continue;
        const side = 1 + Math.min(sides[column], before[column], before[column + 1]);
        sides[column + 1] = side;
        if (side <= best) continue;
        best = side;
        places[region] = { x: left + (column + 1 - side / 2) * ((right - left) / columns), y: bottom - (row + 1 - side / 2) * ((bottom - top) / rows) };
      }
      before = sides;
    }
  }
  return places;
}
