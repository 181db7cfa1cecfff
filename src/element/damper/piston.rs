//! A piston that is moved by hand.

use super::{Coefficients, DamperSpec};
use crate::{
    error::{Code, Error, Result, shown},
    parameter::{Validity, check_number},
};

/// Substeps of a move at most: a second of a hand takes some ten thousand.
const MOST_SUBSTEPS: f64 = 1e6;
/// Of the displacement over which the element yields, and of the time in which w follows, a substep is this part.
const PART: f64 = 0.25;

/// A damper whose piston goes from one displacement to another, as a hand leads it.
///
/// # Method
/// Each move is a straight line in time: x goes on at a steady velocity. It is cut so that neither the hysteresis element
/// yields nor w follows within a substep by more than a quarter, and taken by the midpoint rule; z by its closed form where
/// there is one (n = 1, 2), which no length of substep can spoil. It is for hands, whose error is larger: a sine in a
/// thousand moves is followed to some 0.1 % of the greatest force.
#[derive(Clone, Debug)]
pub struct Piston {
    spec: DamperSpec,
    at: Coefficients,
    x: f64,
    z: f64,
    w: f64,
}

/// Where a piston is, and what the damper does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grip {
    /// x \[m\].
    pub displacement: f64,
    /// ẋ of the last move \[m/s\].
    pub velocity: f64,
    /// F \[N\], positive against a positive velocity.
    pub force: f64,
    /// z.
    pub hysteresis: f64,
    /// w \[m\]; 0 where there is none.
    pub internal_displacement: f64,
}

impl Piston {
    /// At x = 0 with z = 0, w = 0 and the command settled.
    pub fn new(spec: DamperSpec) -> Self {
        let at = spec.damper().coefficients(spec.command);
        Self { spec, at, x: 0.0, z: 0.0, w: 0.0 }
    }

    /// Another command, which acts at once: the piston stays where it is.
    ///
    /// # Errors
    /// A command that the model does not take.
    pub fn set_command(&mut self, command: f64) -> Result<()> {
        self.spec.command = self.spec.description.check_command(command)?;
        self.at = self.spec.damper().coefficients(command);
        Ok(())
    }

    /// Leads the piston to `displacement` \[m\] within `interval` \[s\].
    ///
    /// # Errors
    /// Numbers that are not finite, an interval that is not > 0, and a move so far that it would take too long.
    pub fn lead(&mut self, displacement: f64, interval: f64) -> Result<Grip> {
        check_number("displacement", displacement, Validity::Finite, "m")?;
        check_number("interval", interval, Validity::Positive, "s")?;
        let damper = *self.spec.damper();
        let (from, velocity) = (self.x, (displacement - self.x) / interval);
        let yielding = (displacement - from).abs() * damper.hysteresis().stiffness();
        let following = if damper.in_series() { interval * self.quickness() } else { 0.0 };
        let substeps = ((yielding.max(following)) / PART).ceil().max(1.0);
        if substeps.is_nan() || substeps > MOST_SUBSTEPS {
            return Err(Error::new(Code::StepLimit, "displacement", shown(displacement), "a shorter move"));
        }
        let h = interval / substeps;
        for i in 0..substeps as u64 {
            let start = from + velocity * h * i as f64;
            let response = damper.response(&self.at, start, velocity, self.z, self.w);
            let half = self.hysteresis(self.z, response.slip, 0.5 * h);
            let middle = damper.response(
                &self.at,
                start + 0.5 * velocity * h,
                velocity,
                half,
                self.w + 0.5 * response.internal * h,
            );
            self.z = if damper.hysteresis().is_closed() {
                self.hysteresis(self.z, middle.slip, h)
            } else {
                self.z + damper.hysteresis().rate(half, middle.slip) * h
            };
            self.w += middle.internal * h;
        }
        self.x = displacement;
        let force = damper.response(&self.at, displacement, velocity, self.z, self.w).force;
        if !force.is_finite() {
            return Err(Error::beyond_numbers("the damper's state"));
        }
        Ok(Grip { displacement, velocity, force, hysteresis: self.z, internal_displacement: self.w })
    }

    /// z after a while at a steady slip.
    fn hysteresis(&self, z: f64, slip: f64, h: f64) -> f64 {
        let element = self.spec.damper().hysteresis();
        if element.is_closed() { element.moved(z, slip * h) } else { z + element.rate(z, slip) * h }
    }

    /// How fast w can follow \[1/s\]: against k₀ and the element before it yields.
    fn quickness(&self) -> f64 {
        let element = self.spec.damper().hysteresis();
        let unyielded = self.at.hysteresis_gain * element.rate(0.0, 1.0);
        (self.at.stiffness + unyielded) / (self.at.viscous + self.at.series)
    }
}
