//! Four numbers at once: two registers of two, so that one need not wait for the other.

use std::ops::{Add, Div, Mul, Sub};

use crate::real::{Number, Sums};

/// How many.
pub const LANES: usize = 4;

#[cfg(target_feature = "simd128")]
use std::arch::wasm32 as simd;

/// A register of two numbers.
#[cfg(target_feature = "simd128")]
type Pair = simd::v128;
/// Two numbers where the crate is not built for registers of them.
#[cfg(not(target_feature = "simd128"))]
type Pair = [f64; 2];

/// Numbers in lanes: every operation is done in each, and rounds as it does with one number alone; where the crate is built
/// for relaxed registers a sum of products may round once instead of twice.
#[derive(Clone, Copy, Debug)]
pub struct Lanes([Pair; 2]);

impl Lanes {
    /// The number in every lane.
    #[inline(always)]
    pub fn all(value: f64) -> Self {
        Self::of([value; LANES])
    }

    /// A number a lane.
    #[inline(always)]
    pub fn of([a, b, c, d]: [f64; LANES]) -> Self {
        Self([pair(a, b), pair(c, d)])
    }

    /// The numbers.
    #[inline(always)]
    pub fn each(self) -> [f64; LANES] {
        let [[a, b], [c, d]] = self.0.map(both);
        [a, b, c, d]
    }

    /// The same with another number in a lane.
    #[must_use]
    pub fn with(self, lane: usize, value: f64) -> Self {
        let mut each = self.each();
        each[lane] = value;
        Self::of(each)
    }

    /// The larger of two, lane by lane; what is no number is not larger.
    #[inline(always)]
    #[must_use]
    pub fn or_larger(self, other: Self) -> Self {
        self.zip(other, larger)
    }

    /// Its size.
    #[inline(always)]
    #[must_use]
    pub fn abs(self) -> Self {
        Self(self.0.map(|pair| larger(pair, minus(pair))))
    }

    #[inline(always)]
    fn zip(self, other: Self, with: impl Fn(Pair, Pair) -> Pair) -> Self {
        Self([with(self.0[0], other.0[0]), with(self.0[1], other.0[1])])
    }
}

impl Number for Lanes {
    #[inline(always)]
    fn clamped(self, limit: Self) -> Self {
        self.zip(limit, |x, limit| larger(smaller(x, limit), minus(limit)))
    }
}

impl Sums<Self> for Lanes {
    #[cfg(target_feature = "relaxed-simd")]
    #[inline(always)]
    fn plus(self, x: Self, c: Self) -> Self {
        let plus = |i: usize| simd::f64x2_relaxed_madd(x.0[i], c.0[i], self.0[i]);
        Self([plus(0), plus(1)])
    }

    #[cfg(target_feature = "relaxed-simd")]
    #[inline(always)]
    fn minus(self, x: Self, c: Self) -> Self {
        let minus = |i: usize| simd::f64x2_relaxed_nmadd(x.0[i], c.0[i], self.0[i]);
        Self([minus(0), minus(1)])
    }
}

impl Add for Lanes {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, plus)
    }
}

impl Sub for Lanes {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, less)
    }
}

impl Mul for Lanes {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, times)
    }
}

impl Div for Lanes {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.zip(other, over)
    }
}

#[cfg(target_feature = "simd128")]
mod registers {
    use super::{Pair, simd};

    pub fn pair(a: f64, b: f64) -> Pair {
        simd::f64x2(a, b)
    }
    pub fn both(x: Pair) -> [f64; 2] {
        [simd::f64x2_extract_lane::<0>(x), simd::f64x2_extract_lane::<1>(x)]
    }
    #[inline(always)]
    pub fn plus(x: Pair, y: Pair) -> Pair {
        simd::f64x2_add(x, y)
    }
    #[inline(always)]
    pub fn less(x: Pair, y: Pair) -> Pair {
        simd::f64x2_sub(x, y)
    }
    #[inline(always)]
    pub fn times(x: Pair, y: Pair) -> Pair {
        simd::f64x2_mul(x, y)
    }
    #[inline(always)]
    pub fn over(x: Pair, y: Pair) -> Pair {
        simd::f64x2_div(x, y)
    }
    #[inline(always)]
    pub fn minus(x: Pair) -> Pair {
        simd::f64x2_neg(x)
    }
    #[inline(always)]
    pub fn smaller(x: Pair, y: Pair) -> Pair {
        simd::f64x2_pmin(x, y)
    }
    #[inline(always)]
    pub fn larger(x: Pair, y: Pair) -> Pair {
        simd::f64x2_pmax(x, y)
    }
}

#[cfg(not(target_feature = "simd128"))]
mod registers {
    use super::Pair;

    pub fn pair(a: f64, b: f64) -> Pair {
        [a, b]
    }
    pub fn both(x: Pair) -> [f64; 2] {
        x
    }
    #[inline(always)]
    pub fn plus(x: Pair, y: Pair) -> Pair {
        [x[0] + y[0], x[1] + y[1]]
    }
    #[inline(always)]
    pub fn less(x: Pair, y: Pair) -> Pair {
        [x[0] - y[0], x[1] - y[1]]
    }
    #[inline(always)]
    pub fn times(x: Pair, y: Pair) -> Pair {
        [x[0] * y[0], x[1] * y[1]]
    }
    #[inline(always)]
    pub fn over(x: Pair, y: Pair) -> Pair {
        [x[0] / y[0], x[1] / y[1]]
    }
    #[inline(always)]
    pub fn minus(x: Pair) -> Pair {
        [-x[0], -x[1]]
    }
    #[inline(always)]
    pub fn smaller(x: Pair, y: Pair) -> Pair {
        let smaller = |x: f64, y: f64| if y < x { y } else { x };
        [smaller(x[0], y[0]), smaller(x[1], y[1])]
    }
    #[inline(always)]
    pub fn larger(x: Pair, y: Pair) -> Pair {
        let larger = |x: f64, y: f64| if x < y { y } else { x };
        [larger(x[0], y[0]), larger(x[1], y[1])]
    }
}

use registers::{both, larger, less, minus, over, pair, plus, smaller, times};
