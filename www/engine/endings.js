/**
 * The endings of basins that were made tile by tile: each tile tells apart what it has seen, by a rule that gives the same
 * for the whole as for its parts.
 *
 * @typedef {import('../pkg/shimmy.js').Basins} Basins
 * @typedef {Basins['endings'][number]} Ending
 */

/**
 * Endings of a kind whose amplitudes are not a part apart are one.
 * @param {readonly Ending[]} endings
 * @param {number} apart 0.02, say; 1 where each kind is one ending
 * @returns {Ending[]}
 */
export function joinedEndings(endings, apart) {
  /** @type {Ending[]} */
  const joined = [];
  for (const ending of endings.toSorted((a, b) => order(a) - order(b) || a.low - b.low)) {
    const last = joined.at(-1);
    if (last?.kind === ending.kind && (apart >= 1 || ending.low * (1 - apart) <= last.high)) {
      last.high = Math.max(last.high, ending.high);
      last.cells += ending.cells;
    } else {
      joined.push({ ...ending });
    }
  }
  return joined;
}

const kinds = ['rest', 'rattle', 'shimmy', 'divergence', 'unsettled'];
const order = (/** @type {Ending} */ { kind }) => kinds.indexOf(kind);

/** The place of each cell's ending; 255 where it is not known. @param {Pick<Basins, 'kind' | 'kinds' | 'amplitude' | 'endings'>} basins */
export const placesOf = ({ kind, kinds: names, amplitude, endings }) =>
  kind.map((number, cell) => {
    const place = endings.findIndex((ending) => ending.kind === names[number] && ending.low <= amplitude[cell] && amplitude[cell] <= ending.high);
    return place < 0 ? 255 : place;
  });
