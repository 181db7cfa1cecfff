//! A damper as it is asked for: model, values, command.

use super::{Damper, Description, named};
use crate::{
    error::{Error, Result},
    parameter::{Validity, check_number, parameter_index},
    run::{Fields, Value},
};

/// A damper by itself, checked.
#[derive(Clone, Debug)]
pub struct DamperSpec {
    /// Its tables.
    pub description: &'static Description,
    /// Its values in table order.
    pub values: Vec<f64>,
    /// A or V.
    pub command: f64,
    damper: Damper,
}

impl DamperSpec {
    /// The damper `name` with its defaults.
    ///
    /// # Errors
    /// An unknown name, with the nearest known one.
    pub fn of(name: &str) -> Result<Self> {
        let description = named(name)?;
        let values = description.defaults();
        let damper = description.damper(&values)?;
        Ok(Self { description, values, command: description.command.default, damper })
    }

    /// With another value of the parameter `name`, or of `command`.
    ///
    /// # Errors
    /// An unknown name; a value that is not valid, or not together with the others.
    pub fn with(mut self, name: &str, value: f64) -> Result<Self> {
        if name == "command" {
            self.command = self.description.check_command(value)?;
        } else {
            self.values[parameter_index(self.description.parameters, name)?] = value;
            self.damper = self.description.damper(&self.values)?;
        }
        Ok(self)
    }

    /// Reads a record `{model, command, parameters, leverArm}`. The lever arm is a gear's and does not enter.
    ///
    /// # Errors
    /// Anything but known keys with valid values; the error names the field.
    pub fn read(input: Option<&Value>) -> Result<Self> {
        let missing = |field: &str| Error::missing(field, "the name of a damper, such as bouc-wen");
        let fields = Fields::of(
            "damper",
            input.ok_or_else(|| missing("damper"))?,
            &["model", "command", "parameters", "leverArm"],
        )?;
        let read = || {
            let mut spec = Self::of(fields.text("model")?.ok_or_else(|| missing("model"))?)?;
            if let Some(arm) = fields.number("leverArm", "> 0 m")? {
                check_number("leverArm", arm, Validity::Positive, "m")?;
            }
            if let Some(values) = fields.value("parameters") {
                let table = spec.description.parameters;
                let known: Vec<_> = table.iter().map(|parameter| parameter.name).collect();
                let values = Fields::of("parameters", values, &known)?;
                for (place, parameter) in table.iter().enumerate() {
                    if let Some(value) = values.number(parameter.name, "a finite number")? {
                        spec.values[place] = value;
                    }
                }
                spec.damper = spec.description.damper(&spec.values).map_err(|error| error.within("parameters"))?;
            }
            match fields.number("command", "a finite number")? {
                Some(command) => spec.with("command", command),
                None => Ok(spec),
            }
        };
        read().map_err(|error: Error| error.within("damper"))
    }

    /// The damper.
    pub fn damper(&self) -> &Damper {
        &self.damper
    }
}
