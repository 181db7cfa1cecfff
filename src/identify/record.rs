//! Measured motions and forces of a damper.

use crate::{
    element::damper::{Description, ResponseSpec},
    error::{Code, Error, Result, shown},
    parameter::{Validity, check_number},
    random::Random,
    run::{Fields, Value},
    stability::whole,
};

/// Fewest samples of a record, as many as its differentiation needs.
const FEWEST: usize = 8;
/// Most samples of all records together.
pub(super) const MOST: usize = 1_000_000;
/// Seeds are whole numbers that a double can hold.
pub(super) const LARGEST_SEED: f64 = 9_007_199_254_740_992.0;

/// A record at equal intervals of time and a steady command.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// x \[m\]
    pub displacement: Vec<f64>,
    /// ẋ \[m/s\]
    pub velocity: Vec<f64>,
    /// F \[N\]
    pub force: Vec<f64>,
    /// A or V.
    pub command: f64,
    /// Between samples \[s\].
    pub interval: f64,
}

impl Record {
    /// Reads a record `{displacement, velocity, force, command, interval}`. Where there is no velocity it is
    /// [differentiated].
    ///
    /// # Errors
    /// Anything but known keys with valid values; series of unequal lengths, shorter than eight samples, not finite; a
    /// displacement or a force that never changes; a command that the damper does not take.
    pub fn read(input: &Value, damper: &Description) -> Result<Self> {
        let fields = Fields::of("record", input, &["displacement", "velocity", "force", "command", "interval"])?;
        let column = |name: &str, unit: &str| -> Result<Option<Vec<f64>>> {
            let Some(values) = fields.numbers(name)? else { return Ok(None) };
            for value in &values {
                check_number(name, *value, Validity::Finite, unit)?;
            }
            Ok(Some(values))
        };
        let needed =
            |name: &str, unit: &str| column(name, unit)?.ok_or_else(|| Error::missing(name, "a list of numbers"));
        let (displacement, force) = (needed("displacement", "m")?, needed("force", "N")?);
        let count = displacement.len();
        let of_length = |name: &str, length: usize| {
            let allowed = format!("{count} numbers, as displacement");
            (length == count)
                .then_some(())
                .ok_or_else(|| Error::new(Code::OutOfRange, name, format!("{length} numbers"), allowed))
        };
        if count < FEWEST {
            let allowed = format!("at least {FEWEST} numbers");
            return Err(Error::new(Code::OutOfRange, "displacement", format!("{count} numbers"), allowed));
        }
        of_length("force", force.len())?;
        for (name, values) in [("displacement", &displacement), ("force", &force)] {
            if values.iter().all(|value| *value == values[0]) {
                let got = format!("{} throughout", shown(values[0]));
                return Err(Error::new(Code::OutOfRange, name, got, "a motion: it never changes"));
            }
        }
        let allowed = "> 0 s";
        let interval = fields.number("interval", allowed)?.ok_or_else(|| Error::missing("interval", allowed))?;
        check_number("interval", interval, Validity::Positive, "s")?;
        let velocity = match column("velocity", "m/s")? {
            Some(velocity) => {
                of_length("velocity", velocity.len())?;
                velocity
            }
            None => differentiated(&displacement, interval),
        };
        let command = fields.number("command", "a finite number")?.unwrap_or(damper.command.default);
        let command = damper.check_command(command)?;
        Ok(Self { displacement, velocity, force, command, interval })
    }

    /// How many samples.
    pub fn len(&self) -> usize {
        self.force.len()
    }

    /// There are none. No record that was read is so.
    pub fn is_empty(&self) -> bool {
        self.force.is_empty()
    }
}

/// The rate of equally spaced values: the slope of the polynomial of third degree (or fourth: it is the same) that fits the
/// seven values around best, and at the three first and last ones that of the polynomial through five.
///
/// Exact for polynomials of fourth degree. White noise of deviation s becomes one of 0.49 s an interval, half of what
/// central differences of fourth order make of it (0.95).
///
/// # References
/// A. Savitzky, M. Golay, *Analytical Chemistry* 36 (1964) 1627–1639, with the corrections of J. Steinier et al., 44 (1972)
/// 1906–1909.
pub fn differentiated(values: &[f64], interval: f64) -> Vec<f64> {
    const ENDS: [[f64; 5]; 3] = [
        [-25.0 / 12.0, 4.0, -3.0, 4.0 / 3.0, -0.25],
        [-0.25, -5.0 / 6.0, 1.5, -0.5, 1.0 / 12.0],
        [1.0 / 12.0, -2.0 / 3.0, 0.0, 2.0 / 3.0, -1.0 / 12.0],
    ];
    let last = values.len() - 1;
    let slope = |i: usize| {
        let at = |offset: usize| if i <= 2 { values[offset] } else { values[last - offset] };
        if i >= 3 && i + 3 <= last {
            let pair = |k: usize| values[i + k] - values[i - k];
            return (58.0 * pair(1) + 67.0 * pair(2) - 22.0 * pair(3)) / 252.0;
        }
        let end = if i <= 2 { i } else { last - i };
        let sum: f64 = ENDS[end].iter().enumerate().map(|(k, weight)| weight * at(k)).sum();
        if i <= 2 { sum } else { -sum }
    };
    (0..values.len()).map(|i| slope(i) / interval).collect()
}

/// A record to be made: a damper on a moving piston, with noise in its force.
#[derive(Clone, Debug)]
pub struct RecordSpec {
    /// Damper, motion, samples.
    pub response: ResponseSpec,
    /// Deviation of the noise, in parts of the force's root mean square.
    pub noise: f64,
    /// Of the noise.
    pub seed: u64,
}

impl RecordSpec {
    /// Reads a record `{damper, excitation, cycles, samples, noise, seed}`.
    ///
    /// # Errors
    /// Anything but known keys with valid values; the error names the field.
    pub fn read(input: &Value) -> Result<Self> {
        let fields = Fields::of("spec", input, &["damper", "excitation", "cycles", "samples", "noise", "seed"])?;
        let allowed = "from 0 to 10";
        let noise = fields.number("noise", allowed)?.unwrap_or(0.0);
        if !(0.0..=10.0).contains(&noise) {
            return Err(Error::new(Code::OutOfRange, "noise", shown(noise), allowed));
        }
        let response = ResponseSpec::of(&fields)?;
        whole(&fields, "samples", [FEWEST, MOST])?;
        Ok(Self { response, noise, seed: seed(&fields)? })
    }

    /// The record.
    ///
    /// # Errors
    /// As [`ResponseSpec::response`].
    pub fn record(&self) -> Result<Record> {
        let rows = self.response.response()?;
        let deviation = self.noise * rms(&rows.force);
        let mut random = Random::seeded(self.seed);
        let force = rows.force.iter().map(|force| force + deviation * random.normal()).collect();
        Ok(Record {
            displacement: rows.displacement,
            velocity: rows.velocity,
            force,
            command: self.response.damper.command,
            interval: self.response.excitation.duration() / self.response.samples as f64,
        })
    }
}

/// The field `seed`: 1 where there is none.
pub(super) fn seed(fields: &Fields) -> Result<u64> {
    let allowed = "a whole number from 0, below 2^53";
    match fields.number("seed", allowed)? {
        None => Ok(1),
        Some(seed) if seed.fract() == 0.0 && (0.0..LARGEST_SEED).contains(&seed) => Ok(seed as u64),
        Some(seed) => Err(Error::new(Code::OutOfRange, "seed", shown(seed), allowed)),
    }
}

pub(super) fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_of_fourth_degree_are_differentiated_exactly() {
        let (h, p) = (0.1, |t: f64| 1.0 - t + 2.0 * t * t - 3.0 * t.powi(3) + 0.5 * t.powi(4));
        let values: Vec<f64> = (0..12).map(|i| p(f64::from(i) * h)).collect();
        for (i, slope) in differentiated(&values, h).into_iter().enumerate() {
            let t = i as f64 * h;
            let expected = -1.0 + 4.0 * t - 9.0 * t * t + 2.0 * t.powi(3);
            assert!((slope - expected).abs() < 1e-11, "{i}: {slope} {expected}");
        }
    }
}
