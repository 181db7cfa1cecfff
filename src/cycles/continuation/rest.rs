//! The gear at rest along a range.

use std::f64::consts::TAU;

use super::line::Line;
use crate::error::Result;

/// Values at which rest is looked at, equally spaced, ends included; those at which something crosses come on top.
const VALUES: usize = 101;

/// The gear at rest, by rising values of the parameter.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RestBranch {
    /// The parameter.
    pub value: Vec<f64>,
    /// Where it rests: one column for each state.
    pub states: Vec<Vec<f64>>,
    /// The largest real part of an eigenvalue \[1/s\].
    pub growth_rate: Vec<f64>,
    /// The frequency of that eigenvalue \[Hz\]; 0 where it is real.
    pub frequency: Vec<f64>,
    /// How many eigenvalues are right of the imaginary axis.
    pub unstable: Vec<u8>,
    /// 1 where all are left of it.
    pub stable: Vec<u8>,
}

impl RestBranch {
    /// With room for as many states.
    pub(super) fn of(states: usize) -> Self {
        Self { states: vec![Vec::new(); states], ..Self::default() }
    }

    /// Looks at some more values; says whether there are more to come. `crossings` are among them.
    ///
    /// # Errors
    /// As [`Line::rest`] and for its eigenvalues.
    pub(super) fn advance(&mut self, line: &Line, crossings: &[f64]) -> Result<bool> {
        let count = VALUES + crossings.len();
        let end = (self.value.len() + 16).min(count);
        while self.value.len() < end {
            let value = place(line, crossings, self.value.len());
            let at = line.rest(value)?;
            let values = at.deciding()?;
            let crosses = crossings.contains(&value);
            self.value.push(value);
            self.states.iter_mut().zip(&at.equilibrium).for_each(|(column, x)| column.push(*x));
            self.growth_rate.push(values[0].re);
            self.frequency.push(values[0].im.abs() / TAU);
            self.unstable.push(values.iter().filter(|value| value.re > 0.0).count() as u8);
            // On the axis nothing fades, whatever rounding says.
            self.stable.push(u8::from(values[0].re < 0.0 && !crosses));
        }
        Ok(end < count)
    }
}

/// The value at a place among the equally spaced ones and the crossings, which are given by rising value.
fn place(line: &Line, crossings: &[f64], place: usize) -> f64 {
    let even = |i: usize| {
        let part = i as f64 / (VALUES - 1) as f64;
        if i + 1 == VALUES { line.to() } else { line.from() + line.width() * part }
    };
    let (mut i, mut j) = (0, 0);
    loop {
        let crossing = crossings.get(j).copied().unwrap_or(f64::INFINITY);
        let first = i < VALUES && even(i) <= crossing;
        if i + j == place {
            return if first { even(i) } else { crossing };
        }
        *(if first { &mut i } else { &mut j }) += 1;
    }
}
