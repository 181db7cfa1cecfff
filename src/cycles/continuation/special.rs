//! Special points of a branch: found by a change of sign, located between two cycles.

use nalgebra::Complex;

use super::{family::Family, newton::correct, stop::Stop};
use crate::{
    cycles::vector::{direction, norm},
    error::Result,
    few::sort_few,
};

/// Most cycles on the way to a special one.
const MOST: usize = 60;
/// A pair of multipliers whose imaginary part is smaller is none.
const REAL: f64 = 1e-6;

/// What happens at a special point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointKind {
    /// A pair of eigenvalues of the gear at rest crosses the imaginary axis: a cycle is born.
    Hopf,
    /// An eigenvalue of the gear at rest is zero.
    Divergence,
    /// A branch of cycles turns back: two cycles meet, and a multiplier is 1.
    Fold,
    /// A multiplier is 1, and another branch crosses: of a symmetric cycle one of less symmetry.
    BranchPoint,
    /// A multiplier is −1: a cycle of twice the period branches off.
    PeriodDoubling,
    /// A pair of multipliers is on the unit circle: a torus branches off.
    NeimarkSacker,
}

impl PointKind {
    /// Public name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Hopf => "hopf",
            Self::Divergence => "divergence",
            Self::Fold => "fold",
            Self::BranchPoint => "branch-point",
            Self::PeriodDoubling => "period-doubling",
            Self::NeimarkSacker => "neimark-sacker",
        }
    }
}

/// What changes its sign on a branch: the parameter's direction, and products over the multipliers that are zero where one is
/// 1, one is −1, or two have the product 1. Of half a symmetric cycle −1 is a multiplier 1 of the whole.
#[derive(Clone, Copy)]
enum Test {
    Turn,
    One,
    MinusOne,
    Pair,
}

impl Test {
    const ALL: [Self; 4] = [Self::Turn, Self::One, Self::MinusOne, Self::Pair];

    fn of(self, stop: &Stop) -> f64 {
        let values = &stop.halves;
        let product = |part: &dyn Fn(usize) -> Complex<f64>| {
            (0..values.len()).fold(Complex::from(1.0), |product, i| product * part(i)).re
        };
        match self {
            Self::Turn => stop.tangent[stop.tangent.len() - 1],
            Self::One => product(&|i| values[i] - 1.0),
            Self::MinusOne => product(&|i| values[i] + 1.0),
            Self::Pair => {
                product(&|i| values[..i].iter().fold(Complex::from(1.0), |product, a| product * (a * values[i] - 1.0)))
            }
        }
    }

    /// What it is that was found.
    fn kind(self, found: &Stop) -> Option<PointKind> {
        let symmetric = found.point.symmetric;
        match self {
            Self::Turn => Some(PointKind::Fold),
            Self::One => Some(PointKind::BranchPoint),
            Self::MinusOne if symmetric => Some(PointKind::BranchPoint),
            Self::MinusOne => Some(PointKind::PeriodDoubling),
            // Two real ones with the product 1 do nothing.
            Self::Pair => {
                let off = |value: &Complex<f64>| (value.norm() - 1.0).abs();
                let pairs = found.halves.iter().filter(|value| value.im > REAL);
                pairs.map(off).reduce(f64::min).filter(|off| *off < 1e-3).map(|_| PointKind::NeimarkSacker)
            }
        }
    }
}

/// The search for the special points between two neighbours on a branch.
pub(super) struct Search {
    from: Stop,
    to: Stop,
    /// What has changed its sign, and is to be located.
    tests: Vec<Test>,
    location: Option<Location>,
    found: Vec<(f64, PointKind, Stop)>,
}

impl Search {
    /// Between two neighbours.
    pub fn between(from: Stop, to: Stop) -> Self {
        let changes = |test: Test| test.of(&from) * test.of(&to) < 0.0;
        // Where the branch turns a multiplier is 1 for that reason.
        let one = |test: Test| matches!(test, Test::One) && changes(Test::Turn);
        let tests = Test::ALL.into_iter().filter(|test| changes(*test) && !one(*test)).collect();
        Self { from, to, tests, location: None, found: Vec::new() }
    }

    /// There is nothing left to search for.
    pub fn is_over(&self) -> bool {
        self.tests.is_empty()
    }

    /// Comes a cycle nearer.
    pub fn advance(&mut self, family: &mut dyn Family, tolerance: f64) {
        let Some(test) = self.tests.last().copied() else { return };
        let location = self.location.get_or_insert_with(|| Location::of(&self.from, &self.to, test));
        // What leaves the numbers is no cycle.
        match location.advance(family, &self.from, test, tolerance) {
            Ok(false) => return,
            Ok(true) => {
                if let Some((part, stop)) = self.location.take().and_then(|location| location.best)
                    && let Some(kind) = test.kind(&stop)
                {
                    self.found.push((part, kind, stop));
                }
            }
            Err(_) => self.location = None,
        }
        self.tests.pop();
    }

    /// What has been found, in its order, and the neighbour beyond.
    pub fn end(mut self) -> (Vec<(PointKind, Stop)>, Stop) {
        sort_few(&mut self.found, |a, b| a.0 < b.0);
        (self.found.into_iter().map(|(_, kind, stop)| (kind, stop)).collect(), self.to)
    }
}

/// The way to where a test is zero between two neighbours: by false position, which halves where that does not come nearer.
struct Location {
    way: Vec<f64>,
    /// How far on the way, and the test there.
    low: (f64, f64),
    high: (f64, f64),
    best: Option<(f64, Stop)>,
    again: Option<bool>,
    cycles: usize,
}

impl Location {
    fn of(from: &Stop, to: &Stop, test: Test) -> Self {
        let way = from.chart.between(&from.place, &to.place);
        let (low, high) = ((0.0, test.of(from)), (1.0, test.of(to)));
        Self { way, low, high, best: None, again: None, cycles: 0 }
    }

    /// Finds the next cycle on the way; says whether it is near enough, or there is none.
    ///
    /// # Errors
    /// A motion or a matrix that leaves the numbers.
    fn advance(&mut self, family: &mut dyn Family, from: &Stop, test: Test, tolerance: f64) -> Result<bool> {
        let Self { way, low, high, best, again, cycles } = self;
        let (chart, length, border) = (&from.chart, norm(way), direction(way));
        let part = low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1);
        let Some(solved) = correct(family, chart, &chart.ahead(&from.place, way, part), &border) else {
            return Ok(true);
        };
        let stop = Stop::of(family, chart, solved, &border)?;
        let value = test.of(&stop);
        let moved = best.as_ref().map_or(1.0, |(before, _)| (before - part).abs());
        *best = Some((part, stop));
        if value == 0.0 || moved * length < tolerance || (high.0 - low.0) * length < tolerance {
            return Ok(true);
        }
        // An end that stays twice counts half: so the other one comes over, too.
        let rises = value * low.1 > 0.0;
        let (moves, stays) = if rises { (&mut *low, &mut *high) } else { (&mut *high, &mut *low) };
        *moves = (part, value);
        if *again == Some(rises) {
            stays.1 *= 0.5;
        }
        *again = Some(rises);
        *cycles += 1;
        Ok(*cycles >= MOST)
    }
}
