//! Curves in a plane of two parameters along which branches of cycles fold.

use nalgebra::DMatrix;

use super::{
    bordered::{Corrected, Correction, Equations, Sheet, Spot},
    family::Family,
    newton::{Solved, solution},
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
    /// The folds so far: none while the first is looked for.
    pub stops: Vec<(Stop, f64)>,
    here: Spot,
    tangent: Vec<f64>,
    sheet: Sheet,
    length: f64,
    equations: Option<Equations>,
    attempt: Option<Attempt>,
    /// Parameters that may complete the first tangent, and its sense.
    first: Vec<usize>,
    sense: f64,
}

/// A fold ahead, being looked for.
struct Attempt {
    guess: Spot,
    correction: Correction,
    /// On the plane's edge.
    edge: bool,
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
    pub fn from(sheet: &Sheet, seed: &Spot, back: bool) -> Self {
        let n = seed.place.x.len();
        let (tangent, first) = (Vec::new(), vec![n + 1, n + 2]);
        let sense = if back { -1.0 } else { 1.0 };
        let (here, sheet) = (seed.clone(), *sheet);
        let (equations, attempt) = (None, None);
        Self { stops: Vec::new(), here, tangent, sheet, length: FIRST, equations, attempt, first, sense }
    }

    /// Goes on a bit; tells why where there is no next step to take, or the last was one. Without any stop then, there is no
    /// curve.
    ///
    /// # Errors
    /// A motion or a matrix that leaves the numbers.
    pub fn advance(&mut self, family: &mut dyn Family) -> Result<Option<FoldEnd>> {
        let Some(equations) = self.equations.take() else { return Ok(self.pose(family)) };
        let Some(mut attempt) = self.attempt.take() else {
            self.equations = Some(equations);
            return Ok(self.attempts());
        };
        match attempt.correction.advance(&equations, family, &self.sheet) {
            Corrected::Goes => self.attempt = Some(attempt),
            Corrected::Fails => self.length *= 0.4,
            Corrected::Found(spot, rows) => {
                let before = self.stops.len();
                let end = match before {
                    0 => self.begins(family, &equations, &spot, rows, &attempt.correction.border)?,
                    _ => self.arrives(family, &equations, attempt, spot, rows)?,
                };
                if end.is_some() || self.stops.len() > before {
                    return Ok(end);
                }
            }
        }
        self.equations = Some(equations);
        Ok(None)
    }

    /// The equations around the last fold.
    fn pose(&mut self, family: &mut dyn Family) -> Option<FoldEnd> {
        if self.stops.len() >= MOST_POINTS {
            return Some(FoldEnd::Lost);
        }
        if let Some((stop, _)) = self.stops.last() {
            family.flow().pace(stop.point.period, 1.0);
            let plane = norm(&self.tangent[self.here.place.x.len() + 1..]);
            let others = norm(&self.tangent[..=self.here.place.x.len()]);
            self.length = self.length.min(LONGEST_STEP / plane).min(LONGEST_CHANGE / others);
        }
        self.equations = Equations::around(family, &self.sheet, &self.here);
        if self.equations.is_none() { Some(FoldEnd::Lost) } else { None }
    }

    /// Guesses the next fold; tells where there is none to guess.
    fn attempts(&mut self) -> Option<FoldEnd> {
        if self.stops.is_empty() {
            // A first tangent: rows without a border, completed by either parameter.
            let Some(which) = self.first.pop() else { return Some(FoldEnd::Lost) };
            let border = times(self.sense, &axis(self.here.place.x.len() + 3, which));
            let correction = Correction::from(&self.here, border);
            self.attempt = Some(Attempt { guess: self.here.clone(), correction, edge: false });
            return None;
        }
        if self.length <= SHORTEST {
            return Some(FoldEnd::Lost);
        }
        let Self { here, tangent, sheet, length, .. } = &*self;
        let guess = sheet.ahead(here, tangent, *length);
        self.attempt = Some(match sheet.beyond(here, &guess) {
            Some(end) => self.at_edge(tangent, *length, end),
            None => Attempt { correction: Correction::from(&guess, tangent.clone()), guess, edge: false },
        });
        None
    }

    /// The fold on the plane's edge, which a part of a way passes.
    fn at_edge(&self, way: &[f64], part: f64, (across, edge, share): (usize, f64, f64)) -> Attempt {
        let mut guess = self.sheet.ahead(&self.here, way, part * share);
        *(if across == 0 { &mut guess.place.value } else { &mut guess.other }) = edge;
        let n = self.here.place.x.len();
        Attempt { correction: Correction::from(&guess, axis(n + 3, n + 1 + across)), guess, edge: true }
    }

    /// The first fold and its tangent.
    fn begins(
        &mut self,
        family: &mut dyn Family,
        equations: &Equations,
        spot: &Spot,
        rows: DMatrix<f64>,
        border: &[f64],
    ) -> Result<Option<FoldEnd>> {
        let Some(tangent) = tangent(rows, border) else { return Ok(None) };
        let Some((stop, size)) = stop(family, &self.sheet, spot, &equations.phase)? else {
            return Ok(Some(FoldEnd::Lost));
        };
        self.stops.push((stop, spot.other));
        (self.here, self.tangent, self.sheet.chart.size, self.length) = (spot.clone(), tangent, size, FIRST);
        Ok(None)
    }

    /// The next fold, where it fits to the one before: then the curve goes on, or ends there.
    fn arrives(
        &mut self,
        family: &mut dyn Family,
        equations: &Equations,
        attempt: Attempt,
        spot: Spot,
        mut rows: DMatrix<f64>,
    ) -> Result<Option<FoldEnd>> {
        let Attempt { guess, edge, .. } = attempt;
        let n = self.here.place.x.len();
        match self.sheet.beyond(&self.here, &spot) {
            Some(_) if edge => {
                self.length *= 0.4;
                return Ok(None);
            }
            Some(end) => {
                let way = self.sheet.between(&self.here, &spot);
                self.attempt = Some(self.at_edge(&way, 1.0, end));
                return Ok(None);
            }
            None if edge => (0..n + 3).for_each(|j| rows[(n + 2, j)] = self.tangent[j]),
            None => {}
        }
        let missed = self.sheet.between(&guess, &spot);
        let bend = norm(&missed[n + 1..]).max(0.1 * norm(&missed[..=n])).max(1e-3 * BEND);
        let Some(tangent) = tangent(rows, &self.tangent) else {
            self.length *= 0.4;
            return Ok(None);
        };
        let factor = 0.9 * (BEND / bend).sqrt();
        if bend > BEND || dot(&tangent, &self.tangent) < LARGEST_TURN {
            self.length *= factor.clamp(0.2, 0.5);
            return Ok(None);
        }
        self.length *= factor.min(2.0);
        let Some((stop, size)) = stop(family, &self.sheet, &spot, &equations.phase)? else {
            return Ok(Some(FoldEnd::Lost));
        };
        let closed = !edge && self.comes_back(&stop, spot.other);
        self.stops.push((stop, spot.other));
        if closed {
            return Ok(Some(FoldEnd::Closed));
        }
        // The way is measured by the cycle's size.
        let tangent = rescaled(&tangent, n, self.sheet.chart.size / size);
        (self.here, self.tangent, self.sheet.chart.size) = (spot, tangent, size);
        Ok(edge.then_some(FoldEnd::Edge))
    }

    /// The last cycle is less than this part of the largest.
    pub fn has_shrunk(&self, part: f64) -> bool {
        let size = |(stop, _): &(Stop, f64)| stop.chart.size;
        self.sheet.chart.size < part * self.stops.iter().map(size).fold(0.0, f64::max)
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
