//! Runs.
/// A run.
pub struct Run;
