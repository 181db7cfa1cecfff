//! Tire laws: from the slip angle to side force and aligning moment.

use std::f64::consts::{FRAC_PI_2, PI};

use super::{Side, odd_polynomial::OddPolynomial};
use crate::real::Real;

/// How far past its limit a law is fitted, if the polynomial reaches so far: a step may look ahead before the kink is
/// located. A step is at most a third of a swing.
const OVERSHOOT: [f64; 3] = [2.2, 1.6, 1.2];

/// Terms of the polynomials in an ensemble, of the side force and of the aligning moment.
pub(crate) const CASTING_TERMS: usize = 3;
/// See [`CASTING_TERMS`].
pub(crate) const ALIGNING_TERMS: usize = 6;
/// How far these may be from the laws, in parts of the moment at a limit: what a step of an ensemble leaves open, too.
const ENSEMBLE_ERROR: f64 = 1e-6;

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

    /// δ \[rad\].
    pub fn side_force_limit_angle(&self) -> f64 {
        self.side_force_limit_angle
    }

    /// α_g \[rad\].
    pub fn aligning_limit_angle(&self) -> f64 {
        self.aligning_limit_angle
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
        // Of a limit next to 0 the wave is shorter than a number can say, and so low that it does not matter.
        let turning = (PI / limit).min(f64::MAX);
        match side {
            Side::Within => (q.atan() * turning).sin() * (-self.aligning_stiffness * limit / PI),
            Side::Above | Side::Below => R::from(0.0),
        }
    }
}

/// The law for small slip: F_y = C_Fα α and M_z = −C_Mα α, with α = q.
#[derive(Clone, Copy, Debug)]
pub struct LinearTireLaw {
    side_force_stiffness: f64,
    aligning_stiffness: f64,
}

impl LinearTireLaw {
    /// A law from C_Fα \[N/rad\] and C_Mα \[N m/rad\].
    pub fn new(side_force_stiffness: f64, aligning_stiffness: f64) -> Self {
        Self { side_force_stiffness, aligning_stiffness }
    }

    /// F_y \[N\] at the slip ratio q.
    pub fn side_force<R: Real>(&self, q: R) -> R {
        q * self.side_force_stiffness
    }

    /// M_z \[N m\] at the slip ratio q.
    pub fn aligning_moment<R: Real>(&self, q: R) -> R {
        q * -self.aligning_stiffness
    }
}

/// The law of a gear's tire. Where it has no limit, its limit is infinite.
#[derive(Clone, Copy, Debug)]
pub enum TireLaw {
    /// With limits, in α = arctan q.
    Piecewise(PiecewiseTireLaw),
    /// Without, in α = q.
    Linear(LinearTireLaw),
}

impl TireLaw {
    /// The law for small slip.
    pub fn linearised(&self) -> LinearTireLaw {
        match self {
            Self::Piecewise(law) => LinearTireLaw::new(law.side_force_stiffness, law.aligning_stiffness),
            Self::Linear(law) => *law,
        }
    }

    /// α \[rad\] at the slip ratio q.
    pub fn slip_angle(&self, q: f64) -> f64 {
        match self {
            Self::Piecewise(_) => q.atan(),
            Self::Linear(_) => q,
        }
    }

    /// The slip ratio at which the side force stops growing.
    pub fn side_force_limit(&self) -> f64 {
        match self {
            Self::Piecewise(law) => law.side_force_limit(),
            Self::Linear(_) => f64::INFINITY,
        }
    }

    /// The slip ratio beyond which there is no aligning moment.
    pub fn aligning_limit(&self) -> f64 {
        match self {
            Self::Piecewise(law) => law.aligning_limit(),
            Self::Linear(_) => f64::INFINITY,
        }
    }

    /// F_y \[N\] at the slip ratio q.
    pub fn side_force<R: Real>(&self, q: R, side: Side) -> R {
        match self {
            Self::Piecewise(law) => law.side_force(q, side),
            Self::Linear(law) => law.side_force(q),
        }
    }

    /// M_z \[N m\] at the slip ratio q.
    pub fn aligning_moment<R: Real>(&self, q: R, side: Side) -> R {
        match self {
            Self::Piecewise(law) => law.aligning_moment(q, side),
            Self::Linear(law) => law.aligning_moment(q),
        }
    }
}

fn slip_ratio(angle: f64) -> f64 {
    if angle < FRAC_PI_2 { angle.tan() } else { f64::INFINITY }
}

/// Bits of sides, of no law's own, for which a [`SteeringMoment`] is none.
pub const NO_MOMENT: u32 = 15;

/// What a tire does to a wheel that turns about an axis: (M_z − e F_y)/I_z, without a call to the mathematical library.
///
/// α enters only through y/σ, which is small where the law still curves: on each pair of sides the moment is a constant
/// and an odd polynomial in y, fitted once per parameter set to rounding error (see [`OddPolynomial`]). Every pair has the
/// same form, so that a right-hand side has no branch but the polynomial's range. Where no polynomial of that length
/// serves, the law itself is called.
#[derive(Clone, Debug)]
pub struct SteeringMoment {
    law: TireLaw,
    caster_length: f64,
    /// 1/σ
    slip_ratio: f64,
    /// 1/I_z
    mobility: f64,
    /// By the side of F_y and, four times that, the side of M_z.
    pieces: [Piece; 16],
}

#[derive(Clone, Copy, Debug)]
struct Piece {
    constant: f64,
    curve: OddPolynomial<12>,
}

impl SteeringMoment {
    /// The moment of `law` about an axis that lies e = `caster_length` \[m\] ahead of the contact centre, over the moment
    /// of inertia I_z \[kg m²\], for a tire of relaxation length σ \[m\].
    pub fn new(law: TireLaw, caster_length: f64, relaxation_length: f64, moment_of_inertia: f64) -> Self {
        let (slip_ratio, mobility) = (1.0 / relaxation_length, 1.0 / moment_of_inertia);
        let mut pieces = match law {
            TireLaw::Piecewise(law) => piecewise(law, caster_length, relaxation_length, mobility),
            TireLaw::Linear(law) => {
                let slope =
                    -mobility * (law.aligning_stiffness + caster_length * law.side_force_stiffness) * slip_ratio;
                [Piece { constant: 0.0, curve: OddPolynomial::line(slope) }; 16]
            }
        };
        pieces[NO_MOMENT as usize] = Piece { constant: 0.0, curve: OddPolynomial::zero() };
        Self { law, caster_length, slip_ratio, mobility, pieces }
    }

    /// The part that depends on y: with [`SteeringMoment::constant`] it makes (M_z − e F_y)/I_z \[rad/s²\]. `sides` is
    /// the side of F_y and, four times that, the side of M_z.
    #[inline(always)]
    pub fn curve<R: Real>(&self, y: R, sides: u32) -> R {
        self.pieces[(sides & 15) as usize].curve.eval(y, |y| self.written(y, sides))
    }

    /// The part that does not: what a side force at its limit makes.
    #[inline(always)]
    pub fn constant(&self, sides: u32) -> f64 {
        self.pieces[(sides & 15) as usize].constant
    }

    /// The same moment as the sum of two odd polynomials: of the side force in y clamped to ±its limit, of the aligning moment
    /// in y clamped to ±its own. The limits \[m\] and both polynomials' coefficients of y, y³, y⁵ …; none where they do not
    /// serve. `limits`: of the slip ratio.
    pub(crate) fn clamped(
        &self,
        slip_ratio: f64,
        limits: [f64; 2],
    ) -> Option<([f64; 2], [f64; CASTING_TERMS], [f64; ALIGNING_TERMS])> {
        let TireLaw::Piecewise(law) = self.law else { return None };
        let [force_limit, moment_limit] = limits.map(|limit| limit / slip_ratio);
        let casting = |y: f64| -self.mobility * self.caster_length * law.side_force(y * slip_ratio, Side::Within);
        let aligning = |y: f64| self.mobility * law.aligning_moment(y * slip_ratio, Side::Within);
        let largest = |stiffness: f64, angle: f64| ENSEMBLE_ERROR * self.mobility * stiffness * angle;
        let force_error = largest((self.caster_length * law.side_force_stiffness).abs(), law.side_force_limit_angle);
        let moment_error = largest(law.aligning_stiffness, law.aligning_limit_angle / PI);
        Some((
            [force_limit, moment_limit],
            OddPolynomial::fit_within(force_limit, force_error, &casting).powers()?,
            OddPolynomial::fit_within(moment_limit, moment_error, &aligning).powers()?,
        ))
    }

    /// The curve as the law writes it.
    #[inline(never)]
    fn written<R: Real>(&self, y: R, sides: u32) -> R {
        let q = y * self.slip_ratio;
        let aligning = if sides >> 2 & 3 == 0 { self.law.aligning_moment(q, Side::Within) } else { R::from(0.0) };
        let casting = if sides & 3 == 0 { self.law.side_force(q, Side::Within) } else { R::from(0.0) };
        (aligning - casting * self.caster_length) * self.mobility
    }
}

/// The pieces of the steering moment of a piecewise law, by the side of F_y and, four times that, the side of M_z.
fn piecewise(law: PiecewiseTireLaw, caster_length: f64, relaxation_length: f64, mobility: f64) -> [Piece; 16] {
    let slip_ratio = 1.0 / relaxation_length;
    let (force_limit, moment_limit) = (law.side_force_limit(), law.aligning_limit());
    // Errors are measured by the larger of the two parts, as their sum may cancel.
    let stiffness = law.aligning_stiffness.max((caster_length * law.side_force_stiffness).abs());
    let size = stiffness * slip_ratio * mobility;
    let aligning = |y: f64| mobility * law.aligning_moment(y * slip_ratio, Side::Within);
    let casting = |y: f64| -mobility * caster_length * law.side_force(y * slip_ratio, Side::Within);
    let fit = |limit: f64, function: &dyn Fn(f64) -> f64| {
        // Up to 45° an arc tangent is of the size of its argument; no polynomial of this length reaches further.
        let reaches = OVERSHOOT.map(|factor| factor * limit).into_iter().filter(|reach| *reach <= 1.0);
        let mut fits = reaches.map(|reach| OddPolynomial::fit(reach * relaxation_length, size, function));
        fits.find(|fit| fit.range() > 0.0).unwrap_or(OddPolynomial::none())
    };
    let both = fit(force_limit.min(moment_limit), &|y| aligning(y) + casting(y));
    // Beyond tan δ only the aligning moment changes, beyond tan α_g only the side force.
    let aligning = if moment_limit > force_limit { fit(moment_limit, &aligning) } else { OddPolynomial::zero() };
    let casting = if force_limit > moment_limit { fit(force_limit, &casting) } else { OddPolynomial::zero() };
    let limited = mobility * caster_length * law.side_force_stiffness * law.side_force_limit_angle;
    std::array::from_fn(|index| {
        let (side_force, moment) = (index & 3, index >> 2);
        let constant = if side_force == Side::Above as usize {
            -limited
        } else if side_force == Side::Below as usize {
            limited
        } else {
            0.0
        };
        let curve = match (side_force == Side::Within as usize, moment == Side::Within as usize) {
            (true, true) => both,
            (false, true) => aligning,
            (true, false) => casting,
            (false, false) => OddPolynomial::zero(),
        };
        Piece { constant, curve }
    })
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
        for delta in [0.5_f64, 2.0, 5.0, 10.0, 30.0, 89.999_999, 120.0] {
            for alpha_g in [1.0_f64, 5.0, 10.0, 20.0, 45.0, 89.999_999, 100.0] {
                for e in [-0.5, -0.1, 0.0, 0.1, 0.5] {
                    let (delta, alpha_g) = (delta.to_radians(), alpha_g.to_radians());
                    let law = PiecewiseTireLaw::new(180_000.0, 18_000.0, delta, alpha_g);
                    let (sigma, inertia) = (0.3, 1.7);
                    let steering = SteeringMoment::new(TireLaw::Piecewise(law), e, sigma, inertia);
                    for i in -1000..=1000 {
                        let q = 1e-3 * i as f64;
                        let (force, moment) = written(q, delta, alpha_g);
                        let sides = (Side::of(q, 0.0, law.side_force_limit()), Side::of(q, 0.0, law.aligning_limit()));
                        assert!((law.side_force(q, sides.0) - force).abs() <= 1e-15 * 180_000.0 * delta.min(FRAC_PI_2));
                        assert!((law.aligning_moment(q, sides.1) - moment).abs() <= 4e-15 * 18_000.0 * alpha_g);
                        // Rounding of some twenty operations on terms of this size.
                        let size = (18_000.0_f64).max(180_000.0 * e.abs()) * q.abs();
                        let bits = sides.0 as u32 | (sides.1 as u32) << 2;
                        let got = inertia * (steering.curve(q * sigma, bits) + steering.constant(bits));
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
        let steering = SteeringMoment::new(TireLaw::Piecewise(law), 0.1, 1.0, 1.0);
        let range = |sides: usize| steering.pieces[sides].curve.range();
        assert!(range(0) > law.side_force_limit() && range(1) > law.aligning_limit());
        let law = PiecewiseTireLaw::new(180_000.0, 18_000.0, 5_f64.to_radians(), 3_f64.to_radians());
        assert!(
            SteeringMoment::new(TireLaw::Piecewise(law), 0.1, 1.0, 1.0).pieces[4].curve.range()
                > law.side_force_limit()
        );
    }
}
