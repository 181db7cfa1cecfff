/**
 * Roots followed from one set of values to the next.
 *
 * @typedef {{ re: number, im: number }} Root
 */

/**
 * The roots in the order of those before: each goes on from the one that it is nearest to.
 * @param {readonly Root[]} before
 * @param {readonly Root[]} roots as many
 * @returns {Root[]}
 */
export function inOrderOf(before, roots) {
  const left = [...roots];
  // The nearest pair of all first, or one root could take what belongs to another.
  const wanted = before.flatMap((root, i) => roots.map((other) => ({ i, other, far: (root.re - other.re) ** 2 + (root.im - other.im) ** 2 })))
    .sort((one, other) => one.far - other.far);
  /** @type {Root[]} */
  const ordered = [];
  for (const { i, other } of wanted) {
    if (ordered[i] || !left.includes(other)) continue;
    ordered[i] = other;
    left.splice(left.indexOf(other), 1);
  }
  return ordered;
}

/**
 * Each root's way through sets of roots.
 * @param {readonly (readonly Root[])[]} sets
 * @returns {Root[][]}
 */
export function pathsThrough(sets) {
  /** @type {(readonly Root[])[]} */
  const ordered = [];
  for (const [i, roots] of sets.entries()) ordered.push(i === 0 ? roots : inOrderOf(ordered[i - 1], roots));
  return pathsOf(ordered);
}

/**
 * The same of sets whose roots already go on from each other.
 * @param {readonly (readonly Root[])[]} sets
 * @returns {Root[][]}
 */
export function pathsOf(sets) {
  return (sets[0] ?? []).map((_, i) => sets.map((roots) => roots[i]));
}
