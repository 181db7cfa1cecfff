/**
 * A run as a file: `simulate` takes what `JSON.parse` makes of it as it is.
 * @param {import('./run-of.js').WholeRun} run
 */
export function runJson(run) {
  return `${JSON.stringify(run, null, 2)}\n`;
}
