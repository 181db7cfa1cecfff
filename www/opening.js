/**
 * What a newcomer sees first: a gear that shimmies, let go from a small angle. All else is at the engine's defaults.
 *
 * @typedef {import('./store.js').State} State
 */

/** Values that differ from the engine's defaults. @type {Readonly<Record<string, number>>} */
export const openingParameters = { velocity: 80, dampingConstant: 20 };

/** @type {State['run']} */
export const openingRun = { initial: { torsionAngle: 0.05 } };

export const openingObject = 'torsional';
