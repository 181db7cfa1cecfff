// The torsional gear as a textbook writes it: what a user of a library for JavaScript would type.

const CASTER = 0.1;
const HALF_CONTACT = 0.1;
const RELAXATION = 0.3;
const INERTIA = 1;
const STIFFNESS = 100_000;
const LOAD = 9_000;
const SIDE = 20;
const ALIGNING = 2;
const SIDE_LIMIT = (5 * Math.PI) / 180;
const ALIGNING_LIMIT = (10 * Math.PI) / 180;
const TREAD = 270;

/**
 * The rate of (psi, its rate, y), written into `rate`; the defaults of the gear but for speed and damping.
 * @param {number} velocity
 * @param {number} damping
 * @returns {(rate: Float64Array | number[], state: ArrayLike<number>) => void}
 */
export const gear = (velocity, damping) => (rate, state) => {
  const psi = state[0], psiRate = state[1], y = state[2];
  const alpha = Math.atan(y / RELAXATION);
  const sideForce = SIDE * LOAD * (alpha > SIDE_LIMIT ? SIDE_LIMIT : alpha < -SIDE_LIMIT ? -SIDE_LIMIT : alpha);
  const aligningMoment = Math.abs(alpha) <= ALIGNING_LIMIT
    ? -ALIGNING * LOAD * (ALIGNING_LIMIT / Math.PI) * Math.sin((Math.PI * alpha) / ALIGNING_LIMIT)
    : 0;
  const torque = -STIFFNESS * psi - (damping + TREAD / velocity) * psiRate + aligningMoment - CASTER * sideForce;
  rate[0] = psiRate;
  rate[1] = torque / INERTIA;
  rate[2] = velocity * psi + (CASTER - HALF_CONTACT) * psiRate - (velocity / RELAXATION) * y;
};
