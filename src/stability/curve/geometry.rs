//! Points and ways in the plane.

use super::Point;

/// From one point to another.
pub(super) fn between(from: Point, to: Point) -> Point {
    [to[0] - from[0], to[1] - from[1]]
}

/// A part of the way between two points.
pub(super) fn mixed(a: Point, b: Point, part: f64) -> Point {
    ahead(a, between(a, b), part)
}

/// Some way on.
pub(super) fn ahead(at: Point, way: Point, part: f64) -> Point {
    [at[0] + part * way[0], at[1] + part * way[1]]
}

/// The product along each other.
pub(super) fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The product across each other.
pub(super) fn cross(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// How long a way is.
pub(super) fn length(a: Point) -> f64 {
    dot(a, a).sqrt()
}
