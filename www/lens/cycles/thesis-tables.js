/**
 * The tables of the thesis about cycles: which gears, from which start. Their numbers are computed when they are looked at.
 *
 * @typedef {import('../../run/cycle-looks.js').CycleLooks} CycleLooks
 * @typedef {Readonly<Record<string, number>>} Values in SI
 * @typedef {'torsionAngle' | 'torsionRate' | 'lateralDeformation'} StateName
 * @typedef {{
 *   title: string, start: number, fixed: Values, varied: readonly string[], rows: readonly Values[], shows: readonly StateName[], perGap?: boolean,
 * }} ThesisTable `title`: as the atlas has it; `start`: ψ(0) in rad; `fixed`: what all its gears have; `varied`: what sets them
 *   apart, `rows`: the values of that; `shows`: amplitudes; `perGap`: also as multiples of the gap
 * @typedef {{ verdict: import('../../engine/engine.js').Outlook['verdict'], amplitude: Readonly<Record<string, number>>, frequency: number | null }} Settled
 *   what becomes of a start; the amplitudes are 0 where it rests
 */

const degree = Math.PI / 180;
const all = /** @type {const} */ (['torsionAngle', 'torsionRate', 'lateralDeformation']);
const speedAndDamping = /** @type {const} */ ([[30, 10], [40, 10], [50, 10], [50, 20], [70, 20], [100, 20]]).map(([velocity, dampingConstant]) => ({ velocity, dampingConstant }));
const gaps = [0, 0.5, 1, 1.5].map((half) => ({ freeplayAngle: half * degree }));

/** @param {number} start @param {number} torsionalStiffness @returns {ThesisTable} */
const amplitudes = (start, torsionalStiffness) => ({
  title: `limit cycle amplitudes, psi(0) = ${start}, k = ${torsionalStiffness}`, start, fixed: { torsionalStiffness }, varied: ['velocity', 'dampingConstant'], rows: speedAndDamping, shows: all,
});

/** @param {number} start @param {StateName} state @returns {ThesisTable} */
const rattle = (start, state) => ({
  title: '', start, fixed: { velocity: 50, dampingConstant: 100 }, varied: ['freeplayAngle'], rows: gaps, shows: [state], perGap: true,
});

/** By their numbers. @type {Readonly<Record<string, ThesisTable>>} */
export const thesisTables = {
  5.8: amplitudes(0.01, 100_000),
  5.9: amplitudes(0.01, 75_000),
  '5.10': amplitudes(1, 100_000),
  5.11: amplitudes(1, 75_000),
  5.12: { title: '', start: 0.01, fixed: { velocity: 80 }, varied: ['dampingConstant'], rows: [10, 20, 30, 40, 50, 70].map((dampingConstant) => ({ dampingConstant })), shows: all },
  5.13: { title: '', start: 0.01, fixed: { dampingConstant: 30 }, varied: ['velocity'], rows: [80, 70, 60, 50, 40, 30].map((velocity) => ({ velocity })), shows: all },
  6.1: rattle(0.01, 'torsionAngle'),
  6.2: {
    ...rattle(0.1, 'torsionAngle'), fixed: { dampingConstant: 100 }, varied: ['velocity', 'freeplayAngle'],
    rows: [...gaps.map((gap) => ({ velocity: 50, ...gap })), ...gaps.slice(1).map((gap) => ({ velocity: 80, ...gap }))],
  },
  6.3: rattle(0.01, 'lateralDeformation'),
  6.4: rattle(0.1, 'lateralDeformation'),
  6.5: { ...rattle(0.01, 'torsionAngle'), fixed: { velocity: 50, dampingConstant: 30 }, shows: all, perGap: false },
};

/** In their order: an object's keys that are whole numbers would come first. */
export const tableNumbers = ['5.8', '5.9', '5.10', '5.11', '5.12', '5.13', '6.1', '6.2', '6.3', '6.4', '6.5'];

/** The table that a setting names; the first where it names none. @param {readonly string[]} numbers @param {string} text */
export const chosenOf = (numbers, text) => (numbers.includes(text) ? text : numbers[0]);

/** What becomes of a gear of a table. @param {CycleLooks} cycles @param {ThesisTable} table @param {Values} row @returns {Settled} */
export function settledOf(cycles, { start, fixed }, row) {
  const { verdict, amplitude, frequency } = cycles.outlook({ torsionAngle: start }, { ...fixed, ...row });
  const swings = verdict === 'shimmies' || verdict === 'rattles';
  return { verdict, amplitude: swings ? amplitude : Object.fromEntries(all.map((name) => [name, verdict === 'grows' ? Infinity : 0])), frequency: swings ? frequency : null };
}
