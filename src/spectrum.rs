//! The amplitude spectrum of a series.

mod fourier;

use std::f64::consts::PI;

use self::fourier::{Complex, transform};
use crate::{
    error::{Code, Error, Result, shown},
    parameter::{Validity, check_number},
    run::{Fields, Value},
};

/// Fewest and most values of a series.
const LENGTH: std::ops::RangeInclusive<usize> = 2..=65_536;
/// An amplitude can be several times the largest value, and must be a number too.
const LARGEST: f64 = 1e300;
/// A peak below this part of the largest value is rounding.
const NOTHING: f64 = 1e-12;

/// A series of equally spaced values.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    values: Vec<f64>,
    interval: f64,
}

/// What a series is made of: a sinusoid of amplitude A in it shows as A.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum {
    /// Frequencies from 0 to half of the sampling rate, 1/(n · interval) apart \[Hz\].
    pub frequency: Vec<f64>,
    /// Their amplitudes, in the unit of the values.
    pub amplitude: Vec<f64>,
    /// The strongest sinusoid, between the frequencies above; none in a series that does not swing.
    pub peak: Option<Peak>,
}

/// A sinusoid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// Its frequency \[Hz\].
    pub frequency: f64,
    /// Its amplitude, in the unit of the values.
    pub amplitude: f64,
}

impl Series {
    /// Values `interval` s apart.
    ///
    /// # Errors
    /// Less than 2 or more than 65 536 values, values that are not finite, an interval that is not > 0.
    pub fn new(values: Vec<f64>, interval: f64) -> Result<Self> {
        let refused = |code, value: String, allowed: &str| Err(Error::new(code, "values", value, allowed));
        let count = format!("{} values", values.len());
        if values.len() < *LENGTH.start() {
            return refused(Code::OutOfRange, count, "at least 2 numbers");
        }
        if values.len() > *LENGTH.end() {
            return refused(Code::TooLarge, count, "at most 65536 numbers");
        }
        if let Some((index, value)) = values.iter().enumerate().find(|(_, value)| !value.is_finite()) {
            return refused(Code::NotFinite, format!("{} at index {index}", shown(*value)), "finite numbers");
        }
        if let Some(value) = values.iter().find(|value| value.abs() > LARGEST) {
            return refused(Code::OutOfRange, shown(*value), "at most 1e300 in magnitude");
        }
        check_number("interval", interval, Validity::Positive, "s")?;
        if !(1.0 / interval).is_finite() {
            return Err(Error::new(Code::OutOfRange, "interval", shown(interval), "at least 1e-300 s"));
        }
        Ok(Self { values, interval })
    }

    /// Reads a record `{values, interval}`.
    ///
    /// # Errors
    /// As [`Series::new`]; anything but such a record.
    pub fn read(input: &Value) -> Result<Self> {
        let fields = Fields::of("series", input, &["values", "interval"])?;
        let values = fields.numbers("values")?.ok_or_else(|| Error::missing("values", "a list of numbers"))?;
        let interval = fields.number("interval", "> 0 s")?.ok_or_else(|| Error::missing("interval", "> 0 s"))?;
        Self::new(values, interval)
    }

    /// Its spectrum.
    ///
    /// The series is weighed with Hann's window 1 − cos(2πi/n) and freed of its weighed mean, so that what does not repeat
    /// within its length spreads over few frequencies. The peak's place follows from the two largest neighbours, whose ratio
    /// the window fixes: exact for one sinusoid alone, up to what reaches over from its mirror at −f, 10⁻³ of a spacing
    /// from ten cycles on.
    ///
    /// # References
    /// F. J. Harris, *Proc. IEEE* 66 (1978) 51–83 (the window); T. Grandke, *IEEE Trans. Instrum. Meas.* 32 (1983)
    /// 350–355 (the interpolation).
    pub fn spectrum(&self) -> Spectrum {
        let n = self.values.len();
        let largest = self.values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        // In units of the largest value: squares and sums stay within the numbers.
        let unit = if largest > 0.0 { largest } else { 1.0 };
        let window: Vec<f64> = (0..n).map(|i| 1.0 - (2.0 * PI * i as f64 / n as f64).cos()).collect();
        let weight: f64 = window.iter().sum();
        let mean = self.values.iter().zip(&window).map(|(value, w)| value / unit * w).sum::<f64>() / weight;
        let mut weighed: Vec<Complex> =
            self.values.iter().zip(&window).map(|(value, w)| [(value / unit - mean) * w, 0.0]).collect();
        transform(&mut weighed);
        let size = |k: usize| {
            // Each frequency but the first and the last shares its sinusoid with its mirror.
            let alone = k == 0 || 2 * k == n;
            weighed[k][0].hypot(weighed[k][1]) * if alone { 1.0 } else { 2.0 } / weight
        };
        let sizes: Vec<f64> = (0..=n / 2).map(size).collect();
        let spacing = 1.0 / (n as f64 * self.interval);
        Spectrum {
            frequency: (0..=n / 2).map(|k| k as f64 * spacing).collect(),
            amplitude: sizes.iter().map(|size| size * largest).collect(),
            peak: strongest(&sizes).map(|(place, size)| Peak { frequency: place * spacing, amplitude: size * largest }),
        }
    }
}

/// Place and size of the strongest sinusoid in a single-sided spectrum under Hann's window.
fn strongest(sizes: &[f64]) -> Option<(f64, f64)> {
    let inside = 1..sizes.len().saturating_sub(1);
    let k = inside.max_by(|a, b| sizes[*a].total_cmp(&sizes[*b]))?;
    if sizes[k] < NOTHING {
        return None;
    }
    // A sinusoid δ beside a frequency shows there as sin(πδ)/(πδ(1 − δ²)), and the ratio of the neighbour on its side is
    // (1 + δ)/(2 − δ).
    let (side, neighbour) = if sizes[k + 1] > sizes[k - 1] { (1.0, sizes[k + 1]) } else { (-1.0, sizes[k - 1]) };
    let ratio = neighbour / sizes[k];
    let delta = ((2.0 * ratio - 1.0) / (ratio + 1.0)).clamp(0.0, 0.5);
    let shown = if delta < 1e-6 { 1.0 } else { (PI * delta).sin() / (PI * delta * (1.0 - delta * delta)) };
    Some((k as f64 + side * delta, sizes[k] / shown))
}
