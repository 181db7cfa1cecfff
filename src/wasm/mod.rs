//! The JavaScript API: the only place that knows of JavaScript.
//!
//! Every exported function reads its input into a [`Value`], hands it to the crate, and writes the result as plain
//! objects and `Float64Array`s. Nothing here can panic on input, and methods take `&self`: a panic would leave a
//! `&mut self` borrowed for ever.

mod cycles;
pub(crate) mod digits;
mod ensemble;
mod input;
mod job;
mod linear;
mod output;
mod plane;
mod record;
mod simulator;
