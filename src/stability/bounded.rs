//! Numbers that know how far rounding may have led them astray.

use std::ops::{Add, Mul, Sub};

/// A number with a bound of its rounding error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounded {
    pub value: f64,
    pub error: f64,
}

impl Bounded {
    /// A number that was rounded once or twice.
    pub fn rounded(value: f64) -> Self {
        Self { value, error: 4.0 * f64::EPSILON * value.abs() }
    }

    /// A number that is exact.
    pub fn exact(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// 0 where rounding may have left no more.
    pub fn cleared(self) -> Self {
        if self.value.abs() > self.error { self } else { Self { value: 0.0, error: 2.0 * self.error } }
    }

    pub fn over(self, other: Self) -> Self {
        let value = self.value / other.value;
        let error = (self.error + value.abs() * other.error) / other.value.abs() + f64::EPSILON * value.abs();
        Self { value, error }
    }

    pub fn negative(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

/// A number that somebody wrote down, the nearest to what was meant.
impl From<f64> for Bounded {
    fn from(value: f64) -> Self {
        Self { value, error: f64::EPSILON * value.abs() }
    }
}

impl Add for Bounded {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        Self { value, error: self.error + other.error + f64::EPSILON * value.abs() }
    }
}

impl Sub for Bounded {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        let value = self.value - other.value;
        Self { value, error: self.error + other.error + f64::EPSILON * value.abs() }
    }
}

impl Mul for Bounded {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let value = self.value * other.value;
        let carried = self.error * (other.value.abs() + other.error) + self.value.abs() * other.error;
        Self { value, error: carried + f64::EPSILON * value.abs() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cancels_is_left_in_doubt_and_what_does_not_is_not() {
        let [tenth, fifth, third] = [0.1, 0.2, 0.3].map(Bounded::from);
        let difference = tenth + fifth - third;
        assert!(difference.value != 0.0 && difference.cleared().value == 0.0, "{difference:?}");
        let product = tenth * fifth - Bounded::from(0.02 * (1.0 + 1e-14));
        assert!(product.cleared().value < 0.0, "{product:?}");
        let ratio = (tenth * third).over(fifth) - Bounded::from(0.15);
        assert_eq!(ratio.cleared().value, 0.0, "{ratio:?}");
    }
}
