//! The torsional gear in the lanes of an ensemble: without modes, each lane with a gear of its own.

use std::f64::consts::TAU;

use super::{Gear, Motion, PSI, STATE, System, Torsional, Y};
use crate::{
    element::tire_law::{ALIGNING_TERMS, CASTING_TERMS},
    model::Mode,
    real::Sums,
    stability::eigenvalues,
};

/// How many numbers a gear is.
const COUNT: usize = 8 + CASTING_TERMS + ALIGNING_TERMS;
/// Steps in a swing of the gear without freeplay: 2·10⁻⁴ s at 50 Hz.
const STEPS: f64 = 100.0;
/// The longest step in terms of what fades: |λ| times it. Stable were 2.7.
const FADING: f64 = 0.5;
/// Shorter steps than this would never come to an end: such a gear is followed by itself, with a method for stiff equations.
const SHORTEST: f64 = 1e-6;

/// A gear made ready for an ensemble.
#[derive(Clone, Debug)]
pub struct Prepared {
    /// The step \[s\].
    pub step: f64,
    /// The gear for that step.
    pub gear: Laned<f64>,
    /// The same without freeplay, where it has any.
    pub gapless: Option<Laned<f64>>,
    /// Below this amplitude \[rad\] all is linear, and what falls, falls to rest: within the gap, or where the tire's laws are
    /// still straight.
    pub small: f64,
}

impl Prepared {
    /// None where an ensemble cannot take the gear.
    pub fn of(gear: &Torsional) -> Option<Self> {
        let gapless = gear.without_freeplay();
        let swinging = gapless.as_ref().unwrap_or(gear);
        let rows = swinging.jacobian(0.0, Mode::default(), &[0.0; 3]);
        let matrix = nalgebra::DMatrix::from_fn(3, 3, |i, j| rows[i][j]);
        let rates = matrix.iter().all(|entry| entry.is_finite()).then(|| eigenvalues(&matrix).ok())??;
        let step = rates.iter().fold(f64::INFINITY, |step, rate| {
            let swing = if rate.im == 0.0 { f64::INFINITY } else { TAU / STEPS / rate.im.abs() };
            step.min(swing).min(FADING / rate.norm())
        });
        if !(SHORTEST..f64::INFINITY).contains(&step) {
            return None;
        }
        let freeplay = gear.spring.freeplay();
        let small = 0.01 * STATE[PSI].scale;
        Some(Self {
            step,
            gear: Laned::of(gear, step)?,
            gapless: gapless
                .as_ref()
                .map(|gapless| Laned::of(gapless, step))
                .map_or(Some(None), |gear| gear.map(Some))?,
            small: if freeplay > 0.0 { small.min(0.1 * freeplay) } else { small },
        })
    }
}

/// A gear as numbers, with the time in units of a step and ψ̇ as the change of ψ in one: so a step multiplies by nothing.
///
/// Where a law is piecewise in its argument, it is a smooth one of the argument clamped: s(ψ) is ψ − ψ clamped to the gap,
/// F_y and M_z are their polynomials in y clamped to their limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Laned<R>(pub [R; COUNT]);

impl Laned<f64> {
    /// Nothing that moves.
    pub const REST: Self = Self([0.0; COUNT]);

    /// The gear for steps of `h` s; none where its tire's laws are not polynomials.
    pub fn of(gear: &Torsional, h: f64) -> Option<Self> {
        let Motion { velocity, lever, relaxation_rate, damping } = gear.motion;
        let (limits, casting, aligning) = gear.tire.clamped(gear.slip_ratio, gear.limits)?;
        let mut numbers = [0.0; COUNT];
        let (first, polynomials) = numbers.split_at_mut(8);
        let stiffness = h * h * gear.stiffness * gear.mobility;
        first.copy_from_slice(&[
            h * velocity,
            lever,
            h * relaxation_rate,
            h * damping,
            stiffness,
            gear.spring.freeplay(),
            limits[0],
            limits[1],
        ]);
        for (number, power) in polynomials.iter_mut().zip(casting.iter().chain(&aligning)) {
            *number = h * h * power;
        }
        numbers.iter().all(|number| number.is_finite()).then_some(Self(numbers))
    }
}

impl<R: Sums<R>> Laned<R> {
    /// The change of the state (ψ, the change of ψ, y) in a step.
    #[inline(always)]
    pub fn rate(&self, x: &[R; 3]) -> [R; 3] {
        let c = &self.0;
        let motion = Motion { velocity: c[0], lever: c[1], relaxation_rate: c[2], damping: c[3] };
        let spring = (x[PSI] - x[PSI].clamped(c[5])) * c[4];
        let (force, moment) = (x[Y].clamped(c[6]), x[Y].clamped(c[7]));
        // Pairs, and pairs of pairs: so nothing waits long for what comes before.
        let square = force * force;
        let casting = c[8].plus(c[9].plus(c[10], square), square) * force;
        let square = moment * moment;
        let fourth = square * square;
        let (low, middle, high) = (c[11].plus(c[12], square), c[13].plus(c[14], square), c[15].plus(c[16], square));
        let tire = casting.plus(low.plus(middle.plus(high, fourth), fourth), moment);
        motion.rate(x, spring, tire)
    }
}
