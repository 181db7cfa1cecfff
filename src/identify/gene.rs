//! A parameter as a number from 0 to 1.

use crate::parameter::{Parameter, Scale};

/// Bounds this far apart are decades.
const DECADES: f64 = 100.0;

/// A parameter between bounds, all of whose range counts alike: equal distances are equal ratios where the table's scale or
/// the bounds say that it spans decades, equal differences elsewhere.
#[derive(Clone, Debug)]
pub(super) struct Gene {
    pub parameter: &'static Parameter,
    /// Its place in the table.
    pub place: usize,
    low: f64,
    high: f64,
    logarithmic: bool,
}

impl Gene {
    pub fn new(parameter: &'static Parameter, place: usize, low: f64, high: f64) -> Self {
        let logarithmic = low > 0.0 && (parameter.scale == Scale::Log || high / low >= DECADES);
        Self { parameter, place, low, high, logarithmic }
    }

    /// The value at a place between the bounds.
    pub fn value(&self, unit: f64) -> f64 {
        let value = if self.logarithmic {
            self.low * (unit * (self.high / self.low).ln()).exp()
        } else {
            self.low + unit * (self.high - self.low)
        };
        value.clamp(self.low, self.high)
    }

    /// The place of a value.
    pub fn unit(&self, value: f64) -> f64 {
        let unit = if self.logarithmic {
            (value / self.low).ln() / (self.high / self.low).ln()
        } else {
            (value - self.low) / (self.high - self.low)
        };
        unit.clamp(0.0, 1.0)
    }
}
