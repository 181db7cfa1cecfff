//! The live motion: it goes on by any amount of time, takes changes on its way, and finds back.
//!
//! Steps overshoot the time asked for and are interpolated, so that the path does not depend on how time is cut. What
//! was is kept as a keyframe every 50 ms and a journal of changes: any past moment is the nearest keyframe and a re-run,
//! equal to the last bit.

mod codec;
mod cursor;
mod journal;
mod keyframes;
mod motion;
mod series;
mod simulator;
mod snapshot;

pub(crate) use codec::Codec;
pub(crate) use motion::Motion;
pub(crate) use series::thin;
pub use series::{Columns, Envelope};
pub use simulator::{Live, Simulator};

/// How far back a motion can be seen, in s.
pub const REACH: f64 = 60.0;
/// Time between keyframes, in s; also the longest step, so that no keyframe's place is passed over.
const INTERVAL: f64 = 0.05;
