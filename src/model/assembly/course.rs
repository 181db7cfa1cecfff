//! How speed, weight and the runway change while a gear rolls.

use crate::{
    model::{Mode, torsional::Motion},
    real::Real,
};

// Bits in a mode, after those of the damper: the wheel has come to its last speed; the stretch of uneven runway lies
// ahead, is under the wheel, or lies behind.
const SLOWED: usize = 8;
const RUNWAY: usize = 9;
const UNDER: u32 = 1;
const BEHIND: u32 = 2;

/// A gear's speed and weight by the time.
///
/// # Equations
/// v(t) = v₀ − bt down to v_f, and v_f from then on; F_z(v) = F_z[1 − λ(v/v₀)²] as lift decays. b is kinematic: the load does
/// not move to the nose. Where κ follows F_z, it does so in proportion.
#[derive(Clone, Copy, Debug)]
pub struct Roll {
    /// v₀ \[m/s\]
    pub touchdown_velocity: f64,
    /// b \[m/s²\]
    pub deceleration: f64,
    /// v_f \[m/s\]
    pub final_velocity: f64,
    /// λ
    pub lift_fraction: f64,
    /// κ follows F_z.
    pub tread_follows: bool,
}

impl Roll {
    /// When it comes to its last speed \[s\].
    pub fn duration(&self) -> f64 {
        (self.touchdown_velocity - self.final_velocity) / self.deceleration
    }

    /// v(t) \[m/s\].
    pub fn velocity(&self, t: f64) -> f64 {
        (self.touchdown_velocity - self.deceleration * t).max(self.final_velocity)
    }

    #[inline(always)]
    fn at<R: Real>(&self, t: R, mode: Mode) -> R {
        if mode.sides(SLOWED) & 1 == 1 {
            R::from(self.final_velocity)
        } else {
            t * -self.deceleration + self.touchdown_velocity
        }
    }

    /// F_z(v)/F_z.
    #[inline(always)]
    fn weight<R: Real>(&self, velocity: R) -> R {
        let part = velocity * (1.0 / self.touchdown_velocity);
        part * part * -self.lift_fraction + 1.0
    }
}

/// A stretch of uneven runway.
///
/// # Equations
/// The moment M sin(2πs/λ) about the steering axis, s the way from the start of the stretch on.
#[derive(Clone, Copy, Debug)]
pub struct Unevenness {
    /// M \[N m\]
    pub moment: f64,
    /// λ \[m\]
    pub wavelength: f64,
    /// When the wheel comes to it \[s\].
    pub start: f64,
    /// How long it is on it \[s\].
    pub duration: f64,
}

/// What changes with the time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Course {
    pub roll: Option<Roll>,
    pub unevenness: Option<Unevenness>,
    /// v of a gear that does not slow down \[m/s\].
    pub velocity: f64,
    /// c/I_z
    pub damping: f64,
    /// κ/I_z
    pub tread: f64,
    /// 1/I_z
    pub mobility: f64,
    /// e − a, and 1/σ
    pub lever: f64,
    pub slip: f64,
}

impl Course {
    /// The motion's coefficients now, and the part of F_z that is on the wheel.
    #[inline(always)]
    pub fn motion<R: Real>(&self, t: R, mode: Mode) -> (Motion<R>, R) {
        let one = R::from(1.0);
        let (velocity, weight, follows) = match &self.roll {
            Some(roll) => {
                let velocity = roll.at(t, mode);
                (velocity, roll.weight(velocity), roll.tread_follows)
            }
            None => (R::from(self.velocity), one, false),
        };
        let tread = if follows { weight } else { one } * self.tread / velocity;
        let motion = Motion {
            velocity,
            lever: R::from(self.lever),
            relaxation_rate: velocity * self.slip,
            damping: tread + self.damping,
        };
        (motion, weight)
    }

    /// The runway's moment over I_z.
    #[inline(always)]
    pub fn push<R: Real>(&self, t: R, mode: Mode) -> R {
        match &self.unevenness {
            Some(runway) if mode.sides(RUNWAY) & 3 == UNDER => {
                let way = self.way(t, mode) - self.way(runway.start, Mode::default());
                (way * (std::f64::consts::TAU / runway.wavelength)).sin() * (runway.moment * self.mobility)
            }
            _ => R::from(0.0),
        }
    }

    /// How far it has rolled \[m\].
    fn way<R: Real>(&self, t: R, mode: Mode) -> R {
        match &self.roll {
            Some(roll) => {
                let end = roll.duration();
                if mode.sides(SLOWED) & 1 == 1 || t.value() > end {
                    let slowing = 0.5 * (roll.touchdown_velocity + roll.final_velocity) * end;
                    (t - end) * roll.final_velocity + slowing
                } else {
                    (t * (-0.5 * roll.deceleration) + roll.touchdown_velocity) * t
                }
            }
            None => t * self.velocity,
        }
    }

    /// The mode at a time.
    pub fn mode(&self, t: f64, mode: Mode) -> Mode {
        let slowed = self.roll.is_some_and(|roll| t >= roll.duration());
        let where_on = |runway: &Unevenness| match t - runway.start {
            before if before < 0.0 => 0,
            on if on < runway.duration => UNDER,
            _ => BEHIND,
        };
        mode.with(SLOWED, u32::from(slowed)).with(RUNWAY, self.unevenness.as_ref().map_or(0, where_on))
    }

    /// Positive until it comes to its last speed.
    pub fn slowing<R: Real>(&self, t: R, mode: Mode) -> Option<R> {
        let roll = self.roll.as_ref()?;
        (mode.sides(SLOWED) & 1 == 0).then(|| -t + roll.duration())
    }

    /// Positive until the wheel comes to the uneven stretch.
    pub fn coming<R: Real>(&self, t: R, mode: Mode) -> Option<R> {
        let runway = self.unevenness.as_ref()?;
        (mode.sides(RUNWAY) & 3 == 0).then(|| -t + runway.start)
    }

    /// Positive until it leaves it.
    pub fn leaving<R: Real>(&self, t: R, mode: Mode) -> Option<R> {
        let runway = self.unevenness.as_ref()?;
        (mode.sides(RUNWAY) & 3 == UNDER).then(|| -t + (runway.start + runway.duration))
    }

    /// It has come to its last speed.
    pub fn slowed(mode: Mode) -> Mode {
        mode.with(SLOWED, 1)
    }

    /// The runway has changed under the wheel.
    pub fn passed(mode: Mode) -> Mode {
        mode.with(RUNWAY, if mode.sides(RUNWAY) & 3 == 0 { UNDER } else { BEHIND })
    }
}
