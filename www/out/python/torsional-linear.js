/**
 * The linear torsional gear as Python writes it.
 * @type {import('./model.js').PythonModel}
 */
export const torsionalLinear = {
  subject: `The torsional nose gear on a stretched-string tire, linearized: G. Somieski, Aerospace Science and
Technology 8 (1997) 545-555. SI units and radians:

    I_z ψ'' = -k ψ - (c + κ/v) ψ' + M_z - e F_y
    y'      = v ψ + (e - a) ψ' - (v/σ) y
    α       = y/σ
    F_y     = c_Fα F_z α
    M_z     = -c_Mα F_z α`,
  imports: [],
  rates: `def rates(time, state):
    """The equations above."""
    ψ, ψ_rate, y = state

    α = y / σ
    F_y = c_Fα * F_z * α
    M_z = -c_Mα * F_z * α

    ψ_acceleration = (-k * ψ - (c + κ / v) * ψ_rate + M_z - e * F_y) / I_z
    y_rate = v * ψ + (e - a) * ψ_rate - v / σ * y
    return ψ_rate, ψ_acceleration, y_rate`,
  load: `def load(ψ, y):
    """The moments on a wheel that does not turn, but for friction."""
    α = y / σ
    F_y = c_Fα * F_z * α
    M_z = -c_Mα * F_z * α
    return -k * ψ + M_z - e * F_y`,
};
