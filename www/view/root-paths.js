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
  if (sets.length === 0) return [];
  let before = [...sets[0]];
  const paths = before.map((root) => [root]);
  for (const roots of sets.slice(1)) {
    before = inOrderOf(before, roots);
    before.forEach((root, i) => paths[i].push(root));
  }
  return paths;
}
