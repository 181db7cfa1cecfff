//! Integration: methods, dense output, switches, trajectories.
//!
//! Model, method and result are three things. A *scheme* is a table of coefficients with its dense output; the
//! [`Integrator`] is the one driver that takes steps with any of them, controls the error, finds where a piecewise law
//! changes and restarts there; a [`Trajectory`] is what comes out. Nothing here allocates within a step.
//!
//! To add a method: write its file beside `dormand_prince.rs`, add it to [`Scheme`] and its line to the list in
//! `method.rs`, and follow the compiler through the driver, which matches on the scheme wherever it must know it; `order`
//! and `controller` at its end say how steps follow its error.

mod controller;
mod dense;
mod dop853;
pub(crate) mod dormand_prince;
mod driver;
mod linear;
mod locate;
mod method;
mod rodas;
mod runge_kutta4;
mod stages;
mod trajectory;

pub use driver::{Failure, Integrator, Outcome, Stats, Tolerance};
pub(crate) use locate::bracketed;
pub use method::{Method, MethodDescription, Scheme, methods};
pub use trajectory::{Events, Output, Trajectory, solve};
pub(crate) use trajectory::{Solving, failed};
