//! What a damper does as its piston is moved: loops to draw.

use super::{DamperSpec, Excitation, follow::Follower};
use crate::{
    error::{Error, Result},
    run::{Fields, MOST_SAMPLES, Value},
    stability::whole,
};

/// Most cycles of a motion.
const MOST_CYCLES: f64 = 10_000.0;

/// A damper and the motion of its piston.
#[derive(Clone, Debug)]
pub struct ResponseSpec {
    /// The damper.
    pub damper: DamperSpec,
    /// How it is moved, and how long.
    pub excitation: Excitation,
    /// How many rows, equally spaced, the end excluded.
    pub samples: usize,
}

/// A damper's motion and force: one entry a row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DamperResponse {
    /// \[s\]
    pub time: Vec<f64>,
    /// x \[m\]
    pub displacement: Vec<f64>,
    /// ẋ \[m/s\]
    pub velocity: Vec<f64>,
    /// F \[N\]
    pub force: Vec<f64>,
    /// z
    pub hysteresis: Vec<f64>,
    /// w \[m\], 0 of a damper without.
    pub internal_displacement: Vec<f64>,
}

impl ResponseSpec {
    /// Reads a record `{damper, excitation, cycles, samples}`.
    ///
    /// # Errors
    /// Anything but known keys with valid values; the error names the field.
    pub fn read(input: &Value) -> Result<Self> {
        Self::of(&Fields::of("spec", input, &["damper", "excitation", "cycles", "samples"])?)
    }

    /// The same of fields that may hold others, too.
    pub(crate) fn of(fields: &Fields) -> Result<Self> {
        let damper = DamperSpec::read(fields.value("damper"))?;
        let allowed = "> 0 and at most 10000";
        let cycles = fields.number("cycles", allowed)?.unwrap_or(4.0);
        if !(cycles > 0.0 && cycles <= MOST_CYCLES) {
            return Err(Error::new(crate::Code::OutOfRange, "cycles", crate::error::shown(cycles), allowed));
        }
        let excitation = Excitation::read(fields.value("excitation"), cycles)?;
        let samples = whole(fields, "samples", [2, MOST_SAMPLES / 10])?.unwrap_or(1000);
        Ok(Self { damper, excitation, samples })
    }

    /// From t = 0 on, where z = 0, w = 0 and the command has arrived.
    ///
    /// # Errors
    /// A motion that would take too many steps; values so extreme that the force leaves the numbers.
    pub fn response(&self) -> Result<DamperResponse> {
        let mut follower = Follower::new(self.damper.damper(), self.damper.command, &self.excitation);
        let mut rows = DamperResponse::default();
        for sample in 0..self.samples {
            let time = self.excitation.duration() * sample as f64 / self.samples as f64;
            follower.advance(time)?;
            let row = follower.row();
            Error::unless_finite("force", &row)?;
            let [displacement, velocity, force, hysteresis, internal] = row;
            rows.time.push(time);
            rows.displacement.push(displacement);
            rows.velocity.push(velocity);
            rows.force.push(force);
            rows.hysteresis.push(hysteresis);
            rows.internal_displacement.push(internal);
        }
        Ok(rows)
    }
}
