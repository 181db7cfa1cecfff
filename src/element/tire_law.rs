//! Tire laws: from the slip angle to side force and aligning moment.

use std::f64::consts::{FRAC_PI_2, PI};

use super::{Side, odd_polynomial::OddPolynomial};
use crate::real::Real;

/// How far past its limit a law is fitted: a step may look that far ahead before the kink is located.
const OVERSHOOT: f64 = 1.35;

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
    aligning_stiffness: f64,
    side_force_limit_angle: f64,
    aligning_limit_angle: f64,
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
        Self { side_force_stiffness, aligning_stiffness, side_force_limit_angle, aligning_limit_angle }
    }

    /// tan δ: the slip ratio at which the side force stops growing.
    pub fn side_force_limit(&self) -> f64 {
        slip_ratio(self.side_force_limit_angle)
    }

    /// tan α_g: the slip ratio beyond which there is no aligning moment.
    pub fn aligning_limit(&self) -> f64 {
        slip_ratio(self.aligning_limit_angle)
    }

    /// F_y \[N\] at the slip ratio q.
    pub fn side_force<R: Real>(&self, q: R, side: Side) -> R {
        let largest = self.side_force_stiffness * self.side_force_limit_angle;
        match side {
            Side::Within => q.atan() * self.side_force_stiffness,
            Side::Above => R::from(largest),
            Side::Below => R::from(-largest),
        }
    }

    /// M_z \[N m\] at the slip ratio q.
    pub fn aligning_moment<R: Real>(&self, q: R, side: Side) -> R {
        let limit = self.aligning_limit_angle;
        match side {
            Side::Within => (q.atan() * (PI / limit)).sin() * (-self.aligning_stiffness * limit / PI),
            Side::Above | Side::Below => R::from(0.0),
        }
    }
}

fn slip_ratio(angle: f64) -> f64 {
    if angle < FRAC_PI_2 { angle.tan() } else { f64::INFINITY }
}

/// What a tire does to a wheel that turns about an axis: M_z − e F_y, without a call to the mathematical library.
///
/// α enters only through q, which is small where the law still curves: on each pair of sides the moment is one odd
/// polynomial in q, fitted once per parameter set to rounding error (see [`OddPolynomial`]). Where no polynomial of that
/// length serves, the law itself is called.
#[derive(Clone, Copy, Debug)]
pub struct SteeringMoment {
    law: PiecewiseTireLaw,
    caster_length: f64,
    /// e F_y past its limit.
    limited: f64,
    both: OddPolynomial<10>,
    aligning: OddPolynomial<12>,
    casting: OddPolynomial<8>,
}

impl SteeringMoment {
    /// The moment of `law` about an axis that lies `caster_length` e \[m\] ahead of the contact centre.
    pub fn new(law: PiecewiseTireLaw, caster_length: f64) -> Self {
        let (force_limit, moment_limit) = (law.side_force_limit(), law.aligning_limit());
        let aligning = |q: f64| law.aligning_moment(q, Side::Within);
        let casting = |q: f64| -caster_length * law.side_force(q, Side::Within);
        // Errors are measured by the larger of the two parts, as their sum may cancel.
        let size = law.aligning_stiffness.max((caster_length * law.side_force_stiffness).abs());
        let both = |q: f64| aligning(q) + casting(q);
        // Beyond tan δ only the aligning moment changes, beyond tan α_g only the side force.
        let aligning_range = if moment_limit > force_limit { OVERSHOOT.min(1.2) * moment_limit } else { 0.0 };
        let casting_range = if force_limit > moment_limit { OVERSHOOT * force_limit } else { 0.0 };
        Self {
            law,
            caster_length,
            limited: caster_length * law.side_force_stiffness * law.side_force_limit_angle,
            both: OddPolynomial::fit(OVERSHOOT * force_limit.min(moment_limit), size, both),
            aligning: OddPolynomial::fit(aligning_range, size, aligning),
            casting: OddPolynomial::fit(casting_range, size, casting),
        }
    }

    /// M_z − e F_y \[N m\] at the slip ratio q, each part on its side.
    #[inline(always)]
    pub fn at<R: Real>(&self, q: R, side_force: Side, aligning: Side) -> R {
        let e = self.caster_length;
        match (side_force, aligning) {
            (Side::Within, Side::Within) => self.both.eval(q, |q| self.written(q)),
            (Side::Within, _) => self.casting.eval(q, |q| -(self.law.side_force(q, Side::Within) * e)),
            (limited, Side::Within) => {
                let moment = self.aligning.eval(q, |q| self.law.aligning_moment(q, Side::Within));
                if limited == Side::Above { moment - self.limited } else { moment + self.limited }
            }
            (Side::Above, _) => R::from(-self.limited),
            (Side::Below, _) => R::from(self.limited),
        }
    }

    #[inline(never)]
    fn written<R: Real>(&self, q: R) -> R {
        self.law.aligning_moment(q, Side::Within) - self.law.side_force(q, Side::Within) * self.caster_length
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The law as it is written, without pieces: F_y and M_z.
    fn written(q: f64, delta: f64, alpha_g: f64) -> (f64, f64) {
        let alpha = q.atan();
        let force = alpha.clamp(-delta, delta) * 180_000.0;
        let moment = if alpha.abs() <= alpha_g { -18_000.0 * alpha_g / PI * (PI * alpha / alpha_g).sin() } else { 0.0 };
        (force, moment)
    }

    #[test]
    fn steering_moment_is_the_written_law_over_the_parameter_range() {
        // δ and α_g from half a degree to beyond 90°, either one the smaller; e through the cancellation at −c_Mα/c_Fα.
        for delta in [0.5_f64, 2.0, 5.0, 10.0, 30.0, 120.0] {
            for alpha_g in [1.0_f64, 5.0, 10.0, 20.0, 45.0, 100.0] {
                for e in [-0.5, -0.1, 0.0, 0.1, 0.5] {
                    let (delta, alpha_g) = (delta.to_radians(), alpha_g.to_radians());
                    let law = PiecewiseTireLaw::new(180_000.0, 18_000.0, delta, alpha_g);
                    let steering = SteeringMoment::new(law, e);
                    for i in -1000..=1000 {
                        let q = 1e-3 * i as f64;
                        let (force, moment) = written(q, delta, alpha_g);
                        let sides = (Side::of(q, 0.0, law.side_force_limit()), Side::of(q, 0.0, law.aligning_limit()));
                        assert!((law.side_force(q, sides.0) - force).abs() <= 1e-15 * 180_000.0 * delta.min(FRAC_PI_2));
                        assert!((law.aligning_moment(q, sides.1) - moment).abs() <= 4e-15 * 18_000.0 * alpha_g);
                        // Rounding of some twenty operations on terms of this size.
                        let size = (18_000.0_f64).max(180_000.0 * e.abs()) * q.abs();
                        let got = steering.at(q, sides.0, sides.1);
                        assert!(
                            (got - (moment - e * force)).abs() <= 6e-15 * size + 1e-11,
                            "δ {delta} α_g {alpha_g} e {e} q {q}: {got} {}",
                            moment - e * force
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn default_limits_are_served_by_polynomials() {
        let law = PiecewiseTireLaw::new(180_000.0, 18_000.0, 5_f64.to_radians(), 10_f64.to_radians());
        let steering = SteeringMoment::new(law, 0.1);
        assert!(steering.both.range() > law.side_force_limit());
        assert!(steering.aligning.range() > law.aligning_limit());
        let law = PiecewiseTireLaw::new(180_000.0, 18_000.0, 5_f64.to_radians(), 3_f64.to_radians());
        assert!(SteeringMoment::new(law, 0.1).casting.range() > law.side_force_limit());
    }
}
