//! How much of a plane is stable, by its boundary.

use super::{
    Boundary, ClosedForm, Eigenvalues,
    geometry::{between, cross, dot, length},
    pieces::{Branch, branches},
    trace::Spot,
};
use crate::{error::Result, stability::Plane};

/// How far the boundary may be from straight lines between its points: the arcs laid through them are far nearer.
const MEASURED: f64 = 1e-4;
/// What is judged beside the right edge is judged so far from it, in case a boundary runs along it.
const INSIDE: f64 = 1.0 - 1e-9;
/// Rows that the curves are held against, and how much of one may differ: they are to 1e-4 of the plane, a flat curve is
/// less sharp across.
const ROWS: u32 = 13;
const DIFFERENT: f64 = 0.01;
/// Parts of the height to begin an integral over rows with, how often each may be halved, and what it may err by.
const PARTS: u32 = 128;
const DEEPEST: u32 = 30;
const ERROR: f64 = 1e-9;

impl Plane {
    /// The share of the plane's area in which all small motions fade \[%\], by the boundary.
    ///
    /// Green's theorem: the area left of the curves that bound it is ∮ x dy along them and along what is stable of the right
    /// edge (along the others x or dy is 0), each curve taken from spot to spot as the cubic that has its tangents there.
    /// Where there is a closed form some rows are asked whether that can be; if it cannot, rows are integrated instead.
    ///
    /// # Errors
    /// As [`Plane::hopf_curves`].
    pub fn stable_area(&self) -> Result<f64> {
        Ok(match ClosedForm::of(self) {
            Some(closed) => share(&closed),
            None => share(&Eigenvalues::of(self)?),
        })
    }
}

fn share(boundary: &dyn Boundary) -> f64 {
    let mut pieces = branches(boundary, MEASURED);
    pieces.retain(|piece| piece.bounds);
    let edge = stable_of_edge(boundary, &pieces);
    let area = if agree(boundary, &pieces, &edge) {
        pieces.iter().map(beside).sum::<f64>() + edge.iter().map(|[from, to]| to - from).sum::<f64>()
    } else {
        integral(&|y| boundary.stable_part(y).unwrap_or(0.0))
    };
    100.0 * area.clamp(0.0, 1.0)
}

/// ∫ x dy along a curve.
fn beside(piece: &Branch) -> f64 {
    let part = |two: &[Spot]| {
        let (from, to) = (two[0].at, two[1].at);
        let chord = between(from, to);
        // A cubic with tangents of this length follows an arc of a circle best.
        let half_turn = (0.5 * (1.0 + dot(two[0].tangent, two[1].tangent))).sqrt();
        let size = length(chord) * 2.0 / (1.0 + half_turn);
        let (start, end) = (two[0].tangent.map(|part| size * part), two[1].tangent.map(|part| size * part));
        0.5 * (from[0] + to[0]) * chord[1] + (cross(chord, end) - cross(chord, start)) / 10.0 - cross(start, end) / 60.0
    };
    piece.spots.windows(2).map(part).sum()
}

/// The stable parts of the right edge.
fn stable_of_edge(boundary: &dyn Boundary, pieces: &[Branch]) -> Vec<[f64; 2]> {
    let mut cuts = vec![0.0, 1.0];
    for spot in pieces.iter().flat_map(|piece| [&piece.spots[0], &piece.spots[piece.spots.len() - 1]]) {
        if spot.at[0] == 1.0 {
            cuts.insert(cuts.partition_point(|cut| *cut < spot.at[1]), spot.at[1]);
        }
    }
    let stable = |[from, to]: &[f64; 2]| boundary.stable([INSIDE, from.midpoint(*to)]);
    cuts.windows(2).map(|two| [two[0], two[1]]).filter(stable).collect()
}

/// Whether rows are stable where the curves let them, as far as that is known.
fn agree(boundary: &dyn Boundary, pieces: &[Branch], edge: &[[f64; 2]]) -> bool {
    (0..ROWS).all(|row| {
        // By golden sections: boundaries of round numbers are at round parts.
        let y = (0.618_033_988_749_894_9 * f64::from(row + 1)).fract();
        let Some(expected) = boundary.stable_part(y) else { return true };
        let mut part = f64::from(u8::from(edge.iter().any(|[from, to]| (*from..*to).contains(&y))));
        for two in pieces.iter().flat_map(|piece| piece.spots.windows(2)) {
            let (from, to) = (two[0].at, two[1].at);
            if (from[1] <= y) != (to[1] <= y) {
                let x = from[0] + (to[0] - from[0]) * (y - from[1]) / (to[1] - from[1]);
                part += if to[1] > from[1] { x } else { -x };
            }
        }
        (part - expected).abs() < DIFFERENT
    })
}

/// ∫ f from 0 to 1 by Simpson's rule, halved where it does not agree with itself: jumps are found.
fn integral(f: &dyn Fn(f64) -> f64) -> f64 {
    fn part(f: &dyn Fn(f64) -> f64, [a, b]: [f64; 2], [low, middle, high]: [f64; 3], deeper: u32) -> f64 {
        let (left, right) = (f(a + 0.25 * (b - a)), f(a + 0.75 * (b - a)));
        let whole = (b - a) / 6.0 * (low + 4.0 * middle + high);
        let halves = (b - a) / 12.0 * (low + 4.0 * left + 2.0 * middle + 4.0 * right + high);
        if deeper == 0 || (halves - whole).abs() < ERROR {
            return halves;
        }
        let centre = a.midpoint(b);
        part(f, [a, centre], [low, left, middle], deeper - 1) + part(f, [centre, b], [middle, right, high], deeper - 1)
    }
    let piece = |i: u32| {
        let [a, b] = [i, i + 1].map(|i| f64::from(i) / f64::from(PARTS));
        part(f, [a, b], [f(a), f(a.midpoint(b)), f(b)], DEEPEST)
    };
    (0..PARTS).map(piece).sum()
}

#[cfg(test)]
mod tests {
    use super::super::{Crossing, CurveKind, Point};
    use super::*;

    #[test]
    fn rows_are_integrated_across_jumps_and_roots() {
        for (f, expected) in [
            (&(|y: f64| f64::from(u8::from(y > 0.3))) as &dyn Fn(f64) -> f64, 0.7),
            (&|y: f64| (y - 0.4).max(0.0).sqrt(), 0.6_f64.powf(1.5) / 1.5),
            (&|y: f64| y * y * y, 0.25),
        ] {
            // A part of a hundred, at each of its halvings, errs by no more than 1e-9.
            assert!((integral(f) - expected).abs() < 2e-7, "{} for {expected}", integral(f));
        }
    }

    /// Stable below 0.4, with a boundary there that no seed leads to.
    struct Missed;

    impl Boundary for Missed {
        fn test(&self, _: CurveKind, [_, y]: Point) -> (f64, Point) {
            (0.4 - y, [0.0, -1.0])
        }
        fn seeds(&self, _: CurveKind) -> Vec<[Point; 2]> {
            Vec::new()
        }
        fn crossing(&self, _: CurveKind, _: Point) -> Option<Crossing> {
            None
        }
        fn holds(&self, _: CurveKind, _: Point) -> bool {
            true
        }

        fn stable(&self, [_, y]: Point) -> bool {
            y < 0.4
        }
        fn stable_part(&self, y: f64) -> Option<f64> {
            Some(f64::from(u8::from(y < 0.4)))
        }
    }

    #[test]
    fn a_curve_that_was_missed_does_not_falsify_the_area() {
        assert!((share(&Missed) - 40.0).abs() < 1e-6, "{}", share(&Missed));
    }
}
