//! One parameter that varies while the others stay, or follow it.

use super::{Links, Polynomial, range};
use crate::{
    error::{Code, Error, Result, shown},
    parameter::Parameter,
    run::{Fields, Value},
};

/// A parameter's range to look at.
#[derive(Clone, Debug, PartialEq)]
pub struct Variation {
    /// Its public name.
    pub parameter: String,
    /// Lower end.
    pub from: f64,
    /// Upper end.
    pub to: f64,
    /// σ = 3a holds as a varies.
    pub relaxation_length_follows: bool,
    /// κ = 0.15 a² c_Fα F_z holds as a, c_Fα or F_z varies.
    pub tread_width_moment_constant_follows: bool,
}

impl Variation {
    /// Of `parameter` from `from` to `to`, the others as they are.
    pub fn of(parameter: &str, from: f64, to: f64) -> Self {
        Self {
            parameter: parameter.to_owned(),
            from,
            to,
            relaxation_length_follows: false,
            tread_width_moment_constant_follows: false,
        }
    }

    /// Reads a record `{parameter, from, to, linked: {relaxationLength, treadWidthMomentConstant}}`.
    ///
    /// # Errors
    /// Anything but a record of these keys; the error names the field. Names and ranges are checked against the model.
    pub fn read(input: &Value) -> Result<Self> {
        let fields = Fields::of("variation", input, &["parameter", "from", "to", "linked"])?;
        let (parameter, [from, to]) = range::read(&fields)?;
        let Links { relaxation_length, tread_width_moment_constant } = Links::read(&fields)?;
        Ok(Self {
            relaxation_length_follows: relaxation_length,
            tread_width_moment_constant_follows: tread_width_moment_constant,
            ..Self::of(parameter, from, to)
        })
    }

    /// The parameters of `table`, the others being `values`, as polynomials in the one that varies.
    ///
    /// # Errors
    /// An unknown parameter, ends that are not valid for it or do not ascend.
    pub(crate) fn applied(&self, table: &[Parameter], values: &[f64]) -> Result<Vec<Polynomial>> {
        let Self { from, to, .. } = *self;
        let index = range::check(table, &self.parameter, [from, to])?;
        if to < from {
            return Err(Error::new(Code::NotAscending, "to", shown(to), format!("≥ {} (from)", shown(from))));
        }
        let mut varied: Vec<Polynomial> = values.iter().map(|value| Polynomial::from(*value)).collect();
        // A range of one value is that value: freeplay of 0 is none, freeplay that varies is some.
        varied[index] = if from == to { Polynomial::from(from) } else { Polynomial::variable() };
        self.links().follow(table, &mut varied, &[&self.parameter]);
        Ok(varied)
    }

    fn links(&self) -> Links {
        Links {
            relaxation_length: self.relaxation_length_follows,
            tread_width_moment_constant: self.tread_width_moment_constant_follows,
        }
    }
}
