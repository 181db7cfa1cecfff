//! A fold of cycles over two parameters as the solution of equations.

use nalgebra::{Complex, DMatrix};

use super::{
    family::Family,
    hopf::null_vector,
    newton::{Chart, Place, solution},
};
use crate::cycles::vector::{axis, dot, matrix, norm, real, sum, times};

/// A Newton step that is shorter ends the way.
const ARRIVED: f64 = 1e-8;
/// A step that cannot be bettered is the last where it is shorter than this.
const ROUNDED: f64 = 1e-5;
const LONGEST: f64 = 0.3;
/// Most matrices on the way, and most steps with one.
const MATRICES: usize = 4;
const STEPS: usize = 6;
const GAINING: f64 = 0.3;
/// The way over which derivatives are taken.
const ASIDE: f64 = 1e-5;

/// A cycle at a fold, and the second parameter.
#[derive(Clone, Debug)]
pub(super) struct Spot {
    pub place: Place,
    pub other: f64,
}

/// Units of a plane: of the first parameter in the chart, of the second its own range.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sheet {
    pub chart: Chart,
    pub low: f64,
    pub high: f64,
}

impl Sheet {
    pub fn ahead(&self, spot: &Spot, way: &[f64], part: f64) -> Spot {
        let last = way.len() - 1;
        Spot {
            place: self.chart.ahead(&spot.place, way, part),
            other: spot.other + part * way[last] * (self.high - self.low),
        }
    }

    pub fn between(&self, from: &Spot, to: &Spot) -> Vec<f64> {
        let mut way = self.chart.between(&from.place, &to.place);
        way.push((to.other - from.other) / (self.high - self.low));
        way
    }

    /// How far beyond its edges a spot is: the axis of the plane, and the edge that is passed first on a way there.
    pub fn beyond(&self, from: &Spot, to: &Spot) -> Option<(usize, f64, f64)> {
        let passed = |axis: usize, from: f64, to: f64, low: f64, high: f64| {
            let edge = if to > high { high } else { low };
            (to > high || to < low).then(|| (axis, edge, (edge - from) / (to - from)))
        };
        let across = passed(0, from.place.value, to.place.value, self.chart.low, self.chart.high);
        let along = passed(1, from.other, to.other, self.low, self.high);
        match (across, along) {
            (Some(a), Some(b)) => Some(if a.2 < b.2 { a } else { b }),
            (a, b) => a.or(b),
        }
    }
}

/// The equations of a fold around a spot: an arrival and a phase, as of any cycle, and that their derivatives with respect to
/// start and time are singular.
///
/// # Equations
/// With M = ∂(arrival, phase)/∂(x, T) and its null vectors b on the left and c on the right, kept from the spot before,
/// [M b; cᵀ 0] (w, g) = (0, 1) has g = 0 exactly where M is singular, and g is as smooth as M.
///
/// # References
/// W. J. F. Govaerts, *Numerical Methods for Bifurcations of Dynamical Equilibria*, 2000, chapter 3: bordered matrices.
pub(super) struct Equations {
    from: Spot,
    pub phase: Vec<f64>,
    left: Vec<f64>,
    right: Vec<f64>,
}

impl Equations {
    pub fn around(family: &mut dyn Family, sheet: &Sheet, from: &Spot) -> Option<Self> {
        family.aside(from.other);
        family.vary(from.place.value).then_some(())?;
        let phase = family.flow().rate(&from.place.x);
        let mut equations = Self { from: from.clone(), phase, left: Vec::new(), right: Vec::new() };
        let (matrix, _) = equations.matrix(family, sheet, from)?;
        let null = |matrix: &DMatrix<f64>| real(&null_vector(matrix, Complex::from(0.0)));
        (equations.left, equations.right) = (null(&matrix.transpose()), null(&matrix));
        Some(equations)
    }

    /// M, and the arrival's miss.
    fn matrix(&self, family: &mut dyn Family, sheet: &Sheet, spot: &Spot) -> Option<(DMatrix<f64>, Vec<f64>)> {
        let Chart { sign, size, .. } = sheet.chart;
        let Place { x, time, value } = &spot.place;
        let n = x.len();
        family.aside(spot.other);
        (*time > 0.0 && family.vary(*value)).then_some(())?;
        let flow = family.flow();
        let (end, around) = flow.carry(x, *time, true)?;
        let arriving = flow.rate(&end);
        let speed = norm(&self.phase);
        let rows = matrix(n + 1, &|i, j| match (i < n, j < n) {
            (true, true) => around.at(i, j) - if i == j { sign } else { 0.0 },
            (true, false) => arriving[i] * time / size,
            (false, true) => self.phase[j] / speed,
            (false, false) => 0.0,
        });
        Some((rows, times(1.0 / size, &sum(&end, -sign, x))))
    }

    /// By how much a spot misses a fold.
    fn miss(&self, family: &mut dyn Family, sheet: &Sheet, spot: &Spot) -> Option<Vec<f64>> {
        let (inner, mut miss) = self.matrix(family, sheet, spot)?;
        let n = miss.len();
        let moved = sum(&spot.place.x, -1.0, &self.from.place.x);
        miss.push(dot(&self.phase, &moved) / (norm(&self.phase) * sheet.chart.size));
        let bordered = matrix(n + 2, &|i, j| match (i <= n, j <= n) {
            (true, true) => inner[(i, j)],
            (true, false) => self.left[i],
            (false, true) => self.right[j],
            (false, false) => 0.0,
        });
        let solved = solution(&bordered, &|i| f64::from(u8::from(i == n + 1)));
        miss.push(solved[n + 1]);
        miss.iter().all(|part| part.is_finite()).then_some(miss)
    }

    /// The derivatives of the miss, with a last row that `border` is.
    fn rows(&self, family: &mut dyn Family, sheet: &Sheet, spot: &Spot, border: &[f64]) -> Option<DMatrix<f64>> {
        let last = border.len() - 1;
        let here = self.miss(family, sheet, spot)?;
        let mut rows = matrix(last + 1, &|_, j| border[j]);
        for j in 0..=last {
            // Inwards from the edges, beyond which a parameter may mean nothing.
            let inwards = match j + 1 {
                _ if j + 2 == border.len() => spot.place.value + ASIDE * sheet.chart.width() > sheet.chart.high,
                _ if j + 1 == border.len() => spot.other + ASIDE * (sheet.high - sheet.low) > sheet.high,
                _ => false,
            };
            let aside = if inwards { -ASIDE } else { ASIDE };
            let way = axis(last + 1, j);
            let there = self.miss(family, sheet, &sheet.ahead(spot, &way, aside))?;
            (0..last).for_each(|i| rows[(i, j)] = (there[i] - here[i]) / aside);
        }
        Some(rows)
    }
}

/// The way to the fold near a guess in the plane through it that `border` stands on, by Newton's method.
pub(super) struct Correction {
    pub border: Vec<f64>,
    spot: Spot,
    matrices: usize,
}

/// How a correction goes.
pub(super) enum Corrected {
    Goes,
    Fails,
    /// The fold, with the derivatives there.
    Found(Spot, DMatrix<f64>),
}

impl Correction {
    pub fn from(guess: &Spot, border: Vec<f64>) -> Self {
        Self { border, spot: guess.clone(), matrices: 0 }
    }

    /// Goes on with derivatives taken anew.
    pub fn advance(&mut self, equations: &Equations, family: &mut dyn Family, sheet: &Sheet) -> Corrected {
        self.matrices += 1;
        match self.stepped(equations, family, sheet) {
            Some(Corrected::Goes) if self.matrices >= MATRICES => Corrected::Fails,
            stepped => stepped.unwrap_or(Corrected::Fails),
        }
    }

    fn stepped(&mut self, equations: &Equations, family: &mut dyn Family, sheet: &Sheet) -> Option<Corrected> {
        let Self { border, spot, .. } = self;
        let last = border.len() - 1;
        let rows = equations.rows(family, sheet, spot, border)?;
        let mut before = f64::INFINITY;
        for _ in 0..STEPS {
            let miss = equations.miss(family, sheet, spot)?;
            let step = solution(&rows, &|i| if i < last { -miss[i] } else { 0.0 });
            let long = norm(&step);
            if long < ARRIVED || (long < ROUNDED && long > 0.5 * before) {
                return Some(Corrected::Found(spot.clone(), rows));
            }
            if long.is_nan() || long > LONGEST {
                return None;
            }
            if long > GAINING * before {
                break;
            }
            before = long;
            *spot = sheet.ahead(spot, &step, 1.0);
        }
        Some(Corrected::Goes)
    }
}
