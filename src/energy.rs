//! Where a swing's energy comes from, and where it goes.

use crate::{
    error::{Code, Error, Result},
    integrate::{Failure, Integrator, failed},
    model::{Gear, laws::Power},
    outlook::HORIZON,
    run::Posed,
};

/// Five-point Gauss–Legendre quadrature on \[0, 1\]: places and weights (Abramowitz and Stegun, table 25.4, halved). Over a
/// twentieth of a cycle it is exact to rounding.
pub(crate) const GAUSS: [(f64, f64); 5] = [
    (0.046_910_077_030_668, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_24),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_5, 0.239_314_335_249_683_24),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];
/// A step is at most this part of the time looked at: quadrature holds whatever the tolerance.
const STEPS: f64 = 16.0;

/// Energy that went through the steering motion over a time \[J\]: `tire` = `damper` + `tread_width` + `friction` + `fitted` +
/// `stored`, up to the error of the integration.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// The time \[s\].
    pub duration: f64,
    /// ∫(M_z − e F_y)ψ̇ dt: what the tire feeds in.
    pub tire: f64,
    /// ∫cψ̇² dt: what the damper takes.
    pub damper: f64,
    /// ∫(κ/v)ψ̇² dt: what the width of the tread takes.
    pub tread_width: f64,
    /// ∫M_f|ψ̇| dt: what dry friction takes.
    pub friction: f64,
    /// ∫M_dψ̇ dt: what a damper on the gear takes, for good or to be given back: its spring and its hysteresis store some.
    pub fitted: f64,
    /// By how much ½I_zψ̇² has risen.
    pub kinetic: f64,
    /// By how much ½k s(ψ)² has risen.
    pub spring: f64,
    /// By how much the energy of the motion has risen: `kinetic` + `spring`.
    pub stored: f64,
}

/// The energy of a run over its duration, or over one cycle from its start where it gives none; nothing where it does not
/// swing.
pub(crate) fn of<S: Gear<N>, const N: usize>(posed: &Posed<S, N>) -> Result<Option<Energy>> {
    let laws = posed.run.laws()?;
    let Some(duration) = posed.run.given_duration().map_or_else(|| cycle(posed), |given| Ok(Some(given)))? else {
        return Ok(None);
    };
    posed.check_step_count(duration)?;
    let mut motion = posed.motion(duration / STEPS)?;
    let (kinetic, spring) = laws.stored(motion.state());
    let mut energy = Energy { duration, ..Energy::default() };
    while motion.time() < duration {
        step(&mut motion, duration, posed.run.max_steps())?;
        let (start, length) = (motion.step_start(), motion.time() - motion.step_start());
        for (place, weight) in GAUSS {
            let Power { tire, damper, tread_width, friction, fitted } =
                laws.power(&motion.interpolate(start + place * length));
            energy.tire += weight * length * tire;
            energy.damper += weight * length * damper;
            energy.tread_width += weight * length * tread_width;
            energy.friction += weight * length * friction;
            energy.fitted += weight * length * fitted;
        }
    }
    let end = laws.stored(motion.state());
    (energy.kinetic, energy.spring) = (end.0 - kinetic, end.1 - spring);
    energy.stored = energy.kinetic + energy.spring;
    Error::unless_finite(
        "the energy",
        &[energy.tire, energy.damper, energy.tread_width, energy.friction, energy.fitted, energy.stored],
    )?;
    Ok(Some(energy))
}

/// The time between the next two rises of the first state through zero; none where it does not swing within the horizon.
fn cycle<S: Gear<N>, const N: usize>(posed: &Posed<S, N>) -> Result<Option<f64>> {
    let mut motion = posed.motion(HORIZON / 20.0)?;
    let mut first = None;
    while motion.time() < HORIZON {
        match step(&mut motion, f64::INFINITY, posed.run.max_steps()) {
            // What grows without a swing has no cycle.
            Err(error) if error.code == Code::Diverged => return Ok(None),
            outcome => outcome?,
        }
        match (motion.rise_through_zero(0), first) {
            (Some(second), Some(first)) => return Ok(Some(second - first)),
            (Some(rise), None) => first = Some(rise),
            (None, _) => {}
        }
    }
    Ok(None)
}

fn step<S: Gear<N>, const N: usize>(motion: &mut Integrator<S, N>, end: f64, most_steps: u64) -> Result<()> {
    let time = motion.time();
    if motion.stats().steps >= most_steps {
        return Err(Error::step_limit(time, most_steps));
    }
    motion.step(end).map(drop).map_err(|failure: Failure| failed(failure, time))
}
