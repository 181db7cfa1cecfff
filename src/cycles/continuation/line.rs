//! A gear along the range of one of its parameters.

use crate::{
    error::{Code, Error, Result, shown},
    run::Run,
    stability::{Linearisation, Polynomial, Variation, linearised},
};

/// A gear whose parameter varies from one end of a range to the other.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    run: Run,
    variation: Variation,
    /// Every parameter by the one that varies, in table order.
    varied: Vec<Polynomial>,
}

impl Line {
    /// The gear of `run` over a range, whose ends may come in either order.
    ///
    /// # Errors
    /// An unknown parameter, ends that are not valid for it or the same.
    pub fn of(run: Run, variation: Variation) -> Result<Self> {
        let Variation { from, to, .. } = variation;
        let variation = Variation { from: from.min(to), to: from.max(to), ..variation };
        let varied = variation.applied(run.description().table, run.parameters())?;
        if from == to {
            let allowed = format!("another value than {} (from)", shown(from));
            return Err(Error::new(Code::OutOfRange, "to", shown(to), allowed));
        }
        Ok(Self { run, variation, varied })
    }

    /// The gear, with a value of its own for what varies.
    pub fn run(&self) -> &Run {
        &self.run
    }

    /// What varies.
    pub fn variation(&self) -> &Variation {
        &self.variation
    }

    /// The parameter's public name, as the table has it.
    pub fn parameter(&self) -> &'static str {
        let table = self.run.description().table;
        table.iter().find(|parameter| parameter.name == self.variation.parameter).map_or("", |found| found.name)
    }

    /// Lower end.
    pub fn from(&self) -> f64 {
        self.variation.from
    }

    /// Upper end.
    pub fn to(&self) -> f64 {
        self.variation.to
    }

    /// How far it is from one end to the other.
    pub fn width(&self) -> f64 {
        self.to() - self.from()
    }

    fn values(&self, value: f64) -> Vec<f64> {
        self.varied.iter().map(|parameter| parameter.at(value)).collect()
    }

    /// The gear at a value of the parameter.
    ///
    /// # Errors
    /// A value that makes another one invalid that is linked to it.
    pub fn run_at(&self, value: f64) -> Result<Run> {
        self.run.clone().with_values(&self.values(value))
    }

    /// The gear at rest at a value of the parameter.
    ///
    /// # Errors
    /// As [`Run::linearised`].
    pub fn rest(&self, value: f64) -> Result<Linearisation> {
        linearised(&self.run.description(), &self.values(value))
    }
}
