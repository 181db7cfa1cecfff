//! Many motions at once, each followed until it settles: basins and sweeps.
//!
//! A *motion* is a start with a gear of its own. Four of them move side by side in [`Lanes`], by the classical method with
//! a step of a hundredth of the gear's swing ([`Bundle`]); one that has settled makes room for the next. The right-hand side
//! is the model's own ([`Laned`](crate::model::Laned)): where a law is piecewise in its argument it is a smooth one of the
//! argument clamped, so that lanes need not agree on a mode. A step may straddle a kink, which the adaptive methods locate;
//! that costs amplitudes some 10⁻⁵ of themselves. Where a model has no such form, or a tire's laws are no short
//! polynomials, each motion is followed by itself, as [`crate::outlook`] does.
//!
//! [`Basins`] asks in which motion each cell of a plane ends, [`Sweep`] carries one motion on as a parameter goes there and
//! back.

mod basins;
mod bundle;
mod endings;
mod field;
mod follow;
mod judge;
mod lanes;
mod refine;
mod sweep;

pub use self::{
    basins::{Basins, BasinsSpec},
    bundle::{Bundle, step},
    endings::Ending,
    field::{Axis, Field},
    follow::Fate,
    lanes::{LANES, Lanes},
    sweep::{Sweep, SweepSpec, Way},
};

/// What the numbers of a cell's `kind` mean, in their order.
pub const KINDS: [&str; 5] = ["rest", "rattle", "shimmy", "divergence", "unsettled"];

/// A cell that is not made yet.
pub const UNKNOWN: u8 = 255;
