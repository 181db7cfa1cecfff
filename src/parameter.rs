//! Parameters and states as tables: written once, read by defaults, checks, sliders, documents and tests.

use serde::Serialize;

use crate::error::{Code, Error, Result, shown};

/// One parameter of a model.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Parameter {
    /// Public name, camel case: `casterLength`.
    pub name: &'static str,
    /// Symbol of the equations: `e`, with `_` before a subscript: `I_z`.
    pub symbol: &'static str,
    /// SI unit, `1` for a pure number.
    pub unit: &'static str,
    /// Value of a run that does not name the parameter.
    pub default: f64,
    /// Lower end of a slider. What is *valid* is wider: see [`Parameter::check`].
    pub min: f64,
    /// Upper end of a slider.
    pub max: f64,
    /// How a slider runs from `min` to `max`.
    pub scale: Scale,
    /// Meaning, where it enters the equations and by which source, validity: one to three sentences.
    pub doc: &'static str,
    /// What values make sense at all.
    #[serde(skip)]
    pub validity: Validity,
}

/// How a slider divides its range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Scale {
    /// Equal distances are equal differences.
    Linear,
    /// Equal distances are equal ratios.
    Log,
}

/// The values for which the equations have a meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Validity {
    /// Greater than zero.
    Positive,
    /// Zero or greater.
    NonNegative,
    /// Any finite number.
    Finite,
}

/// Larger magnitudes than this overflow when they are squared and multiplied; no gear has them.
pub(crate) const LARGEST: f64 = 1e12;

impl Parameter {
    /// The value itself where it is valid, otherwise an error that says what is.
    ///
    /// # Errors
    /// NaN, infinities, magnitudes above 10¹², and values outside of [`Parameter::validity`].
    pub fn check(&self, value: f64) -> Result<f64> {
        check_number(self.name, value, self.validity, self.unit)
    }
}

/// As [`Parameter::check`], for any named number.
///
/// # Errors
/// As [`Parameter::check`].
#[inline(never)]
pub fn check_number(name: &str, value: f64, validity: Validity, unit: &str) -> Result<f64> {
    let unit = if unit == "1" { String::new() } else { format!(" {unit}") };
    let allowed = match validity {
        Validity::Positive => format!("> 0{unit}"),
        Validity::NonNegative => format!("≥ 0{unit}"),
        Validity::Finite => {
            format!("a finite number{}", if unit.is_empty() { String::new() } else { format!(" of{unit}") })
        }
    };
    if !value.is_finite() {
        return Err(Error::new(Code::NotFinite, name, shown(value), allowed));
    }
    let inside = match validity {
        Validity::Positive => value > 0.0,
        Validity::NonNegative => value >= 0.0,
        Validity::Finite => true,
    };
    if !inside {
        return Err(Error::new(Code::OutOfRange, name, shown(value), allowed));
    }
    if value.abs() > LARGEST {
        return Err(Error::new(Code::OutOfRange, name, shown(value), format!("at most 1e12{unit} in magnitude")));
    }
    Ok(value)
}

/// One state variable of a model.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct StateVariable {
    /// Public name, camel case: `torsionAngle`.
    pub name: &'static str,
    /// Symbol of the equations.
    pub symbol: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// Typical size: absolute tolerances and finite differences are measured with it.
    pub scale: f64,
    /// Meaning and positive sense.
    pub doc: &'static str,
}

/// Place of `name` in a table of parameters.
///
/// # Errors
/// An unknown name, with the nearest known one.
#[inline(never)]
pub fn parameter_index(table: &[Parameter], name: &str) -> Result<usize> {
    table.iter().position(|p| p.name == name).ok_or_else(|| {
        let known: Vec<_> = table.iter().map(|p| p.name).collect();
        Error::unknown(Code::UnknownKey, "parameters", name, &known)
    })
}

/// Place of `name` in a table of states.
///
/// # Errors
/// An unknown name, with the nearest known one.
pub fn state_index(table: &[StateVariable], name: &str) -> Result<usize> {
    table.iter().position(|s| s.name == name).ok_or_else(|| {
        let known: Vec<_> = table.iter().map(|s| s.name).collect();
        Error::unknown(Code::UnknownKey, "state", name, &known)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn check_says_what_is_allowed() {
        let speed = |value| check_number("velocity", value, Validity::Positive, "m/s");
        assert_eq!(speed(3.0), Ok(3.0));
        assert_eq!(speed(-3.0).unwrap_err().to_string(), "velocity must be > 0 m/s, got -3");
        assert_eq!(speed(0.0).unwrap_err().code, Code::OutOfRange);
        assert_eq!(speed(f64::NAN).unwrap_err().code, Code::NotFinite);
        assert_eq!(speed(f64::INFINITY).unwrap_err().to_string(), "velocity must be > 0 m/s, got Infinity");
        assert_eq!(speed(1e13).unwrap_err().code, Code::OutOfRange);
        assert!(check_number("casterLength", -0.5, Validity::Finite, "m").is_ok());
    }
}
