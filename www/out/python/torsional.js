/**
 * The torsional gear as Python writes it. Text for others to check the engine with: the page itself computes nothing
 * from it.
 * @type {import('./model.js').PythonModel}
 */
export const torsional = {
  subject: `The torsional nose gear on a stretched-string tire: G. Somieski, Aerospace Science and Technology 8
(1997) 545-555; used by E. Atabay, Dynamics of a Landing Gear Mechanism, Istanbul Technical University,
2012, ch. 5 and 6. SI units and radians:

    I_z ψ'' = -k s(ψ) - (c + κ/v) ψ' + M_z(α) - e F_y(α)
    y'      = v ψ + (e - a) ψ' - (v/σ) y
    α       = arctan(y/σ)
    F_y     = c_Fα F_z α                        up to |α| = δ, constant beyond
    M_z     = -c_Mα F_z (α_g/π) sin(π α/α_g)    up to |α| = α_g, zero beyond
    s(ψ)    = ψ less the gap, in which it is zero: |ψ| < ψ_fp`,
  imports: ['atan', 'pi', 'sin'],
  rates: `def rates(time, state):
    """The equations above."""
    ψ, ψ_rate, y = state

    α = atan(y / σ)
    F_y = c_Fα * F_z * max(-δ, min(α, δ))
    M_z = -c_Mα * F_z * α_g / pi * sin(pi * α / α_g) if abs(α) <= α_g else 0.0
    s = ψ - max(-ψ_fp, min(ψ, ψ_fp))

    ψ_acceleration = (-k * s - (c + κ / v) * ψ_rate + M_z - e * F_y) / I_z
    y_rate = v * ψ + (e - a) * ψ_rate - v / σ * y
    return ψ_rate, ψ_acceleration, y_rate`,
  load: `def load(ψ, y):
    """The moments on a wheel that does not turn, but for friction."""
    α = atan(y / σ)
    F_y = c_Fα * F_z * max(-δ, min(α, δ))
    M_z = -c_Mα * F_z * α_g / pi * sin(pi * α / α_g) if abs(α) <= α_g else 0.0
    s = ψ - max(-ψ_fp, min(ψ, ψ_fp))
    return -k * s + M_z - e * F_y`,
};
