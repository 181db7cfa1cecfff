//! Series for drawing, and how they are thinned without losing a peak.

use crate::few::sort_few;

/// A series: times and one column per state variable.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Columns {
    /// Times in s.
    pub time: Vec<f64>,
    /// One column per state variable, in the order of the state table.
    pub states: Vec<Vec<f64>>,
}

impl Columns {
    /// Empty, with room for `rows` rows of `states` columns.
    pub(super) fn with_capacity(states: usize, rows: usize) -> Self {
        Self { time: Vec::with_capacity(rows), states: (0..states).map(|_| Vec::with_capacity(rows)).collect() }
    }

    pub(super) fn push(&mut self, t: f64, x: &[f64]) {
        self.time.push(t);
        for (column, value) in self.states.iter_mut().zip(x) {
            column.push(*value);
        }
    }

    /// Pushes a row, where need be after thinning to half of `most` rows.
    pub(super) fn push_within(&mut self, most: usize, t: f64, x: &[f64]) {
        if self.time.len() >= most {
            self.thin(most / 2);
        }
        self.push(t, x);
    }

    /// Forgets the rows after time `t`.
    pub(super) fn truncate_after(&mut self, t: f64) {
        let kept = self.time.partition_point(|time| *time <= t);
        for column in std::iter::once(&mut self.time).chain(&mut self.states) {
            column.truncate(kept);
        }
    }

    /// Takes out the rows up to time `t`.
    pub(super) fn take_until(&mut self, t: f64) -> Self {
        let taken = self.time.partition_point(|time| *time <= t);
        let take = |column: &mut Vec<f64>| column.drain(..taken).collect();
        Self { time: take(&mut self.time), states: self.states.iter_mut().map(take).collect() }
    }

    pub(super) fn clear(&mut self) {
        self.time.clear();
        for column in &mut self.states {
            column.clear();
        }
    }

    /// Keeps about `most` rows, every column's peaks among them.
    pub(super) fn thin(&mut self, most: usize) {
        thin(&mut self.time, &mut self.states, most);
    }
}

/// Keeps about `most` rows, every column's peaks among them.
pub(crate) fn thin(time: &mut Vec<f64>, states: &mut [Vec<f64>], most: usize) {
    let columns: Vec<&[f64]> = states.iter().map(Vec::as_slice).collect();
    let kept = rows_to_keep(&columns, most);
    for column in std::iter::once(time).chain(states) {
        for (to, &from) in kept.iter().enumerate() {
            column[to] = column[from];
        }
        column.truncate(kept.len());
    }
}

/// Least and greatest value of the first state in equal stretches of time.
#[derive(Clone, Debug, PartialEq)]
pub struct Envelope {
    /// Middle of each stretch, in s.
    pub time: Vec<f64>,
    /// Least values.
    pub low: Vec<f64>,
    /// Greatest values.
    pub high: Vec<f64>,
}

impl Envelope {
    /// Empty stretches over \[`from`, `to`\].
    pub(crate) fn over(from: f64, to: f64, stretches: usize) -> Self {
        let width = (to - from) / stretches as f64;
        Self {
            time: (0..stretches).map(|i| from + (i as f64 + 0.5) * width).collect(),
            low: vec![f64::INFINITY; stretches],
            high: vec![f64::NEG_INFINITY; stretches],
        }
    }

    /// Takes in the value at the place `at` of the whole, 0 … 1; places outside do not count.
    pub(crate) fn take(&mut self, at: f64, value: f64) {
        if !(0.0..=1.0).contains(&at) {
            return;
        }
        let stretch = ((at * self.time.len() as f64) as usize).min(self.time.len() - 1);
        self.low[stretch] = self.low[stretch].min(value);
        self.high[stretch] = self.high[stretch].max(value);
    }

    /// Fills stretches in which no value fell with their neighbours'.
    pub(crate) fn close(mut self) -> Self {
        for i in 1..self.time.len() {
            if self.low[i] > self.high[i] {
                (self.low[i], self.high[i]) = (self.low[i - 1], self.high[i - 1]);
            }
        }
        for i in (0..self.time.len().saturating_sub(1)).rev() {
            if self.low[i] > self.high[i] {
                (self.low[i], self.high[i]) = (self.low[i + 1], self.high[i + 1]);
            }
        }
        self
    }
}

/// Rows of a series to keep so that at most about `most` remain and every column keeps its extremes.
///
/// The series is cut into stretches; of each, the rows where any column is least or greatest stay. With fewer rows than
/// asked for, all stay. `most` is at least 2.
pub(super) fn rows_to_keep(columns: &[&[f64]], most: usize) -> Vec<usize> {
    let rows = columns.first().map_or(0, |column| column.len());
    if rows <= most {
        return (0..rows).collect();
    }
    // Two rows a column and stretch; with less room than that, the first columns count.
    let columns = &columns[..columns.len().min(most / 2)];
    let stretches = most / (2 * columns.len());
    let mut kept = Vec::with_capacity(most + 2);
    for stretch in 0..stretches {
        let (from, to) = (stretch * rows / stretches, (stretch + 1) * rows / stretches);
        let start = kept.len();
        for column in columns {
            let order = |a: &usize, b: &usize| column[*a].total_cmp(&column[*b]);
            kept.extend((from..to).min_by(order));
            kept.extend((from..to).max_by(order));
        }
        sort_few(&mut kept[start..], |a, b| a < b);
    }
    kept.dedup();
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_peak_stays() {
        let mut wave: Vec<f64> = (0..10_000).map(|i| (i as f64 * 0.01).sin()).collect();
        wave[4321] = 7.0;
        wave[8765] = -9.0;
        let kept = rows_to_keep(&[&wave], 200);
        assert!(kept.len() <= 200 && kept.is_sorted());
        assert!(kept.contains(&4321) && kept.contains(&8765));
        assert_eq!(rows_to_keep(&[&wave, &wave, &wave], 3), [4321, 8765]);
    }

    #[test]
    fn short_series_stay_whole() {
        assert_eq!(rows_to_keep(&[&[1.0, 2.0, 3.0]], 3), [0, 1, 2]);
        assert!(rows_to_keep(&[&[]], 10).is_empty());
    }
}
