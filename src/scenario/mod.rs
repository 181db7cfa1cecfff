//! What a gear goes through: the landing roll.

mod landing_roll;

pub use landing_roll::{Landing, LandingRoll};
