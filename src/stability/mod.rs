//! Linear theory: does a small swing grow or fade?
//!
//! Every model has it by numbers: its Jacobian at rest ([`Linearisation`]), from that eigenvalues and what they swing like
//! ([`Eigenmode`]), the characteristic polynomial and Routh's array ([`RouthArray`]), and where eigenvalues cross the
//! imaginary axis as a parameter varies ([`Crossing`]). The torsional gears have it in closed form, too
//! ([`TorsionalTheory`]), with every parameter a polynomial in the one that varies: one text of the conditions says whether
//! a gear is stable, and where that changes.
//!
//! Over a [`Plane`] of two parameters a map ([`MapSpec`]) says of each cell what becomes of a small swing there, and curves
//! ([`HopfCurve`]) where that changes; both in closed form, where every condition is a polynomial in both parameters
//! ([`Surface`]), and by eigenvalues for any other model.

mod bounded;
mod characteristic;
mod crossings;
mod curve;
mod eigenmodes;
mod eigenvalues;
mod elimination;
mod linearisation;
mod links;
mod map;
mod plane;
mod polynomial;
pub(crate) mod range;
mod routh;
mod torsional;
mod variation;

pub(crate) use self::{
    bounded::Bounded,
    characteristic::characteristic_bounded,
    crossings::crossings,
    elimination::Triangle,
    linearisation::{at_rest, linearised},
    map::whole,
};
pub use self::{
    characteristic::characteristic_polynomial,
    crossings::Crossing,
    curve::{CurveKind, CurveSpec, HopfCurve},
    eigenmodes::{Eigenmode, EnergyFlow},
    eigenvalues::eigenvalues,
    linearisation::Linearisation,
    links::Links,
    map::{Cells, KINDS, MOST_CELLS, MapSpec, Quantities, StabilityMap, Tile},
    plane::{Axis, Plane},
    polynomial::{Polynomial, Ring, Surface},
    routh::{RouthArray, Special},
    torsional::TorsionalTheory,
    variation::Variation,
};

/// The verdict of Routh and Hurwitz at rest.
#[derive(Clone, Debug, PartialEq)]
pub struct RouthHurwitz {
    /// Every entry of the column is positive by more than rounding, as Routh's array judges: all small motions fade.
    pub stable: bool,
    /// First column of the Routh array; of the torsional gears 1, a₂, a₁ − a₀/a₂, a₀.
    pub column: Vec<f64>,
    /// Every velocity at which eigenvalues cross the imaginary axis, ascending \[m/s\]: of the torsional gears every one > 0,
    /// of others those from 0.1 to 2000; none where a model has no velocity.
    pub critical_velocities: Vec<f64>,
    /// The largest damping constant > 0 at which a pair crosses \[N m s/rad\]; none where no pair does.
    pub critical_damping: Option<f64>,
}

/// A part of a parameter's range in which a small swing does not fade.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnstableInterval {
    /// Its lower end, in the parameter's unit.
    pub from: f64,
    /// Its upper end.
    pub to: f64,
    /// What ends it below.
    pub from_kind: EndKind,
    /// What ends it above.
    pub to_kind: EndKind,
}

/// What is at the end of an [`UnstableInterval`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EndKind {
    /// A pair of eigenvalues crosses the imaginary axis.
    Hopf,
    /// A real eigenvalue crosses zero.
    Divergence,
    /// The end of the range asked for.
    Range,
}

impl EndKind {
    /// Public name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Hopf => "hopf",
            Self::Divergence => "divergence",
            Self::Range => "range",
        }
    }
}
