//! The torsional gear's linear theory in closed form.

use super::{EndKind, Polynomial, Ring, RouthArray, RouthHurwitz, UnstableInterval, bounded::Bounded};
use crate::{
    error::{Error, Result},
    parameter::LARGEST,
};

/// The parameters that enter the linear theory of a wheel that turns about its axis on a stretched-string tire: each a
/// number, or the variable.
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
pub struct TorsionalTheory<T = Polynomial> {
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

impl<T: Ring> TorsionalTheory<T> {
    /// k at rest.
    fn stiffness(&self) -> T {
        let none = T::from(0.0);
        if self.freeplay_angle == none { self.torsional_stiffness } else { none }
    }

    /// T, by which the tire turns a deformed wheel back.
    fn tire(&self) -> T {
        (self.aligning_moment_derivative + self.caster_length * self.side_force_derivative) * self.vertical_force
    }

    /// D = cv + κ.
    fn damping(&self) -> T {
        self.damping_constant * self.velocity + self.tread_width_moment_constant
    }

    /// k + T: a₀ is positive exactly where this is.
    #[inline(never)]
    pub(super) fn stays(&self) -> T {
        self.stiffness() + self.tire()
    }

    /// (a₂a₁ − a₀) v σ² I_z²: positive exactly where a₂a₁ > a₀.
    #[inline(never)]
    pub(crate) fn calms(&self) -> T {
        let Self { velocity: v, relaxation_length: sigma, moment_of_inertia: i_z, .. } = *self;
        let lever = self.caster_length - self.half_contact_length;
        let damping = self.damping();
        let (k, tire) = (self.stiffness(), self.tire());
        i_z * v * v * (damping + tire * (lever - sigma)) + sigma * damping * (k * sigma + damping + tire * lever)
    }

    /// a₂ v σ I_z.
    pub(super) fn damps(&self) -> T {
        self.moment_of_inertia * self.velocity * self.velocity + self.relaxation_length * self.damping()
    }

    /// a₁ σ I_z: ω² σ I_z where a pair crosses.
    pub(crate) fn swings(&self) -> T {
        let lever = self.caster_length - self.half_contact_length;
        self.stiffness() * self.relaxation_length + self.damping() + self.tire() * lever
    }
}

impl TorsionalTheory {
    /// The same of numbers that know their rounding. Every parameter is a number.
    fn bounded(&self) -> TorsionalTheory<Bounded> {
        let number = |parameter: Polynomial| Bounded::from(parameter.at(0.0));
        TorsionalTheory {
            velocity: number(self.velocity),
            caster_length: number(self.caster_length),
            half_contact_length: number(self.half_contact_length),
            relaxation_length: number(self.relaxation_length),
            moment_of_inertia: number(self.moment_of_inertia),
            torsional_stiffness: number(self.torsional_stiffness),
            damping_constant: number(self.damping_constant),
            vertical_force: number(self.vertical_force),
            side_force_derivative: number(self.side_force_derivative),
            aligning_moment_derivative: number(self.aligning_moment_derivative),
            tread_width_moment_constant: number(self.tread_width_moment_constant),
            freeplay_angle: number(self.freeplay_angle),
        }
    }

    /// 1, a₂, a₁, a₀. Every parameter is a number.
    ///
    /// # Errors
    /// Values so extreme that they leave the numbers.
    pub(crate) fn characteristic(&self) -> Result<[Bounded; 4]> {
        let gear = self.bounded();
        let inertia = gear.relaxation_length * gear.moment_of_inertia;
        let a2 = gear.damps().over(gear.velocity * inertia);
        let a1 = gear.swings().over(inertia);
        let a0 = (gear.velocity * gear.stays()).over(inertia);
        if [a2, a1, a0].iter().any(|coefficient| !coefficient.value.is_finite()) {
            return Err(Error::beyond_numbers("the characteristic polynomial"));
        }
        Ok([Bounded::exact(1.0), a2, a1, a0])
    }

    /// Routh and Hurwitz, and where their verdict changes. Every parameter is a number.
    ///
    /// # Errors
    /// Values so extreme that the coefficients leave the numbers.
    pub(crate) fn routh_hurwitz(&self) -> Result<RouthHurwitz> {
        let [v, sigma, i_z] =
            [self.velocity, self.relaxation_length, self.moment_of_inertia].map(|number| number.at(0.0));
        let (stays, calms) = (self.stays().at(0.0), self.calms().at(0.0));
        let characteristic = self.characteristic()?;
        let [_, a2, _, a0] = characteristic.map(|coefficient| coefficient.value);
        let column = [1.0, a2, calms / (v * sigma * sigma * i_z * i_z) / a2, a0];
        if column.iter().any(|entry| !entry.is_finite()) {
            return Err(Error::beyond_numbers("the Routh column"));
        }
        // Neither speed nor damping enters k + T. Where that is not positive, a₂a₁ = a₀ ≤ 0 is no pair on the axis.
        let crossings = |gear: Self| if stays > 0.0 { gear.calms().roots(0.0, LARGEST) } else { Vec::new() };
        Ok(RouthHurwitz {
            stable: RouthArray::of_bounded(&characteristic)?.stable,
            column: column.to_vec(),
            critical_velocities: crossings(Self { velocity: Polynomial::variable(), ..*self }),
            critical_damping: crossings(Self { damping_constant: Polynomial::variable(), ..*self }).pop(),
        })
    }

    /// The parts of \[`from`, `to`\] in which the gear is not stable as the variable runs over it.
    pub(crate) fn unstable_intervals(&self, from: f64, to: f64) -> Vec<UnstableInterval> {
        let (stays, calms) = (self.stays(), self.calms());
        let stable = |x: f64| stays.at(x) > 0.0 && calms.at(x) > 0.0;
        let mut ends: Vec<(f64, EndKind)> =
            calms.roots(from, to).into_iter().map(|root| (root, EndKind::Hopf)).collect();
        for root in stays.roots(from, to) {
            let place = ends.partition_point(|end| end.0 < root);
            ends.insert(place, (root, EndKind::Divergence));
        }
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
