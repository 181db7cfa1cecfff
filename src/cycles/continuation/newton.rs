//! Cycles of a family as the solutions of equations: Newton's method, tangents, multipliers.

use nalgebra::{Complex, DMatrix};

use super::family::Family;
use crate::{
    cycles::{
        shooting::multipliers,
        square::Square,
        vector::{complex, direction, matrix, norm, real, sum, times},
    },
    error::Result,
    stability::Triangle,
};

/// A Newton step that is shorter ends the way: what it would better is in the noise of the integration.
const ARRIVED: f64 = 1e-8;
/// With old derivatives one goes as near as this, and no nearer.
const NEARLY: f64 = 1e-7;
/// A step that cannot be bettered is the last where it is shorter than this.
const ROUNDED: f64 = 1e-6;
/// The longest step that is believed.
const LONGEST: f64 = 1.0;
/// Most matrices on the way, and most steps with one.
const MATRICES: usize = 6;
const STEPS: usize = 3;
/// Steps with an old matrix go on as long as each is shorter than the one before by this factor.
const GAINING: f64 = 0.2;
/// By which part of its range the parameter is changed to see what that does; by less where an arrival moves farther than
/// this for it, so often.
const ASIDE: f64 = 1e-5;
const FAR: f64 = 1e-3;
const DIFFERENCES: usize = 4;

/// A cycle: a state on it in units of the typical sizes, the time after which it is back there (of a symmetric one: at the
/// mirror image), and the parameter.
#[derive(Clone, Debug)]
pub(super) struct Place {
    pub x: Vec<f64>,
    pub time: f64,
    pub value: f64,
}

/// Units in which distances between cycles are measured: the state by the cycle's size, time by itself, the parameter by
/// its range.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chart {
    /// −1 where half of a symmetric cycle is asked for, else 1.
    pub sign: f64,
    pub size: f64,
    pub low: f64,
    pub high: f64,
}

impl Chart {
    pub fn width(&self) -> f64 {
        self.high - self.low
    }

    /// `place` a part of a way farther.
    pub fn ahead(&self, place: &Place, way: &[f64], part: f64) -> Place {
        let n = place.x.len();
        Place {
            x: sum(&place.x, self.size * part, &way[..n]),
            time: place.time * (1.0 + part * way[n]),
            value: place.value + self.width() * part * way[n + 1],
        }
    }

    /// The way from one place to another.
    pub fn between(&self, from: &Place, to: &Place) -> Vec<f64> {
        let mut way = times(1.0 / self.size, &sum(&to.x, -1.0, &from.x));
        way.push(to.time / from.time - 1.0);
        way.push((to.value - from.value) / self.width());
        way
    }
}

/// A cycle that has been found, with the equations' derivatives there.
#[derive(Clone, Debug)]
pub(super) struct Solved {
    pub place: Place,
    /// How its neighbours are carried around, mirrored back where it is half of a symmetric one.
    around: Square,
    /// ẋ where it starts.
    leaving: Vec<f64>,
    /// Derivatives of the equations that `border` completes.
    rows: DMatrix<f64>,
}

/// The cycle near `from` in the plane through it that stands on `border`; none where Newton's method finds none.
///
/// # Equations
/// φ(x, T, p) = ±x, f(x₀)·(x − x₀) = 0 and b·(u − u₀) = 0 in the unknowns u = (x, T, p): an arrival, a phase, and a step of
/// pseudo-arclength, or of the parameter alone where b points along it. The derivatives are taken anew only where old ones
/// gain no more: with them a motion takes its neighbours along, and costs ten times as much.
pub(super) fn correct(family: &mut dyn Family, chart: &Chart, from: &Place, border: &[f64]) -> Option<Solved> {
    let mut place = from.clone();
    let mut last = f64::INFINITY;
    family.vary(from.value).then_some(())?;
    let phase = family.flow().rate(&from.x);
    for _ in 0..MATRICES {
        let (here, end) = Solved::at(family, chart, place, &phase, border)?;
        let step = here.step(chart, &end, &here.place.x);
        let mut long = norm(&step);
        if long < ARRIVED || (long >= last && long < ROUNDED) {
            return Some(here);
        }
        if long.is_nan() || long >= LONGEST.min(last) {
            return None;
        }
        last = long;
        let mut next = chart.ahead(&here.place, &step, 1.0);
        for _ in 0..STEPS {
            if long < NEARLY || !is_sound(family, &next) {
                break;
            }
            let (end, _) = family.flow().carry(&next.x, next.time, false)?;
            let step = here.step(chart, &end, &next.x);
            let again = norm(&step);
            if again.is_nan() || again >= GAINING * long {
                break;
            }
            (next, long) = (chart.ahead(&next, &step, 1.0), again);
        }
        place = next;
    }
    None
}

/// Goes over to the place's parameter; says whether there is a way to go from it.
fn is_sound(family: &mut dyn Family, place: &Place) -> bool {
    place.time > 0.0 && family.vary(place.value)
}

impl Solved {
    /// The equations at a place, and where the motion from it arrives.
    pub fn at(
        family: &mut dyn Family,
        chart: &Chart,
        place: Place,
        phase: &[f64],
        border: &[f64],
    ) -> Option<(Self, Vec<f64>)> {
        let Chart { sign, size, .. } = *chart;
        let n = place.x.len();
        is_sound(family, &place).then_some(())?;
        let flow = family.flow();
        let (end, around) = flow.carry(&place.x, place.time, true)?;
        let (leaving, arriving) = (flow.rate(&place.x), flow.rate(&end));
        let slope = Self::slope(family, chart, &place, &end)?;
        let speed = norm(phase);
        let rows = matrix(n + 2, &|i, j| match (i, j) {
            _ if i == n + 1 => border[j],
            _ if i == n => {
                if j < n {
                    phase[j] / speed
                } else {
                    0.0
                }
            }
            _ if j < n => around.at(i, j) - if i == j { sign } else { 0.0 },
            _ if j == n => arriving[i] * place.time / size,
            _ => slope[i],
        });
        let around = Square::of(n, &|i, j| sign * around.at(i, j));
        Some((Self { place, around, leaving, rows }, end))
    }

    /// How the arrival changes with the parameter: by a difference so small that the arrival hardly moves.
    fn slope(family: &mut dyn Family, chart: &Chart, place: &Place, end: &[f64]) -> Option<Vec<f64>> {
        let mut aside = ASIDE * if place.value + ASIDE * chart.width() > chart.high { -1.0 } else { 1.0 };
        for _ in 0..DIFFERENCES {
            family.vary(place.value + aside * chart.width()).then_some(())?;
            let (other, _) = family.flow().carry(&place.x, place.time, false)?;
            let moved = times(1.0 / chart.size, &sum(&other, -1.0, end));
            let far = norm(&moved);
            if far < FAR {
                return Some(times(1.0 / aside, &moved));
            }
            aside *= 0.1 * FAR / far;
        }
        None
    }

    /// The step that the equations ask for where a motion from x arrives at `end`.
    fn step(&self, chart: &Chart, end: &[f64], x: &[f64]) -> Vec<f64> {
        let miss = |i: usize| if i < x.len() { (chart.sign * x[i] - end[i]) / chart.size } else { 0.0 };
        solution(&self.rows, &miss)
    }

    /// The way that the branch goes here, of length 1, ahead along `border`.
    pub fn tangent(&self, border: &[f64]) -> Vec<f64> {
        let last = self.rows.nrows() - 1;
        let mut rows = self.rows.clone();
        (0..=last).for_each(|j| rows[(last, j)] = border[j]);
        direction(&solution(&rows, &|i| f64::from(u8::from(i == last))))
    }

    /// The multipliers of one round, of half a round and its mirror where that is what was asked for: see [`multipliers`].
    ///
    /// # Errors
    /// A matrix so extreme that its eigenvalues leave the numbers.
    pub fn multipliers(&self) -> Result<(f64, Vec<Complex<f64>>)> {
        multipliers(&self.around, &self.leaving)
    }
}

/// The solution of linear equations.
#[inline(never)]
pub(super) fn solution(rows: &DMatrix<f64>, side: &dyn Fn(usize) -> f64) -> Vec<f64> {
    let side = complex(rows.nrows(), &|i| side(i).into());
    real(&Triangle::of(rows, 0.0.into(), &side).solution(0.0))
}
