//! What is said when an input cannot be used.
//!
//! An error is data first: which field, which value, what is allowed. The sentence is made from that, so that a page
//! can say the same in another language.

use std::{fmt, ops::Deref};

/// Result of anything that can refuse its input.
pub type Result<T> = std::result::Result<T, Error>;

/// The kind of an [`Error`]: a stable name that programs can match.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Code {
    /// A number outside of what the field allows.
    OutOfRange,
    /// NaN or an infinity.
    NotFinite,
    /// A value of another type than the field takes.
    WrongType,
    /// A key that this record does not have.
    UnknownKey,
    /// A name (of a model, a method, a state …) that is not on the list.
    UnknownName,
    /// A field that has no default is absent.
    Missing,
    /// A size that would not fit or would never end.
    TooLarge,
    /// A list that must rise does not.
    NotAscending,
    /// The step limit was reached before the end of the run.
    StepLimit,
    /// The motion left the finite numbers.
    Diverged,
    /// The step became too small to advance the time.
    StepTooSmall,
    /// The method cannot be used for this run.
    Unsuited,
    /// Bytes that are not a snapshot of this object.
    BadSnapshot,
    /// The object is in use or has been freed.
    Unusable,
}

impl Code {
    /// The name by which programs match: kebab case, stable.
    pub fn name(self) -> &'static str {
        match self {
            Code::OutOfRange => "out-of-range",
            Code::NotFinite => "not-finite",
            Code::WrongType => "wrong-type",
            Code::UnknownKey => "unknown-key",
            Code::UnknownName => "unknown-name",
            Code::Missing => "missing",
            Code::TooLarge => "too-large",
            Code::NotAscending => "not-ascending",
            Code::StepLimit => "step-limit",
            Code::Diverged => "diverged",
            Code::StepTooSmall => "step-too-small",
            Code::Unsuited => "unsuited",
            Code::BadSnapshot => "bad-snapshot",
            Code::Unusable => "unusable",
        }
    }
}

/// A refused input, or a run that could not be carried through: a [`Refusal`] on the heap, so that what can fail hands on
/// one word in its stead.
#[derive(Clone, Debug, PartialEq)]
pub struct Error(Box<Refusal>);

impl Deref for Error {
    type Target = Refusal;

    fn deref(&self) -> &Refusal {
        &self.0
    }
}

/// What an [`Error`] holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// Its kind.
    pub code: Code,
    /// The field, by its public (JavaScript) name; dotted where it is nested.
    pub field: String,
    /// The value, as it would be written.
    pub value: String,
    /// What is allowed instead, with its unit: `> 0 m/s`.
    pub allowed: String,
    /// The nearest known name, where the field or value is a name.
    pub suggestion: Option<&'static str>,
}

impl Error {
    #[cold]
    #[inline(never)]
    fn of(code: Code, field: String, value: String, allowed: String, suggestion: Option<&'static str>) -> Self {
        Self(Box::new(Refusal { code, field, value, allowed, suggestion }))
    }

    /// `field must be allowed, got value`.
    #[cold]
    #[inline(never)]
    pub fn new(code: Code, field: impl Into<String>, value: impl Into<String>, allowed: impl Into<String>) -> Self {
        Self::of(code, field.into(), value.into(), allowed.into(), None)
    }

    /// An unknown `name` in `place`, with the nearest of the known ones.
    #[inline(never)]
    pub fn unknown(code: Code, place: &str, name: &str, known: &[&'static str]) -> Self {
        let shown: String = name.chars().take(60).collect();
        let allowed = format!("one of {}", known.join(", "));
        Self::of(code, place.to_owned(), shown, allowed, nearest(name, known))
    }

    /// There is no `field`, which must be `allowed`.
    #[cold]
    pub(crate) fn missing(field: &str, allowed: &str) -> Self {
        Self::new(Code::Missing, field, "nothing", allowed)
    }

    /// The run came to `time` s in as many steps as it may take.
    #[cold]
    pub(crate) fn step_limit(time: f64, steps: u64) -> Self {
        Self::new(Code::StepLimit, "maxSteps", shown(time), steps.to_string())
    }

    /// The model `name` has no `what`.
    #[inline(never)]
    pub(crate) fn without(name: &str, what: &str) -> Self {
        Self::new(Code::Unsuited, "model", name, format!("one with {what}, such as torsional"))
    }

    /// Results of what is valid each by itself, where one of them is no number.
    #[inline(never)]
    pub(crate) fn unless_finite(what: &str, results: &[f64]) -> Result<()> {
        match results.iter().find(|value| !value.is_finite()) {
            Some(value) => Err(Self::new(Code::NotFinite, what, shown(*value), "finite: choose less extreme values")),
            None => Ok(()),
        }
    }

    /// Parameters, each of them valid, that together drive something out of what a double can say.
    #[cold]
    pub(crate) fn beyond_numbers(what: &str) -> Self {
        Self::new(
            Code::NotFinite,
            "parameters",
            format!("values with which {what} would leave the numbers"),
            "less extreme",
        )
    }

    /// The same error with its field placed inside a record: `parameters.velocity`.
    #[inline(never)]
    pub fn within(mut self, record: &str) -> Self {
        self.0.field = format!("{record}.{}", self.field);
        self
    }

    /// The same error of another field.
    #[inline(never)]
    pub(crate) fn called(mut self, field: &str) -> Self {
        self.0.field = field.to_owned();
        self
    }

    /// The same error of another kind.
    pub(crate) fn of_kind(mut self, code: Code) -> Self {
        self.0.code = code;
        self
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Refusal { code, field, value, allowed, suggestion } = &**self;
        match code {
            Code::UnknownKey => write!(f, "{field} has no key {value}")?,
            Code::UnknownName => write!(f, "{field} must be {allowed}, got {value}")?,
            Code::Missing => write!(f, "{field} is missing: it must be {allowed}")?,
            Code::StepLimit => {
                write!(f, "{field} of {allowed} were taken by t = {value} s, before the end of the run")?
            }
            Code::Diverged => write!(f, "{field} left the finite numbers at t = {value} s: {allowed}")?,
            Code::StepTooSmall => write!(f, "{field} became too small at t = {value} s: {allowed}")?,
            _ => write!(f, "{field} must be {allowed}, got {value}")?,
        }
        match (suggestion, code) {
            (Some(name), _) => write!(f, " (did you mean {name}?)"),
            (None, Code::UnknownKey) => write!(f, " (it takes {})", allowed.strip_prefix("one of ").unwrap_or(allowed)),
            _ => Ok(()),
        }
    }
}

impl std::error::Error for Error {}

/// A number as an error shows it: short, whatever its size, and in words that JavaScript has too.
#[cold]
pub(crate) fn shown(value: f64) -> String {
    match value {
        _ if value.is_nan() => "NaN".into(),
        _ if value.is_infinite() => if value > 0.0 { "Infinity" } else { "-Infinity" }.into(),
        _ if value != 0.0 && !(1e-6..1e15).contains(&value.abs()) => digits::with_exponent(value),
        _ => digits::plain(value),
    }
}

/// A number to four digits, with an exponent.
#[cold]
pub(crate) fn shown_short(value: f64) -> String {
    digits::to_four(value)
}

/// Shortest digits that stand for a number. JavaScript has them; a second set of tables and big integers for them would be
/// a twentieth of the module.
#[cfg(target_arch = "wasm32")]
use crate::wasm::digits;

#[cfg(not(target_arch = "wasm32"))]
mod digits {
    pub fn plain(value: f64) -> String {
        value.to_string()
    }
    pub fn with_exponent(value: f64) -> String {
        format!("{value:e}")
    }
    pub fn to_four(value: f64) -> String {
        format!("{value:.3e}")
    }
}

/// The known name nearest to `name`, or none where nothing is near.
///
/// Near: an edit distance (insert, delete, replace) of at most a third of the longer name, letter case aside.
pub fn nearest(name: &str, known: &[&'static str]) -> Option<&'static str> {
    // An absurdly long name is near to nothing, and its distance would cost its length.
    if name.len() > 60 {
        return None;
    }
    // What stands within a known name stands for it: damping for dampingConstant.
    let part = name.as_bytes();
    let holds = |candidate: &&str| {
        part.len() >= 3 && candidate.as_bytes().windows(part.len()).any(|window| window.eq_ignore_ascii_case(part))
    };
    if let Some(candidate) = known.iter().copied().find(holds) {
        return Some(candidate);
    }
    let wanted: Vec<char> = name.to_ascii_lowercase().chars().collect();
    known
        .iter()
        .map(|&candidate| {
            (edit_distance(&wanted, &candidate.to_ascii_lowercase().chars().collect::<Vec<_>>()), candidate)
        })
        .filter(|(distance, candidate)| 3 * distance <= candidate.len().max(wanted.len()))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

fn edit_distance(a: &[char], b: &[char]) -> usize {
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.iter().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(x != y);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sentence_names_field_value_and_what_is_allowed() {
        let error = Error::new(Code::OutOfRange, "velocity", "-3", "> 0 m/s");
        assert_eq!(error.to_string(), "velocity must be > 0 m/s, got -3");
        assert_eq!(error.within("parameters").to_string(), "parameters.velocity must be > 0 m/s, got -3");
    }

    #[test]
    fn numbers_are_shown_short() {
        let shown = [f64::INFINITY, -f64::INFINITY, f64::NAN, 1e300, 1e-300, -3.0, 0.0, 1e12].map(shown);
        assert_eq!(shown, ["Infinity", "-Infinity", "NaN", "1e300", "1e-300", "-3", "0", "1000000000000"]);
    }

    #[test]
    fn nearest_name_is_suggested_and_nonsense_is_not() {
        let known = ["velocity", "casterLength", "dampingConstant"];
        assert_eq!(nearest("velocty", &known), Some("velocity"));
        assert_eq!(nearest("CasterLenght", &known), Some("casterLength"));
        assert_eq!(nearest("damping", &known), Some("dampingConstant"));
        assert_eq!(nearest("qqqqqqqq", &known), None);
        assert_eq!(nearest(&"x".repeat(100_000), &known), None);
        let error = Error::unknown(Code::UnknownKey, "parameters", "velocty", &known);
        assert_eq!(error.to_string(), "parameters has no key velocty (did you mean velocity?)");
    }
}
