//! Force laws that models share.
//!
//! Each law is smooth piece by piece. A [`Side`] says which piece holds, and stays what it is within a step even where
//! the state has already left the piece: the law is *continued* there, so that a step never straddles a kink, and the
//! integrator finds the crossing on a smooth curve.

pub mod control;
pub mod damper;
pub mod freeplay;
pub mod friction;
pub mod kink;
pub mod odd_polynomial;
pub mod tire_law;

pub use kink::{Boundary, Side};
