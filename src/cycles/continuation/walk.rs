//! Following a branch of cycles.

use super::{
    family::Family,
    newton::{Chart, Place, correct},
    special::{PointKind, Search},
    stop::{Stop, rescaled},
};
use crate::{
    cycles::{
        FINEST,
        vector::{axis, dot, norm},
    },
    error::Result,
};

/// The first step, one that is short, the shortest, and the longest: in an amplitude this part of it.
const FIRST: f64 = 0.02;
const SHORT: f64 = 1e-3;
const SHORTEST: f64 = 1e-9;
const LONGEST: f64 = 0.5;
/// How far a branch may be from the tangent at the end of a step: a fourth of that from the straight line between its points.
const BEND: f64 = 6e-3;
/// The cosine of the largest turn in a step.
const LARGEST_TURN: f64 = 0.8;
/// A cycle that is this much smaller than the largest of its branch has gone to rest.
const REST: f64 = 1e-3;
/// A cycle whose states are this many times their typical sizes is beyond all reason.
const LARGE: f64 = 1e3;
/// What a period may grow to, beside the shortest of its branch.
const LONG: f64 = 100.0;
/// Where the trivial multiplier is this good, motions need not be followed as finely.
const EASY: f64 = 1e-9;
/// So many cycles within so small a part of the range, the size and the period, and the branch gets nowhere any more.
const STANDING: usize = 40;
const PROGRESS: f64 = 0.02;
/// How near to its first point a branch is when it has come back: parts of the range, the amplitude and the period.
const CLOSED: f64 = 1e-3;

/// Why a branch ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BranchEnd {
    /// At a Hopf point: the cycle is born there, or dies.
    Hopf,
    /// At the end of the range.
    Range,
    /// It comes back to where it began.
    Closed,
    /// The cycle shrinks to nothing elsewhere: as the gap does that it lives on.
    Rest,
    /// The cycle, or its period, grows beyond all bounds.
    Large,
    /// As many points as were asked for.
    Points,
    /// Newton's method finds no next one.
    Lost,
}

impl BranchEnd {
    /// Public name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Hopf => "hopf",
            Self::Range => "range",
            Self::Closed => "closed",
            Self::Rest => "rest",
            Self::Large => "large",
            Self::Points => "points",
            Self::Lost => "lost",
        }
    }
}

/// A branch on the way.
pub(super) struct Walk {
    /// The cycles so far.
    pub stops: Vec<Stop>,
    /// Special ones among them: their kind and place in the list.
    pub special: Vec<(PointKind, usize)>,
    /// For special ones before the next, which may be at the end of the range.
    search: Option<(Search, bool)>,
    /// The next step.
    length: f64,
    /// The largest size and the shortest period so far.
    largest: f64,
    shortest: f64,
    /// How many times finer than usual the motions are followed.
    fineness: f64,
    limits: Limits,
}

/// What a branch is followed with.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Most points.
    pub points: usize,
    /// The longest step, in parts of the parameter's range.
    pub step: f64,
    /// How near a special point is located, in steps' units.
    pub tolerance: f64,
}

impl Walk {
    pub fn new(start: Stop, limits: Limits) -> Self {
        let (largest, shortest) = (start.chart.size, start.point.period);
        let (stops, special) = (vec![start], Vec::new());
        Self { stops, special, search: None, length: FIRST, largest, shortest, fineness: 1.0, limits }
    }

    /// The other way from the same cycle.
    pub fn turned(&self) -> Self {
        let begun = Self::new(self.stops[0].turned(), self.limits);
        Self { fineness: self.fineness, ..begun }
    }

    /// From the cycle near a place, in the plane through it that `border` stands on.
    ///
    /// # Errors
    /// A motion or a matrix that leaves the numbers.
    pub fn at(
        family: &mut dyn Family,
        chart: &Chart,
        place: &Place,
        border: &[f64],
        limits: Limits,
    ) -> Result<Option<Self>> {
        let period = place.time * if chart.sign < 0.0 { 2.0 } else { 1.0 };
        let mut fineness = 1.0;
        while fineness <= FINEST {
            family.flow().pace(period, fineness);
            let Some(solved) = correct(family, chart, place, border) else { return Ok(None) };
            let start = Stop::of(family, chart, solved, border)?;
            if start.is_sound() {
                return Ok(Some(Self { fineness, ..Self::new(start, limits) }));
            }
            fineness *= 2.0;
        }
        Ok(None)
    }

    /// Tries a step, and a shorter one the next time where that leads nowhere; tells why where there is none to take, or the
    /// last was one.
    pub fn advance(&mut self, family: &mut dyn Family) -> Option<BranchEnd> {
        if let Some((mut search, edge)) = self.search.take() {
            search.advance(family, self.limits.tolerance);
            return self.searched(search, edge);
        }
        if self.stops.len() >= self.limits.points {
            return Some(BranchEnd::Points);
        }
        let here = self.stops[self.stops.len() - 1].clone();
        let n = here.place.x.len();
        let (swings, along) = (norm(&here.tangent[..=n]), here.tangent[n + 1].abs());
        self.length = self.length.min(LONGEST / swings).min(self.limits.step / along);
        if self.length < SHORTEST {
            return Some(BranchEnd::Lost);
        }
        // What leaves the numbers is no cycle.
        let Ok(Some((next, fit))) = self.next(family, &here) else {
            // Where a short step leads nowhere, too, errors may be in the way.
            if self.length < SHORT && self.fineness < FINEST {
                self.fineness *= 2.0;
            } else {
                self.length *= 0.4;
            }
            return None;
        };
        if !next.is_sound() {
            self.fineness *= 2.0;
            return (self.fineness > FINEST).then_some(BranchEnd::Lost);
        }
        let factor = 0.9 * (BEND / fit.bend).sqrt();
        if fit.turn < LARGEST_TURN || fit.bend > BEND {
            self.length *= factor.clamp(0.2, 0.5);
            return None;
        }
        self.length *= factor.min(2.0);
        if (next.point.multipliers[0] - 1.0).norm() < EASY {
            self.fineness = (0.5 * self.fineness).max(1.0);
        }
        self.searched(Search::between(here, next), fit.edge)
    }

    /// Goes on to the next cycle once there is nothing more to search for before it.
    fn searched(&mut self, search: Search, edge: bool) -> Option<BranchEnd> {
        if !search.is_over() {
            self.search = Some((search, edge));
            return None;
        }
        let (special, next) = search.end();
        for (kind, stop) in special {
            self.special.push((kind, self.stops.len()));
            self.stops.push(stop);
        }
        let end = if edge { Some(BranchEnd::Range) } else { self.end(&next) };
        self.largest = self.largest.max(next.chart.size);
        self.shortest = self.shortest.min(next.point.period);
        self.stops.push(next);
        end
    }

    /// The cycle a step ahead, at the end of the range where that is nearer.
    fn next(&self, family: &mut dyn Family, here: &Stop) -> Result<Option<(Stop, Fit)>> {
        let Stop { tangent, chart, .. } = here;
        let within = |place: &Place| (chart.low..=chart.high).contains(&place.value);
        let guess = chart.ahead(&here.place, tangent, self.length);
        family.flow().pace(here.point.period, self.fineness);
        let found = if within(&guess) { correct(family, chart, &guess, tangent) } else { None };
        let (solved, guess, edge) = match found {
            Some(solved) if within(&solved.place) => (solved, guess, false),
            found => {
                // Towards the point beyond the end, or along the tangent, as far as the end.
                let way = match &found {
                    Some(beyond) => chart.between(&here.place, &beyond.place),
                    None if within(&guess) => return Ok(None),
                    None => tangent.clone(),
                };
                let along = way[way.len() - 1];
                let end = if along > 0.0 { chart.high } else { chart.low };
                let mut guess = chart.ahead(&here.place, &way, (end - here.place.value) / (chart.width() * along));
                guess.value = end;
                let border = axis(way.len(), way.len() - 1);
                let Some(mut solved) = correct(family, chart, &guess, &border) else { return Ok(None) };
                solved.place.value = end;
                (solved, guess, true)
            }
        };
        let missed = chart.between(&guess, &solved.place);
        let n = missed.len() - 2;
        let bend = (norm(&missed[..n]) * chart.size / self.largest).hypot(missed[n + 1]);
        let next = Stop::of(family, chart, solved, tangent)?;
        let turn = dot(tangent, &rescaled(&next.tangent, n, next.chart.size / chart.size));
        Ok(Some((next, Fit { bend: bend.max(1e-3 * BEND), turn, edge })))
    }

    /// Why the branch ends with its next cycle, if it does.
    fn end(&self, next: &Stop) -> Option<BranchEnd> {
        let size = next.chart.size;
        if size < REST * self.largest {
            Some(BranchEnd::Rest)
        } else if size > LARGE || next.point.period > LONG * self.shortest {
            Some(BranchEnd::Large)
        } else if self.comes_back(next) {
            Some(BranchEnd::Closed)
        } else if self.stands(next) {
            Some(BranchEnd::Lost)
        } else {
            None
        }
    }

    /// Whether many steps have led nearly nowhere, as they do where a cycle comes to pass a rest that it never leaves.
    fn stands(&self, next: &Stop) -> bool {
        let Some(before) = self.stops.len().checked_sub(STANDING).map(|place| &self.stops[place]) else { return false };
        let moved = |from: f64, to: f64, unit: f64| (to - from).abs() < PROGRESS * unit;
        moved(before.point.value, next.point.value, next.chart.width())
            && moved(before.chart.size, next.chart.size, next.chart.size)
            && moved(before.point.period, next.point.period, next.point.period)
    }

    /// Whether the first cycle lies between the last and the next one.
    fn comes_back(&self, next: &Stop) -> bool {
        let (first, last) = (&self.stops[0], &self.stops[self.stops.len() - 1]);
        let at = |stop: &Stop| {
            let (size, period) = (stop.chart.size / first.chart.size, stop.point.period / first.point.period);
            [stop.point.value / first.chart.width(), size, period]
        };
        self.stops.len() > 4 && super::passes(&at(last), &at(next), &at(first), CLOSED)
    }
}

/// How well the next cycle fits to the one before.
struct Fit {
    /// How far it is from the tangent.
    bend: f64,
    /// The cosine of the angle between both tangents.
    turn: f64,
    /// It is at the end of the range.
    edge: bool,
}
