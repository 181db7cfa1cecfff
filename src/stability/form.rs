//! A polynomial over the unit square, ready to be evaluated.

use super::{
    Surface,
    line::{Bernstein, Line, bernstein},
    polynomial::COEFFICIENTS,
};

/// Coefficients by the index of x, then of y.
pub(super) type Patch = [[f64; COEFFICIENTS]; COEFFICIENTS];

/// Those of the index `j` of y.
#[inline(never)]
pub(super) fn column(patch: &Patch, j: usize) -> Bernstein {
    let mut column = [0.0; COEFFICIENTS];
    for (into, row) in column.iter_mut().zip(patch) {
        *into = row[j];
    }
    column
}

/// Puts those of the index `j` of y.
#[inline(never)]
pub(super) fn put_column(patch: &mut Patch, j: usize, column: &Bernstein) {
    for (row, from) in patch.iter_mut().zip(column) {
        row[j] = *from;
    }
}

/// Σ cᵢⱼ xⁱ yʲ with its degrees.
#[derive(Clone, Debug)]
pub(super) struct Form {
    /// Of the powers.
    pub c: Patch,
    /// The degree in x.
    pub across: usize,
    /// The degree in y.
    pub along: usize,
}

impl Form {
    #[inline(never)]
    pub fn of(surface: &Surface) -> Self {
        let (mut c, mut along) = ([[0.0; COEFFICIENTS]; COEFFICIENTS], 0);
        for i in 0..COEFFICIENTS {
            c[i] = surface.coefficient(i).0;
            along = along.max(surface.coefficient(i).degree());
        }
        Self { c, across: surface.degree(), along }
    }

    /// The same with x and y exchanged.
    pub fn transposed(&self) -> Self {
        let mut c = self.c;
        for j in 0..COEFFICIENTS {
            c[j] = column(&self.c, j);
        }
        Self { c, across: self.along, along: self.across }
    }

    /// The polynomial in x at `y`.
    #[inline]
    pub fn row(&self, y: f64) -> Line {
        let mut power = [0.0; COEFFICIENTS];
        for i in 0..=self.across {
            power[i] = self.c[i][..=self.along].iter().rev().fold(0.0, |sum, c| sum * y + c);
        }
        Line { power, degree: self.across }
    }

    /// The Bernstein coefficients over the unit square.
    pub fn bernstein(&self) -> Patch {
        let mut b = self.c;
        for c in &mut b[..=self.across] {
            *c = bernstein(*c, self.along);
        }
        for j in 0..=self.along {
            let across = bernstein(column(&b, j), self.across);
            put_column(&mut b, j, &across);
        }
        b
    }

    /// Whether it is positive all over the unit square, as far as its Bernstein coefficients tell.
    pub fn positive(&self) -> bool {
        let b = self.bernstein();
        b[..=self.across].iter().all(|b| b[..=self.along].iter().all(|b| *b > 0.0))
    }

    /// The value at a point.
    pub fn at(&self, at: [f64; 2]) -> f64 {
        self.slope(at).0
    }

    /// The value at a point, and the slopes along x and y.
    #[inline(never)]
    pub fn slope(&self, [x, y]: [f64; 2]) -> (f64, [f64; 2]) {
        let (mut value, mut across, mut along) = (0.0, 0.0, 0.0);
        for i in (0..=self.across).rev() {
            let (coefficient, its_slope) = Line { power: self.c[i], degree: self.along }.at(y);
            across = across * x + value;
            value = value * x + coefficient;
            along = along * x + its_slope;
        }
        (value, [across, along])
    }
}
