//! Sides of a symmetric kink: a law that changes its form where a quantity passes ±limit.

use crate::real::Real;

/// Where a quantity lies with respect to ±limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// |q| ≤ limit.
    Within = 0,
    /// q ≥ limit.
    Above = 1,
    /// q ≤ −limit.
    Below = 2,
}

/// One of the two places where a [`Side`] changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Boundary {
    /// q = +limit.
    Upper,
    /// q = −limit.
    Lower,
}

impl Side {
    /// The side on which `quantity` lies; a value on the boundary lies within, unless it is about to leave
    /// (`rate` points outwards).
    pub fn of(quantity: f64, rate: f64, limit: f64) -> Side {
        if quantity > limit || (quantity == limit && rate > 0.0) {
            Side::Above
        } else if quantity < -limit || (quantity == -limit && rate < 0.0) {
            Side::Below
        } else {
            Side::Within
        }
    }

    /// How far `quantity` is from leaving this side through `boundary`: positive as long as the side holds, `None`
    /// where this side does not touch that boundary.
    #[inline(always)]
    pub fn margin<R: Real>(self, boundary: Boundary, quantity: R, limit: f64) -> Option<R> {
        match (self, boundary) {
            (Side::Within, Boundary::Upper) => Some(-quantity + limit),
            (Side::Within, Boundary::Lower) => Some(quantity + limit),
            (Side::Above, Boundary::Upper) => Some(quantity - limit),
            (Side::Below, Boundary::Lower) => Some(-quantity - limit),
            (Side::Above, Boundary::Lower) | (Side::Below, Boundary::Upper) => None,
        }
    }

    /// The side after passing `boundary`.
    pub fn across(self, boundary: Boundary) -> Side {
        match (self, boundary) {
            (Side::Within, Boundary::Upper) => Side::Above,
            (Side::Within, Boundary::Lower) => Side::Below,
            _ => Side::Within,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn margins_are_positive_on_the_side_that_holds() {
        for quantity in [-2.0, -0.5, 0.0, 0.5, 2.0] {
            let side = Side::of(quantity, 0.0, 1.0);
            for boundary in [Boundary::Upper, Boundary::Lower] {
                assert!(side.margin(boundary, quantity, 1.0).is_none_or(|margin| margin > 0.0), "{quantity} {side:?}");
            }
        }
    }

    #[test]
    fn the_way_there_and_back_is_the_same_boundary() {
        for boundary in [Boundary::Upper, Boundary::Lower] {
            let there = Side::Within.across(boundary);
            assert_ne!(there, Side::Within);
            assert_eq!(there.across(boundary), Side::Within);
        }
    }

    #[test]
    fn on_the_boundary_the_rate_decides() {
        assert_eq!(Side::of(1.0, 1.0, 1.0), Side::Above);
        assert_eq!(Side::of(1.0, -1.0, 1.0), Side::Within);
        assert_eq!(Side::of(-1.0, -1.0, 1.0), Side::Below);
    }
}
