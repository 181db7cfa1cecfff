//! Curves in a plane of two parameters along which branches of cycles fold.

use nalgebra::DMatrix;

use super::{
    bordered::{Equations, Sheet, Spot},
    family::Family,
    newton::{Chart, Solved, solution},
    stop::{Stop, rescaled},
};
use crate::{
    cycles::vector::{axis, direction, dot, norm, times},
    error::Result,
};

/// The first step along a curve, the shortest, and the longest: in the plane, and in the cycle.
const FIRST: f64 = 0.01;
const SHORTEST: f64 = 1e-6;
const LONGEST_STEP: f64 = 0.05;
const LONGEST_CHANGE: f64 = 0.3;
/// How far a curve may be from its tangent at the end of a step: a fourth of that from the straight line between its points.
const BEND: f64 = 2e-3;
const LARGEST_TURN: f64 = 0.8;
/// A curve has come back where its first point is as near as this to a straight line between two of its last.
const CLOSED: f64 = 2e-3;
/// Most points of a curve.
const MOST_POINTS: usize = 2_000;

/// A curve of folds on the way.
pub(super) struct FoldWalk {
    pub stops: Vec<(Stop, f64)>,
    here: Spot,
    tangent: Vec<f64>,
    sheet: Sheet,
    length: f64,
}

/// How a curve of folds ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FoldEnd {
    Closed,
    Edge,
    Lost,
}

impl FoldWalk {
    /// From a fold in the direction whose second parameter rises, or where `back` falls.
    ///
    /// # Errors
    /// A motion or a matrix that leaves the numbers.
    pub fn from(family: &mut dyn Family, sheet: &Sheet, seed: &Spot, back: bool) -> Result<Option<Self>> {
        let n = seed.place.x.len();
        let Some(equations) = Equations::around(family, sheet, seed) else { return Ok(None) };
        let sense = if back { -1.0 } else { 1.0 };
        // A first tangent: rows without a border, completed by either parameter.
        for border in [n + 2, n + 1].map(|which| times(sense, &axis(n + 3, which))) {
            if let Some((spot, rows)) = equations.correct(family, sheet, seed, &border)
                && let Some(tangent) = tangent(rows, &border)
            {
                let Some((stop, size)) = stop(family, sheet, &spot, &equations.phase)? else { return Ok(None) };
                let sheet = Sheet { chart: Chart { size, ..sheet.chart }, ..*sheet };
                let stops = vec![(stop, spot.other)];
                return Ok(Some(Self { stops, here: spot, tangent, sheet, length: FIRST }));
            }
        }
        Ok(None)
    }

    /// Takes a step; tells why where there is none to take, or the last was one.
    ///
    /// # Errors
    /// A motion or a matrix that leaves the numbers.
    pub fn advance(&mut self, family: &mut dyn Family) -> Result<Option<FoldEnd>> {
        if self.stops.len() >= MOST_POINTS {
            return Ok(Some(FoldEnd::Lost));
        }
        let n = self.here.place.x.len();
        family.flow().pace(self.stops[self.stops.len() - 1].0.point.period, 1.0);
        let plane = norm(&self.tangent[n + 1..]);
        self.length = self.length.min(LONGEST_STEP / plane).min(LONGEST_CHANGE / norm(&self.tangent[..=n]));
        let Some(equations) = Equations::around(family, &self.sheet, &self.here) else {
            return Ok(Some(FoldEnd::Lost));
        };
        while self.length > SHORTEST {
            let Some((spot, guess, rows, edge)) = self.next(family, &equations) else {
                self.length *= 0.4;
                continue;
            };
            let missed = self.sheet.between(&guess, &spot);
            let bend = norm(&missed[n + 1..]).max(0.1 * norm(&missed[..=n])).max(1e-3 * BEND);
            let Some(tangent) = tangent(rows, &self.tangent) else {
                self.length *= 0.4;
                continue;
            };
            let factor = 0.9 * (BEND / bend).sqrt();
            if bend > BEND || dot(&tangent, &self.tangent) < LARGEST_TURN {
                self.length *= factor.clamp(0.2, 0.5);
                continue;
            }
            self.length *= factor.min(2.0);
            let Some((stop, size)) = stop(family, &self.sheet, &spot, &equations.phase)? else { break };
            let closed = !edge && self.comes_back(&stop, spot.other);
            self.stops.push((stop, spot.other));
            if closed {
                return Ok(Some(FoldEnd::Closed));
            }
            // The way is measured by the cycle's size.
            let tangent = rescaled(&tangent, n, self.sheet.chart.size / size);
            (self.here, self.tangent, self.sheet.chart.size) = (spot, tangent, size);
            return Ok(edge.then_some(FoldEnd::Edge));
        }
        Ok(Some(FoldEnd::Lost))
    }

    /// The last cycle is less than this part of the largest.
    pub fn has_shrunk(&self, part: f64) -> bool {
        let size = |(stop, _): &(Stop, f64)| stop.chart.size;
        self.sheet.chart.size < part * self.stops.iter().map(size).fold(0.0, f64::max)
    }

    /// The fold a step ahead, where it was guessed, the derivatives there, and whether it is on the plane's edge.
    fn next(&self, family: &mut dyn Family, equations: &Equations) -> Option<(Spot, Spot, DMatrix<f64>, bool)> {
        let Self { here, tangent, sheet, .. } = self;
        let mut way = tangent.clone();
        let mut part = self.length;
        let mut end = sheet.beyond(here, &sheet.ahead(here, &way, part));
        if end.is_none() {
            let guess = sheet.ahead(here, tangent, self.length);
            let (spot, rows) = equations.correct(family, sheet, &guess, tangent)?;
            end = sheet.beyond(here, &spot);
            if end.is_none() {
                return Some((spot, guess, rows, false));
            }
            (way, part) = (sheet.between(here, &spot), 1.0);
        }
        let (across, edge, share) = end?;
        let mut guess = sheet.ahead(here, &way, part * share);
        *(if across == 0 { &mut guess.place.value } else { &mut guess.other }) = edge;
        let n = here.place.x.len();
        let border = axis(n + 3, n + 1 + across);
        let (spot, mut rows) = equations.correct(family, sheet, &guess, &border)?;
        sheet.beyond(here, &spot).is_none().then_some(())?;
        (0..n + 3).for_each(|j| rows[(n + 2, j)] = tangent[j]);
        Some((spot, guess, rows, true))
    }

    /// Whether the first fold lies between the last and the next one.
    fn comes_back(&self, next: &Stop, other: f64) -> bool {
        let chart = &self.sheet.chart;
        let at = |stop: &Stop, other: f64| {
            let size = (stop.chart.size / self.stops[0].0.chart.size).ln();
            [stop.point.value / chart.width(), other / (self.sheet.high - self.sheet.low), size]
        };
        let of = |(stop, other): &(Stop, f64)| at(stop, *other);
        let (first, last, next) = (of(&self.stops[0]), of(&self.stops[self.stops.len() - 1]), at(next, other));
        self.stops.len() > 4 && super::passes(&last, &next, &first, CLOSED)
    }
}

/// The way on, of length 1, along the border that the last row has.
fn tangent(mut rows: DMatrix<f64>, border: &[f64]) -> Option<Vec<f64>> {
    let last = border.len() - 1;
    (0..=last).for_each(|j| rows[(last, j)] = border[j]);
    let way = solution(&rows, &|i| f64::from(u8::from(i == last)));
    norm(&way).is_finite().then(|| direction(&way))
}

/// What there is to know of the cycle at a fold, and its size.
fn stop(family: &mut dyn Family, sheet: &Sheet, spot: &Spot, phase: &[f64]) -> Result<Option<(Stop, f64)>> {
    family.aside(spot.other);
    let n = spot.place.x.len();
    let border = axis(n + 2, 0);
    let Some((solved, _)) = Solved::at(family, &sheet.chart, spot.place.clone(), phase, &border) else {
        return Ok(None);
    };
    let stop = Stop::of(family, &sheet.chart, solved, &border)?;
    let size = stop.chart.size;
    Ok(Some((stop, size)))
}
