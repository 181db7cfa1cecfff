//! Boundaries of any model, by its eigenvalues.

use nalgebra::Complex;

use super::{Boundary, Crossing, CurveKind, Point};
use crate::{error::Result, stability::Plane};

/// Lines of the grid on which branches are looked for, each way.
const LINES: usize = 49;
/// Half of the distance over which slopes are taken: rounding and curvature err by some 1e-10 each.
const STEP: f64 = 1e-5;
/// What a test function, which is of the size 1, may be at a point of its curve.
const ON_CURVE: f64 = 1e-6;

/// A model's eigenvalues over the unit square.
pub(super) struct Eigenvalues<'a> {
    plane: &'a Plane,
    /// The values of both test functions on the grid, row by row.
    grid: Vec<[f64; 2]>,
}

impl<'a> Eigenvalues<'a> {
    /// Those of a plane.
    ///
    /// # Errors
    /// As [`Plane::eigenvalues`], anywhere on the grid.
    pub fn of(plane: &'a Plane) -> Result<Self> {
        let mut grid = Vec::with_capacity(LINES * LINES);
        for index in 0..LINES * LINES {
            grid.push(tests(&plane.eigenvalues(place(index))?));
        }
        Ok(Self { plane, grid })
    }

    fn value(&self, kind: CurveKind, at: Point) -> f64 {
        self.plane.eigenvalues(at).map_or(f64::NAN, |values| tests(&values)[kind as usize])
    }
}

/// Where a point of the grid is.
fn place(index: usize) -> Point {
    [index % LINES, index / LINES].map(|line| line as f64 / (LINES - 1) as f64)
}

/// ∏ (λᵢ + λⱼ) over all pairs, and ∏ λᵢ: zero where a pair, or one, is on the axis, smooth where eigenvalues meet; each
/// factor by its size, and with the sign that makes them positive where all are left of the axis.
fn tests(values: &[Complex<f64>]) -> [f64; 2] {
    let size = values.iter().fold(f64::MIN_POSITIVE, |most, value| most.max(value.norm()));
    let (mut sums, mut product) = (Complex::from(1.0), Complex::from(1.0));
    for (i, a) in values.iter().enumerate() {
        product *= -a / size;
        for b in &values[..i] {
            sums *= -(a + b) / (a.norm() + b.norm()).max(f64::MIN_POSITIVE);
        }
    }
    [sums.re, product.re]
}

impl Boundary for Eigenvalues<'_> {
    fn test(&self, kind: CurveKind, at: Point) -> (f64, Point) {
        let slope = |axis: usize| {
            let (mut low, mut high) = (at, at);
            (low[axis], high[axis]) = ((at[axis] - STEP).max(0.0), (at[axis] + STEP).min(1.0));
            (self.value(kind, high) - self.value(kind, low)) / (high[axis] - low[axis])
        };
        (self.value(kind, at), [slope(0), slope(1)])
    }

    fn seeds(&self, kind: CurveKind) -> Vec<[Point; 2]> {
        let rises = |index: usize| self.grid[index][kind as usize] > 0.0;
        let mut seeds = Vec::new();
        for index in 0..LINES * LINES {
            for (last, next) in [(index % LINES == LINES - 1, index + 1), (index / LINES == LINES - 1, index + LINES)] {
                if !last && rises(index) != rises(next) {
                    seeds.push([place(index), place(next)]);
                }
            }
        }
        seeds
    }

    fn crossing(&self, kind: CurveKind, at: Point) -> Option<Crossing> {
        let values = self.plane.eigenvalues(at).ok()?;
        let size = |i: usize| values[i].norm().max(f64::MIN_POSITIVE);
        let pairs = (0..values.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
        let (i, j) = match kind {
            CurveKind::Hopf => pairs.min_by(|a, b| {
                let sum = |(i, j): (usize, usize)| (values[i] + values[j]).norm() / (size(i) + size(j));
                sum(*a).total_cmp(&sum(*b))
            })?,
            CurveKind::Divergence => {
                let least = (0..values.len()).min_by(|a, b| size(*a).total_cmp(&size(*b)))?;
                (least, least)
            }
        };
        let bounds = (0..values.len()).all(|other| other == i || other == j || values[other].re < 0.0);
        match kind {
            CurveKind::Hopf if values[i].im == 0.0 => None,
            _ => Some(Crossing { frequency: values[i].im.abs() / std::f64::consts::TAU, bounds }),
        }
    }

    fn holds(&self, kind: CurveKind, at: Point) -> bool {
        self.value(kind, at).abs() < ON_CURVE
    }

    fn stable(&self, at: Point) -> bool {
        self.plane.eigenvalues(at).is_ok_and(|values| values[0].re < 0.0)
    }
}
