//! Freeplay of the torsion spring: a gap in which the spring does nothing.

use super::Side;
use crate::real::Real;

/// s(ψ), the angle that winds the spring: ψ − ψ_fp sign ψ outside of the gap, 0 inside.
///
/// `half_gap` is ψ_fp in rad. Source: E. Atabay 2012, ch. 6.
#[inline(always)]
pub fn spring_angle<R: Real>(angle: R, half_gap: f64, side: Side) -> R {
    match side {
        Side::Within => R::from(0.0),
        Side::Above => angle - half_gap,
        Side::Below => angle + half_gap,
    }
}
