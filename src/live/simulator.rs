//! What a live motion offers, whatever its model.

use super::series::{Columns, Envelope};
use crate::{error::Result, integrate::Stats, model::Description};

/// A live motion. Times in s, from 0; the state in the order of the state table.
pub trait Live {
    /// The model's tables.
    fn description(&self) -> Description;
    /// The time that is shown.
    fn time(&self) -> f64;
    /// Earliest and latest time that can be sought.
    fn range(&self) -> [f64; 2];
    /// The state at the time shown.
    fn state(&mut self) -> Vec<f64>;
    /// The parameters at the time shown, in table order.
    fn parameters(&self) -> Vec<f64>;
    /// What the motion has cost up to here.
    fn stats(&self) -> Stats;
    /// Goes on by `dt` ≥ 0 s, with the changes recorded on the way where that is the past.
    ///
    /// # Errors
    /// A bad `dt`; a motion that cannot go on, which then shows the last time it reached.
    fn advance(&mut self, dt: f64) -> Result<()>;
    /// Sets a parameter now; what had been recorded after now is forgotten.
    ///
    /// # Errors
    /// An unknown name, a value that is not valid.
    fn set(&mut self, name: &str, value: f64) -> Result<()>;
    /// Sets a state variable now; what had been recorded after now is forgotten.
    ///
    /// # Errors
    /// An unknown name, a value that is not finite.
    fn set_state(&mut self, name: &str, value: f64) -> Result<()>;
    /// Gives an angular impulse in N m s about the steering axis now.
    ///
    /// # Errors
    /// An impulse that is not finite.
    fn kick(&mut self, impulse: f64) -> Result<()>;
    /// Back to the run as it was given: t = 0, its start, its parameters, no past.
    ///
    /// # Errors
    /// None that the start did not have.
    fn reset(&mut self) -> Result<()>;
    /// Shows another time within [`Live::range`].
    ///
    /// # Errors
    /// A time outside.
    fn seek(&mut self, time: f64) -> Result<()>;
    /// The present as bytes, from which [`Live::restore`] goes on bit by bit. The past is not in them.
    fn snapshot(&self) -> Vec<u8>;
    /// Takes up the motion of a snapshot of the same model.
    ///
    /// # Errors
    /// Bytes that are not such a snapshot; the motion stays as it was.
    fn restore(&mut self, bytes: &[u8]) -> Result<()>;
    /// The solver's steps since the last call up to the time shown, thinned to at most `most` ≥ 2 rows. With room for two
    /// rows a state no peak is lost; some 10 000 steps are remembered, then every other stretch's peaks.
    ///
    /// # Errors
    /// A bad `most`.
    fn trace(&mut self, most: f64) -> Result<Columns>;
    /// Values at `samples` times, equally spaced from `from` to `to`, of what has been recorded.
    ///
    /// # Errors
    /// Times outside of the range, a bad number of samples.
    fn history(&self, from: f64, to: f64, samples: f64) -> Result<Columns>;
    /// Least and greatest value of the first state in `stretches` equal parts of \[`from`, `to`\].
    ///
    /// # Errors
    /// As [`Live::history`].
    fn envelope(&self, from: f64, to: f64, stretches: f64) -> Result<Envelope>;
}

/// A live motion of any model.
pub struct Simulator(Box<dyn Live>);

impl Simulator {
    pub(crate) fn new(motion: Box<dyn Live>) -> Self {
        Self(motion)
    }
}

impl std::ops::Deref for Simulator {
    type Target = dyn Live;
    fn deref(&self) -> &Self::Target {
        &*self.0
    }
}

impl std::ops::DerefMut for Simulator {
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut *self.0
    }
}

impl std::fmt::Debug for Simulator {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Simulator").field("model", &self.description().name).field("time", &self.time()).finish()
    }
}
