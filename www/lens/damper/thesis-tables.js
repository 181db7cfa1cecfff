/**
 * The tables of the thesis about the damper on the gear: which gears, at which currents, from which start. Their numbers are
 * computed when they are looked at.
 *
 * @typedef {Readonly<Record<string, number>>} Values in SI
 * @typedef {{ start: number, fixed: Values, varied: readonly string[], rows: readonly Values[], shows: readonly 'torsionAngle'[], title: string }} DamperTable as the tables of the lens Cycles
 */

const degree = Math.PI / 180;
const command = 'damper.command';
const atSpeed = (/** @type {number} */ velocity, /** @type {readonly number[]} */ currents, /** @type {Values} */ more = {}) => currents.map((current) => ({ velocity, ...more, [command]: current }));

/** By their numbers: figures 7.8 to 7.14, and with a gap 7.15 to 7.26. @type {Readonly<Record<string, DamperTable>>} */
export const damperTables = {
  7.2: {
    title: '', start: 0.01, fixed: { dampingConstant: 0 }, varied: ['velocity', command],
    rows: [...atSpeed(30, [0, 0.5, 0.75, 1, 1.1]), ...atSpeed(80, [1, 1.1])], shows: ['torsionAngle'],
  },
  7.3: {
    title: '', start: 0.01, fixed: { dampingConstant: 0 }, varied: ['velocity', 'freeplayAngle', command],
    rows: [
      ...atSpeed(30, [1], { freeplayAngle: 0 }), ...[0.5, 1, 1.5].flatMap((gap) => atSpeed(30, [1, 1.1, 1.2], { freeplayAngle: gap * degree })),
      ...atSpeed(80, [1, 1.1], { freeplayAngle: 0.5 * degree }),
    ], shows: ['torsionAngle'],
  },
};

export const damperTableNumbers = ['7.2', '7.3'];

/** @param {string} text */
export const isDamperTable = (text) => damperTableNumbers.includes(text);
