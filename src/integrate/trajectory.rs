//! Runs from start to end.

use super::{Failure, Integrator, Outcome, Stats, method::Scheme};
use crate::{
    error::{Code, Error, Result, shown},
    live::thin,
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
    /// At the solver's own steps and where the first state turns, thinned to about so many rows, the least and greatest values
    /// of every state among them: to be drawn.
    Rows(usize),
}

impl Output {
    /// How many times are wanted that are known beforehand.
    #[inline(always)]
    fn wanted(&self) -> usize {
        match self {
            Self::Times(times) => times.len(),
            Self::Samples(samples) => *samples,
            Self::Steps | Self::Rows(_) => 0,
        }
    }
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
    motion: Integrator<S, N>,
    duration: f64,
    output: &Output,
    max_steps: u64,
) -> Result<Trajectory> {
    let mut way = Solving::new(motion, duration, output.clone(), max_steps)?;
    while !way.advance(u64::MAX)? {}
    Ok(way.trajectory())
}

/// A motion on its way, with what has been collected of it.
pub(crate) struct Solving<S, const N: usize> {
    motion: Integrator<S, N>,
    output: Output,
    duration: f64,
    end: f64,
    max_steps: u64,
    columns: Columns,
    events: Events,
    /// The next of the times that are wanted.
    row: usize,
}

impl<S: System<N>, const N: usize> Solving<S, N> {
    /// At t = 0.
    ///
    /// # Errors
    /// More rows than memory holds.
    pub fn new(motion: Integrator<S, N>, duration: f64, output: Output, max_steps: u64) -> Result<Self> {
        let end = match &output {
            Output::Times(times) => times.last().copied().unwrap_or(0.0),
            Output::Samples(_) | Output::Steps | Output::Rows(_) => duration,
        };
        let mut way = Self {
            columns: Columns::with_room(motion.system().width(), output.wanted().max(256))?,
            events: Events { kinds: S::EVENT_KINDS, ..Events::default() },
            motion,
            output,
            duration,
            end,
            max_steps,
            row: 0,
        };
        while way.row < way.output.wanted() && way.wanted_time() <= 0.0 {
            way.columns.push(way.wanted_time(), way.motion.state())?;
            way.row += 1;
        }
        if way.output.wanted() == 0 {
            way.columns.push(0.0, way.motion.state())?;
        }
        Ok(way)
    }

    /// The next time that is wanted.
    #[inline(always)]
    fn wanted_time(&self) -> f64 {
        match &self.output {
            Output::Times(times) => times[self.row],
            Output::Samples(wanted) if self.row + 1 == *wanted => self.duration,
            output => self.duration * self.row as f64 / (output.wanted() - 1) as f64,
        }
    }

    /// Takes so many steps, or those that are left; says whether it has come to its end.
    ///
    /// # Errors
    /// As [`solve`].
    pub fn advance(&mut self, steps: u64) -> Result<bool> {
        let wanted = self.output.wanted();
        let before = self.motion.stats().steps;
        while self.motion.time() < self.end && self.motion.stats().steps - before < steps {
            if self.motion.stats().steps >= self.max_steps {
                return Err(Error::step_limit(self.motion.time(), self.max_steps));
            }
            let outcome = self.motion.step(self.end).map_err(|failure| failed(failure, self.motion.time()))?;
            while self.row < wanted && self.wanted_time() <= self.motion.time() {
                let t = self.wanted_time();
                self.columns.push(t, &self.motion.interpolate(t))?;
                self.row += 1;
            }
            if wanted == 0 {
                self.push_step()?;
            }
            if let Outcome::Switch(which) = outcome {
                self.events.time.push(self.motion.time());
                self.events.kind.push(self.motion.system().event_kind(which) as u8);
            }
        }
        Ok(self.motion.time() >= self.end)
    }

    /// The end of a step, and where it is to be drawn the first state's turn on the way.
    #[inline(always)]
    fn push_step(&mut self) -> Result<()> {
        if let Output::Rows(_) = self.output
            && let Some((t, _)) = self.motion.turning_point(0)
            && t < self.motion.time()
        {
            self.columns.push(t, &self.motion.interpolate(t))?;
        }
        if self.columns.time.last() != Some(&self.motion.time()) {
            self.columns.push(self.motion.time(), self.motion.state())?;
        }
        Ok(())
    }

    /// Start and end, which need be no peaks.
    fn add_ends(&self, time: &mut Vec<f64>, states: &mut [Vec<f64>]) {
        let all = &self.columns;
        let last = all.time.len() - 1;
        if time.first() != all.time.first() {
            time.insert(0, all.time[0]);
            states.iter_mut().zip(&all.states).for_each(|(column, all)| column.insert(0, all[0]));
        }
        if time.last() != all.time.last() {
            time.push(all.time[last]);
            states.iter_mut().zip(&all.states).for_each(|(column, all)| column.push(all[last]));
        }
    }

    /// The time that it has come to, in parts of the whole.
    pub fn fraction(&self) -> f64 {
        if self.end > 0.0 { (self.motion.time() / self.end).min(1.0) } else { 1.0 }
    }

    /// What there is of it.
    pub fn trajectory(&self) -> Trajectory {
        let Columns { time, states } = &self.columns;
        let (mut time, mut states) = (time.clone(), states.clone());
        if let Output::Rows(most) = self.output {
            thin(&mut time, &mut states, most);
            self.add_ends(&mut time, &mut states);
        }
        let (stats, scheme) = (self.motion.stats(), self.motion.scheme());
        Trajectory { time, states, events: self.events.clone(), stats, scheme }
    }
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
