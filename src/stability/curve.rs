//! The boundary of stability in a plane of two parameters, as curves.

mod closed;
mod eigen;
mod geometry;
mod pieces;
mod share;
mod trace;

use super::Plane;
use crate::{
    error::{Code, Error, Result, shown},
    run::{Fields, Value},
};
use closed::ClosedForm;
use eigen::Eigenvalues;
use pieces::{Branch, branches};

/// A point of the unit square that stands for the plane's rectangle.
type Point = [f64; 2];

/// What crosses the imaginary axis at a place, or along a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveKind {
    /// A pair of eigenvalues: a small swing neither grows nor fades.
    Hopf,
    /// A real eigenvalue: a small deviation neither grows nor fades.
    Divergence,
}

impl CurveKind {
    pub(super) const BOTH: [Self; 2] = [Self::Hopf, Self::Divergence];

    /// Public name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Hopf => "hopf",
            Self::Divergence => "divergence",
        }
    }
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

/// How far a curve may be from the straight lines between its points, unless asked for otherwise.
const ACCURACY: f64 = 1e-6;

/// Curves to be followed.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveSpec {
    /// The two parameters and what stays.
    pub plane: Plane,
    /// How far a curve may be from the straight lines between its points, in parts of the plane's width and height.
    pub accuracy: f64,
}

impl CurveSpec {
    /// Those of a plane, to 10⁻⁶.
    pub fn of(plane: Plane) -> Self {
        Self { plane, accuracy: ACCURACY }
    }

    /// Reads a record `{model, parameters, x: {parameter, from, to}, y, linked, accuracy}`; a `count` of the axes may be
    /// there.
    ///
    /// # Errors
    /// Anything but known keys with valid values; the error names the field.
    pub fn read(input: &Value) -> Result<Self> {
        let fields = Fields::of("plane", input, &[Plane::KEYS.as_slice(), &["accuracy"]].concat())?;
        let mut curves = Self::of(Plane::read_with(&fields, &["count"])?.0);
        let allowed = "from 1e-7 to 0.01 of the plane";
        if let Some(accuracy) = fields.number("accuracy", allowed)? {
            if !(1e-7..=0.01).contains(&accuracy) {
                return Err(Error::new(Code::OutOfRange, "accuracy", shown(accuracy), allowed));
            }
            curves.accuracy = accuracy;
        }
        Ok(curves)
    }

    /// The curves.
    ///
    /// # Errors
    /// As [`Plane::hopf_curves`].
    pub fn made(&self) -> Result<Vec<HopfCurve>> {
        match ClosedForm::of(&self.plane) {
            Some(closed) => self.along(&closed),
            None => self.along(&Eigenvalues::of(&self.plane)?),
        }
    }

    fn along(&self, boundary: &dyn Boundary) -> Result<Vec<HopfCurve>> {
        self.plane.resolved()?;
        let pieces = branches(boundary, self.accuracy);
        pieces.into_iter().map(|piece| self.plane.curve(boundary, piece)).collect()
    }
}

impl Plane {
    /// All curves in the plane; one that runs along its edge bounds nothing in it, and is none of them. Neighbouring points
    /// are so near that a straight line between them is within 10⁻⁶ of the plane's width or height from the curve; they
    /// themselves are on it within 10⁻⁹.
    ///
    /// # Method
    /// Pseudo-arclength continuation: a step along the tangent, and back to the curve by Newton's method at right angles
    /// to it, shorter where it bends. Where there is a closed form no curve is missed: the plane is cut into boxes until the
    /// Bernstein coefficients exclude that one has a closed curve within itself, and the curves through their edges are
    /// followed. Elsewhere a curve that passes between the points of a grid of 49 × 49 is missed.
    ///
    /// # Errors
    /// Axes so wide, or parameters so extreme, that rounding hides the boundary; eigenvalues that leave the numbers; a model
    /// that has no equilibrium somewhere.
    pub fn hopf_curves(&self) -> Result<Vec<HopfCurve>> {
        CurveSpec::of(self.clone()).made()
    }

    /// As [`Plane::hopf_curves`], by eigenvalues alone where there is a closed form, too.
    ///
    /// # Errors
    /// As there.
    pub fn hopf_curves_by_eigenvalues(&self) -> Result<Vec<HopfCurve>> {
        CurveSpec::of(self.clone()).along(&Eigenvalues::of(self)?)
    }

    fn curve(&self, boundary: &dyn Boundary, branch: Branch) -> Result<HopfCurve> {
        if branch.frequency.iter().any(|frequency| !frequency.is_finite()) {
            return Err(Error::beyond_numbers("the frequency"));
        }
        if !branch.spots.iter().all(|spot| boundary.holds(branch.kind, spot.at)) {
            let got = "values with which rounding hides the boundary";
            return Err(Error::new(Code::Unsuited, "parameters", got, "less extreme, or the plane smaller"));
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
    /// Whether something crosses at a point of a curve indeed, as far as rounding lets one see.
    fn holds(&self, kind: CurveKind, at: Point) -> bool;
    /// All eigenvalues are to the left of the axis.
    fn stable(&self, at: Point) -> bool;
    /// How much of the row at a height is stable, where that is known without curves.
    fn stable_part(&self, _y: f64) -> Option<f64> {
        None
    }
}
