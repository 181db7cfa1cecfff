//! Numbers that right-hand sides and force laws are written for.
//!
//! One text of a model gives trajectories (`f64`), exact Jacobians ([`Dual`]) and ensembles ([`crate::ensemble::Lanes`]);
//! nothing else in the crate is generic over its numbers.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// What numbers and lanes of numbers have in common: arithmetic without a branch.
pub trait Number: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// The nearest number in −`limit` … `limit`.
    #[must_use]
    fn clamped(self, limit: Self) -> Self;
}

/// Sums of products, which lanes take in one step where the processor may: with one rounding then, or with two.
pub trait Sums<C>: Number + Mul<C, Output = Self> {
    /// self + x · c.
    #[must_use]
    #[inline(always)]
    fn plus(self, x: Self, c: C) -> Self {
        self + x * c
    }

    /// self − x · c.
    #[must_use]
    #[inline(always)]
    fn minus(self, x: Self, c: C) -> Self {
        self - x * c
    }
}

impl Sums<f64> for f64 {}
impl<const D: usize> Sums<f64> for Dual<D> {}
impl<const D: usize> Sums<Self> for Dual<D> {}

impl Number for f64 {
    #[inline(always)]
    fn clamped(self, limit: Self) -> Self {
        // Not f64::clamp, which asks first whether there is such a number.
        let below = if limit < self { limit } else { self };
        if below < -limit { -limit } else { below }
    }
}

/// A number of a right-hand side: a value, or a value with its derivatives.
///
/// Coefficients stay `f64`; states are `Real`. Comparisons use [`Real::value`], so that a branch never depends on a
/// derivative.
pub trait Real:
    Sums<f64>
    + Sums<Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + From<f64>
{
    /// The value without its derivatives.
    fn value(self) -> f64;
    /// Sine of an angle in radians.
    fn sin(self) -> Self;
    /// Arc tangent in radians, in (−π/2, π/2).
    fn atan(self) -> Self;
    /// f(self), given f and its derivative at the value: what the trait does not name.
    fn chain(self, value: f64, derivative: f64) -> Self;
    /// The size without the sign.
    #[inline(always)]
    fn abs(self) -> Self {
        if self.value() < 0.0 { -self } else { self }
    }
}

impl Real for f64 {
    #[inline(always)]
    fn value(self) -> f64 {
        self
    }
    #[inline(always)]
    fn sin(self) -> Self {
        f64::sin(self)
    }
    #[inline(always)]
    fn atan(self) -> Self {
        f64::atan(self)
    }
    #[inline(always)]
    fn chain(self, value: f64, _derivative: f64) -> Self {
        value
    }
}

/// A value with its derivatives in `D` directions (forward-mode differentiation).
///
/// The derivative of every operation is exact up to rounding: this is where analytic Jacobians come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<const D: usize> {
    /// The value.
    pub value: f64,
    /// Its derivatives, one per direction.
    pub slope: [f64; D],
}

impl<const D: usize> Dual<D> {
    /// The variable of direction `direction`: its own derivative is 1, all others are 0.
    ///
    /// # Panics
    /// Where `direction ≥ D`.
    pub fn variable(value: f64, direction: usize) -> Self {
        let mut slope = [0.0; D];
        slope[direction] = 1.0;
        Self { value, slope }
    }

    #[inline(always)]
    fn zip(self, other: Self, value: f64, slope: impl Fn(f64, f64) -> f64) -> Self {
        Self { value, slope: std::array::from_fn(|i| slope(self.slope[i], other.slope[i])) }
    }
}

impl<const D: usize> From<f64> for Dual<D> {
    fn from(value: f64) -> Self {
        Self { value, slope: [0.0; D] }
    }
}

impl<const D: usize> Add for Dual<D> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.zip(other, self.value + other.value, |a, b| a + b)
    }
}

impl<const D: usize> Sub for Dual<D> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.zip(other, self.value - other.value, |a, b| a - b)
    }
}

// The rules of products and quotients mix operations by nature.
#[allow(clippy::suspicious_arithmetic_impl)]
impl<const D: usize> Mul for Dual<D> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.zip(other, self.value * other.value, |a, b| a * other.value + self.value * b)
    }
}

#[allow(clippy::suspicious_arithmetic_impl)]
impl<const D: usize> Div for Dual<D> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let ratio = self.value / other.value;
        self.zip(other, ratio, |a, b| (a - ratio * b) / other.value)
    }
}

impl<const D: usize> Neg for Dual<D> {
    type Output = Self;
    fn neg(self) -> Self {
        self.chain(-self.value, -1.0)
    }
}

impl<const D: usize> Add<f64> for Dual<D> {
    type Output = Self;
    fn add(self, other: f64) -> Self {
        Self { value: self.value + other, ..self }
    }
}

impl<const D: usize> Sub<f64> for Dual<D> {
    type Output = Self;
    fn sub(self, other: f64) -> Self {
        Self { value: self.value - other, ..self }
    }
}

impl<const D: usize> Mul<f64> for Dual<D> {
    type Output = Self;
    fn mul(self, other: f64) -> Self {
        self.chain(self.value * other, other)
    }
}

impl<const D: usize> Number for Dual<D> {
    fn clamped(self, limit: Self) -> Self {
        if self.value > limit.value {
            limit
        } else if self.value < -limit.value {
            -limit
        } else {
            self
        }
    }
}

impl<const D: usize> Real for Dual<D> {
    fn value(self) -> f64 {
        self.value
    }
    fn sin(self) -> Self {
        self.chain(self.value.sin(), self.value.cos())
    }
    fn atan(self) -> Self {
        self.chain(self.value.atan(), 1.0 / (1.0 + self.value * self.value))
    }
    #[inline(always)]
    fn chain(self, value: f64, derivative: f64) -> Self {
        Self { value, slope: self.slope.map(|s| derivative * s) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A function that uses every operation, differentiated by hand and by differences.
    fn every_operation<R: Real>(x: R) -> R {
        ((x * x - 2.0) / (x + 3.0) + (-x).sin() * 0.5) * x.atan()
            - x * x * x.abs() * x.chain(x.value().cos(), -x.value().sin())
    }

    #[test]
    fn dual_numbers_agree_with_central_differences() {
        for x in [-1.7, -0.2, 0.0, 0.4, 2.3] {
            let dual = every_operation(Dual::<1>::variable(x, 0));
            // 1e-5 balances truncation (h²) against rounding (ε/h): both near 1e-10.
            let h = 1e-5;
            let difference = (every_operation(x + h) - every_operation(x - h)) / (2.0 * h);
            assert_eq!(dual.value, every_operation(x));
            assert!(
                (dual.slope[0] - difference).abs() < 1e-9 * (1.0 + difference.abs()),
                "{x}: {} {difference}",
                dual.slope[0]
            );
        }
    }

    #[test]
    fn beyond_a_limit_is_the_limit() {
        let x = |value| Dual::<1>::variable(value, 0);
        for (value, clamped, slope) in [(3.0, 2.0, 0.0), (-3.0, -2.0, 0.0), (1.5, 1.5, 1.0), (-2.0, -2.0, 1.0)] {
            assert_eq!(value.clamped(2.0), clamped);
            assert_eq!(x(value).clamped(Dual::from(2.0)), Dual { value: clamped, slope: [slope] });
        }
    }

    #[test]
    fn directions_do_not_mix() {
        let x = Dual::<2>::variable(2.0, 0);
        let y = Dual::<2>::variable(5.0, 1);
        assert_eq!((x * y).slope, [5.0, 2.0]);
        assert_eq!((x / y).slope, [0.2, -2.0 / 25.0]);
    }
}
