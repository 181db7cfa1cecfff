//! The atlas: every figure and table of the work that this project implements, as a run or a map to look at.

/// The entries as JSON, one a line: an `id` (`Figure 5.59`), a `title`, a `view`, and what the view is made of: a `run`,
/// a `map`, a `damper` … Numbers are SI.
///
/// Source: E. Atabay, *Dynamics of a Landing Gear Mechanism*, Istanbul Technical University, 2012: the captions of its
/// figures and tables. What a caption does not give was chosen here: ranges of maps, durations, starts.
pub const JSON: &str = include_str!("atlas.json");
