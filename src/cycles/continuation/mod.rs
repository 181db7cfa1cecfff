//! Bifurcation diagrams: rest and cycles of a gear over the range of a parameter, with the places where they change.
//!
//! Rest is looked at value by value, and every crossing of eigenvalues is found ([`crate::stability::Crossing`]). From each
//! Hopf point the branch of cycles that is born there is followed by pseudo-arclength: shooting in the start, the period and
//! the parameter at once, stable or not, through folds, to where the branch ends ([`BranchEnd`]). Cycles that no such branch
//! has are looked for by simulation, and followed both ways. A special point is a change of sign of a test between two cycles,
//! located there. Two parameters have curves of folds ([`FoldCurve`]).

mod bordered;
mod diagram;
mod family;
mod field;
mod fold;
mod folds;
mod hopf;
mod line;
mod newton;
mod rest;
mod spec;
mod special;
mod stop;
mod walk;

#[cfg(test)]
mod slices;
#[cfg(test)]
mod tests;

pub use self::{
    diagram::{Bifurcation, CycleBranch, SpecialPoint},
    folds::{FoldCurve, FoldCurves, FoldSpec},
    hopf::{Criticality, Told},
    rest::RestBranch,
    spec::BifurcationSpec,
    special::PointKind,
    stop::CyclePoint,
    walk::BranchEnd,
};
use super::vector::{dot, norm, sum};

/// Whether a point lies on the straight way between two others, or nearly so.
fn passes(from: &[f64], to: &[f64], point: &[f64], near: f64) -> bool {
    let (step, home) = (sum(to, -1.0, from), sum(point, -1.0, from));
    let along = dot(&step, &home) / dot(&step, &step);
    let aside = sum(&home, -along, &step);
    (0.0..=1.0).contains(&along) && norm(&aside) < near
}
