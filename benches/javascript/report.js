// What `npm run bench` prints of its measurements.

/**
 * One solver's place in the contest.
 * @typedef {object} Entry
 * @property {string} solver
 * @property {boolean} [gaveUp]
 * @property {number} tolerance
 * @property {boolean} met  whether both errors are within what is allowed
 * @property {number[]} errors
 * @property {number} milliseconds
 * @property {number | null} steps
 * @property {number | null} evaluations
 */

/** How the names of our own entries begin. */
const OURS = { wasm: 'shimmy, wasm in Node', native: 'shimmy, native (plain flags)', thisCpu: 'shimmy, native (this CPU)' };

/** Formats columns: the first to the left, the others to the right. @param {string[][]} rows */
function table(rows) {
  const widths = rows[0].map((_, column) => Math.max(...rows.map((row) => row[column].length)));
  return rows
    .map((row) => row.map((cell, i) => (i ? cell.padStart(widths[i]) : cell.padEnd(widths[i]))).join('  ').trimEnd())
    .join('\n');
}

/** @param {number | null | undefined} value @param {number} [digits] */
const number = (value, digits = 3) => (value == null ? '' : Number(value.toPrecision(digits)).toString());

/** @param {number | null} value */
const count = (value) => (value == null ? '' : value.toLocaleString('en-US'));

/** @param {number} value */
const power = (value) => value.toExponential(1);

/** @param {number[]} values */
export const powers = (values) => values.map(power).join(' and ');

/** @param {{ milliseconds: number, evaluations: number | null }} measured */
const perEvaluation = ({ milliseconds, evaluations }) => (evaluations ? number((milliseconds * 1e6) / evaluations) : '');

/** @param {Entry[]} entries @param {string} start */
const entryOf = (entries, start) => entries.find(({ solver, gaveUp }) => solver.startsWith(start) && !gaveUp);

/** @param {Entry[]} entries */
export function contest(entries) {
  const ours = entryOf(entries, OURS.wasm);
  const rows = entries.map((entry) => {
    if (entry.gaveUp) return [entry.solver, 'gave up', '', '', '', '', '', '', ''];
    const { solver, tolerance, met, errors, milliseconds, steps, evaluations } = entry;
    const ratio = ours ? `${number(milliseconds / ours.milliseconds)} ×` : '';
    return [
      solver, power(tolerance), power(errors[0]), `${power(errors[1])}${met ? '' : ' (its best)'}`,
      count(steps), count(evaluations), perEvaluation(entry), number(milliseconds), ratio,
    ];
  });
  const head = ['solver', 'tolerance', 'error at 0.2 s', 'at 6 s', 'steps', 'right-hand sides', 'ns each', 'ms', 'of ours'];
  return `The torsional gear from 0.01 rad at 80 m/s and c = 20, 0 to 6 s, at the loosest tolerance with an error of at most
1e-8 at 0.2 s and 1e-5 at 6 s, relative to the amplitudes of the cycle; the shortest of many runs.
${table([head, ...rows])}`;
}

/** @param {Entry[]} entries */
export function goals(entries) {
  const [wasm, native, thisCpu] = [OURS.wasm, OURS.native, OURS.thisCpu].map((name) => entryOf(entries, name));
  if (!wasm) return 'Our own entry is missing: no goal to compare.';
  const javascript = ['Dormand-Prince by hand', 'ode45-cash-karp', 'odex'].map((name) => entryOf(entries, name));
  const libraries = javascript.slice(1).map((entry) => entry?.milliseconds ?? Infinity);
  /** @param {Entry | undefined} over @param {Entry | undefined} under */
  const ratio = (over, under) => (over && under ? over.milliseconds / under.milliseconds : null);
  const cyrk = ratio(entryOf(entries, 'CyRK'), wasm);
  const lines = [
    ['wasm in Node', `${number(wasm.milliseconds)} ms`, '≤ 1.5 ms'],
    ['wasm over native, plain flags', number(ratio(wasm, native)), '≤ 1.0'],
    ['wasm over native, this CPU', number(ratio(wasm, thisCpu)), '≤ 1.1'],
    ['best JavaScript library over wasm', number(Math.min(...libraries) / wasm.milliseconds), '≥ 7'],
    ['SciPy RK45 over wasm', number(ratio(entryOf(entries, 'SciPy RK45'), wasm)), '≥ 600'],
    ['SciPy LSODA over wasm', number(ratio(entryOf(entries, 'SciPy LSODA'), wasm)), '≥ 350'],
    ['CyRK with numba over wasm', number(cyrk), '≥ 10'],
  ];
  return table([['against the goals', 'measured', 'goal'], ...lines.map(([what, value, goal]) => [what, value || 'not run', goal])]);
}

/** @param {(Entry & { method: string, rtol?: number, step?: number })[]} rows */
export function workAndPrecision(rows) {
  const head = ['method', 'rtol or step', 'error at 0.2 s', 'at 6 s', 'steps', 'right-hand sides', 'ns each', 'ms'];
  return `Work against precision, the module in Node:\n${table([
    head,
    ...rows.map((row) => [
      row.method, row.rtol ? power(row.rtol) : `${power(row.step ?? 0)} s`, power(row.errors[0]), power(row.errors[1]),
      count(row.steps), count(row.evaluations), perEvaluation(row), number(row.milliseconds),
    ]),
  ])}`;
}

/** @param {import('./maps.js').Row[]} rows */
export function maps(rows) {
  const head = ['stability maps', 'cells', 'ms', 'ns a cell', 'stable', 'goal'];
  return `Maps of the torsional gear, all of one run; the shortest of many.\n${table([
    head,
    ...rows.map(({ what, cells, milliseconds, percent, goal }) => [
      what, cells ? count(cells) : '', number(milliseconds), cells ? number((milliseconds * 1e6) / cells) : '',
      percent == null ? '' : `${percent.toFixed(2)} %`, goal ?? '',
    ]),
  ])}`;
}

/** @param {import('./branches.js').Row[]} rows */
export function branches(rows) {
  const head = ['branches of limit cycles', 'cycles', 'ms', 'ms a cycle', 'goal'];
  return `Branches of limit cycles with amplitudes and multipliers, all of one run; the shortest of many.\n${table([
    head,
    ...rows.map(({ what, points, milliseconds, goal }) => [what, count(points), number(milliseconds), number(milliseconds / points), goal ?? '']),
  ])}`;
}

/** @param {import('./ensembles.js').Row[]} rows */
export function ensembles(rows) {
  const head = ['ensembles', 'two-second trajectories a second', 'goal'];
  return `The torsional gear at its critical speed, the classical method with steps of a hundredth of a swing; the shortest of many.\n${table([
    head, ...rows.map(({ what, perSecond, goal }) => [what, count(Math.round(perSecond)), goal ?? '']),
  ])}`;
}

/** @param {import('./identification.js').Row[]} rows */
export function identifications(rows) {
  const head = ['identifications', 'generations a second', 'goal'];
  return `A damper's values from four records of 500 samples, 60 individuals, one core; the first 60 generations of a few seeds.\n${table([
    head, ...rows.map(({ what, perSecond, goal }) => [what, count(Math.round(perSecond)), goal ?? '']),
  ])}`;
}

/** @param {{ place: string, first: number, least: number }[]} all */
export const warmUps = (all) =>
  all
    .map(({ place, first, least }) => `${place}: the first call of a fresh module takes ${number(first)} ms, later ones ${number(least)} ms: it begins in the engine's baseline compiler.`)
    .join('\n');

/** @param {number} raw @param {number} gzip @param {number} brotli */
export const bytes = (raw, gzip, brotli) =>
  `The module: ${[raw, gzip, brotli].map((size) => `${number(size / 1000)} kB`).join(', ')} (plain, gzip, brotli); the goal with everything in it is 120 kB in brotli.`;
