//! The force laws of the torsional gears, one by one: what a drawing, a plot and an account of energy read.

mod curves;

pub use self::curves::{Curves, ForceLaws, Kinks};

use super::{
    assembly::Fitted,
    torsional::{PSI, PSI_RATE, Y},
};
use crate::{
    element::{Side, freeplay::Spring, friction::DryFriction, tire_law::TireLaw},
    error::{Error, Result},
};

/// The moments about the steering axis of a wheel on a stretched-string tire, each by itself.
///
/// # Equations
/// I_z ψ̈ is their sum: the spring's −k s(ψ), the damper's −cψ̇, the tread width's −(κ/v)ψ̇, the tire's M_z − e F_y, and the
/// friction's −M_f sign ψ̇, which at ψ̇ = 0 is as much as is needed, up to M_f. The model's own right-hand side says the same in another form, made for speed.
#[derive(Clone, Copy, Debug)]
pub struct Laws {
    /// F_y and M_z.
    pub tire: TireLaw,
    /// σ \[m\].
    pub relaxation_length: f64,
    /// e \[m\].
    pub caster_length: f64,
    /// k \[N m/rad\].
    pub stiffness: f64,
    /// ψ_fp \[rad\], 0 where there is no gap.
    pub freeplay: f64,
    /// M_f \[N m\], 0 where there is no dry friction.
    pub friction: f64,
    /// c \[N m s/rad\].
    pub damping: f64,
    /// κ/v \[N m s/rad\].
    pub tread_damping: f64,
    /// I_z \[kg m²\].
    pub moment_of_inertia: f64,
    /// A damper on the gear.
    pub fitted: Option<Fitted>,
}

/// Forces at a state: what a drawing shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Forces {
    /// α \[rad\].
    pub slip_angle: f64,
    /// F_y \[N\].
    pub side_force: f64,
    /// M_z \[N m\].
    pub aligning_moment: f64,
    /// |α| > δ: the side force does not grow any more.
    pub side_force_limited: bool,
    /// s(ψ) \[rad\]: the angle that winds the spring.
    pub spring_angle: f64,
    /// −k s(ψ) \[N m\].
    pub spring_torque: f64,
    /// What the dry friction does \[N m\].
    pub friction_torque: f64,
    /// F of the damper on the gear \[N\]: 0 without one.
    pub damper_force: f64,
    /// −M_d = −rF \[N m\].
    pub damper_torque: f64,
}

/// Forces along a motion, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceColumns {
    /// α \[rad\].
    pub slip_angle: Vec<f64>,
    /// F_y \[N\].
    pub side_force: Vec<f64>,
    /// M_z \[N m\].
    pub aligning_moment: Vec<f64>,
    /// −k s(ψ) \[N m\].
    pub spring_torque: Vec<f64>,
    /// What the dry friction does \[N m\].
    pub friction_torque: Vec<f64>,
    /// F of the damper on the gear \[N\].
    pub damper_force: Vec<f64>,
    /// −M_d \[N m\].
    pub damper_torque: Vec<f64>,
}

/// What each element does to the motion at a state \[W\]: positive puts energy in, or takes it out, as the name says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Power {
    /// (M_z − e F_y)ψ̇, put in by the tire.
    pub tire: f64,
    /// cψ̇², taken out by the damper.
    pub damper: f64,
    /// (κ/v)ψ̇², taken out by the tread's width.
    pub tread_width: f64,
    /// M_f|ψ̇|, taken out by dry friction.
    pub friction: f64,
    /// M_dψ̇, taken out by the damper on the gear: for good, or to be given back.
    pub fitted: f64,
}

impl Forces {
    /// Themselves, where they are numbers: a tire may be so short, or a state so large, that they are not.
    fn checked(self) -> Result<Self> {
        let Self { slip_angle, side_force, aligning_moment, spring_torque, friction_torque, damper_torque, .. } = self;
        let all = [slip_angle, side_force, aligning_moment, spring_torque, friction_torque, damper_torque];
        Error::unless_finite("the forces", &all)?;
        Ok(self)
    }
}

impl Laws {
    /// The laws of small motions about rest: straight, without a spring in a gap, and without friction, which would let
    /// nothing move.
    pub fn linearised(&self) -> Self {
        let stiffness = if self.freeplay > 0.0 { 0.0 } else { self.stiffness };
        Self { tire: TireLaw::Linear(self.tire.linearised()), stiffness, freeplay: 0.0, friction: 0.0, ..*self }
    }

    /// α, F_y, M_z and whether F_y is at its limit, at the slip ratio q = y/σ.
    fn at_slip_ratio(&self, q: f64) -> (f64, f64, f64, bool) {
        let law = &self.tire;
        let (force, moment) = (Side::of(q, 0.0, law.side_force_limit()), Side::of(q, 0.0, law.aligning_limit()));
        (law.slip_angle(q), law.side_force(q, force), law.aligning_moment(q, moment), force != Side::Within)
    }

    /// s(ψ) \[rad\].
    pub fn spring_angle(&self, psi: f64) -> f64 {
        Spring::new(self.stiffness, self.freeplay).angle(psi)
    }

    /// F of the damper on the gear \[N\], and r \[m\].
    fn damper_force(&self, x: &[f64]) -> (f64, f64) {
        self.fitted.map_or((0.0, 0.0), |fitted| (fitted.force(x), fitted.lever()))
    }

    /// Forces at the state (ψ, ψ̇, y), and the damper's after it.
    ///
    /// # Errors
    /// Parameters or a state so extreme that they leave the numbers.
    pub fn forces(&self, x: &[f64]) -> Result<Forces> {
        let (slip_angle, side_force, aligning_moment, side_force_limited) =
            self.at_slip_ratio(x[Y] / self.relaxation_length);
        let spring_angle = self.spring_angle(x[PSI]);
        let spring_torque = -self.stiffness * spring_angle;
        let (damper_force, lever) = self.damper_force(x);
        let damper_torque = 0.0 - lever * damper_force;
        let load = spring_torque + aligning_moment - self.caster_length * side_force + damper_torque;
        let friction_torque = DryFriction::new(self.friction).torque(x[PSI_RATE], load);
        let forces = Forces {
            slip_angle,
            side_force,
            aligning_moment,
            side_force_limited,
            spring_angle,
            spring_torque,
            friction_torque,
            damper_force,
            damper_torque,
        };
        forces.checked()
    }

    /// Forces at every row of the states' columns, which are of the same length.
    ///
    /// # Errors
    /// As [`Laws::forces`].
    pub(crate) fn along(&self, states: &[Vec<f64>]) -> Result<ForceColumns> {
        let rows = states.first().map_or(0, Vec::len);
        let empty = || Vec::with_capacity(rows);
        let mut columns = ForceColumns {
            slip_angle: empty(),
            side_force: empty(),
            aligning_moment: empty(),
            spring_torque: empty(),
            friction_torque: empty(),
            damper_force: empty(),
            damper_torque: empty(),
        };
        for row in 0..rows {
            let x: Vec<f64> = states.iter().map(|column| column[row]).collect();
            let forces = self.forces(&x)?;
            columns.slip_angle.push(forces.slip_angle);
            columns.side_force.push(forces.side_force);
            columns.aligning_moment.push(forces.aligning_moment);
            columns.spring_torque.push(forces.spring_torque);
            columns.friction_torque.push(forces.friction_torque);
            columns.damper_force.push(forces.damper_force);
            columns.damper_torque.push(forces.damper_torque);
        }
        Ok(columns)
    }

    /// Power at the state (ψ, ψ̇, y), and the damper's after it.
    #[inline(never)]
    pub fn power(&self, x: &[f64]) -> Power {
        let (_, side_force, aligning_moment, _) = self.at_slip_ratio(x[Y] / self.relaxation_length);
        let rate = x[PSI_RATE];
        let (damper_force, lever) = self.damper_force(x);
        Power {
            tire: (aligning_moment - self.caster_length * side_force) * rate,
            damper: self.damping * rate * rate,
            tread_width: self.tread_damping * rate * rate,
            friction: self.friction * rate.abs(),
            fitted: lever * damper_force * rate,
        }
    }

    /// ½I_zψ̇² and ½k s(ψ)² \[J\].
    pub fn stored(&self, x: &[f64]) -> (f64, f64) {
        let wound = self.spring_angle(x[PSI]);
        (0.5 * self.moment_of_inertia * x[PSI_RATE] * x[PSI_RATE], 0.5 * self.stiffness * wound * wound)
    }
}
