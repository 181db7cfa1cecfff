//! How a piston is moved: motions that are known for all times.

use std::f64::consts::PI;

use crate::{
    error::{Code, Error, Result},
    parameter::{Validity, check_number},
    run::{Fields, Value},
};

/// A motion of the piston about its middle, from x = 0 upwards.
///
/// # Equations
/// x(t) = a(t) p(φ(t)), where amplitude a and frequency φ̇/2π go in straight lines from their first to their last values
/// over the motion's duration T: φ = 2π(f₀ + (f₁ − f₀) t/2T) t. p is the sine, or the triangle that has its zeros and
/// peaks at the same phases.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Excitation {
    amplitude: [f64; 2],
    frequency: [f64; 2],
    shape: Shape,
    duration: f64,
}

/// The form of a stroke.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A sine.
    Sine,
    /// Straight lines up and down.
    Triangle,
}

const KEYS: [&str; 5] = ["amplitude", "frequency", "endAmplitude", "endFrequency", "shape"];
const SHAPES: [&str; 2] = ["sine", "triangle"];

impl Excitation {
    /// A sine of `amplitude` \[m\] and `frequency` \[Hz\] for so many `cycles`.
    ///
    /// # Errors
    /// Numbers that are not > 0.
    pub fn sine(amplitude: f64, frequency: f64, cycles: f64) -> Result<Self> {
        let both = |value| [value, value];
        Self::new(Shape::Sine, both(amplitude), both(frequency), cycles)
    }

    /// A motion from the first to the last amplitude \[m\] and frequency \[Hz\], for so many `cycles`.
    ///
    /// # Errors
    /// Numbers that are not > 0.
    pub fn new(shape: Shape, amplitude: [f64; 2], frequency: [f64; 2], cycles: f64) -> Result<Self> {
        for (name, value) in ["amplitude", "endAmplitude"].into_iter().zip(amplitude) {
            check_number(name, value, Validity::Positive, "m")?;
        }
        for (name, value) in ["frequency", "endFrequency"].into_iter().zip(frequency) {
            check_number(name, value, Validity::Positive, "Hz")?;
        }
        check_number("cycles", cycles, Validity::Positive, "1")?;
        Ok(Self { amplitude, frequency, shape, duration: 2.0 * cycles / (frequency[0] + frequency[1]) })
    }

    /// Reads a record `{amplitude, frequency, endAmplitude, endFrequency, shape}`: 0.01 m and 2 Hz, the same at the end, a
    /// sine.
    ///
    /// # Errors
    /// Anything but known keys with valid values; the error names the field.
    pub fn read(input: Option<&Value>, cycles: f64) -> Result<Self> {
        let nothing = Value::Record(Vec::new());
        let fields = Fields::of("excitation", input.unwrap_or(&nothing), &KEYS)?;
        let read = || {
            let number = |key, unit| fields.number(key, unit);
            let amplitude = number("amplitude", "> 0 m")?.unwrap_or(0.01);
            let frequency = number("frequency", "> 0 Hz")?.unwrap_or(2.0);
            let last = [
                number("endAmplitude", "> 0 m")?.unwrap_or(amplitude),
                number("endFrequency", "> 0 Hz")?.unwrap_or(frequency),
            ];
            let shape = match fields.text("shape")? {
                None | Some("sine") => Shape::Sine,
                Some("triangle") => Shape::Triangle,
                Some(other) => return Err(Error::unknown(Code::UnknownName, "shape", other, &SHAPES)),
            };
            Self::new(shape, [amplitude, last[0]], [frequency, last[1]], cycles)
        };
        read().map_err(|error: Error| if error.field == "cycles" { error } else { error.within("excitation") })
    }

    /// How long it lasts \[s\].
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// Within so long a time \[s\] it is nowhere more than a part of a stroke.
    pub(super) fn part_of_a_stroke(&self) -> f64 {
        0.1 / self.frequency[0].max(self.frequency[1])
    }

    /// The length that it is measured by \[m\].
    pub(super) fn reach(&self) -> f64 {
        self.amplitude[0].max(self.amplitude[1])
    }

    /// Displacement \[m\] and velocity \[m/s\].
    pub fn at(&self, t: f64) -> (f64, f64) {
        let [a0, a1] = self.amplitude;
        let [f0, f1] = self.frequency;
        let growth = (a1 - a0) / self.duration;
        let amplitude = a0 + growth * t;
        let turns = (f0 + 0.5 * (f1 - f0) * t / self.duration) * t;
        let turning = f0 + (f1 - f0) * t / self.duration;
        let (p, slope) = match self.shape {
            Shape::Sine => {
                // Of whole turns nothing is left to round.
                let (sin, cos) = (2.0 * PI * (turns - turns.floor())).sin_cos();
                (sin, 2.0 * PI * cos)
            }
            Shape::Triangle => {
                let part = turns + 0.25 - (turns + 0.25).floor();
                if part < 0.5 { (4.0 * part - 1.0, 4.0) } else { (3.0 - 4.0 * part, -4.0) }
            }
        };
        (amplitude * p, growth * p + amplitude * turning * slope)
    }

    /// The next time after `t` at which a triangle turns, where its velocity jumps.
    pub(super) fn next_corner(&self, t: f64) -> f64 {
        if self.shape == Shape::Sine {
            return f64::INFINITY;
        }
        let [f0, f1] = self.frequency;
        let bend = 0.5 * (f1 - f0) / self.duration;
        // Corners at ¼, ¾ … turns; one that lies at t but for rounding is over.
        let passed = ((f0 + bend * t) * t + 0.25) * 2.0;
        let turns = 0.5 * (passed + 1e-9).floor() + 0.25;
        2.0 * turns / (f0 + (f0 * f0 + 4.0 * bend * turns).max(0.0).sqrt())
    }
}
