//! A damper on a gear.

use super::{STATES, Z};
use crate::{
    element::damper::{Coefficients, Course, Damper, Response},
    error::Result,
    few::padded,
    model::{
        Mode,
        torsional::{PSI, PSI_RATE},
    },
    real::{Dual, Number, Real},
};

/// State w of a damper in series.
const W: usize = Z + 1;

// The damper's bits in a mode, after those of the gear.
const HEADING: usize = 6;
const PHASE: usize = 7;

/// The hysteresis variable has yielded for good once it is this near to its largest value, in parts of it. The way there is
/// exponential: what is left of it pulls with less than any tolerance asks for, and would hold an explicit step down to
/// some microseconds from then on.
const YIELDED: f64 = 1e-10;

/// Which way the hysteresis variable goes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Phase {
    /// Away from zero, to where it yields.
    Away = 0,
    /// Back to zero.
    Back = 1,
    /// It has yielded, and stays.
    Yielded = 2,
    /// Down to where it yields, from beyond: a start from there, or the damper has become another one.
    Beyond = 3,
}

/// A damper whose piston is driven by the turning wheel through a lever.
///
/// # Equations
/// x = rψ, M_d = rF, and the damper's own, with ż held to a *phase*: which way the piston goes, and whether |z| rises, falls
/// or has yielded. Within a phase all is smooth. A phase ends where the velocity of the element's ends is zero, where z is,
/// or where z comes to its largest value: there it is put to just that, and stays until the piston turns. So the only stiff
/// stretch of the equations, z held at saturation at some 10⁵ s⁻¹, is none, and explicit methods of high order serve.
///
/// # Measured
/// Simple form at 1.1 A, v = 80 m/s, c = 0, on the cycle (52 a second), for a second at rtol 10⁻⁸: 4,205 steps of DOP853. Without
/// the phase of having yielded it takes 71,757, held at its stability bound, and Rodas5P 9,437 in 3.6 times as long.
#[derive(Clone, Copy, Debug)]
pub struct Fitted {
    damper: Damper,
    /// r \[m\]
    lever: f64,
    /// r/I_z
    arm: f64,
    /// z_max
    most: f64,
    command: f64,
    /// At the command, where that acts at once.
    steady: Coefficients,
    /// Where the state u is, if there is one, and how fast it comes to the command \[1/s\].
    place: Option<(usize, f64)>,
}

impl Fitted {
    /// With the lever arm r \[m\] on a gear of mobility 1/I_z, at a command; `fading`: of a coil that takes its time where the
    /// damper's own does not \[1/s\].
    pub fn new(damper: Damper, lever: f64, mobility: f64, command: f64, fading: Option<f64>) -> Self {
        let place = Z + 1 + usize::from(damper.in_series());
        let place = damper.command_rate().or(fading).map(|fading| (place, fading));
        let (most, steady) = (damper.hysteresis().saturation(), damper.coefficients(command));
        Self { damper, lever, arm: lever * mobility, most, command, steady, place }
    }

    /// The velocity of the hysteresis element's ends is not that of the piston.
    pub fn slips(&self) -> bool {
        self.damper.in_series()
    }

    /// Where its state u is, if it has one.
    pub fn place(&self) -> Option<usize> {
        self.place.map(|(place, _)| place)
    }

    /// How fast the command takes effect, where it takes its time \[1/s\].
    pub fn fading_of_command(&self) -> Option<f64> {
        self.place.map(|(_, fading)| fading)
    }

    /// How many states it has.
    pub fn states(&self) -> usize {
        1 + usize::from(self.damper.in_series()) + usize::from(self.place.is_some())
    }

    /// At rest with no force on the wheel; and a bit for each state that may have any value there.
    pub fn rest<const N: usize>(&self, x: &mut [f64; N]) -> u32 {
        if let Some(place) = self.place() {
            x[place] = self.command;
        }
        let loose = self.damper.in_series() && self.steady.stiffness == 0.0;
        1 << Z | u32::from(loose) << W
    }

    #[inline(always)]
    fn coefficients<R: Real, const N: usize>(&self, x: &[R; N]) -> Coefficients<R> {
        match self.place {
            Some((place, _)) => self.damper.coefficients(x[place]),
            None => {
                let Coefficients { viscous, stiffness, hysteresis_gain, series, accumulator, preload } = self.steady;
                Coefficients {
                    viscous: R::from(viscous),
                    stiffness: R::from(stiffness),
                    hysteresis_gain: R::from(hysteresis_gain),
                    series: R::from(series),
                    accumulator: R::from(accumulator),
                    preload: R::from(preload),
                }
            }
        }
    }

    #[inline(always)]
    fn response<R: Real, const N: usize>(&self, x: &[R; N]) -> Response<R> {
        let (displacement, velocity) = (x[PSI] * self.lever, x[PSI_RATE] * self.lever);
        self.damper.response(&self.coefficients(x), displacement, velocity, x[Z], x[W])
    }

    /// M_d \[N m\].
    pub fn moment<R: Real, const N: usize>(&self, x: &[R; N]) -> R {
        self.response(x).force * self.lever
    }

    /// F \[N\].
    pub fn force(&self, x: &[f64]) -> f64 {
        let x: [f64; STATES] = padded(x, 0.0);
        self.response(&x).force
    }

    /// r \[m\].
    pub fn lever(&self) -> f64 {
        self.lever
    }

    /// Puts in the rates of its states, and gives M_d/I_z.
    #[inline(always)]
    pub fn rate<R: Real, const N: usize>(&self, mode: Mode, x: &[R; N], rate: &mut [R; N]) -> R {
        let Response { force, slip, internal } = self.response(x);
        let element = self.damper.hysteresis();
        rate[Z] = match mode.sides(PHASE) & 3 {
            phase if phase == Phase::Yielded as u32 => R::from(0.0),
            phase if phase == Phase::Back as u32 => slip * element.slope_on(Course::Back, x[Z]),
            _ => slip * element.slope_on(Course::Away, x[Z]),
        };
        if self.damper.in_series() {
            rate[W] = internal;
        }
        if let Some((place, fading)) = self.place {
            rate[place] = (x[place] - self.command) * -fading;
        }
        force * self.arm
    }

    /// The velocity of the hysteresis element's ends.
    pub fn slip<R: Real, const N: usize>(&self, x: &[R; N]) -> R {
        self.response(x).slip
    }

    /// How it changes while the state does like this.
    pub fn pull<const N: usize>(&self, x: &[f64; N], rate: &[f64; N]) -> f64 {
        let along: [Dual<1>; N] = std::array::from_fn(|i| Dual { value: x[i], slope: [rate[i]] });
        self.slip(&along).slope[0]
    }

    fn sign(mode: Mode) -> f64 {
        if mode.sides(HEADING) & 1 == 0 { 1.0 } else { -1.0 }
    }

    fn is(mode: Mode, phase: Phase) -> bool {
        mode.sides(PHASE) & 3 == phase as u32
    }

    /// The mode in which the element's ends go forward, or back.
    pub fn heading<const N: usize>(&self, mode: Mode, forward: bool, x: &[f64; N]) -> Mode {
        let z = if forward { x[Z] } else { -x[Z] };
        let phase = if z < 0.0 {
            Phase::Back
        } else if z < self.most * (1.0 - YIELDED) {
            Phase::Away
        } else if z <= self.most * (1.0 + YIELDED) {
            Phase::Yielded
        } else {
            Phase::Beyond
        };
        mode.with(HEADING, u32::from(!forward)).with(PHASE, phase as u32)
    }

    /// Positive as long as the element's ends go on like this.
    #[inline(always)]
    pub fn going<R: Real, const N: usize>(&self, mode: Mode, x: &[R; N]) -> R {
        self.slip(x) * Self::sign(mode)
    }

    /// Positive as long as z has not come back to zero.
    #[inline(always)]
    pub fn returning<R: Real, const N: usize>(&self, mode: Mode, x: &[R; N]) -> Option<R> {
        Self::is(mode, Phase::Back).then(|| x[Z] * -Self::sign(mode))
    }

    /// Positive as long as z has not come to where it yields.
    #[inline(always)]
    pub fn yielding<R: Real, const N: usize>(&self, mode: Mode, x: &[R; N]) -> Option<R> {
        let z = x[Z] * Self::sign(mode);
        if Self::is(mode, Phase::Away) {
            Some(-z + self.most * (1.0 - YIELDED))
        } else {
            Self::is(mode, Phase::Beyond).then(|| z - self.most * (1.0 + YIELDED))
        }
    }

    /// The element's ends have turned: where they are the piston's, so has the wheel.
    pub fn turned<const N: usize>(&self, mode: Mode, x: &mut [f64; N]) -> Mode {
        if !self.slips() {
            x[PSI_RATE] = 0.0;
        }
        let phase = if Self::is(mode, Phase::Back) { Phase::Away } else { Phase::Back };
        mode.with(HEADING, mode.sides(HEADING) & 1 ^ 1).with(PHASE, phase as u32)
    }

    /// z has come back to zero.
    pub fn returned<const N: usize>(&self, mode: Mode, x: &mut [f64; N]) -> Mode {
        x[Z] = 0.0;
        mode.with(PHASE, Phase::Away as u32)
    }

    /// z has yielded.
    pub fn yielded<const N: usize>(&self, mode: Mode, x: &mut [f64; N]) -> Mode {
        x[Z] = self.most * Self::sign(mode);
        mode.with(PHASE, Phase::Yielded as u32)
    }

    /// The fastest rate at which z comes to where it yields, at the piston's velocity now.
    pub fn fading<const N: usize>(&self, mode: Mode, x: &[f64; N]) -> f64 {
        if Self::is(mode, Phase::Yielded) {
            return 0.0;
        }
        self.damper.hysteresis().stiffness() * self.slip(x).abs()
    }

    /// That z may start like this.
    ///
    /// # Errors
    /// As [`Damper::check_hysteresis`].
    pub fn check_hysteresis(&self, z: f64) -> Result<()> {
        self.damper.check_hysteresis(z).map(drop)
    }

    /// z within what it can be.
    pub fn within(&self, z: f64) -> f64 {
        z.clamped(self.most)
    }
}
