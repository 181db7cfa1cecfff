//! A control law at work on a gear.

use crate::{
    element::{Boundary, Side, control::Law},
    model::{
        Mode,
        torsional::{PSI, PSI_RATE},
    },
    real::Real,
};

// Bits in a mode, after those of the way: what the law does, which way the wheel turns, and whether the coil has failed.
const DOES: usize = 10;
const TURNS: usize = 11;
const FAILED: usize = 12;

/// It commands all or nothing: on. Of one that follows the rate: at its largest. Of an actuator, a [`Side`].
const ON: u32 = 1;

/// What a switch falls back behind, in parts of where it comes from: so no law chatters.
const BACK: f64 = 0.9;

/// A control law on a gear.
///
/// # Equations
/// u̇ = (I − u)/τ, with the law's command I, which is 0 once the coil has failed. Where a law commands by steps, they are
/// switches with a band of a tenth: it is on, or off, as a mode. With τ > 0 the force itself never jumps, so a motion cannot be
/// held between on and off.
#[derive(Clone, Copy, Debug)]
pub(super) struct Controlled {
    pub law: Law,
    /// 1/τ \[1/s\]
    pub fading: f64,
    /// \[s\]
    pub failure: f64,
    /// Where the state u is.
    pub place: usize,
}

impl Controlled {
    /// The mode at a time and state, `moment` being M_d.
    pub fn mode(&self, t: f64, mode: Mode, x: &[f64], moment: f64) -> Mode {
        let rate = x[PSI_RATE];
        let does = match self.law {
            Law::Passive(_) => 0,
            Law::OnOff { threshold, .. } => u32::from(rate.abs() > threshold),
            Law::Proportional { gain, high } => u32::from(gain * rate.abs() > high),
            Law::Clipped { damping, .. } => {
                let wanted = damping * rate;
                u32::from(moment * wanted > 0.0 && moment.abs() < wanted.abs())
            }
            Law::Active { damping, stiffness, most } => Side::of(damping * rate + stiffness * x[PSI], 0.0, most) as u32,
        };
        let failed = u32::from(t >= self.failure);
        mode.with(DOES, does).with(TURNS, u32::from(rate < 0.0)).with(FAILED, failed)
    }

    fn on(mode: Mode) -> bool {
        mode.sides(DOES) & 3 == ON
    }

    /// ψ̇, or −ψ̇, whichever is positive in this mode.
    fn speed<R: Real, const N: usize>(mode: Mode, x: &[R; N]) -> R {
        if mode.sides(TURNS) & 1 == 1 { -x[PSI_RATE] } else { x[PSI_RATE] }
    }

    /// What is commanded: a current, or a moment.
    fn command<R: Real, const N: usize>(&self, mode: Mode, x: &[R; N]) -> R {
        if mode.sides(FAILED) & 1 == 1 {
            return R::from(0.0);
        }
        match self.law {
            Law::Passive(command) => R::from(command),
            Law::OnOff { low, high, .. } => R::from(if Self::on(mode) { high } else { low }),
            Law::Proportional { high, .. } if Self::on(mode) => R::from(high),
            Law::Proportional { gain, .. } => Self::speed(mode, x) * gain,
            Law::Clipped { high, .. } => R::from(if Self::on(mode) { high } else { 0.0 }),
            Law::Active { damping, stiffness, most } => match mode.side(DOES) {
                Side::Within => x[PSI_RATE] * damping + x[PSI] * stiffness,
                Side::Above => R::from(most),
                Side::Below => R::from(-most),
            },
        }
    }

    /// u̇.
    pub fn rate<R: Real, const N: usize>(&self, mode: Mode, x: &[R; N]) -> R {
        (self.command(mode, x) - x[self.place]) * self.fading
    }

    /// Positive until the law does more: switches on, comes to its largest command, or to the actuator's upper bound.
    pub fn rising<R: Real, const N: usize>(&self, mode: Mode, x: &[R; N], moment: R) -> Option<R> {
        let rate = x[PSI_RATE];
        match self.law {
            Law::Active { damping, stiffness, most } => {
                mode.side(DOES).margin(Boundary::Upper, rate * damping + x[PSI] * stiffness, most)
            }
            _ if Self::on(mode) => None,
            Law::Passive(_) => None,
            Law::OnOff { threshold, .. } => Some(-rate * rate + threshold * threshold),
            Law::Proportional { gain, high } => Some(Self::speed(mode, x) * -gain + high),
            Law::Clipped { damping, .. } => {
                let wanted = rate * damping;
                let (along, less) = (moment * wanted, wanted * wanted * (BACK * BACK) - moment * moment);
                Some(if along.value() < less.value() { -along } else { -less })
            }
        }
    }

    /// Positive until it does less.
    pub fn falling<R: Real, const N: usize>(&self, mode: Mode, x: &[R; N], moment: R) -> Option<R> {
        let rate = x[PSI_RATE];
        match self.law {
            Law::Active { damping, stiffness, most } => {
                mode.side(DOES).margin(Boundary::Lower, rate * damping + x[PSI] * stiffness, most)
            }
            _ if !Self::on(mode) => None,
            Law::Passive(_) => None,
            Law::OnOff { threshold, .. } => Some(rate * rate - (BACK * threshold).powi(2)),
            Law::Proportional { gain, high } => Some(Self::speed(mode, x) * gain - high),
            Law::Clipped { damping, .. } => {
                let wanted = rate * damping;
                Some(wanted * wanted - moment * moment)
            }
        }
    }

    /// Positive until the wheel turns back, where the law asks for that; of a clipped one, until the damper pushes.
    pub fn turning<R: Real, const N: usize>(&self, mode: Mode, x: &[R; N], moment: R) -> Option<R> {
        match self.law {
            Law::Proportional { .. } => Some(Self::speed(mode, x)),
            Law::Clipped { .. } if Self::on(mode) => Some(x[PSI_RATE] * moment),
            _ => None,
        }
    }

    /// Positive until the coil fails.
    pub fn failing<R: Real>(&self, t: R, mode: Mode) -> Option<R> {
        (mode.sides(FAILED) & 1 == 0).then(|| -t + self.failure)
    }

    /// Past [`Controlled::rising`] or [`Controlled::falling`].
    pub fn stepped(&self, mode: Mode, upper: bool) -> Mode {
        match self.law {
            Law::Active { .. } => {
                let boundary = if upper { Boundary::Upper } else { Boundary::Lower };
                mode.with_side(DOES, mode.side(DOES).across(boundary))
            }
            _ => mode.with(DOES, u32::from(upper)),
        }
    }

    /// Past [`Controlled::turning`].
    pub fn turned(&self, mode: Mode) -> Mode {
        match self.law {
            Law::Clipped { .. } => mode.with(DOES, 0),
            _ => mode.with(TURNS, mode.sides(TURNS) & 1 ^ 1),
        }
    }

    /// The coil has failed.
    pub fn failed(mode: Mode) -> Mode {
        mode.with(FAILED, 1)
    }
}
