//! A polynomial over the unit square, ready to be evaluated.

use super::{
    Polynomial, Surface,
    line::{Bernstein, Line, bernstein},
    polynomial::COEFFICIENTS,
};

/// Σ cᵢⱼ xⁱ yʲ with its degrees.
#[derive(Clone, Debug)]
pub(super) struct Form {
    /// By the power of x, then of y.
    pub c: [[f64; COEFFICIENTS]; COEFFICIENTS],
    /// The degree in x.
    pub across: usize,
    /// The degree in y.
    pub along: usize,
}

impl Form {
    pub fn of(surface: &Surface) -> Self {
        let c = std::array::from_fn(|i| surface.coefficient(i).0);
        let along = (0..COEFFICIENTS).map(|i| Polynomial(c[i]).degree()).fold(0, usize::max);
        Self { c, across: surface.degree(), along }
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
    pub fn bernstein(&self) -> [Bernstein; COEFFICIENTS] {
        let along = self.c.map(|c| bernstein(c, self.along));
        let mut b = along;
        for j in 0..=self.along {
            let across = bernstein(along.map(|c| c[j]), self.across);
            for i in 0..=self.across {
                b[i][j] = across[i];
            }
        }
        b
    }
}
