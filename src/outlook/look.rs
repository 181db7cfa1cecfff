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

/// A look ahead under way: the motion is followed until it repeats, is gone, or the horizon is reached; where it is still on
/// its way then, the way is cut short ([`approach`]).
pub(crate) struct Ahead<S, const N: usize> {
    watch: Watch<S, N>,
    cycles: Vec<Cycle<N>>,
    scales: &'static [StateVariable],
    horizon: f64,
    most_steps: u64,
    /// The size at the start, and the fastest rate so far.
    start: f64,
    fastest: f64,
    end: Option<End>,
}

/// The same in one go.
pub(crate) fn look_ahead<S: Gear<N>, const N: usize>(
    motion: Integrator<S, N>,
    scales: &'static [StateVariable],
    horizon: f64,
    most_steps: u64,
) -> Result<Look<S, N>> {
    let mut ahead = Ahead::of(motion, scales, horizon, most_steps);
    while !ahead.follow(usize::MAX)? {}
    ahead.seen()
}

impl<S: Gear<N>, const N: usize> Ahead<S, N> {
    /// From where the motion is.
    pub fn of(motion: Integrator<S, N>, scales: &'static [StateVariable], horizon: f64, most_steps: u64) -> Self {
        let horizon = if motion.system().sticks() { PATIENCE * horizon } else { horizon };
        let (start, fastest) = (size(scales, motion.state()), size(scales, motion.derivative()));
        let watch = Watch::new(motion);
        Self { watch, cycles: Vec::new(), scales, horizon, most_steps, start, fastest, end: None }
    }

    /// Follows the motion for so many steps more; says whether there is no more to follow.
    pub fn follow(&mut self, steps: usize) -> Result<bool> {
        for _ in 0..steps {
            let time = self.watch.motion.time();
            if time >= self.horizon || self.end.is_some() || self.watch.motion.stats().steps >= self.most_steps {
                return Ok(true);
            }
            match self.watch.step(self.horizon) {
                Ok(cycle) => self.cycles.extend(cycle),
                Err(Failure::Diverged) => {
                    self.end = Some(End::Grows);
                    return Ok(true);
                }
                Err(failure) => return Err(failed(failure, time)),
            }
            self.end = self.judged();
        }
        Ok(false)
    }

    /// The states, with their typical sizes.
    pub fn scales(&self) -> &'static [StateVariable] {
        self.scales
    }

    /// The end that the last step shows, if it does.
    #[inline]
    fn judged(&mut self) -> Option<End> {
        let motion = &self.watch.motion;
        let (size, speed) = (size(self.scales, motion.state()), size(self.scales, motion.derivative()));
        self.fastest = self.fastest.max(speed);
        if size < GONE * self.start && !held(motion) {
            Some(End::Dies)
        } else if size > 1e6 * self.start.max(1.0) {
            Some(End::Grows)
        } else if speed < STILL * self.fastest.max(size / self.horizon) {
            Some(End::Stops)
        } else {
            repeats(&self.cycles).then_some(End::Repeats)
        }
    }

    /// What was seen.
    pub fn seen(self) -> Result<Look<S, N>> {
        let Self { mut watch, cycles, scales, most_steps, start, fastest, end, .. } = self;
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
