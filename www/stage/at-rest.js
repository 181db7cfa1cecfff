/**
 * The gear as it stands before the engine is there: at rest, so that no physics is needed. Its few lengths are those
 * of the engine's defaults; the picture is replaced as soon as the engine has its table.
 *
 * @type {Omit<import('./gear/scene.js').Scene, 'layout'>}
 */
export const gearAtRest = {
  state: [0, 0, 0],
  parameters: { velocity: 80, casterLength: 0.1, halfContactLength: 0.1, relaxationLength: 0.3, freeplayAngle: 0 },
  forces: { slipAngle: 0, sideForce: 0, aligningMoment: 0, sideForceLimited: false, springAngle: 0, springTorque: 0 },
  track: { distance: new Float64Array(), torsionAngle: new Float64Array(), lateralDeformation: new Float64Array() },
  roll: 0,
  exposure: 0.03,
  extremes: null,
  magnification: 1,
  forceScale: { force: 1, moment: 1 },
  trail: [],
};
