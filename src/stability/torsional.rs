//! The torsional gear's linear theory in closed form.

use std::ops::{Add, Mul, Sub};

use super::{EndKind, RouthHurwitz, UnstableInterval, polynomial::Polynomial};
use crate::{
    error::{Code, Error, Result},
    parameter::LARGEST,
};

/// What a parameter of the linear theory may be: a number, or a polynomial in the one that varies.
pub trait Number: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + From<f64> + PartialEq {}

impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + From<f64> + PartialEq> Number for T {}

/// The parameters that enter the linear theory of a wheel that turns about its axis on a stretched-string tire.
///
/// # Equations
/// With B = −(c_Mα + e c_Fα) F_z/(σ I_z) the matrix of (ψ, ψ̇, y) has the characteristic polynomial s³ + a₂s² + a₁s + a₀:
///
/// ```text
/// a₂ = v/σ + (c + κ/v)/I_z
/// a₁ = k/I_z + (c + κ/v) v/(σ I_z) − (e − a) B
/// a₀ = v k/(σ I_z) − v B
/// ```
///
/// Stable exactly when a₂ > 0, a₀ > 0 and a₂a₁ > a₀ (Routh and Hurwitz). At a₂a₁ = a₀ a pair crosses the imaginary axis
/// with ω² = a₁; at a₀ = 0 a real eigenvalue crosses (divergence). The first holds for every valid gear. With
/// D = cv + κ and T = (c_Mα + e c_Fα) F_z the others are two polynomials, of which one speaks of one sign each:
///
/// ```text
/// a₀ σ I_z/v              = k + T
/// (a₂a₁ − a₀) v σ² I_z²   = I_z v² (D + T (e − a − σ)) + σ D (kσ + D + T (e − a))
/// ```
///
/// Each is of degree 3 at most in each single parameter.
///
/// # Limits
/// With freeplay the gear rests in its gap, where no spring acts: k counts as 0.
///
/// # References
/// Derived from G. Somieski, *Aerospace Science and Technology* 8 (1997) 545–555; signs and letters as in
/// [`crate::model::Torsional`].
#[derive(Clone, Copy, Debug)]
pub struct TorsionalTheory<T> {
    /// v
    pub velocity: T,
    /// e
    pub caster_length: T,
    /// a
    pub half_contact_length: T,
    /// σ
    pub relaxation_length: T,
    /// I_z
    pub moment_of_inertia: T,
    /// k
    pub torsional_stiffness: T,
    /// c
    pub damping_constant: T,
    /// F_z
    pub vertical_force: T,
    /// c_Fα
    pub side_force_derivative: T,
    /// c_Mα
    pub aligning_moment_derivative: T,
    /// κ
    pub tread_width_moment_constant: T,
    /// ψ_fp
    pub freeplay_angle: T,
}

impl<T: Number> TorsionalTheory<T> {
    /// k at rest.
    fn stiffness(&self) -> T {
        let none = T::from(0.0);
        if self.freeplay_angle == none { self.torsional_stiffness } else { none }
    }

    /// T, by which the tire turns a deformed wheel back.
    fn tire(&self) -> T {
        (self.aligning_moment_derivative + self.caster_length * self.side_force_derivative) * self.vertical_force
    }

    /// k + T: a₀ is positive exactly where this is.
    fn stays(&self) -> T {
        self.stiffness() + self.tire()
    }

    /// (a₂a₁ − a₀) v σ² I_z²: positive exactly where a₂a₁ > a₀.
    fn calms(&self) -> T {
        let Self { velocity: v, relaxation_length: sigma, moment_of_inertia: i_z, .. } = *self;
        let lever = self.caster_length - self.half_contact_length;
        let damping = self.damping_constant * v + self.tread_width_moment_constant;
        let (k, tire) = (self.stiffness(), self.tire());
        i_z * v * v * (damping + tire * (lever - sigma)) + sigma * damping * (k * sigma + damping + tire * lever)
    }
}

impl TorsionalTheory<f64> {
    /// Routh and Hurwitz, and where their verdict changes.
    ///
    /// # Errors
    /// Values so extreme that the coefficients leave the numbers.
    pub(crate) fn routh_hurwitz(&self) -> Result<RouthHurwitz> {
        let Self { velocity: v, relaxation_length: sigma, moment_of_inertia: i_z, .. } = *self;
        let (stays, calms) = (self.stays(), self.calms());
        let a2 = v / sigma + (self.damping_constant + self.tread_width_moment_constant / v) / i_z;
        let a0 = v * stays / (sigma * i_z);
        let column = [1.0, a2, calms / (v * sigma * sigma * i_z * i_z) / a2, a0];
        if !column.iter().all(|entry| entry.is_finite()) {
            let value = format!("{column:?}");
            return Err(Error::new(Code::NotFinite, "the Routh column", value, "finite: choose less extreme values"));
        }
        Ok(RouthHurwitz {
            stable: column.iter().all(|entry| *entry > 0.0),
            column: column.to_vec(),
            critical_velocities: self.crossings(|gear| &mut gear.velocity),
            critical_damping: self.crossings(|gear| &mut gear.damping_constant).pop(),
        })
    }

    /// The values > 0 of one parameter at which a pair crosses the imaginary axis.
    fn crossings(&self, pick: impl Fn(&mut TorsionalTheory<Polynomial>) -> &mut Polynomial) -> Vec<f64> {
        // Neither speed nor damping enters k + T. Where that is not positive, a₂a₁ = a₀ ≤ 0 is no pair on the axis.
        if self.stays() <= 0.0 {
            return Vec::new();
        }
        let mut gear = self.map(Polynomial::from);
        *pick(&mut gear) = Polynomial::variable();
        gear.calms().roots(0.0, LARGEST)
    }

    fn map<T>(&self, f: impl Fn(f64) -> T) -> TorsionalTheory<T> {
        TorsionalTheory {
            velocity: f(self.velocity),
            caster_length: f(self.caster_length),
            half_contact_length: f(self.half_contact_length),
            relaxation_length: f(self.relaxation_length),
            moment_of_inertia: f(self.moment_of_inertia),
            torsional_stiffness: f(self.torsional_stiffness),
            damping_constant: f(self.damping_constant),
            vertical_force: f(self.vertical_force),
            side_force_derivative: f(self.side_force_derivative),
            aligning_moment_derivative: f(self.aligning_moment_derivative),
            tread_width_moment_constant: f(self.tread_width_moment_constant),
            freeplay_angle: f(self.freeplay_angle),
        }
    }
}

impl TorsionalTheory<Polynomial> {
    /// The parts of \[`from`, `to`\] in which the gear is not stable as the polynomials' variable runs over it.
    pub(crate) fn unstable_intervals(&self, from: f64, to: f64) -> Vec<UnstableInterval> {
        let (stays, calms) = (self.stays(), self.calms());
        let stable = |x: f64| stays.at(x) > 0.0 && calms.at(x) > 0.0;
        let boundaries = |condition: &Polynomial, kind| condition.roots(from, to).into_iter().map(move |at| (at, kind));
        let mut ends: Vec<(f64, EndKind)> =
            boundaries(&stays, EndKind::Divergence).chain(boundaries(&calms, EndKind::Hopf)).collect();
        ends.sort_by(|a, b| a.0.total_cmp(&b.0));
        ends.push((to, EndKind::Range));
        let mut intervals: Vec<UnstableInterval> = Vec::new();
        let mut start = (from, EndKind::Range);
        for end in ends {
            if !stable(start.0.midpoint(end.0)) {
                match intervals.last_mut() {
                    // A boundary of one condition within what the other one forbids.
                    Some(last) if last.to == start.0 => (last.to, last.to_kind) = end,
                    _ => intervals.push(UnstableInterval {
                        from: start.0,
                        to: end.0,
                        from_kind: start.1,
                        to_kind: end.1,
                    }),
                }
            }
            start = end;
        }
        intervals
    }
}
