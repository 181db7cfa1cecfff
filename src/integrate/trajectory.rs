//! Runs from start to end.

use super::{Failure, Integrator, Outcome, Stats, method::Scheme};
use crate::{
    error::{Code, Error, Result, shown},
    model::System,
};

/// The times at which a trajectory is wanted.
#[derive(Clone, Debug, PartialEq)]
pub enum Output {
    /// At these times: ascending, ≥ 0. The last one ends the run.
    Times(Vec<f64>),
    /// At this many times, equally spaced from 0 to the duration, both included.
    Samples(usize),
    /// At the solver's own steps, from 0 to the duration.
    Steps,
}

/// A motion from its start to its end, column by column.
#[derive(Clone, Debug, PartialEq)]
pub struct Trajectory {
    /// Times in s.
    pub time: Vec<f64>,
    /// One column per state variable, in the order of the state table.
    pub states: Vec<Vec<f64>>,
    /// Where piecewise laws changed.
    pub events: Events,
    /// What it has cost.
    pub stats: Stats,
    /// The scheme that was in use at the end.
    pub scheme: Scheme,
}

/// The switches met on the way.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Events {
    /// Their times in s, ascending.
    pub time: Vec<f64>,
    /// Their kinds: indices into `kinds`.
    pub kind: Vec<u8>,
    /// Names of the kinds.
    pub kinds: &'static [&'static str],
}

/// Columns that grow, or say that memory has run out.
struct Columns {
    time: Vec<f64>,
    states: Vec<Vec<f64>>,
}

impl Columns {
    fn with_room(width: usize, rows: usize) -> Result<Self> {
        let mut columns = Self { time: Vec::new(), states: vec![Vec::new(); width] };
        for column in std::iter::once(&mut columns.time).chain(&mut columns.states) {
            column.try_reserve_exact(rows).map_err(|_| out_of_memory(rows))?;
        }
        Ok(columns)
    }

    fn push<const N: usize>(&mut self, t: f64, x: &[f64; N]) -> Result<()> {
        if self.time.len() == self.time.capacity() {
            let rows = self.time.len().max(256);
            for column in std::iter::once(&mut self.time).chain(&mut self.states) {
                column.try_reserve(rows).map_err(|_| out_of_memory(2 * rows))?;
            }
        }
        self.time.push(t);
        for (column, value) in self.states.iter_mut().zip(x) {
            column.push(*value);
        }
        Ok(())
    }
}

fn out_of_memory(rows: usize) -> Error {
    Error::new(Code::TooLarge, "the trajectory", format!("{rows} rows"), "no longer than memory holds")
}

/// Carries a motion from t = 0 to its end and collects what is wanted.
///
/// # Errors
/// [`Code::StepLimit`] after `max_steps` steps, [`Code::Diverged`] and [`Code::StepTooSmall`] where the motion cannot go
/// on; each names the time reached.
pub fn solve<S: System<N>, const N: usize>(
    mut motion: Integrator<S, N>,
    duration: f64,
    output: &Output,
    max_steps: u64,
) -> Result<Trajectory> {
    let end = match output {
        Output::Times(times) => times.last().copied().unwrap_or(0.0),
        Output::Samples(_) | Output::Steps => duration,
    };
    let wanted = match output {
        Output::Times(times) => times.len(),
        Output::Samples(samples) => *samples,
        Output::Steps => 0,
    };
    let time_of = |row: usize| match output {
        Output::Times(times) => times[row],
        Output::Samples(_) if row + 1 == wanted => duration,
        Output::Samples(_) | Output::Steps => duration * row as f64 / (wanted - 1) as f64,
    };
    let mut columns = Columns::with_room(motion.system().width(), wanted.max(256))?;
    let mut events = Events { kinds: S::EVENT_KINDS, ..Events::default() };
    let mut row = 0;
    while row < wanted && time_of(row) <= 0.0 {
        columns.push(time_of(row), motion.state())?;
        row += 1;
    }
    if *output == Output::Steps {
        columns.push(0.0, motion.state())?;
    }
    while motion.time() < end {
        if motion.stats().steps >= max_steps {
            return Err(Error::step_limit(motion.time(), max_steps));
        }
        let outcome = motion.step(end).map_err(|failure| failed(failure, motion.time()))?;
        while row < wanted && time_of(row) <= motion.time() {
            let t = time_of(row);
            columns.push(t, &motion.interpolate(t))?;
            row += 1;
        }
        if *output == Output::Steps && columns.time.last() != Some(&motion.time()) {
            columns.push(motion.time(), motion.state())?;
        }
        if let Outcome::Switch(which) = outcome {
            events.time.push(motion.time());
            events.kind.push(motion.system().event_kind(which) as u8);
        }
    }
    let Columns { time, states } = columns;
    Ok(Trajectory { time, states, events, stats: motion.stats(), scheme: motion.scheme() })
}

/// A failure as an error that names the time.
pub(crate) fn failed(failure: Failure, t: f64) -> Error {
    match failure {
        Failure::Diverged => Error::new(
            Code::Diverged,
            "the motion",
            shown(t),
            "it grows without bound with these parameters; run it for less time, or choose less extreme values",
        ),
        Failure::StepTooLong => Error::new(
            Code::Unsuited,
            "step",
            format!("one that is too long at {} s", shown(t)),
            "so short for rk4 that it follows how the damper's hysteresis yields: step × rate at most 2",
        ),
        Failure::StepTooSmall => Error::new(
            Code::StepTooSmall,
            "the step",
            shown(t),
            "the equations change faster than time resolves there; choose less extreme values",
        ),
    }
}
