//! The shimmy of aircraft landing gears: a wheel that rolls and starts to shake by itself.
//!
//! A nose wheel that trails its steering axis is steered by its own tire. Above a certain speed the tire feeds more energy
//! into a small swing than the damper takes out, and the swing grows until the tire's force stops growing: *shimmy*, at
//! tens of hertz. This crate holds the equations, integrates them, and says what becomes of a motion. It compiles to
//! WebAssembly; the page around it is `www/`.
//!
//! # Axes and signs
//! ```text
//!              y left                 seen from above
//!              ↑    ψ ↺
//!    ┌─────────┼─────────┐            x forward, y left, z up
//!    │  wheel  │  ⊕──────┼──→ x       ⊕ steering axis
//!    └─────────┼─────────┘            ψ counter-clockwise
//!              │← e →│                e > 0: the contact centre trails the axis
//! ```
//! The leading contact point lies y to the left of the wheel plane; the slip angle is α = arctan(y/σ). All stiffness,
//! damping and restoring constants are positive; k is the torsional stiffness, c the damping constant.
//!
//! # Units
//! SI and radians throughout; frequencies in Hz.
//!
//! # Glossary
//! | word | meaning |
//! | --- | --- |
//! | caster length e | distance of the contact centre behind the steering axis (mechanical trail) |
//! | relaxation length σ | distance over which a tire's lateral deformation fades |
//! | side force F_y, aligning moment M_z | what the ground does to a tire that slips sideways |
//! | freeplay ψ_fp | half of the gap in which the torsion spring does not act |
//! | dry friction M_f | a moment against the turning; at rest as much as is needed to stay there, up to M_f: the wheel *sticks* |
//! | kink | where a piecewise law changes its piece; a *switch* finds it, a *mode* says which piece holds |
//! | limit cycle | a motion that repeats and that its neighbours run to (or from) |
//! | Hopf point | a parameter's value at which a small swing neither grows nor fades: a limit cycle is born there |
//! | hysteresis z | how far a damper's spring that yields is wound; at rest it may have any value, so there is a line of equilibria |
//! | fold | where a branch of limit cycles turns back: two meet there and vanish |
//!
//! # Map
//! | module | holds |
//! | --- | --- |
//! | [`model`] | the gears: physics only, one file each, with their tables |
//! | [`element`] | force laws that gears share: tire law, freeplay, dry friction, magnetorheological dampers |
//! | [`integrate`] | methods, dense output, switches, trajectories |
//! | [`run`] | a run, checked; reading it from untyped input |
//! | [`live`] | a motion that goes on, takes changes and finds back |
//! | [`stability`] | linear theory: eigenvalues and modes, Routh–Hurwitz, critical values, maps and boundaries |
//! | [`energy`] | where a swing's energy comes from and where it goes |
//! | [`cycles`] | limit cycles and their neighbours, and how they come and go with a parameter |
//! | [`outlook`] | what becomes of a motion: one word and its numbers |
//! | [`ensemble`] | many motions at once: basins and sweeps |
//! | [`identify`] | a damper's values from records of its force |
//! | [`scenario`] | what a gear goes through: the landing roll |
//! | [`section`] | where a motion passes a section: Poincaré's map |
//! | [`spectrum`] | the frequencies that a series is made of |
//! | [`atlas`] | the figures and tables of the work that this implements |
//! | [`parameter`], [`error`], [`real`], [`random`] | tables, refusals, numbers, chance |
//!
//! # Example
//! ```
//! use shimmy::{Run, outlook::Verdict};
//!
//! let gear = Run::of("torsional")?.with("velocity", 80.0)?.starting("torsionAngle", 0.05)?;
//! let outlook = gear.clone().with("dampingConstant", 20.0)?.outlook()?;
//! assert_eq!(outlook.verdict, Verdict::Shimmies);
//! assert!((outlook.amplitude[0] - 0.26508).abs() < 5e-6); // rad
//! assert!((outlook.frequency.unwrap() - 51.87).abs() < 5e-3); // Hz
//!
//! assert_eq!(gear.with("dampingConstant", 60.0)?.outlook()?.verdict, Verdict::DiesOut);
//! # Ok::<(), shimmy::Error>(())
//! ```

pub mod atlas;
pub mod cycles;
pub mod element;
pub mod energy;
pub mod ensemble;
pub mod error;
mod few;
pub mod identify;
pub mod integrate;
pub mod live;
pub mod model;
pub mod outlook;
pub mod parameter;
pub mod random;
pub mod real;
pub mod run;
pub mod scenario;
pub mod section;
pub mod spectrum;
pub mod stability;

pub use error::{Code, Error, Result};
pub use run::Run;

#[cfg(target_arch = "wasm32")]
pub mod wasm;

/// The example of the README, run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
