//! A motion under observation: the cycles that it completes.

use crate::{
    integrate::{Failure, Integrator},
    model::Gear,
};

/// One cycle, from a rise through zero of the first state to the next.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cycle<const N: usize> {
    pub start: f64,
    pub period: f64,
    pub low: f64,
    pub high: f64,
    /// Largest |·|: of the first state where it turns, of the others where steps end.
    pub amplitude: [f64; N],
}

/// How a look ahead ended.
#[derive(Clone, Copy, Debug)]
pub(crate) enum End {
    /// The motion repeats.
    Repeats,
    /// It gets to nothing.
    Dies,
    /// It gets to infinity.
    Grows,
    /// It stopped away from the middle.
    Stops,
}

/// A motion under observation: its open cycle and its first turns.
pub(super) struct Watch<S, const N: usize> {
    pub motion: Integrator<S, N>,
    open: Option<Cycle<N>>,
    pub turns: Vec<(f64, f64)>,
}

impl<S: Gear<N>, const N: usize> Watch<S, N> {
    pub fn new(motion: Integrator<S, N>) -> Self {
        Self { motion, open: None, turns: Vec::with_capacity(4) }
    }

    /// Goes on from another state; the open cycle does not count.
    pub fn jump(&mut self, x: [f64; N]) -> std::result::Result<(), Failure> {
        self.open = None;
        self.motion.restart(self.motion.time(), x)
    }

    /// Takes a step, and gives the cycle that it completes.
    pub fn step(&mut self, end: f64) -> std::result::Result<Option<Cycle<N>>, Failure> {
        self.motion.step(end)?;
        if let Some((t, value)) = self.motion.turning_point(0) {
            if self.turns.len() < 4 {
                self.turns.push((t, value));
            }
            if let Some(cycle) = &mut self.open {
                cycle.amplitude[0] = cycle.amplitude[0].max(value.abs());
                (cycle.low, cycle.high) = (cycle.low.min(value), cycle.high.max(value));
            }
        }
        // The turns of the other states would take as long again, a hundred cycles for one that counts.
        if let Some(cycle) = &mut self.open {
            for (amplitude, value) in cycle.amplitude.iter_mut().zip(self.motion.state()).skip(1) {
                *amplitude = amplitude.max(value.abs());
            }
        }
        let Some(t) = self.motion.rise_through_zero(0) else { return Ok(None) };
        let closed = self.open.take().map(|cycle| Cycle { period: t - cycle.start, ..cycle });
        self.open = Some(Cycle { start: t, period: 0.0, low: 0.0, high: 0.0, amplitude: [0.0; N] });
        Ok(closed)
    }
}
