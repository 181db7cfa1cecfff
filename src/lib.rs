//! The shimmy of aircraft landing gears: a wheel that rolls and starts to shake by itself.

#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub mod element;
pub mod error;
pub mod integrate;
pub mod live;
pub mod model;
pub mod outlook;
pub mod parameter;
pub mod real;
pub mod run;

pub use error::{Code, Error, Result};
pub use run::Run;

#[cfg(target_arch = "wasm32")]
pub mod wasm;

/// The example of the README, run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
