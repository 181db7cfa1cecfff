// Random numbers that a seed brings back.

/** @typedef {ReturnType<typeof randomFrom>} Random */

/**
 * A generator of 32-bit words (splitmix32, after Steele, Lea and Flood, OOPSLA 2014) and what is drawn from it.
 * @param {number} seed
 */
export function randomFrom(seed) {
  let state = seed | 0;
  const word = () => {
    state = (state + 0x9e3779b9) | 0;
    let mixed = Math.imul(state ^ (state >>> 16), 0x21f0aaad);
    mixed = Math.imul(mixed ^ (mixed >>> 15), 0x735a2d97);
    return (mixed ^ (mixed >>> 15)) >>> 0;
  };
  const fraction = () => word() / 2 ** 32;
  return {
    word,
    fraction,
    /** Whether something of this probability happens. @param {number} probability */
    chance: (probability) => fraction() < probability,
    /** A whole number from 0 up to, without, `end`. @param {number} end */
    below: (end) => Math.floor(fraction() * end),
    /** @param {number} low @param {number} high */
    between: (low, high) => low + fraction() * (high - low),
    /** @template T @param {readonly T[]} list @returns {T} */
    pick: (list) => list[Math.floor(fraction() * list.length)],
  };
}

/** The seed of one case of many, so that it can be run alone. @param {number} seed @param {number} index */
export const seedOf = (seed, index) => randomFrom(seed ^ Math.imul(index + 1, 0x9e3779b1)).word();
