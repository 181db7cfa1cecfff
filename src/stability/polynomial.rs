//! Polynomials of low degree in one variable, and all of their roots in an interval.

pub(super) mod cubic;
pub(super) mod form;
pub(super) mod line;
mod surface;

use std::ops::{Add, Mul, Sub};

pub use surface::Surface;

/// Numbers as an equation needs them: plain ones, or polynomials in what varies.
pub trait Ring: Copy + PartialEq + From<f64> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {}

impl<T: Copy + PartialEq + From<f64> + Add<Output = T> + Sub<Output = T> + Mul<Output = T>> Ring for T {}

/// Coefficients that a polynomial can have: the conditions of the torsional gear are of degree 5 at most (in the half
/// contact length, with both of its links at work).
const COEFFICIENTS: usize = 6;

/// c₀ + c₁x + c₂x² + … up to x⁵; what a product has beyond is lost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polynomial(pub(super) [f64; COEFFICIENTS]);

impl Polynomial {
    /// The variable itself.
    pub fn variable() -> Self {
        let mut c = [0.0; COEFFICIENTS];
        c[1] = 1.0;
        Self(c)
    }

    /// What runs from `from` to `to` as the variable runs from 0 to 1.
    pub(super) fn between(from: f64, to: f64) -> Self {
        let mut c = [0.0; COEFFICIENTS];
        (c[0], c[1]) = (from, to - from);
        Self(c)
    }

    /// The value at `x`.
    #[inline(never)]
    pub fn at(&self, x: f64) -> f64 {
        self.0.iter().rev().fold(0.0, |sum, c| sum * x + c)
    }

    fn derivative(&self) -> Self {
        Self(std::array::from_fn(|i| if i + 1 < COEFFICIENTS { (i + 1) as f64 * self.0[i + 1] } else { 0.0 }))
    }

    pub(super) fn degree(&self) -> usize {
        self.0.iter().rposition(|c| *c != 0.0).unwrap_or(0)
    }

    /// Every root in the open interval (`low`, `high`), ascending, to the last digits that the coefficients hold; a
    /// multiple root counts once.
    ///
    /// Between two neighbouring roots of its derivative a polynomial is monotone, and has a root exactly where its sign
    /// changes: none is missed, however narrow the gap between two. Where two have come so near that rounding hides the
    /// sign between them, they count as none, or as two as far apart as rounding goes.
    pub fn roots(&self, low: f64, high: f64) -> Vec<f64> {
        if self.degree() == 0 {
            return Vec::new();
        }
        let mut roots = Vec::with_capacity(COEFFICIENTS);
        let (mut left, mut at_left) = (low, self.at(low));
        for turn in self.derivative().roots(low, high).into_iter().chain([high]) {
            let at_turn = self.at(turn);
            let (rises, falls) = (at_left < 0.0 && at_turn > 0.0, at_left > 0.0 && at_turn < 0.0);
            if rises || falls {
                roots.push(self.bisected(left, turn, falls));
            } else if at_turn == 0.0 && turn < high {
                roots.push(turn);
            }
            (left, at_left) = (turn, at_turn);
        }
        roots
    }

    /// The root between `low` and `high`, to neighbouring numbers: at most 64 halvings, whatever the sizes, as it is the
    /// numbers' places in their order that are halved.
    fn bisected(&self, low: f64, high: f64, falls: bool) -> f64 {
        let (mut low, mut high) = (place(low), place(high));
        loop {
            let middle = low.midpoint(high);
            if middle == low || middle == high {
                break;
            }
            if (self.at(number(middle)) > 0.0) == falls {
                low = middle;
            } else {
                high = middle;
            }
        }
        let (low, high) = (number(low), number(high));
        if self.at(high).abs() < self.at(low).abs() { high } else { low }
    }
}

/// The place of a number in the order of all numbers.
fn place(x: f64) -> i64 {
    let size = x.abs().to_bits() as i64;
    if x < 0.0 { -size } else { size }
}

/// The number at a place.
fn number(place: i64) -> f64 {
    let size = f64::from_bits(place.unsigned_abs());
    if place < 0 { -size } else { size }
}

impl From<f64> for Polynomial {
    fn from(constant: f64) -> Self {
        let mut c = [0.0; COEFFICIENTS];
        c[0] = constant;
        Self(c)
    }
}

impl Add for Polynomial {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] + other.0[i]))
    }
}

impl Sub for Polynomial {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] - other.0[i]))
    }
}

impl Mul for Polynomial {
    type Output = Self;
    #[inline(never)] // a dozen products a condition, and no hurry
    fn mul(self, other: Self) -> Self {
        debug_assert!(self.degree() + other.degree() < COEFFICIENTS, "no condition is of that degree");
        let mut c = [0.0; COEFFICIENTS];
        for i in 0..=self.degree() {
            for j in 0..COEFFICIENTS - i {
                c[i + j] += self.0[i] * other.0[j];
            }
        }
        Self(c)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∏ (x − root).
    fn with_roots(roots: &[f64]) -> Polynomial {
        roots
            .iter()
            .fold(Polynomial::from(1.0), |product, root| product * (Polynomial::variable() - Polynomial::from(*root)))
    }

    #[test]
    fn all_roots_in_the_interval_are_found() {
        let found = with_roots(&[-0.5, 1e-6, 0.25, 3.0, 70.0]).roots(-1.0, 10.0);
        for (found, root) in found.iter().zip([-0.5, 1e-6, 0.25, 3.0]) {
            // The coefficients, rounded to 2⁻⁵³, hold a root to that times the sum of the terms over the slope there:
            // some 1e-16 · 100 relative to the largest root near.
            assert!((found - root).abs() < 2e-14, "{found} {root}");
        }
        assert_eq!(found.len(), 4);
        assert!(with_roots(&[1.0, 2.0]).roots(3.0, 4.0).is_empty());
    }

    #[test]
    fn close_neighbours_and_multiple_roots_are_seen() {
        // Two roots 2e-6 apart lie 1e-12 deep, far above rounding (2e-16).
        let found = with_roots(&[1.0 - 1e-6, 1.0 + 1e-6]).roots(-1e3, 1e3);
        assert_eq!(found.len(), 2);
        assert!((found[1] - found[0] - 2e-6).abs() < 1e-9);
        // Exact in binary: the sign does not change at a double root, and does at a triple one.
        assert_eq!(with_roots(&[0.5, 0.5]).roots(0.0, 1.0), [0.5]);
        assert_eq!(with_roots(&[0.5, 0.5, 0.5]).roots(0.0, 1.0), [0.5]);
        // Where a turn is known to rounding only, a double root is seen as none or two, as far apart as √ε.
        let found = with_roots(&[0.5, 0.5, 0.75]).roots(0.0, 1.0);
        let (last, double) = found.split_last().unwrap();
        assert!((last - 0.75).abs() < 1e-14 && double.iter().all(|root| (root - 0.5).abs() < 1e-8), "{found:?}");
    }

    #[test]
    fn sizes_do_not_matter() {
        let found = with_roots(&[1e-200, 1e150]).roots(0.0, 1e300);
        assert!((found[0] / 1e-200 - 1.0).abs() < 1e-15 && (found[1] / 1e150 - 1.0).abs() < 1e-15, "{found:?}");
    }

    #[test]
    fn a_constant_has_no_roots_and_ends_do_not_count() {
        assert!(Polynomial::from(0.0).roots(-1.0, 1.0).is_empty());
        assert!(Polynomial::from(3.0).roots(-1.0, 1.0).is_empty());
        assert!(with_roots(&[0.0, 1.0]).roots(0.0, 1.0).is_empty());
    }
}
