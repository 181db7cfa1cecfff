//! A polynomial over the unit square, ready to be evaluated.

use super::{
    COEFFICIENTS, Surface,
    line::{Bernstein, Line, bernstein},
};

/// Coefficients by the index of y, then of x.
pub(in crate::stability) type Patch = [[f64; COEFFICIENTS]; COEFFICIENTS];

/// Those of the index `i` of x.
#[inline(never)]
pub(in crate::stability) fn column(patch: &Patch, i: usize) -> Bernstein {
    let mut column = [0.0; COEFFICIENTS];
    for (into, row) in column.iter_mut().zip(patch) {
        *into = row[i];
    }
    column
}

/// Puts those of the index `i` of x.
#[inline(never)]
pub(in crate::stability) fn put_column(patch: &mut Patch, i: usize, column: &Bernstein) {
    for (row, from) in patch.iter_mut().zip(column) {
        row[i] = *from;
    }
}

/// Σ cᵢⱼ xⁱ yʲ with its degrees.
#[derive(Clone, Debug)]
pub(in crate::stability) struct Form {
    /// Of the powers.
    c: Patch,
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
            put_column(&mut c, i, &surface.coefficient(i).0);
            along = along.max(surface.coefficient(i).degree());
        }
        Self { c, across: surface.degree(), along }
    }

    /// The same with x and y exchanged.
    pub fn transposed(&self) -> Self {
        let mut c = self.c;
        for i in 0..COEFFICIENTS {
            c[i] = column(&self.c, i);
        }
        Self { c, across: self.along, along: self.across }
    }

    /// The polynomial in x at `y`.
    #[inline(never)]
    pub fn row(&self, y: f64) -> Line {
        self.row_in_line(y)
    }

    /// As [`Form::row`], where a call would be seen.
    #[inline(always)]
    pub fn row_in_line(&self, y: f64) -> Line {
        let mut power = [0.0; COEFFICIENTS];
        for c in self.c[..=self.along].iter().rev() {
            // Nearly always these are all.
            for i in 0..4 {
                power[i] = power[i] * y + c[i];
            }
            if self.across > 3 {
                power[4] = power[4] * y + c[4];
                power[5] = power[5] * y + c[5];
            }
        }
        Line { power, degree: self.across }
    }

    /// The Bernstein coefficients over the unit square.
    pub fn bernstein(&self) -> Patch {
        let mut b = self.c;
        for c in &mut b[..=self.along] {
            *c = bernstein(*c, self.across);
        }
        for i in 0..=self.across {
            let along = bernstein(column(&b, i), self.along);
            put_column(&mut b, i, &along);
        }
        b
    }

    /// Whether it is positive all over the unit square, as far as its Bernstein coefficients tell.
    pub fn positive(&self) -> bool {
        let b = self.bernstein();
        b[..=self.along].iter().all(|b| b[..=self.across].iter().all(|b| *b > 0.0))
    }

    /// The value at a point.
    pub fn at(&self, at: [f64; 2]) -> f64 {
        self.slope(at).0
    }

    /// The sum of its terms' sizes at a point.
    pub fn size(&self, [x, y]: [f64; 2]) -> f64 {
        self.c.iter().rev().fold(0.0, |sum, c| sum * y + c.iter().rev().fold(0.0, |sum, c| sum * x + c.abs()))
    }

    /// The value at a point, and the slopes along x and y.
    #[inline(never)]
    pub fn slope(&self, [x, y]: [f64; 2]) -> (f64, [f64; 2]) {
        let (mut value, mut across, mut along) = (0.0, 0.0, 0.0);
        for c in self.c[..=self.along].iter().rev() {
            let (coefficient, its_slope) = Line { power: *c, degree: self.across }.at(x);
            along = along * y + value;
            value = value * y + coefficient;
            across = across * y + its_slope;
        }
        (value, [across, along])
    }
}
