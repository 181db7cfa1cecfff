/**
 * Where a gear has two motions to choose from: rest and a cycle, both stable. Its start decides.
 *
 * @typedef {import('../../pkg/shimmy.js').Bifurcation} Bifurcation
 * @typedef {import('../../run/linear-looks.js').Range} Range
 * @typedef {readonly (readonly [from: number, to: number])[]} Spans of a range, as shares of it from its beginning; ascending, apart
 */

import { lineOf, restOf } from './diagram.js';

/** Less is the point itself at which cycles are born, as a share of the range. */
const narrowest = 2e-3;

/**
 * @param {Bifurcation} diagram
 * @param {Range} range
 * @param {number} friction of the gear, in N m: what it holds is at rest
 * @returns {Spans}
 */
export function twoAlong(diagram, { from, to }, friction) {
  const share = (/** @type {number} */ value) => (value - from) / (to - from);
  const cycles = joined(diagram.cycles.flatMap((_, i) => stableSpans(lineOf(diagram, i, 'torsionAngle'), share)));
  const rest = joined(stableSpans(restOf(diagram, 'torsionAngle', friction), share));
  return cycles.flatMap(([start, end]) => rest.map(([first, last]) => /** @type {const} */ ([Math.max(start, first), Math.min(end, last)])))
    .filter(([start, end]) => end - start > narrowest);
}

/**
 * Whether there are two motions at a place, between the rows of a plane as they are at the middle of each.
 * @param {readonly Spans[]} rows from the lowest
 * @param {number} across 0 … 1
 * @param {number} up 0 … 1
 */
export function hasTwoAt(rows, across, up) {
  const row = Math.min(Math.max(up * rows.length - 0.5, 0), rows.length - 1);
  const below = Math.min(Math.floor(row), Math.max(0, rows.length - 2));
  const [lower, upper] = [rows[below], rows[below + 1] ?? rows[below]];
  const share = row - below;
  // Where a span ends between two rows it ends in the middle.
  const spans = lower.length === upper.length
    ? lower.map(([from, to], i) => [from + share * (upper[i][0] - from), to + share * (upper[i][1] - to)])
    : share < 0.5 ? lower : upper;
  return spans.some(([from, to]) => across >= from && across <= to);
}

/** The stable pieces of a line. @param {import('../../view/bifurcation.js').Line} line @param {(value: number) => number} share @returns {[number, number][]} */
function stableSpans({ across, stable, turns }, share) {
  return Array.from(across).slice(1).flatMap((value, i) => {
    // A piece is as stable as that end of it at which nothing turns.
    if (stable[turns.includes(i + 1) ? i : i + 1] !== 1) return [];
    const ends = [across[i], value].map((one) => Math.min(Math.max(share(one), 0), 1));
    return [[Math.min(...ends), Math.max(...ends)]];
  });
}

/** Those that touch are one. @param {[number, number][]} spans @returns {Spans} */
function joined(spans) {
  /** @type {[number, number][]} */
  const apart = [];
  for (const [from, to] of spans.sort(([one], [other]) => one - other)) {
    const last = apart.at(-1);
    if (last && from <= last[1] + 1e-9) last[1] = Math.max(last[1], to);
    else apart.push([from, to]);
  }
  return apart;
}
