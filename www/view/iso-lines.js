/**
 * Lines along which a field has one value.
 *
 * @typedef {import('./field.js').Field} Field
 * @typedef {{ across: number[], up: number[] }} Line places from 0 to 1; of a closed line the last is the first
 */

/**
 * @param {Field} field cells without a number have no lines through them
 * @param {readonly number[]} levels ascending
 * @returns {Line[][]} the lines of each level
 */
export function isoLinesOf(field, levels) {
  const { values, columns, rows } = field;
  /** Of each level, from each crossed edge the edges that a cell joins to it. @type {Map<number, number[]>[]} */
  const joined = levels.map(() => new Map());
  const lowest = levels[0];
  for (let row = 0; row < rows - 1; row++) {
    for (let column = 0; column < columns - 1; column++) {
      const at = row * columns + column;
      const a = values[at];
      const b = values[at + 1];
      const c = values[at + columns + 1];
      const d = values[at + columns];
      // Nearly all cells are passed by: nothing may be made for them.
      const most = Math.max(a, b, c, d);
      if (!(most > lowest)) continue;
      const least = Math.min(a, b, c, d);
      for (let i = 0; i < levels.length && levels[i] < most; i++)
        if (levels[i] >= least) joinEdges(joined[i], at, columns, levels[i], [a, b, c, d]);
    }
  }
  return joined.map((edges, i) => linesThrough(edges).map((line) => placesOf(line, field, levels[i])));
}

/**
 * Joins the edges that a level crosses around a cell.
 * @param {Map<number, number[]>} joined
 * @param {number} at the cell's lower left corner @param {number} columns
 * @param {number} level
 * @param {[number, number, number, number]} corners from there counter-clockwise
 */
function joinEdges(joined, at, columns, level, corners) {
  const join = (/** @type {number} */ one, /** @type {number} */ other) => {
    joined.get(one)?.push(other) ?? joined.set(one, [other]);
    joined.get(other)?.push(one) ?? joined.set(other, [one]);
  };
  const above = corners.map((value) => value > level);
  // Edges are numbered by their left or lower corner: even to the right, odd upward.
  const edges = [2 * at, 2 * (at + 1) + 1, 2 * (at + columns), 2 * at + 1].filter((_, side) => above[side] !== above[(side + 1) % 4]);
  if (edges.length === 2) join(edges[0], edges[1]);
  if (edges.length < 4) return;
  // A saddle: its middle tells which two corners belong together.
  const isFirstCut = (corners.reduce((sum, value) => sum + value, 0) > 4 * level) !== above[0];
  join(edges[0], edges[isFirstCut ? 3 : 1]);
  join(edges[isFirstCut ? 1 : 2], edges[isFirstCut ? 2 : 3]);
}

/** Chains of joined edges, open ones from their ends. @param {Map<number, number[]>} joined */
function linesThrough(joined) {
  /** @type {number[][]} */
  const lines = [];
  const seen = new Set();
  const starts = [...[...joined].filter(([, others]) => others.length === 1).map(([edge]) => edge), ...joined.keys()];
  for (const start of starts) {
    if (seen.has(start)) continue;
    const line = [start];
    seen.add(start);
    for (let edge = start; ;) {
      const next = joined.get(edge)?.find((other) => !seen.has(other));
      if (next === undefined) break;
      seen.add(next);
      line.push(next);
      edge = next;
    }
    if (line.length > 2 && joined.get(line[line.length - 1])?.includes(start)) line.push(start);
    lines.push(line);
  }
  return lines;
}

/** @param {number[]} edges @param {Field} field @param {number} level @returns {Line} */
function placesOf(edges, { values, columns, rows }, level) {
  /** @type {Line} */
  const line = { across: [], up: [] };
  for (const edge of edges) {
    const at = edge >> 1;
    const isUpward = edge & 1;
    const share = (level - values[at]) / (values[at + (isUpward ? columns : 1)] - values[at]);
    line.across.push(((at % columns) + (isUpward ? 0 : share) + 0.5) / columns);
    line.up.push((Math.floor(at / columns) + (isUpward ? share : 0) + 0.5) / rows);
  }
  return line;
}
