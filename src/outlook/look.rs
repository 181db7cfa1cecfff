//! Following a motion, cycle by cycle, until its end can be told.

use super::{
    TRUSTED, approach,
    watch::{Cycle, End, Watch},
};
use crate::{
    error::Result,
    integrate::{Failure, Integrator, failed},
    model::Gear,
    parameter::StateVariable,
};

/// A cycle repeats when its amplitude changes by less than this over [`REPEATS`] cycles.
const REPEATING: f64 = 2e-8;
const REPEATS: usize = 5;
/// A motion has died out when it has fallen to this fraction of its start.
const GONE: f64 = 1e-5;
/// A motion has stopped when its rate has fallen to this fraction of the largest, or of what would take it through its own
/// size within the horizon: one that starts beside where it comes to rest is never fast.
const STILL: f64 = 1e-6;
/// Where friction holds a motion cannot be foreseen by a cut: one looks so many times as far.
const PATIENCE: f64 = 10.0;

/// What was seen.
pub(crate) struct Look<S, const N: usize> {
    pub motion: Integrator<S, N>,
    /// The cycles on the way.
    pub cycles: Vec<Cycle<N>>,
    /// First turning points of the first state: what is known before a cycle is complete.
    pub turns: Vec<(f64, f64)>,
    /// The cycle that it goes to, or the last one seen.
    pub destination: Option<Cycle<N>>,
    pub end: End,
}

/// Follows the motion until it repeats, is gone, or the horizon is reached; where it is still on its way then, the way
/// is cut short ([`approach`]).
pub(crate) fn look_ahead<S: Gear<N>, const N: usize>(
    motion: Integrator<S, N>,
    scales: &[StateVariable],
    horizon: f64,
    most_steps: u64,
) -> Result<Look<S, N>> {
    let horizon = if motion.system().sticks() { PATIENCE * horizon } else { horizon };
    let mut watch = Watch::new(motion);
    let mut cycles: Vec<Cycle<N>> = Vec::new();
    let start = size(scales, watch.motion.state());
    let mut fastest = size(scales, watch.motion.derivative());
    let mut end = None;
    while watch.motion.time() < horizon && end.is_none() && watch.motion.stats().steps < most_steps {
        let time = watch.motion.time();
        match watch.step(horizon) {
            Ok(cycle) => cycles.extend(cycle),
            Err(Failure::Diverged) => {
                end = Some(End::Grows);
                break;
            }
            Err(failure) => return Err(failed(failure, time)),
        }
        let (size, speed) = (size(scales, watch.motion.state()), size(scales, watch.motion.derivative()));
        fastest = fastest.max(speed);
        end = if size < GONE * start && !held(&watch.motion) {
            Some(End::Dies)
        } else if size > 1e6 * start.max(1.0) {
            Some(End::Grows)
        } else if speed < STILL * fastest.max(size / horizon) {
            Some(End::Stops)
        } else {
            repeats(&cycles).then_some(End::Repeats)
        };
    }
    let mut destination = cycles.last().copied();
    let end = match (end, destination) {
        (Some(end), _) => end,
        (None, Some(last)) if watch.motion.time() < last.start + 3.0 * last.period => {
            let (end, cycle) = approach::shortcut(&mut watch, &cycles, most_steps)?;
            destination = Some(cycle);
            end
        }
        (None, _) => without_cycles(&watch.motion, scales, start, fastest),
    };
    Ok(Look { motion: watch.motion, cycles, turns: watch.turns, destination, end })
}

/// Whether friction holds the first state away from the middle.
pub(super) fn held<S: Gear<N>, const N: usize>(motion: &Integrator<S, N>) -> bool {
    motion.system().sticks() && motion.state()[0] != 0.0 && motion.derivative()[0] == 0.0
}

/// Largest state in units of its scale.
fn size<const N: usize>(scales: &[StateVariable], x: &[f64; N]) -> f64 {
    x.iter().zip(scales).fold(0.0, |most: f64, (x, state)| most.max(x.abs() / state.scale))
}

/// Whether the last cycles are the same.
fn repeats<const N: usize>(cycles: &[Cycle<N>]) -> bool {
    let [.., before, _, _, _, _, last] = cycles else { return false };
    const { assert!(REPEATS == 5) };
    (last.amplitude[0] - before.amplitude[0]).abs() < REPEATING * last.amplitude[0]
}

/// The end of a motion that does not oscillate (any more) at the horizon: by where it is and how fast it still goes.
fn without_cycles<S: Gear<N>, const N: usize>(
    motion: &Integrator<S, N>,
    scales: &[StateVariable],
    start: f64,
    fastest: f64,
) -> End {
    let (size, speed) = (size(scales, motion.state()), size(scales, motion.derivative()));
    if motion.state()[0].abs() > TRUSTED || (size > start && speed > 0.5 * fastest) {
        End::Grows
    } else if size < start && !held(motion) {
        End::Dies
    } else {
        End::Stops
    }
}
