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

/// The special points between two neighbours on a branch, in their order.
///
/// # Errors
/// A motion or a matrix that leaves the numbers.
pub(super) fn between(
    family: &mut dyn Family,
    from: &Stop,
    to: &Stop,
    tolerance: f64,
) -> Result<Vec<(PointKind, Stop)>> {
    let changes = |test: Test| test.of(from) * test.of(to) < 0.0;
    let mut found: Vec<(f64, PointKind, Stop)> = Vec::new();
    for test in Test::ALL {
        // Where the branch turns a multiplier is 1 for that reason.
        if !changes(test) || (matches!(test, Test::One) && changes(Test::Turn)) {
            continue;
        }
        if let Some((part, stop)) = located(family, from, to, test, tolerance)?
            && let Some(kind) = test.kind(&stop)
        {
            found.push((part, kind, stop));
        }
    }
    sort_few(&mut found, |a, b| a.0 < b.0);
    Ok(found.into_iter().map(|(_, kind, stop)| (kind, stop)).collect())
}

/// Where a test is zero between two neighbours, and how far on the way: by false position, which halves where that does not
/// come nearer.
fn located(family: &mut dyn Family, from: &Stop, to: &Stop, test: Test, tolerance: f64) -> Result<Option<(f64, Stop)>> {
    let chart = &from.chart;
    let way = chart.between(&from.place, &to.place);
    let length = norm(&way);
    let border = direction(&way);
    let (mut low, mut high) = ((0.0, test.of(from)), (1.0, test.of(to)));
    let mut best: Option<(f64, Stop)> = None;
    let mut again = None;
    for _ in 0..MOST {
        let part = low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1);
        let Some(solved) = correct(family, chart, &chart.ahead(&from.place, &way, part), &border) else { break };
        let stop = Stop::of(family, chart, solved, &border)?;
        let value = test.of(&stop);
        let moved = best.as_ref().map_or(1.0, |(before, _)| (before - part).abs());
        best = Some((part, stop));
        if value == 0.0 || moved * length < tolerance || (high.0 - low.0) * length < tolerance {
            break;
        }
        // An end that stays twice counts half: so the other one comes over, too.
        let rises = value * low.1 > 0.0;
        let (moves, stays) = if rises { (&mut low, &mut high) } else { (&mut high, &mut low) };
        *moves = (part, value);
        if again == Some(rises) {
            stays.1 *= 0.5;
        }
        again = Some(rises);
    }
    Ok(best)
}
