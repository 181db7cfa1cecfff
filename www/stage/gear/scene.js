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

/**
 * @typedef {'desktop' | 'projector' | 'phone' | 'phone-side' | 'big'} LayoutName `phone`: the top view alone, `phone-side`:
 *   the other; `big`: the top view under a big verdict
 */

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
 * @property {number} [frictionTorque] of dry friction on the wheel [N m], positive counter-clockwise from above
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
 * The parameters that the drawing reads, by the models' names. Any of them may be missing:
 * - `casterLength` (0), `halfContactLength` (0.1 m), `relaxationLength` (0.3 m): what is drawn
 *   without them stands in brackets;
 * - `velocity`: without it no speed is written;
 * - `freeplayAngle`: without it, or at 0, the slot in the steering head is closed;
 * - `torsionalStiffness`, `dampingConstant`: at 0 the spring, the damper is but a shadow;
 * - `friction.moment`: above 0 a shoe rubs on the tube;
 * - `damper.command`: of a magnetorheological damper; without it the damper has no coil.
 *
 * @typedef {Readonly<Record<string, number>>} Parameters
 */

/**
 * A second run in lockstep, of which the wheel's outline and its track are drawn, dashed.
 *
 * @typedef {object} Ghost
 * @property {ArrayLike<number>} state as the scene's
 * @property {Parameters} parameters
 * @property {Track} track
 * @property {number} [roll] distance that it has rolled [m], where that is not the scene's
 * @property {string} [label] what sets it apart, such as "c = 60"
 * @property {boolean} [isMode] whether it is a mode of the gear, which is what one looks at just then
 */

/**
 * @typedef {object} Scene
 * @property {ArrayLike<number>} state ψ [rad], its rate [rad/s], y [m]
 * @property {Parameters} parameters
 * @property {Forces} forces
 * @property {Track} track
 * @property {number} roll distance rolled so far [m]
 * @property {number} exposure ground traveled in one frame [m], the length of a speckle's streak
 * @property {readonly [number, number] | null} extremes lowest and highest ψ of the last cycle [rad]
 * @property {number} magnification one factor for ψ and y together: 1, 2, 5, 10, 20, 50
 * @property {{force: number, moment: number}} forceScale what the longest arrows mean [N], [N m]
 * @property {LayoutName} layout
 * @property {readonly {psi: number, y: number}[]} trail earlier poses, drawn as faint outlines
 * @property {readonly Ghost[]} [ghosts]
 * @property {readonly {psi: number, y: number}[] | null} [fan] where the motion is too fast for the
 *   screen: poses equally spaced over the frame's exposure, the last of them now. They are drawn
 *   as one blur, and nothing is drawn that would show a single pose: no ghosts, trail or forces
 * @property {number} [command] of a magnetorheological damper as it is now, where a control changes it [A]
 * @property {boolean} [held] whether a hand has hold of the wheel
 * @property {boolean} [focused] whether the keyboard would move it
 */

/**
 * Every string of the drawing, made by words/gear.js in each language.
 *
 * @typedef {typeof import('../../words/gear.js').gearEn} GearWords
 */

export {};
