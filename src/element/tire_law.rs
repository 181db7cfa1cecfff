//! Tire laws: from the slip angle to side force and aligning moment.

use std::f64::consts::{FRAC_PI_2, PI};

use super::{Side, odd_polynomial::OddPolynomial};
use crate::real::Real;

/// How far past its limit a law is fitted: a step may look that far ahead before the kink is located.
const OVERSHOOT: f64 = 1.2;

/// The piecewise law of a stretched-string tire.
///
/// # Equations
/// With the slip ratio q = y/σ and the slip angle α = arctan q:
///
/// ```text
/// F_y = C_Fα α                          |α| ≤ δ,    C_Fα δ sign α   beyond
/// M_z = −C_Mα (α_g/π) sin(π α/α_g)      |α| ≤ α_g,  0               beyond
/// ```
///
/// C_Fα = c_Fα F_z in N/rad, C_Mα = c_Mα F_z in N m/rad. Each piece is continued past its limit (see
/// [`crate::element`]).
///
/// # References
/// G. Somieski, *Aerospace Science and Technology* 8 (1997) 545–555, eqs. for F_y and M_z, with the sign of c_Mα turned.
#[derive(Clone, Copy, Debug)]
pub struct PiecewiseTireLaw {
    side_force_stiffness: f64,
    largest_side_force: f64,
    aligning_stiffness: f64,
    aligning_limit_angle: f64,
    side_force_limit: f64,
    aligning_limit: f64,
    arc_tangent: OddPolynomial<8>,
    aligning_moment: OddPolynomial<12>,
}

impl PiecewiseTireLaw {
    /// A law from C_Fα \[N/rad\], C_Mα \[N m/rad\], δ and α_g \[rad\].
    ///
    /// A limit of 90° or more is never reached.
    pub fn new(
        side_force_stiffness: f64,
        aligning_stiffness: f64,
        side_force_limit_angle: f64,
        aligning_limit_angle: f64,
    ) -> Self {
        let ratio = |angle: f64| if angle < FRAC_PI_2 { angle.tan() } else { f64::INFINITY };
        let side_force_limit = ratio(side_force_limit_angle);
        let aligning_limit = ratio(aligning_limit_angle);
        let aligning = |q: f64| aligning_moment_of_angle(q.atan(), aligning_stiffness, aligning_limit_angle);
        Self {
            side_force_stiffness,
            largest_side_force: side_force_stiffness * side_force_limit_angle,
            aligning_stiffness,
            aligning_limit_angle,
            side_force_limit,
            aligning_limit,
            arc_tangent: OddPolynomial::fit(OVERSHOOT * side_force_limit, f64::atan),
            aligning_moment: OddPolynomial::fit(OVERSHOOT * aligning_limit, aligning),
        }
    }

    /// tan δ: the slip ratio at which the side force stops growing.
    #[inline(always)]
    pub fn side_force_limit(&self) -> f64 {
        self.side_force_limit
    }

    /// tan α_g: the slip ratio beyond which there is no aligning moment.
    #[inline(always)]
    pub fn aligning_limit(&self) -> f64 {
        self.aligning_limit
    }

    /// F_y \[N\] at the slip ratio q.
    #[inline(always)]
    pub fn side_force<R: Real>(&self, q: R, side: Side) -> R {
        match side {
            Side::Within => self.arc_tangent.eval(q, R::atan) * self.side_force_stiffness,
            Side::Above => R::from(self.largest_side_force),
            Side::Below => R::from(-self.largest_side_force),
        }
    }

    /// M_z \[N m\] at the slip ratio q.
    #[inline(always)]
    pub fn aligning_moment<R: Real>(&self, q: R, side: Side) -> R {
        match side {
            Side::Within => self
                .aligning_moment
                .eval(q, |q| aligning_moment_of_angle(q.atan(), self.aligning_stiffness, self.aligning_limit_angle)),
            Side::Above | Side::Below => R::from(0.0),
        }
    }
}

#[inline(always)]
fn aligning_moment_of_angle<R: Real>(angle: R, stiffness: f64, limit: f64) -> R {
    (angle * (PI / limit)).sin() * (-stiffness * limit / PI)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The law as it is written, without polynomials or pieces.
    fn written(q: f64, delta: f64, alpha_g: f64) -> (f64, f64) {
        let alpha = q.atan();
        let force = alpha.clamp(-delta, delta) * 180_000.0;
        let moment = if alpha.abs() <= alpha_g { -18_000.0 * alpha_g / PI * (PI * alpha / alpha_g).sin() } else { 0.0 };
        (force, moment)
    }

    #[test]
    fn law_is_the_written_one_over_the_parameter_range() {
        // δ and α_g from half a degree to beyond 90°: short polynomials, long ones, and none at all.
        for delta in [0.5_f64, 2.0, 5.0, 10.0, 30.0, 120.0] {
            for alpha_g in [1.0_f64, 5.0, 10.0, 20.0, 45.0, 100.0] {
                let (delta, alpha_g) = (delta.to_radians(), alpha_g.to_radians());
                let law = PiecewiseTireLaw::new(180_000.0, 18_000.0, delta, alpha_g);
                for i in -4000..=4000 {
                    let q = 1e-3 * i as f64;
                    let (force, moment) = written(q, delta, alpha_g);
                    let got = law.side_force(q, Side::of(q, 0.0, law.side_force_limit()));
                    // Rounding of a few operations on the largest force; the moment's sine sees a rounded argument.
                    assert!((got - force).abs() <= 1e-15 * 180_000.0 * delta.min(FRAC_PI_2), "F_y({q}) {got} {force}");
                    let got = law.aligning_moment(q, Side::of(q, 0.0, law.aligning_limit()));
                    let peak = 18_000.0 * alpha_g / PI;
                    assert!((got - moment).abs() <= 4e-15 * peak.max(1.0), "M_z({q}) {got} {moment}");
                }
            }
        }
    }

    #[test]
    fn default_limits_are_served_by_polynomials() {
        let law = PiecewiseTireLaw::new(180_000.0, 18_000.0, 5_f64.to_radians(), 10_f64.to_radians());
        assert!(law.arc_tangent.range() > law.side_force_limit());
        assert!(law.aligning_moment.range() > law.aligning_limit());
    }
}
