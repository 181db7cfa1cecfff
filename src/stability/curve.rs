//! The boundary of stability in a plane of two parameters, as curves.

mod closed;
mod eigen;
mod geometry;
mod pieces;
mod share;
mod trace;

use serde::Serialize;

use super::Plane;
use crate::{
    error::{Error, Result},
    run::{Fields, Value},
};
use closed::ClosedForm;
use eigen::Eigenvalues;
use pieces::Branch;
use trace::branches;

/// A point of the unit square that stands for the plane's rectangle.
type Point = [f64; 2];

/// How far a curve may be from the straight lines between its points, in parts of the plane: a third of what the eye, or
/// whoever draws it, needs.
const DRAWN: f64 = 3e-5;

/// What crosses the imaginary axis at a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum CurveKind {
    /// A pair of eigenvalues: a small swing neither grows nor fades.
    Hopf,
    /// A real eigenvalue: a small deviation neither grows nor fades.
    Divergence,
}

impl CurveKind {
    const BOTH: [Self; 2] = [Self::Hopf, Self::Divergence];
}

/// A curve in a plane at which eigenvalues cross the imaginary axis, whatever the others do.
///
/// A curve runs from one end to the other with the side where what crosses is to the left of the axis at its own left. It
/// ends at the rectangle's edge (on it exactly), or where another curve begins: at the double zero where a pair that
/// crosses becomes two real eigenvalues, at points where others come to the axis too, and where a curve meets itself.
#[derive(Clone, Debug, PartialEq)]
pub struct HopfCurve {
    /// Values of the parameter across.
    pub x: Vec<f64>,
    /// Values of the parameter along.
    pub y: Vec<f64>,
    /// Of the pair on the axis \[Hz\]; 0 where it is a real eigenvalue.
    pub frequency: Vec<f64>,
    /// What crosses.
    pub kind: CurveKind,
    /// It comes back to where it began: the last point is the first.
    pub closed: bool,
    /// All other eigenvalues are to the left of the axis: it bounds what is stable.
    pub bounds: bool,
}

impl Plane {
    /// Reads a record `{model, parameters, x: {parameter, from, to}, y, linked}`; a `count` of the axes may be there.
    ///
    /// # Errors
    /// Anything but known keys with valid values; the error names the field.
    pub fn read(input: &Value) -> Result<Self> {
        Ok(Self::read_with(&Fields::of("plane", input, &Self::KEYS)?, &["count"])?.0)
    }

    /// All curves in the plane; one that runs along its edge bounds nothing in it, and is none of them. Neighbouring points are so near that a straight line between them is within 10⁻⁴ of the
    /// plane's width or height from the curve; they themselves are on it within 10⁻⁹.
    ///
    /// # Method
    /// Pseudo-arclength continuation: a step along the tangent, and back to the curve by Newton's method at right angles
    /// to it, shorter where it bends. Where there is a closed form no curve is missed: the plane is cut into boxes until the
    /// Bernstein coefficients exclude that one has a closed curve within itself, and the curves through their edges are
    /// followed. Elsewhere a curve that passes between the points of a grid of 49 × 49 is missed.
    ///
    /// # Errors
    /// Eigenvalues that leave the numbers; a model that has no equilibrium somewhere.
    pub fn hopf_curves(&self) -> Result<Vec<HopfCurve>> {
        let branches = match ClosedForm::of(self) {
            Some(closed) => branches(&closed, DRAWN),
            None => branches(&Eigenvalues::of(self)?, DRAWN),
        };
        branches.into_iter().map(|branch| self.curve(branch)).collect()
    }

    /// As [`Plane::hopf_curves`], by eigenvalues alone where there is a closed form, too.
    ///
    /// # Errors
    /// As there.
    pub fn hopf_curves_by_eigenvalues(&self) -> Result<Vec<HopfCurve>> {
        let branches = branches(&Eigenvalues::of(self)?, DRAWN);
        branches.into_iter().map(|branch| self.curve(branch)).collect()
    }

    fn curve(&self, branch: Branch) -> Result<HopfCurve> {
        if branch.frequency.iter().any(|frequency| !frequency.is_finite()) {
            return Err(Error::beyond_numbers("the frequency"));
        }
        Ok(HopfCurve {
            x: branch.spots.iter().map(|spot| self.x.value(spot.at[0])).collect(),
            y: branch.spots.iter().map(|spot| self.y.value(spot.at[1])).collect(),
            frequency: branch.frequency,
            kind: branch.kind,
            closed: branch.closed,
            bounds: branch.bounds,
        })
    }
}

/// What crosses the axis at a point, seen from a test function.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Crossing {
    /// \[Hz\]
    frequency: f64,
    /// All others are to the left of the axis.
    bounds: bool,
}

/// Where eigenvalues cross the imaginary axis over the unit square.
trait Boundary {
    /// A function that is zero there, and positive on the stable side where the other eigenvalues are; and its slopes.
    fn test(&self, kind: CurveKind, at: Point) -> (f64, Point);
    /// Lines, or points where both ends are one, through which its zeros pass: at least one for every branch.
    fn seeds(&self, kind: CurveKind) -> Vec<[Point; 2]>;
    /// What crosses at a zero; nothing where it is zero for another reason: two real eigenvalues of one size.
    fn crossing(&self, kind: CurveKind, at: Point) -> Option<Crossing>;
    /// All eigenvalues are to the left of the axis.
    fn stable(&self, at: Point) -> bool;
    /// How much of the row at a height is stable, where that is known without curves.
    fn stable_part(&self, _y: f64) -> Option<f64> {
        None
    }
}
