/**
 * What the gear's drawing is made from. Everything is in SI units and radians; the drawing turns
 * it into pixels and degrees and changes nothing.
 *
 * Axes as in the equations: x forward (to the right on the sheet), y to the left (up on the
 * sheet), the torsion angle ψ counter-clockwise from above.
 *
 * @module
 */

/**
 * The canvas in CSS pixels. The context is already scaled for device pixels.
 *
 * @typedef {object} Size
 * @property {number} width
 * @property {number} height
 */

/** @typedef {'desktop' | 'projector' | 'phone'} LayoutName */

/**
 * The tire's forces and the spring at this instant, as the engine computes them.
 *
 * @typedef {object} Forces
 * @property {number} slipAngle α [rad]
 * @property {number} sideForce F_y [N], positive to the left
 * @property {number} aligningMoment M_z [N m], positive counter-clockwise from above
 * @property {boolean} sideForceLimited whether |α| is beyond the side force's limit angle
 * @property {number} springAngle s(ψ) [rad], the part of ψ that winds the spring
 * @property {number} springTorque k·s(ψ) [N m]
 */

/**
 * The past, oldest first and ending at or before now. {@link trackLength} in sheet.js says how
 * much of it can be seen.
 *
 * @typedef {object} Track
 * @property {Float64Array} distance that the wheel had rolled by then [m]
 * @property {Float64Array} torsionAngle ψ [rad]
 * @property {Float64Array} lateralDeformation y [m]
 */

/**
 * @typedef {object} Scene
 * @property {ArrayLike<number>} state ψ [rad], its rate [rad/s], y [m]
 * @property {Readonly<Record<string, number>>} parameters by the model's names; a model without
 *   freeplay has no `freeplayAngle`
 * @property {Forces} forces
 * @property {Track} track
 * @property {number} roll distance rolled so far [m]
 * @property {number} exposure ground traveled in one frame [m], the length of a speckle's streak
 * @property {readonly [number, number] | null} extremes lowest and highest ψ of the last cycle [rad]
 * @property {number} magnification one factor for ψ and y together: 1, 2, 5, 10, 20, 50
 * @property {{force: number, moment: number}} forceScale what the longest arrows mean [N], [N m]
 * @property {LayoutName} layout
 * @property {readonly {psi: number, y: number}[]} trail earlier poses, drawn as faint outlines
 */

/**
 * Every string of the drawing, made by words/gear.js in each language.
 *
 * @typedef {typeof import('../../words/gear.js').gearEn} GearWords
 */

export {};
