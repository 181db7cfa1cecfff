/**
 * The endings of motions as colors and words.
 *
 * @typedef {import('../../pkg/shimmy.js').Basins} Basins
 * @typedef {Basins['endings'][number]} Ending
 * @typedef {import('../../style/theme.js').Theme} Theme
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

import { decimalsFor } from '../../words/number.js';

/** Colors mixed so far into the surface that what lies over them is read. */
const strengths = [0.28, 0.48, 0.16];
const tokens = /** @type {const} */ ({ rest: 'surface', rattle: 'freeplay', shimmy: 'unstable', divergence: 'ink2', unsettled: 'raised' });

/** What colors the endings have: of several of a kind each its own strength. @param {readonly Ending[]} endings @param {Theme} theme @returns {string[]} `#rrggbb` */
export function colorsOfEndings(endings, theme) {
  return endings.map(({ kind }, i) => {
    const nth = endings.slice(0, i).filter((one) => one.kind === kind).length;
    return mixed(theme.surface, theme[tokens[kind]], strengths[nth % strengths.length]);
  });
}

/** An ending in words: "shimmies, ±15.2°". @param {Ending} ending @param {Voice} voice */
export function endingInWords({ kind, high }, voice) {
  const degrees = (high * 180) / Math.PI;
  const name = voice.say(/** @type {import('../../words/voice.js').Key} */ (`basins.${kind}`));
  return kind === 'rattle' || kind === 'shimmy' ? voice.say('basins.ending', { name, amplitude: `±${voice.number(degrees, Math.min(2, decimalsFor(degrees, 3)))}°` }) : name;
}

/** Whether a motion of this kind swings on. @param {Ending} ending */
export const swingsOn = ({ kind }) => kind === 'rattle' || kind === 'shimmy' || kind === 'divergence';

/**
 * Cells that are not known yet take what the nearest that is known has.
 * @param {Uint8Array} cells 255 where it is not known
 * @param {number} columns
 */
export function spread(cells, columns) {
  const filled = cells.slice();
  let edge = Array.from(cells.keys()).filter((cell) => cells[cell] !== 255);
  while (edge.length > 0) {
    /** @type {number[]} */
    const next = [];
    for (const cell of edge) {
      const column = cell % columns;
      for (const [neighbor, isThere] of /** @type {const} */ ([[cell - 1, column > 0], [cell + 1, column < columns - 1], [cell - columns, true], [cell + columns, true]])) {
        if (!isThere || filled[neighbor] !== 255) continue;
        filled[neighbor] = filled[cell];
        next.push(neighbor);
      }
    }
    edge = next;
  }
  return filled;
}

/** @param {string} one @param {string} other @param {number} share of the other */
function mixed(one, other, share) {
  const channels = (/** @type {string} */ color) => [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16));
  const [from, to] = [channels(one), channels(other)];
  return `#${from.map((value, i) => Math.round(value + share * (to[i] - value)).toString(16).padStart(2, '0')).join('')}`;
}
