//! Records with known keys, read field by field.

use super::{
    Value,
    parse::{number, numbers, record, text, wrong_type},
};
use crate::{
    error::{Code, Error, Result},
    parameter::StateVariable,
};

/// A record all of whose keys are known. A missing field and an absent value are the same.
pub(crate) struct Fields<'a>(&'a [(String, Value)]);

impl<'a> Fields<'a> {
    /// The record `input`, called `place` in errors.
    ///
    /// # Errors
    /// Anything else, and a key that is not among `known`.
    #[inline(never)]
    pub fn of(place: &str, input: &'a Value, known: &[&'static str]) -> Result<Self> {
        let entries = record(place, input)?;
        match entries.iter().find(|(key, _)| !known.contains(&key.as_str())) {
            Some((key, _)) => Err(Error::unknown(Code::UnknownKey, place, key, known)),
            None => Ok(Self(entries)),
        }
    }

    /// The value of a field. Of a key given twice the last counts, as in JavaScript.
    #[inline(never)]
    pub fn value(&self, key: &str) -> Option<&'a Value> {
        self.0.iter().rev().find(|(name, _)| name == key).map(|(_, value)| value).filter(|v| **v != Value::Absent)
    }

    /// A field that holds a finite number; `allowed` says so in errors.
    #[inline(never)]
    pub fn number(&self, key: &str, allowed: &str) -> Result<Option<f64>> {
        self.value(key).map(|value| number(key, value, allowed)).transpose()
    }

    /// A field that holds a list of numbers.
    #[inline(never)]
    pub fn numbers(&self, key: &str) -> Result<Option<Vec<f64>>> {
        self.value(key).map(|value| numbers(key, value)).transpose()
    }

    /// A field that holds a name.
    #[inline(never)]
    pub fn text(&self, key: &str) -> Result<Option<&'a str>> {
        self.value(key).map(|value| text(key, value)).transpose()
    }

    /// A field that holds true or false.
    #[inline(never)]
    pub fn truth(&self, key: &str) -> Result<Option<bool>> {
        match self.value(key) {
            None => Ok(None),
            Some(Value::Bool(truth)) => Ok(Some(*truth)),
            Some(other) => Err(wrong_type(key, other, "true or false")),
        }
    }

    /// A state: the record `input`, called `place` in errors, by the names of a model's states; one that is not named is 0.
    ///
    /// # Errors
    /// Anything but finite numbers by these names.
    pub fn state(place: &str, input: &Value, states: &[StateVariable]) -> Result<Vec<f64>> {
        let names: Vec<&'static str> = states.iter().map(|state| state.name).collect();
        let fields = Fields::of(place, input, &names)?;
        names.iter().map(|name| Ok(fields.number(name, "a finite number")?.unwrap_or(0.0))).collect()
    }
}
