//! Dry friction: a moment against the turning, and at rest as much as is needed, up to that.

use crate::{
    parameter::{Parameter, Scale, Validity},
    real::Real,
};

/// What a dry friction does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rubbing {
    /// There is none.
    Absent = 0,
    /// It works against a positive rate.
    Forward = 1,
    /// It works against a negative rate.
    Backward = 2,
    /// It holds: the rate is zero and stays so.
    Sticking = 3,
}

/// A dry friction of the moment M_f \[N m\].
///
/// # Equations
/// The friction's torque is −M_f sign ψ̇ where ψ̇ ≠ 0. At rest it is set-valued, from −M_f to M_f: it takes away all of the
/// other moments' sum, the *load*, as long as that is within, and what moves then moves again only once the load leaves.
///
/// Sticking and slipping have the same M_f.
///
/// # References
/// G. Somieski, *Aerospace Science and Technology* 8 (1997) 545–555 (his k₀); A. F. Filippov, *Differential Equations with
/// Discontinuous Righthand Sides*, 1988, for what such an equation means where its right-hand side jumps.
#[derive(Clone, Copy, Debug)]
pub struct DryFriction {
    moment: f64,
}

impl DryFriction {
    /// With the moment M_f ≥ 0 \[N m\].
    pub fn new(moment: f64) -> Self {
        Self { moment }
    }

    /// M_f, 0 where there is no friction.
    #[inline(always)]
    pub fn moment(&self) -> f64 {
        self.moment
    }

    /// What it does at the rate ψ̇, the other moments being `load`.
    pub fn at(&self, rate: f64, load: f64) -> Rubbing {
        let heading = if rate == 0.0 && load.abs() > self.moment { load } else { rate };
        if self.moment == 0.0 {
            Rubbing::Absent
        } else if heading > 0.0 {
            Rubbing::Forward
        } else if heading < 0.0 {
            Rubbing::Backward
        } else {
            Rubbing::Sticking
        }
    }

    /// What it does once it can no longer hold the load.
    pub fn released(&self, load: f64) -> Rubbing {
        if load > 0.0 { Rubbing::Forward } else { Rubbing::Backward }
    }

    /// M_f² − load²: positive as long as it holds.
    #[inline(always)]
    pub fn margin<R: Real>(&self, load: R) -> R {
        -load * load + self.moment * self.moment
    }

    /// Its torque \[N m\] at the rate ψ̇, the other moments being `load`.
    pub fn torque(&self, rate: f64, load: f64) -> f64 {
        match self.at(rate, load) {
            Rubbing::Absent => 0.0,
            Rubbing::Forward => -self.moment,
            Rubbing::Backward => self.moment,
            Rubbing::Sticking => 0.0 - load,
        }
    }
}

/// The friction's one parameter, on gears that take it.
pub const MOMENT: Parameter = Parameter {
    name: "friction.moment",
    symbol: "M_f",
    unit: "N m",
    default: 0.0,
    min: 0.0,
    max: 300.0,
    scale: Scale::Linear,
    doc: "Dry friction about the steering axis: the moment −M_f sign ψ̇, and at rest as much as is needed to stay there, up to M_f (Somieski 1997, k₀). Linear theory leaves it out. Any value ≥ 0 is valid; 0 is none.",
    validity: Validity::NonNegative,
};

/// A model's parameters, and the friction's after them.
pub(crate) const fn with_friction<const N: usize, const ALL: usize>(parameters: [Parameter; N]) -> [Parameter; ALL] {
    assert!(ALL == N + 1);
    let mut all = [MOMENT; ALL];
    let mut i = 0;
    while i < N {
        all[i] = parameters[i];
        i += 1;
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_opposes_motion_and_holds_what_it_can() {
        let friction = DryFriction::new(5.0);
        for (rate, load, torque) in [(0.1, -80.0, -5.0), (-0.1, -80.0, 5.0), (0.0, 3.0, -3.0), (0.0, -5.0, 5.0)] {
            assert_eq!(friction.torque(rate, load), torque);
        }
        assert_eq!(friction.torque(0.0, 5.1), -5.0, "it cannot hold more");
        assert_eq!(friction.at(0.0, 5.0), Rubbing::Sticking);
        assert!(friction.margin(4.9) > 0.0 && friction.margin(5.1) < 0.0 && friction.margin(-5.1) < 0.0);
        assert_eq!(DryFriction::new(0.0).at(1.0, 1.0), Rubbing::Absent);
        assert_eq!(DryFriction::new(0.0).torque(0.0, 7.0), 0.0);
    }
}
