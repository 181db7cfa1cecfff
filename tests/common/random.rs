//! Seeded random numbers: the same on every machine.

use shimmy::random::Random as Source;

/// The crate's own sequence, with what chooses test cases.
pub struct Random(Source);

impl Random {
    pub fn seeded(seed: u64) -> Self {
        Self(Source::seeded(seed))
    }

    /// From 0 to 1.
    pub fn unit(&mut self) -> f64 {
        self.0.unit()
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// One time in `times`.
    pub fn once_in(&mut self, times: u64) -> bool {
        self.0.bits().is_multiple_of(times)
    }
}
