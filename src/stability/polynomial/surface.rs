//! Polynomials in two variables.

use std::ops::{Add, Mul, Sub};

use super::{COEFFICIENTS, Polynomial};

/// Σ cᵢⱼ xⁱ yʲ up to the fifth power of each: a polynomial in x whose coefficients are polynomials in y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface([Polynomial; COEFFICIENTS]);

impl Surface {
    /// A polynomial in x, the same for every y.
    pub(in crate::stability) fn across(p: Polynomial) -> Self {
        Self(p.0.map(Polynomial::from))
    }

    /// A polynomial in y, the same for every x.
    pub(in crate::stability) fn along(p: Polynomial) -> Self {
        let mut c = [Polynomial::from(0.0); COEFFICIENTS];
        c[0] = p;
        Self(c)
    }

    /// The coefficient of xⁱ.
    pub(in crate::stability) fn coefficient(&self, i: usize) -> &Polynomial {
        &self.0[i]
    }

    /// The highest power of x.
    pub(in crate::stability) fn degree(&self) -> usize {
        self.0.iter().rposition(|c| *c != Polynomial::from(0.0)).unwrap_or(0)
    }
}

impl From<f64> for Surface {
    fn from(constant: f64) -> Self {
        Self::along(Polynomial::from(constant))
    }
}

impl Add for Surface {
    type Output = Self;
    #[inline(never)]
    fn add(mut self, other: Self) -> Self {
        for (mine, others) in self.0.iter_mut().zip(&other.0) {
            for (mine, others) in mine.0.iter_mut().zip(&others.0) {
                *mine += others;
            }
        }
        self
    }
}

impl Sub for Surface {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + other * Self::from(-1.0)
    }
}

impl Mul for Surface {
    type Output = Self;
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        let (mine, others) = (self.degree(), other.degree());
        debug_assert!(mine + others < COEFFICIENTS, "no condition is of that degree");
        let mut c = [Polynomial::from(0.0); COEFFICIENTS];
        for i in 0..=mine {
            for j in 0..=others.min(COEFFICIENTS - 1 - i) {
                c[i + j] = c[i + j] + self.0[i] * other.0[j];
            }
        }
        Self(c)
    }
}
