//! How much of a plane is stable, by its boundary.

use super::{
    Boundary, ClosedForm, Eigenvalues,
    geometry::{between, cross, dot, length},
    pieces::Branch,
    trace::branches,
};
use crate::{error::Result, stability::Plane};

/// How far the boundary may be from straight lines between its points: the arcs laid through them are far nearer.
const MEASURED: f64 = 1e-4;

impl Plane {
    /// The share of the plane's area in which all small motions fade \[%\], by the boundary.
    ///
    /// Green's theorem: the area left of the curves that bound it is ∮ x dy along them and along what is stable of the right
    /// edge (along the others x or dy is 0), each curve taken from spot to spot as the cubic that has its tangents there.
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
    let mut area = 0.0;
    let mut cuts = vec![0.0, 1.0];
    for Branch { spots, bounds, .. } in branches(boundary, MEASURED) {
        if !bounds {
            continue;
        }
        for two in spots.windows(2) {
            let (from, to) = (two[0].at, two[1].at);
            let chord = between(from, to);
            // A cubic with tangents of this length follows an arc of a circle best.
            let half_turn = (0.5 * (1.0 + dot(two[0].tangent, two[1].tangent))).sqrt();
            let size = length(chord) * 2.0 / (1.0 + half_turn);
            let (start, end) = (two[0].tangent.map(|part| size * part), two[1].tangent.map(|part| size * part));
            area += 0.5 * (from[0] + to[0]) * chord[1] + (cross(chord, end) - cross(chord, start)) / 10.0
                - cross(start, end) / 60.0;
        }
        for end in [spots[0], spots[spots.len() - 1]] {
            if end.at[0] == 1.0 {
                cuts.insert(cuts.partition_point(|cut| *cut < end.at[1]), end.at[1]);
            }
        }
    }
    for two in cuts.windows(2) {
        if boundary.stable([1.0, two[0].midpoint(two[1])]) {
            area += two[1] - two[0];
        }
    }
    100.0 * area.clamp(0.0, 1.0)
}
